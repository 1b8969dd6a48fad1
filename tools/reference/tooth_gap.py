# SPDX-License-Identifier: Apache-2.0
"""Gap between the flanks of flexspline and circular spline over the angle from the lobe.

A tooth is rigid and stands normal to the rim's centre line.  This line is r = R_m + w0 cos(2 phi)
in polar coordinates about the axis, and it keeps its length exactly: R_m follows from the length of
a quarter, and the polar angle phi of the section theta from the length of the arc up to it.  Seen
from the wave generator the tooth at theta and the space at theta z/(z + 2) belong together.  The
frame of the space has Y along its middle, outward, and X toward +theta.  The gap is that of the
flank on the side of +X; the other flank is its mirror image, t -> -t.

Profiles (heights are those that work, without chamfer or relief; h over the pitch height):

    straight    trapezoids of angle alpha against the middle of tooth and space
    involute    base circles R_p cos(alpha) and (z + 2)/z times that, alpha at the pitch height
    double_arc  convex arc, tangent, concave arc; the space is what the tooth sweeps (conjugate)
    half_path   over the pitch height the tooth has the path of the pitch point at half its size,
                below it a straight flank of angle zero; the space is what the tooth sweeps

Straight flanks and involutes are seated so that they touch without crossing for |t| <= 30 degrees:
at the lobe there may be a gap.

Two roads.  "Points": 4001 points on each flank, joined by chords; the gap is the least distance of
a point of one flank to a chord of the other.  Nothing else is known of the curves; chords deviate
from their curves by less than 1e-11 m.  The centre line is integrated by Gauss's rule.  The swept
space is the farthest X of all positions of the tooth at each height.  "Law": closed forms of the
straight flanks and the involutes, with the centre line as a Fourier series; for the swept spaces
the points of contact by the condition that the velocity has no component along the normal.

    tooth_gap.py            JSON on stdout
    tooth_gap.py --write    and tests/data/tooth_gap.csv
    tooth_gap.py --check    largest differences of the two roads
    tooth_gap.py --plot DIR one SVG per profile
"""
import sys
from functools import cache
from math import acos, atan2, cos, hypot, pi, radians, sin, sqrt, tan
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq, minimize_scalar
from scipy.spatial import cKDTree

from reference_csv import Table, publish

POINTS = 4001
SEAT = radians(30)  # flanks are seated on the teeth up to here


class Drive(NamedTuple):
    ratio: int
    module: float  # m
    wave: float  # w0, half the difference of the axes of the deformed centre line, m
    radius: float  # R, of the centre line of the undeformed rim, m
    offset: float  # e, pitch radius less R, m

    @property
    def teeth(self):
        return 2 * self.ratio

    @property
    def pitch_radius(self):
        return self.radius + self.offset


class Profile(NamedTuple):
    name: str
    flank_angle: float = 0.0  # rad
    flexspline_addendum: float = 0.0  # over the module, as all below
    spline_addendum: float = 0.0
    thickness: float = pi / 2  # of the flexspline's tooth at the pitch height
    dedendum: float = 0.0  # depth of the flexspline's flank
    arcs: tuple = ()  # r1, c1, e1, r2, c2, e2


def size_25(ratio, wave=1.0):
    """Rim of a drive of 63.5 mm pitch diameter; walls over module as in the chapter's study."""
    d = 63.5e-3
    m = d / (2 * ratio)
    wall = 1e-4 * (65 + 2.5 * ratio ** (2 / 3)) * d
    R = d / 2 - 1.1 * m - wall / 2
    return Drive(ratio, m, wave * m, R, d / 2 - R)


STRAIGHT = Profile("straight", radians(22), 0.65, 0.65, dedendum=1.1)
INVOLUTE = Profile("involute", radians(22), 0.65, 0.65, dedendum=1.1)
# Liu et al., Machines 13, 535 (2025), module 0.5 mm, over the module
DOUBLE_ARC = Profile("double_arc", 0.0, 0.55, 0.55, dedendum=0.75,
                     arcs=(1.37, 0.664, 0.31, 1.57, 0.66, 0.268))
HALF_PATH = Profile("half_path", 0.0, 0.65, 0.65, dedendum=1.1)
PROFILES = (STRAIGHT, INVOLUTE, DOUBLE_ARC, HALF_PATH)
RATIOS = (30, 50, 80, 100, 160)


# Motion ---------------------------------------------------------------------------------------

NODES, WEIGHTS = np.polynomial.legendre.leggauss(40)


def arc_length(R_m, w0, phi):
    x = phi / 2 * (1 + NODES)
    r, slope = R_m + w0 * np.cos(2 * x), -2 * w0 * np.sin(2 * x)
    return phi / 2 * WEIGHTS @ np.sqrt(r * r + slope * slope)


@cache
def mean_radius(drive):
    quarter = pi / 2 * drive.radius
    return brentq(lambda R_m: arc_length(R_m, drive.wave, pi / 2) - quarter, 0.9 * drive.radius,
                  drive.radius, xtol=1e-17, rtol=1e-15)


def poses(drive, theta):
    """X, Y of the section's centre and angle of the tooth toward +X, in the frame of the space."""
    theta = np.asarray(theta, dtype=float)
    R_m, w0 = mean_radius(drive), drive.wave
    phi = theta.copy()
    for _ in range(5):
        x = phi[:, None] / 2 * (1 + NODES)
        s = phi / 2 * (np.hypot(R_m + w0 * np.cos(2 * x), 2 * w0 * np.sin(2 * x)) @ WEIGHTS)
        r, slope = R_m + w0 * np.cos(2 * phi), -2 * w0 * np.sin(2 * phi)
        phi -= (s - drive.radius * theta) / np.hypot(r, slope)
    r, slope = R_m + w0 * np.cos(2 * phi), -2 * w0 * np.sin(2 * phi)
    space = theta * drive.teeth / (drive.teeth + 2)
    return r * np.sin(phi - space), r * np.cos(phi - space), phi - np.arctan2(slope, r) - space


def pose(drive, theta):
    return tuple(float(x[0]) for x in poses(drive, [theta]))


def placed(drive, theta, points):
    """Points (x, y) of the tooth, y over the centre line, in the frame of the space."""
    X, Y, turn = pose(drive, theta)
    c, s = cos(turn), sin(turn)
    x, y = points[:, 0], points[:, 1]
    return np.column_stack((X + x * c + y * s, Y - x * s + y * c))


def pitch_height(drive):
    """Y of the pitch height of a tooth at the lobe."""
    return mean_radius(drive) + drive.wave + drive.offset


# Direct geometry ------------------------------------------------------------------------------

def involute(base, half_angle, radii):
    """Right flank about the own axis; half_angle: of the tooth where the flank begins, at the base
    circle, less: the flank leans away from +X with growing radius."""
    pressure = np.arccos(base / radii)
    angle = half_angle - (np.tan(pressure) - pressure)
    return np.column_stack((radii * np.sin(angle), radii * np.cos(angle)))


def base_angles(drive, profile):
    """Base radii and angles at the base circles of tooth and space that coincide at the lobe at the
    pitch height."""
    m, R_p, alpha = drive.module, drive.pitch_radius, profile.flank_angle
    base = R_p * cos(alpha), R_p * cos(alpha) * (drive.teeth + 2) / drive.teeth
    tooth = profile.thickness * m / (2 * R_p) + tan(alpha) - alpha
    Y = pitch_height(drive)
    x, y = R_p * sin(profile.thickness * m / (2 * R_p)), R_p * cos(
        profile.thickness * m / (2 * R_p)) + Y - R_p
    pressure = acos(base[1] / hypot(x, y))
    return base, (tooth, atan2(x, y) + tan(pressure) - pressure)


def tooth_flank(drive, profile, points=POINTS):
    """Flank of the flexspline's tooth from the lowest working point to the tip."""
    m = drive.module
    h = np.linspace(-profile.dedendum * m, profile.flexspline_addendum * m, points)
    if profile.name != "involute":
        x = half_thickness(drive, profile, h)
    else:
        base, angle = base_angles(drive, profile)
        flank = involute(base[0], angle[0], np.maximum(drive.pitch_radius + h, base[0]))
        return flank - [0, drive.radius]
    return np.column_stack((x, drive.offset + h))


def arc_tangent(profile):
    """Inclination of the common tangent, and heights where it meets the arcs."""
    r1, c1, e1, r2, c2, e2 = profile.arcs
    dx, dy = pi / 2 + c2 + c1, e2 + e1
    tilt = acos((r1 + r2) / hypot(dx, dy)) + atan2(dy, dx)
    return tilt, r1 * sin(tilt) - e1, e2 - r2 * sin(tilt)


def arc_half_thickness(profile, h):
    r1, c1, e1, r2, c2, e2 = profile.arcs
    tilt, upper, lower = arc_tangent(profile)
    line = r1 * cos(tilt) - c1 + (upper - h) * tan(tilt)
    tip = np.sqrt(np.maximum(r1 ** 2 - (h + e1) ** 2, 0)) - c1
    root = pi / 2 + c2 - np.sqrt(np.maximum(r2 ** 2 - (e2 - h) ** 2, 0))
    return np.where(h > upper, tip, np.where(h < lower, root, line))


def half_path(drive, h):
    """Distance in X of the half-size path of the pitch point from the pitch point, at height h."""
    half = drive.wave / 2
    eta = np.arccos(np.clip(1 - np.maximum(h, 0) / half, -1, 1))
    return half / 2 * (eta * drive.module / drive.wave - np.sin(eta))


def half_thickness(drive, profile, h):
    """X of the flank over the middle of the tooth at heights h over the pitch height."""
    m = drive.module
    if profile.name == "straight":
        return profile.thickness * m / 2 - h * tan(profile.flank_angle)
    if profile.name == "half_path":
        return profile.thickness * m / 2 - half_path(drive, h)
    return arc_half_thickness(profile, h / m) * m


@cache
def space_flank(drive, profile):
    """Flank of the circular spline's space from its tip to where the flexspline never reaches."""
    m, Y_p, alpha = drive.module, pitch_height(drive), profile.flank_angle
    h = np.linspace(-profile.spline_addendum * m, (profile.flexspline_addendum + 0.05) * m, POINTS)
    if profile.name not in LAWS:
        return swept_flank(drive, profile)
    play = seat(drive, profile)
    if profile.name == "straight":
        x = profile.thickness * m / 2 - h * tan(alpha)
        return np.column_stack((x + play * cos(alpha), Y_p + h + play * sin(alpha)))
    base, angle = base_angles(drive, profile)
    return involute(base[1], angle[1] + play / base[1], Y_p + h)


@cache
def swept_flank(drive, profile):
    """Outline of all positions of the tooth: the farthest X at each height."""
    Y_p, m = pitch_height(drive), drive.module
    Y = Y_p + m * np.linspace(-profile.spline_addendum, profile.flexspline_addendum, POINTS)
    step = radians(0.02)
    steps = np.arange(-radians(65), radians(65), step)
    X, at = np.full(POINTS, -np.inf), np.zeros(POINTS)
    for t, pose_t in zip(steps, np.array(poses(drive, steps)).T):
        x = flank_at_height(drive, profile, pose_t, Y, 9)
        at[x > X] = t
        X = np.maximum(X, x)
    for _ in range(30):  # zoom to the maximum at each height
        step /= 2
        for t in (at - step, at + step):
            x = flank_at_height(drive, profile, poses(drive, t), Y)
            at = np.where(x > X, t, at)
            X = np.maximum(X, x)
    return np.column_stack((X, Y))


def flank_at_height(drive, profile, pose_t, Y, rounds=14):
    """X of the tooth's flank at heights Y in given poses; -inf above the tip."""
    X, height, turn = pose_t
    c, s = np.cos(turn), np.sin(turn)
    m, h = drive.module, Y - height
    y = h.copy()
    for _ in range(rounds):
        x = half_thickness(drive, profile, y - drive.offset)
        y = (h + x * s) / c
    top = drive.offset + profile.flexspline_addendum * m
    return np.where(y <= top, X + x * c + y * s, -np.inf)


def to_chords(points, curve):
    """Least distance of points to the chords of a curve, the point and its foot."""
    _, nearest = cKDTree(curve).query(points)
    best = (np.inf, None, None)
    for first in (nearest - 1, nearest):
        first = np.clip(first, 0, len(curve) - 2)
        a, d = curve[first], curve[first + 1] - curve[first]
        share = np.clip(((points - a) * d).sum(1) / (d * d).sum(1), 0, 1)
        foot = a + share[:, None] * d
        distance = np.hypot(*(points - foot).T)
        k = distance.argmin()
        if distance[k] < best[0]:
            best = distance[k], points[k], foot[k]
    return best


class Gap(NamedTuple):
    value: float  # m
    height: float  # of the point of contact over the pitch height of the tooth, m


def direct_gap(drive, profile, t):
    tooth = placed(drive, t, tooth_flank(drive, profile))
    space = space_flank(drive, profile)
    pairs = [to_chords(tooth, space)]
    value, q, p = to_chords(space, tooth)
    pairs.append((value, p, q))
    value, p, _ = min(pairs, key=lambda pair: pair[0])
    X, Y, turn = pose(drive, t)
    height = (p[0] - X) * sin(turn) + (p[1] - Y) * cos(turn) - drive.offset
    return Gap(value, height)


# Closed forms ---------------------------------------------------------------------------------

@cache
def arc_series(drive):
    """R_m and a_n of ds/dphi = R + sum a_n cos(2 n phi); the mean of ds/dphi is R."""
    phi = pi * np.arange(32) / 32
    wave, slope = drive.wave * np.cos(2 * phi), -2 * drive.wave * np.sin(2 * phi)
    R_m = drive.radius - drive.wave ** 2 / drive.radius
    for _ in range(5):
        speed = np.hypot(R_m + wave, slope)
        R_m += drive.radius - speed.mean()
    return R_m, [2 * (speed * np.cos(2 * n * phi)).mean() for n in range(1, 8)]


@cache
def law_pose(drive, t):
    R_m, a = arc_series(drive)
    phi = t - drive.wave / (2 * drive.radius) * sin(2 * t)
    for _ in range(4):
        s = drive.radius * phi + sum(x * sin(2 * n * phi) / (2 * n) for n, x in enumerate(a, 1))
        r, slope = R_m + drive.wave * cos(2 * phi), -2 * drive.wave * sin(2 * phi)
        phi -= (s - drive.radius * t) / hypot(r, slope)
    r, slope = R_m + drive.wave * cos(2 * phi), -2 * drive.wave * sin(2 * phi)
    space = t * drive.teeth / (drive.teeth + 2)
    return r * sin(phi - space), r * cos(phi - space), phi - atan2(slope, r) - space


def law_straight(drive, profile, t, play):
    """Gap and height of the contact over the pitch height of the tooth."""
    m, alpha = drive.module, profile.flank_angle
    X, Y, turn = law_pose(drive, t)
    half, up, down = (profile.thickness * m / 2, profile.flexspline_addendum * m,
                      profile.spline_addendum * m)
    beta = alpha - turn  # of the tooth's flank against the middle of the space
    # from the pitch point of the tooth's flank to that of the wall without play
    dx = half - X - half * cos(turn) - drive.offset * sin(turn)
    dy = (arc_series(drive)[0] + drive.wave + drive.offset
          - Y + half * sin(turn) - drive.offset * cos(turn))
    tip = dx * cos(alpha) + dy * sin(alpha) + play - up * sin(turn) / cos(alpha)
    root = dx * cos(beta) + dy * sin(beta) + play * cos(turn) + down * sin(turn) / cos(alpha)
    foot = dy * cos(beta) - dx * sin(beta) + play * sin(turn) - down * cos(turn) / cos(alpha)
    return min((tip, up), (root, foot * cos(alpha)))


def law_involute(drive, profile, t, play):
    m, R_p = drive.module, drive.pitch_radius
    Y_p = arc_series(drive)[0] + drive.wave + drive.offset
    (b1, b2), (A1, A2) = base_angles(drive, profile)
    A2 += play / b2
    X, Y, turn = law_pose(drive, t)
    O = X - drive.radius * sin(turn), Y - drive.radius * cos(turn)

    def roll(radius, base):
        return sqrt((radius / base) ** 2 - 1)

    def point(center, base, start, u):
        beta = start - u
        return (center[0] + base * (sin(beta) + u * cos(beta)),
                center[1] + base * (cos(beta) - u * sin(beta)))

    def start_of(center, base, p):
        x, y = p[0] - center[0], p[1] - center[1]
        u = roll(hypot(x, y), base)
        return atan2(x, y) + u - atan2(u, 1), u

    u_tip = roll(R_p + profile.flexspline_addendum * m, b1)
    u_wall = roll(Y_p - profile.spline_addendum * m, b2)
    start, _ = start_of((0, 0), b2, point(O, b1, A1 + turn, u_tip))
    candidates = [(b2 * (A2 - start), u_tip)]
    start, u = start_of(O, b1, point((0, 0), b2, A2, u_wall))
    candidates.append((b1 * (start - A1 - turn), u + A1 + turn - start))
    far, near = hypot(*O), b2 - b1
    if far > near:
        beta = atan2(*O) - acos(near / far)
        u1, u2 = A1 + turn - beta, A2 - beta
        if u1 <= u_tip and u2 >= u_wall:
            candidates.append((b2 * u2 - b1 * u1 - (O[0] * cos(beta) - O[1] * sin(beta)), u1))
    value, u1 = min(candidates)
    x, y = point((0, -drive.radius), b1, A1, u1)
    return value, y - drive.offset


LAWS = {"straight": law_straight, "involute": law_involute}


@cache
def seat(drive, profile):
    """Play at which the flanks just touch for |t| <= SEAT, normal to the flank."""
    law = LAWS[profile.name]
    t = np.linspace(-SEAT, SEAT, 241)
    raw = [law(drive, profile, float(x), 0.0)[0] for x in t]
    k = int(np.argmin(raw))
    low, high = t[max(k - 1, 0)], t[min(k + 1, len(t) - 1)]
    least = minimize_scalar(lambda x: law(drive, profile, x, 0.0)[0], bounds=(low, high),
                            method="bounded", options={"xatol": 1e-10})
    return -min(least.fun, raw[k])


def law_gap(drive, profile, t):
    return LAWS[profile.name](drive, profile, t, seat(drive, profile))


# Conjugate flanks -----------------------------------------------------------------------------

def slope_of(drive, profile, h):
    tiny = 1e-5 * drive.module
    return (half_thickness(drive, profile, h + tiny)
            - half_thickness(drive, profile, h - tiny)) / (2 * tiny)


def contact_points(drive, profile, t):
    """Points of the flank in the position t whose velocity lies along the flank: where the tooth
    touches the space that it sweeps.  Rows: height over the pitch height, X, Y, angle of the common
    normal against X."""
    step, m = 1e-4, drive.module
    before, here, after = (np.array(law_pose(drive, x)) for x in (t - step, t, t + step))
    rate = (after - before) / (2 * step)
    c, s = cos(here[2]), sin(here[2])

    def across(h):
        x, y = half_thickness(drive, profile, h), drive.offset + h
        slope = slope_of(drive, profile, h)
        vx = rate[0] + rate[2] * (-x * s + y * c)
        vy = rate[1] + rate[2] * (-x * c - y * s)
        return (c - slope * s) * vx - (s + slope * c) * vy  # normal (1, -slope) of the tooth

    h = np.linspace(-profile.dedendum * m, profile.flexspline_addendum * m, POINTS)
    value, found = across(h), []
    for k in np.nonzero(value[:-1] * value[1:] < 0)[0]:
        root = brentq(across, h[k], h[k + 1], xtol=1e-16)
        x, y = float(half_thickness(drive, profile, root)), drive.offset + root
        angle = atan2(-float(slope_of(drive, profile, root)), 1) - here[2]
        found.append((root, here[0] + x * c + y * s, here[1] - x * s + y * c, angle))
    return found


def on_outline(drive, profile, t):
    """The points of contact that lie on the outline of the swept space."""
    wall = swept_flank(drive, profile)
    return [p for p in contact_points(drive, profile, t) if wall[0, 1] < p[2] < wall[-1, 1]
            and abs(p[1] - np.interp(p[2], wall[:, 1], wall[:, 0])) < 1e-10]


def envelope_deviation(drive, profile):
    """Largest X by which a point of contact stands outside the swept space, and the positions that
    touch its outline, degrees."""
    wall = swept_flank(drive, profile)
    outside, angles = -np.inf, []
    for degree in np.arange(-60, 60.01, 0.5):
        for _, X, Y, _ in contact_points(drive, profile, radians(degree)):
            if wall[0, 1] < Y < wall[-1, 1]:
                outside = max(outside, X - np.interp(Y, wall[:, 1], wall[:, 0]))
        if on_outline(drive, profile, radians(degree)):
            angles.append(degree)
    return outside, angles


# Ends -----------------------------------------------------------------------------------------

def overlap(drive, profile, t):
    """Height by which the tip of the tooth stands over the tip of the space's wall, m."""
    tip = placed(drive, t, tooth_flank(drive, profile)[-1:])
    return float(tip[0, 1] - space_flank(drive, profile)[0, 1])


@cache
def end(drive, profile, side):
    """|t| from which on tooth and wall have no height in common; side +1: drive flank."""
    return brentq(lambda t: overlap(drive, profile, side * t), radians(10), radians(89), xtol=1e-12)


def interferes(drive, profile, t):
    """Whether tooth and wall cross; a swept space is never crossed."""
    return profile.name in LAWS and law_gap(drive, profile, t)[0] < -1e-10


# Tables ---------------------------------------------------------------------------------------

VARIANTS = (
    (size_25(100, 1.1), STRAIGHT._replace(flank_angle=radians(28.6), flexspline_addendum=0.875,
                                          spline_addendum=0.8)),
    (size_25(100, 0.9), STRAIGHT._replace(thickness=1.375)),
    (size_25(50, 1.05), INVOLUTE._replace(flank_angle=radians(28.6), thickness=1.375)),
    (size_25(30, 1.15), HALF_PATH),
    (size_25(50, 0.9), HALF_PATH),
    (size_25(100, 1.05), HALF_PATH._replace(flexspline_addendum=0.5)),
    (Drive(50, 0.5e-3, 0.5e-3, 24.275e-3, 0.725e-3), DOUBLE_ARC),
    # the common normal meets both working flanks at -10 degrees
    (size_25(30, 1.3), INVOLUTE._replace(flank_angle=radians(15), flexspline_addendum=0.95,
                                         spline_addendum=0.95)),
)
ANGLES = (-50, -40, -30, -20, -10, -5, -2, 0, 2, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60)
ROUNDING = 2e-10  # of a gap by points, m
SOURCE = "points on the flanks; 1e-10 m"


def cases():
    return [(size_25(ratio), p) for p in PROFILES for ratio in RATIOS] + list(VARIANTS)


def inputs_of(drive, profile):
    m = drive.module
    arcs = [x * m for x in profile.arcs] or [""] * 6
    return [drive.ratio, m, drive.wave, drive.radius, drive.offset, profile.flank_angle or "",
            profile.flexspline_addendum * m, profile.spline_addendum * m,
            "" if profile.arcs else profile.thickness * m, profile.dedendum * m, *arcs]


def digits(value, error):
    return max(1, int(np.floor(np.log10(abs(value) / error)))) if value else 1


def table_of(pairs, angles):
    table = Table("tooth_gap", "ratio [1]", "module [m]", "wave [m]", "radius [m]", "offset [m]",
                  "flank_angle [rad]", "flexspline_addendum [m]", "spline_addendum [m]",
                  "thickness [m]", "dedendum [m]", "r1 [m]", "c1 [m]", "e1 [m]", "r2 [m]", "c2 [m]",
                  "e2 [m]", "angle [rad]")
    for drive, profile in pairs:
        inputs = inputs_of(drive, profile)

        def add(what, angle, value, unit, error, source=SOURCE):
            table.add(f"{profile.name}.{what}", [*inputs, angle], value, unit, source,
                      digits(value, error), 12)

        for name, side in (("drive_end", 1), ("coast_end", -1)):
            add(name, "", end(drive, profile, side), "rad", 1e-7)
        if profile.name in LAWS:
            add("seat", "", round(seat(drive, profile), 13), "m", 1e-11, "closed form")
        for t in map(radians, angles):
            side = 1 if t >= 0 else -1
            if abs(t) >= end(drive, profile, side) or interferes(drive, profile, t):
                continue
            gap = direct_gap(drive, profile, t)
            add("gap", t, round(gap.value, 12) if gap.value > ROUNDING else 0.0, "m", ROUNDING)
            if gap.value > 1e-8:  # where they touch all over, the nearest points say little
                add("contact_height", t, round(gap.height, 9), "m", 2e-7)
            elif profile.name not in LAWS and (touching := on_outline(drive, profile, t)):
                add("contact_height", t, touching[0][0], "m", 1e-8, "velocity along the flank")
                add("contact_angle", t, touching[0][3], "rad", 1e-5, "velocity along the flank")
    return table


def tables():
    return [table_of(cases(), ANGLES)]


def some_tables():
    return [table_of([(size_25(30), STRAIGHT), (size_25(100), INVOLUTE)], (-20, 5, 30))]


# Command line ---------------------------------------------------------------------------------

def check():
    for drive, profile in cases():
        if profile.name in LAWS:
            worst = cross = 0.0
            ends = 0.999 * end(drive, profile, -1), 0.999 * end(drive, profile, 1)
            for t in np.linspace(-ends[0], ends[1], 67):
                value = law_gap(drive, profile, t)[0]
                cross = min(cross, value)
                if not interferes(drive, profile, t):
                    worst = max(worst, abs(direct_gap(drive, profile, t).value - value))
            print(f"{profile.name} {drive.ratio}: law less points {worst:.1e} m, "
                  f"interference {abs(cross):.2e} m")
        else:
            outside, angles = envelope_deviation(drive, profile)
            print(f"{profile.name} {drive.ratio}: contact outside the swept space {outside:.1e} m, "
                  f"on it for {min(angles):.1f} to {max(angles):.1f} degrees")


COLOURS = ("#c00000", "#e08000", "#008000", "#0050c0", "#7000a0")


def plot(folder):
    """Gap over the angle: one picture per profile, one line per ratio, gap over w0."""
    for profile in PROFILES:
        wide, high, left, bottom = 900, 520, 70, 50
        top = 0.30

        def x(t):
            return left + (t + 60) / 120 * (wide - left - 20)

        def y(g):
            return high - bottom - g / top * (high - bottom - 40)

        out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{wide}" height="{high}" '
               'font-family="sans-serif" font-size="13">',
               f'<rect width="{wide}" height="{high}" fill="white"/>',
               f'<text x="{left}" y="22">Gap over w0, {profile.name.replace("_", " ")}; '
               'drive flank t &gt; 0, coast flank t &lt; 0; dots: ends of engagement</text>']
        for t in range(-60, 61, 10):
            out.append(f'<path d="M{x(t):.1f} {y(0):.1f}V{y(top):.1f}" stroke="#ddd"/>'
                       f'<text x="{x(t) - 10:.1f}" y="{high - 28}">{t}</text>')
        for g in np.arange(0, top + 0.001, 0.05):
            out.append(f'<path d="M{x(-60):.1f} {y(g):.1f}H{x(60):.1f}" stroke="#ddd"/>'
                       f'<text x="25" y="{y(g) + 4:.1f}">{g:.2f}</text>')
        out.append(f'<text x="{wide // 2 - 60}" y="{high - 8}">angle from the lobe, degrees</text>')
        for colour, ratio in zip(COLOURS, RATIOS):
            drive = size_25(ratio)
            points = []
            for degree in np.arange(-60, 60.01, 1.0):
                t = radians(degree)
                if -end(drive, profile, -1) < t < end(drive, profile, 1):
                    law = profile.name in LAWS
                    gap = (law_gap(drive, profile, t)[0] if law
                           else direct_gap(drive, profile, t).value) / drive.wave
                    if gap <= top:
                        points.append((x(degree), y(gap)))
            line = " ".join(f"{a:.1f},{b:.1f}" for a, b in points)
            out.append(f'<polyline points="{line}" fill="none" stroke="{colour}"/>'
                       f'<circle cx="{points[-1][0]:.1f}" cy="{points[-1][1]:.1f}" r="3" '
                       f'fill="{colour}"/>')
            out.append(f'<text x="{wide - 120}" y="{60 + 18 * RATIOS.index(ratio)}" '
                       f'fill="{colour}">ratio {ratio}</text>')
        out.append("</svg>")
        with open(f"{folder}/tooth_gap_{profile.name}.svg", "w", encoding="ascii") as file:
            file.write("\n".join(out) + "\n")


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    elif "--plot" in sys.argv[1:]:
        plot(sys.argv[sys.argv.index("--plot") + 1])
    else:
        publish(*tables())
