# SPDX-License-Identifier: Apache-2.0
"""Coupled drive: elastic ring on a cam bearing inside a circular spline, twist over torque.

Rim and outer race are one elastic ring, w(theta) outward and v(theta) tangential in N harmonics;
balls on a fixed cam and tooth flanks are unilateral; the circular spline may be a second ring.
The state is the minimum of the potential energy

    x.K.x/2 + sum_balls U(d) + sum_flanks V(u) - T c0/R ,

found by damped Newton on all Fourier coefficients with the dense Hessian, the load torque by
torque; the step is shortened towards the zero of the slope along it, nothing is added to gradient
or energy.  It stops at |gradient| <= 1e-12 of the contact forces or where rounding stops it, and
raises an error above 1e-11.  The cam amplitude A makes the mean of w at the two lobes the nominal
w0 at T = 0 (Newton on A, for the cracked drive as well; in the case "cage_phase" A is that with a ball at the lobe; in the case "deviations" A is that without them; in the cases "sound_cam" A is that of the
sound drive, and only cracks of rim and outer race act that the curvature of the sound assembled
ring opens).  There no flank may touch and the ring may
turn freely within the play: then c0(0) is the point of the play nearest to 0, where a vanishing
spring would hold it (the middle of the play of a sound drive).  Ring rotation is (c0(T) - c0(0))/R;
the twist adds T lambda, lambda of the members in series.

Independent: no condensation to the contacts, so no flexibility matrix and no complementarity; ball
force constants by Carlson's integrals; stiffness of the diaphragm's edge, and of barrel and rim
over their length, by a Rayleigh-Ritz method in Legendre polynomials instead of the four powers of r
and of power series from piece to piece; hinges and series members by quadrature; neighbouring teeth
of the circular spline as displacements of their own, whose layer comes from the equations of plane
elasticity by the matrix exponential, integrated over the wave number alone; contacts of half-path flanks from
points on the flanks and their velocities (tooth_gap.py), which leaves them 7 digits.

Units of everything: N, m, rad, Pa.  T1 = 51.7e3 Pa d^3, T2 = 187e3 Pa d^3, T3 = 1.6 T2 for pitch
diameter d = 2.54 mm x size, except where a table gives its torques.

    coupled_drive.py            JSON on stdout
    coupled_drive.py --write    and tests/data/coupled_drive*.csv; a minute
    coupled_drive.py --digits   change of the twist by another start, another order of torques
"""
import sys
from collections import namedtuple
from functools import cache
from math import asin, atan2, cos, floor, log, log10, pi, radians, sin, sqrt, tan

import numpy as np
from scipy.integrate import quad
from scipy.linalg import LinAlgError, block_diag, cho_factor, cho_solve, expm, inv
from scipy.optimize import brentq, minimize_scalar
from scipy.special import elliprd, elliprf

import tooth_gap



Drive = dict  # the inputs of one drive, see typical()
State = namedtuple("State", "x ball_force flank_force closing residual steps")
Hinge = namedtuple("Hinge", "member angle depth_ratio")  # member: rim, outer_race, circular_spline


def typical(size, ratio, **changes):
    """Proportions of a cup drive of 2 lobes by its size and ratio (all lengths in m)."""
    d = 2.54e-3 * size
    m = d / (2 * ratio)
    t_r = 1e-4 * (65 + 2.5 * ratio ** (2 / 3)) * d
    R = d / 2 - 1.1 * m - t_r / 2
    bore = 2 * R - t_r
    section = bore * (1 - 0.75) / 2
    ball = 0.61 * section
    pitch = bore - section
    drive = Drive(
        pitch_diameter=d, ratio=ratio, radial_displacement=m, rim_radius=R, rim_thickness=t_r,
        face_width=0.15 * d, barrel_thickness=0.6 * t_r, barrel_length=(0.42 - 0.15) * d,
        diaphragm_outer_radius=R, diaphragm_inner_radius=0.29 * d, diaphragm_thickness=0.012 * d,
        hat=False,
        ball_diameter=ball, ball_count=23, inner_race_diameter=pitch - ball,
        outer_race_diameter=pitch + ball, inner_conformity=0.53, outer_conformity=0.53,
        clearance=0.0, outer_race_thickness=(section - ball) / 2, race_width=0.15 * bore,
        groove_factor=0.8, flank_angle=radians(22), gap_factor=1.0, coning=1.0, lobe_gap=0.0,
        rim_stiffening=1.25, cam_factor=0.0, cage_phase=0.0, deviations={}, pair_stiffness=None, tooth=None, tips=None,
        spline_outer_diameter=1.34 * d, spline_inner_diameter=d + 2.2 * m, spline_width=0.15 * d,
        spline_support=0.0, youngs_modulus=206e9, poissons_ratio=0.3, diaphragm_warping=True,
        boss_compliance=0.0, flange_compliance=0.0, groove=None, diaphragm_arc=None,
        broken_teeth={}, ball_compliance={}, hinges=(), harmonics=32)
    assert not set(changes) - set(drive), changes
    if changes.get("tooth"):  # roots that the tips of the flexspline do not meet
        drive["spline_inner_diameter"] = d + 4.2 * m
    if changes.get("tooth") == "half_path":  # the mean angle, for the stiffness of a pair only
        h_a = 0.65 * m
        drive["flank_angle"] = atan2(tooth_gap.half_path(drawn(drive)[0], h_a), h_a)
    return drive | changes


# Members --------------------------------------------------------------------------------------

@cache
def legendre_tables(terms):
    """Gauss points, weights, the polynomials and two derivatives there."""
    legendre = np.polynomial.legendre
    s, weight = legendre.leggauss(terms + 12)
    unit = np.eye(terms)
    return s, weight, *(np.array([legendre.legval(s, legendre.legder(c, k)) for c in unit])
                        for k in range(3))


def plate_edge_stiffness(n, edge, clamped, thickness, E, nu, corner=0.0, terms=26):
    """Force per length times pi r_e over f(r_e): plate clamped at one radius, its other edge r_e
    f cos(n theta).  A spring holds the slope f' at n^2 f/r_e, the slope of a tube that warps by f.
    Twice the least energy with f(r_e) = 1, f = (r - r_c)^2 sum c_k P_k."""
    half = (edge - clamped) / 2
    s, weight, P, dP, ddP = legendre_tables(terms)
    r = clamped + half * (1 + s)
    q = 1 + s  # (r - r_c)/half
    f, df, ddf = q ** 2 * P, q ** 2 * dP + 2 * q * P, q ** 2 * ddP + 4 * q * dP + 2 * P
    df, ddf = df / half, ddf / half ** 2
    radial, hoop, twist = ddf, df / r - n * n * f / r ** 2, n * (df / r - f / r ** 2)
    measure = pi * r * weight * abs(half) * E * thickness ** 3 / (12 * (1 - nu ** 2))

    def energy(a, b):
        return (a * measure) @ b.T

    A = (energy(radial, radial) + energy(hoop, hoop) + nu * (energy(radial, hoop)
         + energy(hoop, radial)) + 2 * (1 - nu) * energy(twist, twist))
    k = np.arange(terms)
    at_edge = np.full(terms, 4.0)  # f(r_e) of each function
    slope = (2 * k * (k + 1) + 4) / half  # f'(r_e)
    off = slope - n * n * at_edge / edge
    A += pi * edge * corner * np.outer(off, off)
    scale = 1 / np.sqrt(np.diag(A))
    return 1 / (scale * at_edge @ np.linalg.solve(A * np.outer(scale, scale), scale * at_edge))


def bottom_stiffness(g, n):
    """Of the diaphragm's edge at the barrel, with the corner between plate and tube."""
    E, nu, t = g["youngs_modulus"], g["poissons_ratio"], g["barrel_thickness"]
    edges = g["diaphragm_outer_radius"], g["diaphragm_inner_radius"]
    corner = (2 * E * t ** 3 / (12 * (1 - nu ** 2))
              * (3 * (1 - nu ** 2) / (g["rim_radius"] * t) ** 2) ** 0.25)
    return plate_edge_stiffness(n, *(edges[::-1] if g["hat"] else edges), g["diaphragm_thickness"],
                                E, nu, corner)


def wall_mode(g, n, terms=48):
    """Twice the energy of barrel, tilting rim and bottom, that of the bottom, and the tilt, for
    cos(n theta) at mid-face.  Least energy of W = (1 - b tilt/2) x + x (1 - x) sum c_k P_k and
    psi = tilt + (1 - x) sum d_k P_k, x from the bottom over the barrel's length."""
    E, nu, R = g["youngs_modulus"], g["poissons_ratio"], g["rim_radius"]
    G, L, t, b = E / (2 * (1 + nu)), g["barrel_length"], g["barrel_thickness"], g["face_width"]
    s, weight, P, dP, _ = legendre_tables(terms)
    x, weight = (1 + s) / 2, weight * L / 2
    dP = 2 * dP / L
    none = np.zeros_like(P)
    one = np.ones_like(x)

    def table(W, psi, tilted, fixed):  # over the unknowns c, d, tilt and the constant part
        return np.vstack((W, psi, tilted, fixed))

    W = table(x * (1 - x) * P, none, -b / 2 * x, x)
    dW = table(x * (1 - x) * dP + (1 - 2 * x) / L * P, none, -b / 2 / L * one, one / L)
    psi = table(none, (1 - x) * P, one, 0 * one)
    dpsi = table(none, (1 - x) * dP - P / L, 0 * one, 0 * one)
    D, D_r = (E * h ** 3 / (12 * (1 - nu ** 2)) for h in (t, g["rim_thickness"]))
    turn, hoop = 2 * (1 - nu) * ((n - 1 / n) / R) ** 2, ((n * n - 1) / R ** 2) ** 2
    A = np.zeros((2 * terms + 2, 2 * terms + 2))
    for factor, strain in ((E * t * (R / n ** 2) ** 2, dpsi), (G * t / n ** 2, dW - psi),
                           (turn * D, dW), (hoop * D, W)):
        A += pi * R * factor * (strain * weight) @ strain.T
    A[-2, -2] += pi * R * D_r * (turn * b + hoop * b ** 3 / 12)
    k = bottom_stiffness(g, n) * (R / n ** 2) ** 2 if g["diaphragm_warping"] else 0.0
    slope = np.concatenate((np.zeros(terms), (-1.0) ** np.arange(terms), [1.0, 0.0]))
    A += k * np.outer(slope, slope)
    scale = 1 / np.sqrt(np.diag(A))
    A *= np.outer(scale, scale)
    y = -cho_solve(cho_factor(A[:-1, :-1]), A[:-1, -1])
    state = scale * np.append(y, 1.0)
    whole = (A[-1, -1] + A[-1, :-1] @ y) / scale[-1] ** 2
    bottom = k * (slope @ state / state[-1]) ** 2
    return whole, bottom, state[-2] / state[-1]


def ring_stiffness(g, n):
    """kb_n: bending of rim and race, barrel, diaphragm, for amplitude 1 of cos(n theta)."""
    k = pi * bending_stiffness(g) / g["rim_radius"] ** 3 * (1 - n * n) ** 2
    return k + (wall_mode(g, n)[0] if n >= 2 else 0.0)


def coning(g):
    """Growth of the wave along the axis."""
    return g["coning"] * g["radial_displacement"] * wall_mode(g, 2)[2]


def strip_bending(E, width, thickness):
    return E * width * thickness ** 3 / 12


def bending_stiffness(g):
    E = g["youngs_modulus"]
    return (strip_bending(E, g["face_width"], g["rim_thickness"]) * g["rim_stiffening"]
            + strip_bending(E, g["race_width"], g["outer_race_thickness"]) * g["groove_factor"])


def hinge_compliance(depth_ratio, width, thickness, E, nu):
    """Angle per moment of an edge crack through the width of a strip, (FR-11) in bending."""
    c = (1.1215, -3.0255, 9.8273, -28.6524, 61.7662, -89.4007, 81.0079, -41.2108, 8.9402)

    def integrand(x):
        return x * np.polyval(c[::-1], x) ** 2 / (1 - x) ** 3

    integral, _ = quad(integrand, 0, depth_ratio, epsabs=0, epsrel=1e-13)
    return 72 * pi * (1 - nu ** 2) / (E * width * thickness ** 2) * integral


def ball_race_constant(diameter, race_diameter, conformity, convex, E, nu):
    """c of approach = c Q^(2/3)."""
    rolling = 2 / diameter + (2 if convex else -2) / race_diameter
    across = 2 / diameter - 1 / (conformity * diameter)
    small, large = sorted((rolling, across))

    def potential_ratio(s):  # major semi-axis 1, minor s: ratio of the curvatures
        return elliprd(0, s * s, 1) / elliprd(0, 1, s * s)

    s = brentq(lambda s: potential_ratio(s) - small / large, 1e-3, 1, xtol=1e-15, rtol=1e-15)
    contact_modulus = E / (2 * (1 - nu ** 2))
    a = (elliprd(0, s * s, 1) / (pi * contact_modulus * small)) ** (1 / 3)  # at Q = 1
    return 3 / (2 * pi * contact_modulus * a) * elliprf(0, 1, s * s)


def structure_compliance(g):
    """Barrel, a third of the rim, diaphragm, boss, flange and cracks in series, rad/(N*m)."""
    E, nu = g["youngs_modulus"], g["poissons_ratio"]
    G = E / (2 * (1 + nu))

    def tube(length, thickness):
        middle = 2 * g["rim_radius"]
        J = pi / 32 * ((middle + thickness) ** 4 - (middle - thickness) ** 4)
        return length / (G * J)

    edges = [g["diaphragm_inner_radius"], g["diaphragm_outer_radius"]]
    depth = 0.0
    if g["groove"]:  # radius of its middle, width, depth
        radius, width, depth = g["groove"]
        edges[1:1] = [radius - width / 2, radius + width / 2]
    total = (tube(g["barrel_length"], g["barrel_thickness"])
             + tube(g["face_width"] / 3, g["rim_thickness"])
             + g["boss_compliance"] + g["flange_compliance"])
    for j, (low, high) in enumerate(zip(edges, edges[1:])):
        h = g["diaphragm_thickness"] - (depth if j == 1 else 0)
        total += quad(lambda r: 1 / (2 * pi * G * r ** 3 * h), low, high, epsabs=0,
                      epsrel=1e-13)[0]
    if g["diaphragm_arc"]:  # half length, radius
        a, r = g["diaphragm_arc"]
        total += a ** 2 / (2 * pi * E * r ** 4 * g["diaphragm_thickness"])
    return total


def flank_gap(t, angle, w0, factor=1.0):
    opening = (1 - np.cos(2 * t)) * sin(angle) - (t - np.sin(2 * t) / 2) * cos(angle)
    return factor * w0 * np.maximum(0, opening)


def drawn(g):
    """Drive and tooth as tooth_gap.py takes them."""
    m, R, w0 = g["pitch_diameter"] / (2 * g["ratio"]), g["rim_radius"], g["radial_displacement"]
    drive = tooth_gap.Drive(g["ratio"], m, w0, R, g["pitch_diameter"] / 2 - R)
    if g["tooth"] == "half_path":
        return drive, tooth_gap.HALF_PATH
    return drive, tooth_gap.Profile(g["tooth"], g["flank_angle"], 0.65, 0.65)


def half_path_contact(drive, profile, t):
    """Distance of tooth and wall, angle of the common normal and height of the contact.

    The point of contact comes from the velocities of the points of the tooth, the distance of the
    opening side from points on both flanks.  Where the edge of the tip touches or is nearest, the
    force has the direction of the tooth's flank at its tip."""
    tip = profile.flexspline_addendum * drive.module
    distance, at_tip = 0.0, False
    if t < 0:
        tooth = tooth_gap.placed(drive, t, tooth_gap.tooth_flank(drive, profile))
        space = tooth_gap.space_flank(drive, profile)
        pairs = [tooth_gap.to_chords(tooth, space)]
        value, q, p = tooth_gap.to_chords(space, tooth)
        distance, p, _ = min(pairs + [(value, p, q)], key=lambda pair: pair[0])
        at_tip = np.hypot(*(p - tooth[-1])) < 1e-6 * drive.module
    points = [] if at_tip else [x for x in tooth_gap.contact_points(drive, profile, abs(t))
                                if 1e-3 * drive.module < x[0] < tip]
    if points:
        height, _, _, angle = points[0]
        return distance, angle, height
    tiny = 1e-6 * drive.module  # one-sided at the tip, of the second order
    x = [float(tooth_gap.half_thickness(drive, profile, tip - k * tiny)) for k in range(3)]
    slope = (3 * x[0] - 4 * x[1] + x[2]) / (2 * tiny)
    return distance, atan2(-slope, 1) - tooth_gap.pose(drive, t)[2], tip


def half_path_teeth(g, t):
    """As drawn_teeth, and angle and height of each contact."""
    drive, profile = drawn(g)
    cone, R = coning(g), g["rim_radius"]

    @cache
    def at(x):
        distance, angle, height = half_path_contact(drive, profile, x)
        lever = 3 * (drive.offset + height) / R
        slope = cone * abs(sin(angle) * cos(2 * x) - (1 - lever) / 2 * sin(2 * x) * cos(angle))
        return distance - slope * g["face_width"] / 2, slope, angle, height

    play = -at(0.0)[0]  # seated at the lobe
    gap, slope, angle, height = np.array([at(round(float(x), 12)) for x in t]).T
    return np.maximum(gap + play, 0.0), slope, angle, height


def drawn_teeth(g, t):
    """Gap at the end of the face that touches first, and growth of the gap along the face, of the
    flanks at the angles t; the end of the engagement comes from the pose of a tip."""
    drive, profile = drawn(g)
    b, cone = g["face_width"], coning(g)
    lever = 3 * (drive.offset + 0.65 * drive.module) / drive.radius

    def slope(t):
        return cone * abs(
            sin(profile.flank_angle) * cos(2 * t)
            - (1 - lever) / 2 * sin(2 * t) * cos(profile.flank_angle))

    def gap(t, play):
        return tooth_gap.LAWS[g["tooth"]](drive, profile, float(t), play)[0] - slope(t) * b / 2

    angles = np.linspace(-pi / 6, pi / 6, 241)
    k = int(np.argmin([gap(x, 0.0) for x in angles]))
    play = -minimize_scalar(lambda x: gap(x, 0.0), method="bounded", options={"xatol": 1e-8},
                            bounds=(angles[max(k - 1, 0)], angles[min(k + 1, 240)])).fun
    return np.array([max(gap(x, play), 0.0) for x in t]), np.array([slope(x) for x in t])


def drawn_end(g):
    """The angle at which the tip of the tooth is as high as the tip of the circular spline's."""
    drive, profile = drawn(g)
    m = drive.module
    across = (tooth_gap.half_thickness(drive, profile, 0.65 * m) if g["tooth"] == "half_path"
              else (pi / 4 - 0.65 * tan(g["flank_angle"])) * m)
    tip = np.array([[float(across), drive.offset + 0.65 * m]])

    def above(t):
        return tooth_gap.placed(drive, t, tip)[0, 1] - tooth_gap.pitch_height(drive) + 0.65 * m

    return brentq(above, 0.1, 1.5, xtol=1e-13)


def widest_gap(g):
    """The first angle at which the gap of a leaving drive flank is largest."""
    drive, profile = drawn(g)
    return minimize_scalar(lambda t: -tooth_gap.LAWS[g["tooth"]](drive, profile, t, 0.0)[0],
                           method="bounded", bounds=(radians(25), drawn_end(g)),
                           options={"xatol": 1e-10}).x


def wall_compliance(alpha, s, h_f, t, nu):
    """Tooth on a wall, lengths over the module, times E (TC-30); beam terms by quadrature."""
    B = s + 2 * h_f * tan(alpha)
    x, q, l = (h_f - s * tan(alpha) / 2) / B, s / (B * cos(alpha) ** 2), t / B
    layer = 2 * (1 - nu ** 2) / pi
    height = B * (1 - q) / (2 * tan(alpha))
    bending, shear, pressure = (quad(lambda y: f(y, B - 2 * y * tan(alpha)), 0, height, epsrel=1e-12)[0]
                                for f in (lambda y, W: 12 * (1 - nu ** 2) * (height - y) ** 2 / W ** 3,
                                          lambda y, W: 2.4 * (1 + nu) / W,
                                          lambda y, W: (1 - nu ** 2) / W))
    return (cos(alpha) ** 2 * (bending + shear + 4.84 * (x + 0.26) ** 2 * l / (l + 0.44)
                               - 2.87 * x - 0.54 * q + layer * log(1 + 2.12 * l))
            + sin(alpha) ** 2 * (pressure + layer * log(1 + 6.17 * l)))


def drawn_extension(g):
    """EA of the toothed rim over that of the bare rim."""
    m = g["pitch_diameter"] / (2 * g["ratio"])
    h_f = g["pitch_diameter"] / 2 - g["rim_radius"] - g["rim_thickness"] / 2
    B = pi / 2 * m + 2 * h_f * tan(g["flank_angle"])
    return 1 / (1 - 0.523 * B / (pi * m) * (1 - 1 / (1 + 0.175 * B / g["rim_thickness"])))


SHORTEST = 20.0  # wave number times thickness from which a layer is a half-plane


@cache
def layer_waves():
    """Waves on a plane layer of thickness 1 on a smooth rigid base, E/(1 - nu^2) = 1/2 per wave number:
    nodes, weights, tangential motion under a shear wave less that of a bar, radial motion under a
    pressure, radial motion under a shear wave less that of a bar.

    (u, v, sigma, tau) over the depth obey four equations of the first order; u and sigma are free at the
    base."""
    nu = 0.3  # none of the results depends on it
    mu, lame = 1 / (2 * (1 + nu)), nu / ((1 + nu) * (1 - 2 * nu))
    both = lame + 2 * mu
    A = np.array([[0, 1, 0, 1 / mu], [-lame / both, 0, 1 / both, 0], [0, 0, 0, -1],
                  [both - lame ** 2 / both, 0, lame / both, 0]])
    x, w = np.polynomial.legendre.leggauss(25)
    panels, half = np.arange(40) * SHORTEST / 40, SHORTEST / 80
    K = (panels[:, None] + half * (1 + x)).ravel()
    shear, press, mixed = [], [], []
    for k in K:
        edge = expm(A * k)[:, [0, 2]]
        u, v = (edge @ np.linalg.solve(edge[2:], [0, 1]))[:2]
        down = -(edge @ np.linalg.solve(edge[2:], [-1, 0]))[1]
        shear.append(u / (2 * (1 - nu ** 2)) - 1 / (2 * k))
        press.append(down / (2 * (1 - nu ** 2)))
        mixed.append((v + nu * (1 + nu)) / (1 - nu ** 2))
    return K, np.tile(half * w, len(panels)), np.array(shear), np.array(press), np.array(mixed)


def neighbour_table(wall, root, lever, count):
    """Motion of a tooth 1 to `count` pitches from a loaded one, lengths over the module, over
    2(1 - nu^2)/(pi E b): tangential under a tangential force, radial under a radial one, radial under a
    tangential one."""
    places = pi * np.arange(1, count + 1)
    K, weight, shear, press, mixed = layer_waves()
    k = K / wall
    a = k * root / 2
    even, linear = np.sin(a) / a, 3 * (np.sin(a) - a * np.cos(a)) / a ** 3
    linear = np.where(a < 0.02, 1 - a ** 2 / 10 + a ** 4 / 280, linear) * k * lever
    cosine, sine, weight = np.cos(np.outer(places, k)), np.sin(np.outer(places, k)), weight / K
    out = [cosine @ (weight * (shear * even ** 2 + mixed * even * linear + press * linear ** 2)),
           cosine @ (weight * press * even ** 2),
           sine @ (weight * (mixed * even ** 2 / 2 + press * even * linear))]
    # From k_0 on, along k_0 + i s, where the waves decrease: exp(i k y) for y = x, x + B, x - B.
    tau = np.arange(-4.2, 4.2, 0.03)
    s = np.exp(pi / 2 * np.sinh(tau))
    k0 = SHORTEST / wall
    k = k0 * (1 + 1j * s)
    step = 1j * k0 * 0.03 * s * pi / 2 * np.cosh(tau)
    a = k * root / 2
    for shift in (0, 1, -1):
        # coefficients of exp(2 i a shift) in the squares and products of sin a and cos a
        sin_sin = 0.5 if shift == 0 else -0.25
        sin_cos = 0 if shift == 0 else -0.25j * shift
        cos_cos = abs(sin_sin)
        even_even = sin_sin / a ** 2
        even_linear = 3 * (sin_sin - a * sin_cos) / a ** 4 * k * lever
        linear_linear = 9 * (sin_sin - 2 * a * sin_cos + a * a * cos_cos) / a ** 6 * (k * lever) ** 2
        waves = np.exp(1j * np.outer(places + shift * root, k)) * (step / k)
        out[0] += (waves @ ((1 - 1 / (2 * k * wall)) * even_even + even_linear + linear_linear)).real
        out[1] += (waves @ even_even).real
        out[2] += (waves @ (even_even / 2 + even_linear)).imag
    return out


def spline_teeth(g):
    """Module; wall of the circular spline and dedendum of its teeth over the module."""
    m = g["pitch_diameter"] / (2 * g["ratio"])
    wall = (g["spline_outer_diameter"] - g["spline_inner_diameter"]) / 2
    dedendum = (g["spline_inner_diameter"] - g["pitch_diameter"]) / 2 - g["radial_displacement"]
    return m, wall / m, dedendum / m


def neighbour_compliance(g, tooth, side, angle):
    """Motion of each flank under a force on another one through the circular spline (TC-31)."""
    _, wall, dedendum = spline_teeth(g)
    alpha, z = g["flank_angle"], round(2 * g["ratio"])
    table = neighbour_table(wall, pi / 2 + 2 * dedendum * tan(alpha),
                            dedendum - pi / 4 * tan(alpha), z // 2)
    along, outward, mixed = (np.concatenate(([0.0], column)) for column in table)
    place = tooth + side / 2  # of the tooth of the circular spline that the flank presses
    apart = np.round(place[:, None] - place).astype(int)
    apart = (apart + z // 2) % z - z // 2
    n = np.minimum(abs(apart), z // 2)
    across, up = np.cos(angle) * side, np.sin(angle)
    motion = (np.outer(across, across) * along[n] + np.outer(up, up) * outward[n]
              + (np.outer(up, across) - np.outer(across, up)) * np.sign(apart) * mixed[n])
    E, nu = g["youngs_modulus"], g["poissons_ratio"]
    return 2 * (1 - nu ** 2) / (pi * E * g["face_width"]) * motion


def drawn_pair(g):
    """c' of drawn teeth by (TC-30)."""
    d, nu, E, alpha = g["pitch_diameter"], g["poissons_ratio"], g["youngs_modulus"], g["flank_angle"]
    m, wall, dedendum = spline_teeth(g)
    b = g["face_width"]
    h_f = d / 2 - g["rim_radius"] - g["rim_thickness"] / 2
    T2, z = 187e3 * d ** 3, 2 * g["ratio"]
    force = T2 / (d / 2 * cos(alpha) * z / 6 * b)
    a = sqrt(8 * (1 - nu ** 2) * force * d / 2 * sin(alpha) / (pi * E))
    contact = 4 * (1 - nu ** 2) / pi * (np.log(pi / 2 * m / cos(alpha) / a) + 0.045)
    step = cos(alpha) ** 2 * pi / 12 * m / g["rim_thickness"] / drawn_extension(g)
    return E / (wall_compliance(alpha, pi / 2, h_f / m, g["rim_thickness"] / m, nu)
                + wall_compliance(alpha, pi / 2, dedendum, wall, nu) + contact + step)


def touching(state):
    """Flanks that carry more than the rounding of a force."""
    return state.flank_force > 1e-10 * state.ball_force.max()


def pair_stiffness(g):
    if g["pair_stiffness"]:
        return g["pair_stiffness"]
    if g["tooth"]:
        return drawn_pair(g)
    module = g["pitch_diameter"] / (2 * g["ratio"])
    return g["youngs_modulus"] / (
        3.296 + 3.09 * module / g["rim_thickness"] + 3.605 + 2.472)


# Deviations of the parts, in um; angles in rad.  Tooth or ball k: amplitude sin(rate k + phase).
WAVY = dict(position=(1.5, 1.3, 0.4), thickness=(1.0, 2.1, 1.2), spline_position=(1.2, 0.9, 2.0),
            spline_thickness=(0.8, 1.7, 1.0), ball=(0.4, 2.3, 0.0), eccentricity=2.0, direction=0.7,
            pairing_gap=3.0)


def wave(deviations, part, number):
    amplitude, rate, phase = deviations[part]
    return 1e-6 * amplitude * np.sin(rate * number + phase)


def wavy_flanks(g, index, theta, side):
    """Distance by which wavy teeth close the gaps, normal to the flanks.  A tooth meets the teeth of
    the circular spline that stand next to its own displaced place."""
    of, z = g["deviations"], round(2 * g["ratio"])
    pitch = 2 * pi / (z + 2)
    place = theta - g["radial_displacement"] / (2 * g["rim_radius"]) * np.sin(2 * theta)
    # tooth k of the circular spline stands at (k + 1) pitches
    met = (np.ceil(place / pitch) if side > 0 else np.floor(place / pitch)).astype(int) - 1
    met %= z + 2
    flank = side * wave(of, "position", index) + wave(of, "thickness", index) / 2
    facing = -side * wave(of, "spline_position", met) + wave(of, "spline_thickness", met) / 2
    return cos(g["flank_angle"]) * (flank + facing) - 1e-6 * of["pairing_gap"]


# The coupled solve ----------------------------------------------------------------------------

class Coupled:
    """Energy of one drive in the coefficients (a0, c0, a_n, b_n, c_n, d_n; spline a_n, b_n; of drawn
    teeth, the displacements of the circular spline's flanks)."""

    def __init__(self, drive, tolerance=1e-12):
        self.g, self.N, self.tolerance = drive, drive["harmonics"], tolerance
        self.n = np.arange(1, self.N + 1)
        self.ring = 2 + 4 * self.N
        self.rings = self.ring + (2 * (self.N - 1) if drive["spline_support"] else 0)
        self.size = self.rings
        self.R = drive["rim_radius"]
        self.K = self.stiffness_matrix()
        self.balls()
        self.flanks()
        self.moved = 0.0
        if drive["tooth"]:
            self.neighbours()
        self.lambda_s = structure_compliance(drive)
        self.start = None  # assembled state

    def part(self, letter):
        return slice(2 + self.N * "abcd".index(letter), 2 + self.N * ("abcd".index(letter) + 1))

    def rows(self, theta, **parts):
        """Rows with cos/sin factors: parts maps a letter to an array over n; zero = (a0, c0)."""
        theta = np.atleast_1d(theta)
        out = np.zeros((len(theta), self.size))
        for letter, table in parts.items():
            out[:, self.part(letter)] = table
        return out

    def radial(self, theta):
        phase = np.outer(theta, self.n)
        out = self.rows(theta, a=np.cos(phase), b=np.sin(phase))
        out[:, 0] = 1
        return out

    def radial_slope(self, theta):
        phase = np.outer(theta, self.n)
        return self.rows(theta, a=-self.n * np.sin(phase), b=self.n * np.cos(phase))

    def tangential(self, theta):
        phase = np.outer(theta, self.n)
        out = self.rows(theta, c=np.cos(phase), d=np.sin(phase))
        out[:, 1] = 1
        return out

    def stiffness_matrix(self):
        g, R, n = self.g, self.R, self.n
        E, nu = g["youngs_modulus"], g["poissons_ratio"]
        K = np.zeros((self.size, self.size))
        EA = E * g["face_width"] * g["rim_thickness"] * (drawn_extension(g) if g["tooth"] else 1)
        K[0, 0] = 2 * pi * (EA / R + bending_stiffness(g) / R ** 3)
        a, b, c, d = (np.arange(self.size)[self.part(p)] for p in "abcd")
        bend, ke = np.array([ring_stiffness(g, k) for k in n]), pi * EA / R
        for radial, along, sign in ((a, d, 1), (b, c, -1)):
            K[radial, radial] = bend + ke
            K[along, along] = ke * n ** 2
            K[radial, along] = K[along, radial] = sign * ke * n
        lateral = pi / 2 * E / (2 * (1 + nu)) * R * g["barrel_thickness"] / g["barrel_length"]
        for p in (a, b, c, d):
            K[p[0], p[0]] += lateral
        if g["spline_support"]:
            m = n[1:]
            t, radius = self.spline_ring()
            k = (pi * strip_bending(E, g["spline_width"], t) / radius ** 3 * (m ** 2 - 1) ** 2
                 / g["spline_support"])
            spline = np.arange(self.ring, self.size)
            K[spline, spline] = np.concatenate((k, k))
        for hinge in g["hinges"]:
            row, alpha = self.hinge(hinge)
            K -= alpha * np.outer(row, row)
        return K

    def spline_ring(self):
        outer, inner = self.g["spline_outer_diameter"], self.g["spline_inner_diameter"]
        return (outer - inner) / 2, (outer + inner) / 4

    def hinge(self, hinge):
        g, E, nu = self.g, self.g["youngs_modulus"], self.g["poissons_ratio"]
        radius, n, more = self.R, self.n, 1.0
        if hinge.member == "rim":
            width, t, factor = g["face_width"], g["rim_thickness"], g["rim_stiffening"]
        elif hinge.member == "outer_race":
            width, t, factor = g["race_width"], g["outer_race_thickness"], g["groove_factor"]
        else:
            t, radius = self.spline_ring()
            width, factor, n, more = g["spline_width"], 1.0, n[1:], g["spline_support"]
        stiffness = strip_bending(E, width, t) * factor / more
        c_M = hinge_compliance(hinge.depth_ratio, width, t, E, nu) * more
        length = 2 * t
        alpha = (stiffness - stiffness / (1 + c_M * stiffness / length)) * length
        mean = (1 - n ** 2) / radius ** 2 * np.sinc(n * length / (2 * radius) / pi)
        row = np.zeros(self.size)
        waves = np.concatenate((mean * np.cos(n * hinge.angle), mean * np.sin(n * hinge.angle)))
        if hinge.member == "circular_spline":
            row[self.ring:self.rings] = waves
        else:
            row[2:2 + 2 * self.N] = waves
        return row, alpha

    def opens(self, hinge):
        """Whether the curvature of the assembled ring opens a crack; more curvature opens a crack from outside."""
        if hinge.member == "circular_spline":
            return True
        flatter = self.hinge(hinge)[0] @ self.start.x
        return flatter < 0 if hinge.member == "rim" else flatter > 0

    def balls(self):
        g = self.g
        E, nu, D = g["youngs_modulus"], g["poissons_ratio"], g["ball_diameter"]
        psi = g["cage_phase"] + 2 * pi * np.arange(g["ball_count"]) / g["ball_count"]
        self.ball_rows = self.radial(psi)
        self.cam = np.cos(2 * psi)
        self.ball_free = (g["clearance"] + g["cam_factor"] * g["radial_displacement"] ** 2 / self.R
                          * np.sin(2 * psi) ** 2)
        if g["deviations"]:
            of = g["deviations"]
            self.ball_free -= (wave(of, "ball", np.arange(len(psi)))
                               + 1e-6 * of["eccentricity"] * np.cos(psi - of["direction"]))
        self.hertz = (
            ball_race_constant(D, g["inner_race_diameter"], g["inner_conformity"], True, E, nu)
            + ball_race_constant(D, g["outer_race_diameter"], g["outer_conformity"], False, E, nu))
        self.series = np.zeros(len(psi))
        for k, compliance in g["ball_compliance"].items():
            self.series[k] = compliance

    def flanks(self):
        g, R, w0 = self.g, self.R, self.g["radial_displacement"]
        count = round(2 * g["ratio"])
        index = np.arange(count)
        theta = (index + 0.5) * 2 * pi / count
        t = np.remainder(theta + pi / 2, pi) - pi / 2
        end = pi / 4
        if g["tooth"]:
            end = widest_gap(g) if g["tips"] else drawn_end(g)
        near = np.abs(t) <= end * (1 + 1e-12)  # a tooth at 45 degrees counts
        index, theta, t = index[near], theta[near], t[near]
        nominal = np.zeros(self.size)
        nominal[self.part("a")][1] = w0
        nominal[self.part("d")][1] = -w0 / 2
        self.nominal = nominal
        rows, free, slopes, angles = [], [], [], []
        cone = coning(g)
        for side in (1, -1):
            angle, height = np.full(len(t), g["flank_angle"]), np.zeros(len(t))
            if g["tooth"] == "half_path":
                gap, slope, angle, height = half_path_teeth(g, side * t)
            elif g["tooth"]:
                gap, slope = drawn_teeth(g, side * t)
            else:
                gap = flank_gap(side * t, g["flank_angle"], w0, g["gap_factor"])
                slope = np.full(len(t), cone * sin(g["flank_angle"]))
            slopes.append(slope)
            angles.append(angle)
            along, radial = self.motion(theta, g["pitch_diameter"] / 2 + height)
            across, up = side * np.cos(angle)[:, None], np.sin(angle)[:, None]
            rows.append(across * along + up * radial)
            on_ring = np.where(np.arange(self.size) < self.ring, rows[-1], 0)
            free.append(on_ring @ nominal + gap + g["lobe_gap"])
            if g["deviations"]:
                free[-1] -= wavy_flanks(g, index, theta, side)
        self.flank_rows, self.flank_free = np.vstack(rows), np.concatenate(free)
        self.teeth = len(index)
        self.health = np.ones(self.teeth)
        for j, loss in g["broken_teeth"].items():
            self.health[index == j] -= loss
        self.health = np.tile(self.health, 2)
        self.pair = pair_stiffness(g)
        self.slope = np.concatenate(slopes)
        self.angle = np.concatenate(angles)
        self.index = index

    def motion(self, theta, radius):
        """Tangential and radial motion of points of the ring at given radii, less that of the
        circular spline."""
        lever = (radius / self.R - 1)[:, None]
        along = self.tangential(theta) * (1 + lever) - self.radial_slope(theta) * lever
        radial = self.radial(theta)
        if self.g["spline_support"]:
            _, spline = self.spline_ring()
            m = self.n[1:]
            lever = (radius / spline - 1)[:, None]
            cosine, sine = np.cos(np.outer(theta, m)), np.sin(np.outer(theta, m))
            w_c, slope = np.hstack((cosine, sine)), np.hstack((-m * sine, m * cosine))
            v_c = np.hstack((-sine / m, cosine / m))
            along[:, self.ring:] = -(v_c * (1 + lever) - slope * lever)
            radial[:, self.ring:] = -w_c
        return along, radial

    def neighbours(self):
        """A displacement of the circular spline for each flank.  The flank's own force moves it by
        `moved`, which its law gives back, so that only the forces of the others count."""
        side = np.repeat([1, -1], self.teeth)
        C = neighbour_compliance(self.g, np.tile(self.index, 2), side, self.angle)
        self.moved = 0.6 / (self.pair * self.g["face_width"])
        self.K = block_diag(self.K, inv(C + self.moved * np.eye(len(side))))
        self.flank_rows = np.hstack((self.flank_rows, -np.eye(len(side))))
        self.ball_rows = np.hstack((self.ball_rows, np.zeros((len(self.ball_rows), len(side)))))
        self.nominal = np.concatenate((self.nominal, np.zeros(len(side))))
        self.size += len(side)

    def ball_law(self, d):
        """Force and its derivative at closing d."""
        d = np.maximum(d, 0)
        force = (d / self.hertz) ** 1.5
        rate = 1.5 * np.sqrt(d / self.hertz) / self.hertz
        for k in np.flatnonzero((self.series > 0) & (d > 0)):
            q = force[k] ** (1 / 3)  # series q^3 + hertz q^2 = d, convex: from above
            for _ in range(60):
                excess = (self.series[k] * q + self.hertz) * q * q - d[k]
                step = excess / ((3 * self.series[k] * q + 2 * self.hertz) * q)
                q -= step
                if abs(step) < 1e-16 * q:
                    break
            force[k] = q ** 3
            rate[k] = 1 / (self.series[k] + 2 * self.hertz / (3 * q))
        return force, rate

    def flank_law(self, u):
        b, s, back = self.g["face_width"], self.slope, self.moved
        u = np.maximum(u, 0)
        k = self.health * self.pair
        some = np.maximum(s, 1e-30)
        # u + back F is the closing of the law
        part = 2 * u / (1 + np.sqrt(np.maximum(1 - 2 * back * k * u / some, 0)))
        full = (u - back * k * s * b * b / 2) / (1 - back * k * b)
        whole = (u > 0) & (u >= s * b * (1 - back * k * b / 2))
        u = np.where(whole, full, part)
        force = k * np.where(whole, b * (u - s * b / 2), u * u / (2 * some))
        rate = k * np.where(whole, b, u / some)
        return force, rate / (1 - back * rate)

    def gradient(self, x, torque, amplitude):
        d = amplitude * self.cam - self.ball_free - self.ball_rows @ x
        u = self.flank_rows @ x - self.flank_free
        Q, q_rate = self.ball_law(d)
        F, f_rate = self.flank_law(u)
        push = F @ self.flank_rows - Q @ self.ball_rows
        push[1] -= torque / self.R
        return self.K @ x + push, q_rate, f_rate, (Q, F, u)

    def factor(self, q_rate, f_rate):
        balls, flanks = q_rate > 0, f_rate > 0
        J = np.vstack((self.ball_rows[balls], self.flank_rows[flanks]))
        H = self.K + (J.T * np.concatenate((q_rate[balls], f_rate[flanks]))) @ J
        shift = 0.0
        while True:  # a ring free to turn has a singular Hessian: only the step is damped
            try:
                return cho_factor(H + shift * np.diag(np.diag(H) + H[0, 0]))
            except LinAlgError:
                shift = max(10 * shift, 1e-14)

    def solve(self, x, torque, amplitude, limit=400):
        g, q_rate, f_rate, forces = self.gradient(x, torque, amplitude)
        best = None
        for step_number in range(limit):
            Q, F, u = forces
            scale = max(abs(torque) / self.R, np.linalg.norm(Q), np.linalg.norm(F), 1e-300)
            residual = np.linalg.norm(g) / scale
            if best is None or residual < best.residual:
                best, stalled = State(x, Q, F, u, residual, step_number), 0
            else:
                stalled += 1
            if residual <= self.tolerance or (best.residual < 1e-10 and stalled > 3):
                break
            dx = -cho_solve(self.factor(q_rate, f_rate), g)
            low, slope_low, a = 0.0, g @ dx, 1.0
            high = None
            if slope_low >= 0:  # rounding
                break
            first = slope_low
            for _ in range(60):  # energy is convex: towards the zero of its slope along dx
                trial = self.gradient(x + a * dx, torque, amplitude)
                slope = trial[0] @ dx
                if slope <= -0.5 * first and (a == 1 or abs(slope) <= -0.5 * first):
                    break
                if slope > 0:
                    high, slope_high = a, slope
                else:
                    low, slope_low = a, slope
                secant = low - slope_low * (high - low) / (slope_high - slope_low)
                a = min(max(secant, low + 0.1 * (high - low)), high - 0.1 * (high - low))
            x = x + a * dx
            g, q_rate, f_rate, forces = trial
        if best.residual > max(1e-11, 10 * self.tolerance):
            raise ArithmeticError(f"no equilibrium: {best.residual:.1e} after {best.steps} steps")
        return best

    def assemble(self, amplitude=None):
        """The cam amplitude whose lobes have the mean w0 at no torque, and that state; or the
        state on a cam of a given amplitude."""
        if amplitude:
            state = self.solve(self.nominal, 0.0, amplitude)
            if not touching(state).any():
                state = self.middle_of_play(state, amplitude)
            self.amplitude, self.start = amplitude, state
            return state
        w0 = self.g["radial_displacement"]
        lobes = self.radial(np.array([0, pi])).mean(axis=0)
        amplitude, x = 1.02 * w0, self.nominal
        for _ in range(30):
            state = self.solve(x, 0.0, amplitude)
            x = state.x
            error = w0 - lobes @ x
            _, q_rate, f_rate, _ = self.gradient(x, 0.0, amplitude)
            growth = lobes @ cho_solve(self.factor(q_rate, f_rate),
                                       (q_rate * self.cam) @ self.ball_rows)
            if abs(error) <= 1e-14 * w0:
                break
            amplitude += error / growth
        if abs(error) > 1e-12 * w0:
            raise ArithmeticError(f"lobe off by {error / w0:.1e} of w0")
        if not touching(state).any():
            state = self.middle_of_play(state, amplitude)
        self.amplitude, self.start = amplitude, state
        return state

    def middle_of_play(self, state, amplitude):
        """The same state turned to c0 = 0, or as near to it as the flanks let it."""
        x = state.x.copy()
        touches = x[1] - state.closing / self.flank_rows[:, 1]  # c0 at which each flank touches
        x[1] = min(max(0.0, touches[self.teeth:].max()), touches[:self.teeth].min())
        g, _, _, (Q, F, u) = self.gradient(x, 0.0, amplitude)
        return State(x, Q, F, u, np.linalg.norm(g) / np.linalg.norm(Q), state.steps)

    def curve(self, torques):
        """Ring rotation, twist and state at each torque, each from the one before."""
        if self.start is None:
            self.assemble()
        x, result = self.start.x, []
        for torque in torques:
            state = self.solve(x, torque, self.amplitude)
            x = state.x
            rotation = (x[1] - self.start.x[1]) / self.R
            result.append((rotation, rotation + torque * self.lambda_s, state))
        return result


# Tables ---------------------------------------------------------------------------------------

SIZES = ((14, 50), (14, 80), (14, 100), (25, 50), (25, 50.5), (25, 100), (25, 160), (50, 50),
         (50, 100), (50, 160))  # 50.5: an odd number of teeth
SOURCE = "dense Newton"


def torques(drive):
    d3 = drive["pitch_diameter"] ** 3
    T1, T2 = 51.7e3 * d3, 187e3 * d3
    return [T1 / 4, T1 / 2, T1, T2, 1.6 * T2]


def plain(**changes):
    return dict(diaphragm_warping=False) | changes


CASES = {  # case: changes of the typical drive, sign of the torque
    "sound": (plain(), 1),
    "sound_warping_support": (dict(spline_support=0.5), 1),
    "tooth": (plain(broken_teeth={0: 0.5}), 1),
    "tooth_reversed": (plain(broken_teeth={0: 0.5}), -1),
    "rim_hinge": (plain(hinges=(Hinge("rim", 0.3, 0.5),)), 1),
    "outer_race_hinge": (plain(hinges=(Hinge("outer_race", pi / 2, 0.5),)), 1),
    "rim_hinge_sound_cam": (plain(hinges=(Hinge("rim", 0.3, 0.5),)), 1),
    "outer_race_hinge_sound_cam": (plain(hinges=(Hinge("outer_race", pi / 2, 0.5),)), 1),
    "straight_teeth": (dict(spline_support=0.5, tooth="straight"), 1),
    "involute_teeth": (dict(spline_support=0.5, tooth="involute", coning=0.5), -1),
    "relieved_teeth": (dict(spline_support=0.5, tooth="straight", tips="relieved"), 1),
    "spline_hinge": (dict(spline_support=0.5, hinges=(Hinge("circular_spline", 0.2, 0.4),)), 1),
}
OTHERS = {  # of size 25, ratio 100 only
    "race_crack": (plain(ball_compliance={1: 2e-8}), 1),
    "diaphragm_arc": (plain(diaphragm_arc=(6e-3, 0.29 * 0.0635)), 1),
    "diaphragm_groove": (plain(groove=(25e-3, 1e-3, 0.3e-3)), 1),
    "clearance": (plain(clearance=5e-6), 1),
    "lobe_interference": (plain(lobe_gap=-2e-6), 1),
    "cam_factor": (plain(cam_factor=1.5), 1),
    "hat": (dict(spline_support=0.5, hat=True, diaphragm_inner_radius=31.02e-3,
                 diaphragm_outer_radius=43e-3, barrel_length=9.525e-3), 1),
    "cage_phase": (plain(cage_phase=radians(4)), 1),
    "deviations": (plain(deviations=WAVY), 1),
    "no_coning": (plain(coning=0.0), 1),
    "rim_hinge_reversed": (plain(hinges=(Hinge("rim", 0.3, 0.5),)), -1),
    "rim_hinge_pressed_sound_cam": (plain(hinges=(Hinge("rim", pi / 2, 0.5),)), 1),
    "outer_race_hinge_pressed_sound_cam": (plain(hinges=(Hinge("outer_race", 0.0, 0.5),)), 1),
    "all_cracks": (dict(spline_support=0.5, broken_teeth={0: 0.5, 101: 1.0},
                        ball_compliance={1: 2e-8}, clearance=2e-6, hinges=(
                            Hinge("rim", 0.3, 0.5), Hinge("outer_race", pi / 2, 0.5),
                            Hinge("circular_spline", 0.2, 0.4))), 1),
}
HALF_PATH = {  # of size 25 at some ratios; seconds for each
    "half_path_teeth": (dict(spline_support=0.5, tooth="half_path"), 1),
    "half_path_teeth_reversed": (dict(spline_support=0.5, tooth="half_path"), -1),
}
HALF_PATH_RATIOS = (30, 50, 100, 160)
HALF_PATH_DIGITS = 7  # the contact comes from differences along the flanks and from chords
OTHERS |= {f"{case}_sound_cam": OTHERS[case]
           for case in ("race_crack", "rim_hinge_reversed", "all_cracks")}


def add_curve(table, case, size, ratio, changes, sign):
    drive = typical(size, ratio, **changes)
    model = Coupled(drive)
    if case.endswith("sound_cam"):
        sound = Coupled(drive | dict(hinges=(), broken_teeth={}, ball_compliance={}))
        sound.assemble()
        model = Coupled(drive | dict(hinges=tuple(h for h in drive["hinges"] if sound.opens(h))))
        model.assemble(sound.amplitude)
    if drive["cage_phase"] or drive["deviations"]:  # the cam is made for a ball at the lobe
        made = Coupled(drive | dict(cage_phase=0.0, deviations={}))
        made.assemble()
        model.assemble(made.amplitude)
    loads = [sign * T for T in torques(drive)]
    results = model.curve(loads)
    add_state(table, case, (size, ratio, 0.0), model, 0.0, 0.0, model.start)
    for T, (rotation, twist, state) in zip(loads, results):
        add_state(table, case, (size, ratio, T), model, rotation, twist, state)


def add_state(table, case, inputs, model, rotation, twist, state):
    def add(what, value, unit):
        digits = HALF_PATH_DIGITS if case in HALF_PATH else 11
        table.add(f"{case}.{what}", inputs, value, unit, SOURCE, digits=digits, printed=12)

    closed = touching(state)
    if inputs[-1]:
        add("ring_rotation", rotation, "rad")
        add("twist", twist, "rad")
    else:
        add("cam_amplitude", model.amplitude, "m")
    add("balls_in_contact", int(np.sum(state.ball_force > 0)), "1")
    add("flanks_in_contact", int(np.sum(closed)), "1")
    add("teeth_in_contact", int(np.sum(closed[:model.teeth] | closed[model.teeth:])), "1")
    if inputs[:2] == (25, 100):
        add("largest_ball_force", state.ball_force.max(), "N")
        add("largest_flank_force", state.flank_force[closed].max(initial=0), "N")


def curve_table(sizes=SIZES, half_path_ratios=HALF_PATH_RATIOS):
    from reference_csv import Table

    table = Table("coupled_drive", "size [1]", "ratio [1]", "torque [N*m]")
    for size, ratio in sizes:
        cases = CASES | OTHERS if (size, ratio) == (25, 100) else CASES
        for case, (changes, sign) in cases.items():
            add_curve(table, case, size, ratio, changes, sign)
    for ratio in half_path_ratios:
        for case, (changes, sign) in HALF_PATH.items():
            add_curve(table, case, 25, ratio, changes, sign)
    return table


def maker_table():
    """K1, K2, K3 of size 25 at the maker's torques; numbers of harmonics; an earlier mesh."""
    from reference_csv import Table

    table = Table("coupled_drive_stiffness", "size [1]", "ratio [1]", "harmonics [1]",
                  "spline_support [1]", "diaphragm_warping [1]", "coning [1]",
                  "pair_stiffness [Pa]", "T1 [N*m]", "T2 [N*m]", "T3 [N*m]")
    T1, T2, T3 = 14.0, 48.0, 76.8
    for ratio, harmonics, support, warping, coning, pair in (
            (100, 32, 0, 0, 1, None), (50, 32, 0, 0, 1, None), (30, 32, 0, 0, 1, None),
            (100, 32, 0.5, 1, 1, None), (50, 32, 0.5, 1, 1, None), (100, 24, 0, 0, 1, None),
            (100, 48, 0, 0, 1, None), (100, 64, 0, 0, 1, None), (100, 32, 0, 0, 0.5, 6.5e9),
            (50, 32, 0, 0, 0.5, 6.5e9), (30, 32, 0, 0, 0.5, 6.5e9)):
        model = Coupled(typical(25, ratio, harmonics=harmonics, spline_support=support,
                                diaphragm_warping=bool(warping), coning=coning,
                                pair_stiffness=pair))
        one, two, three = (twist for _, twist, _ in model.curve([T1, T2, T3]))
        K = T1 / one, (T2 - T1) / (two - one), (T3 - T2) / (three - two)
        for name, value in zip(("K1", "K2", "K3"), K):
            table.add(name, (25, ratio, harmonics, support, warping, coning, model.pair, T1, T2,
                             T3), value, "N*m/rad", SOURCE, digits=11, printed=12)
    return table


def drive_table():
    """Inputs of each drive of the other tables, and what follows from them without a solve."""
    from reference_csv import Table

    table = Table("coupled_drive_members", "size [1]", "ratio [1]", "harmonic [1]")
    units = {"angle": "rad", "modulus": "Pa", "compliance": "rad/(N*m)"}
    no_length = ("ratio", "count", "conformity", "factor", "coning", "stiffening", "support")
    skipped = ("harmonics", "phase")
    for size, ratio in (*SIZES, (25, 30)):
        drive = typical(size, ratio)

        def add(case, value, unit, source, digits, harmonic=""):
            table.add(case, (size, ratio, harmonic), value, unit, source, digits=digits,
                      printed=min(digits + 2, 17))

        for name, value in drive.items():
            last = name.split("_")[-1]
            if isinstance(value, (bool, tuple, dict)) or value is None or last in skipped:
                continue
            add(f"input.{name}", value, "1" if last in no_length else units.get(last, "m"),
                "typical proportions", 17)
        model = Coupled(drive)
        add("ball_force_constant", model.hertz ** -1.5, "N/m^1.5", "Carlson's integrals", 12)
        add("pair_stiffness", model.pair, "Pa", "sum of compliances", 14)
        add("coning_slope", float(model.slope[0]), "1", "definition", 14)
        add("ring_bending_stiffness", bending_stiffness(drive), "N*m^2", "definition", 14)
        add("structure_compliance", model.lambda_s, "rad/(N*m)", "quadrature", 13)
        for n in (2, 3, 4, 6, 8, 16, 32):
            add("plate_edge_stiffness", plate_edge_stiffness(
                n, drive["diaphragm_outer_radius"], drive["diaphragm_inner_radius"],
                drive["diaphragm_thickness"], drive["youngs_modulus"], drive["poissons_ratio"]),
                "N/m", "Rayleigh-Ritz", 10, n)
            for name, value, unit in zip(("wall_stiffness", "bottom_stiffness", "wall_tilt"),
                                         wall_mode(drive, n), ("N/m", "N/m", "1/m")):
                if name != "bottom_stiffness" or n <= 8:  # it vanishes for short waves
                    add(name, value, unit, "Rayleigh-Ritz", 10, n)
        for member, t in (("rim", drive["rim_thickness"]),
                          ("outer_race", drive["outer_race_thickness"])):
            width = drive["face_width" if member == "rim" else "race_width"]
            add(f"{member}_hinge_compliance_at_half_depth",
                hinge_compliance(0.5, width, t, drive["youngs_modulus"], 0.3), "rad/(N*m)",
                "quadrature of (FR-11)", 12)
    return table


def kernel_table():
    """Small laws: free ring under two opposite forces, gap, plate edge, force of a pair."""
    from reference_csv import Table

    table = Table("coupled_drive_laws", "harmonics_or_harmonic [1]", "angle [rad]",
                  "inner_radius [m]", "outer_radius [m]", "thickness [m]", "youngs_modulus [Pa]",
                  "poissons_ratio [1]", "corner [N]")
    blank = ("",) * 8
    for N in (8, 16, 32, 64):
        # 2 F a_n = pi E I/R^3 (n^2 - 1)^2 a_n^2 for even n, the load at theta = 0 and pi
        value = sum(2 / (pi * (n * n - 1) ** 2) for n in range(2, N + 1, 2))
        table.add("ring_under_opposite_forces", (N, *blank[1:]), value, "1",
                  "minimum of the energy", digits=14, printed=16)
    table.add("ring_under_opposite_forces_exact", blank, pi / 8 - 1 / pi, "1", "exact", digits=15,
              printed=16)
    for degrees in (-45, -30, -15, -5, 5, 15, 30, 40, 45):
        t = radians(degrees)
        table.add("gap_over_radial_displacement", ("", t, *blank[2:]),
                  float(flank_gap(t, radians(22), 1.0)), "1", "flank angle 22 degrees", digits=13,
                  printed=15)
    for ratio, degrees in ((0.6, 0), (0.7, 0), (0.8, 0)):
        table.add(f"least_flank_angle_{ratio}", blank, asin(sqrt(1 - ratio ** 2) / sqrt(
            1 + 3 * ratio ** 2)), "rad", "tangent of the tooth's path", digits=15, printed=16)
    for case, inner, outer in (("plate_edge_stiffness", 18.415e-3, 31.02e-3),
                               ("plate_edge_stiffness_of_hat", 31.02e-3, 43e-3)):
        for corner in (0.0, 2500.0):
            for n in (2, 3, 4, 6, 10, 20, 32):
                rest = (0.762e-3, 2.06e11, 0.3, corner)
                edges = (inner, outer) if case.endswith("hat") else (outer, inner)
                table.add(case, (n, "", inner, outer, *rest), plate_edge_stiffness(n, *edges, *rest),
                          "N/m", "Rayleigh-Ritz", digits=10, printed=12)
    return table


def neighbour_rows():
    """Motion of neighbouring teeth (TC-31), lengths over the module."""
    from reference_csv import Table

    table = Table("tooth_neighbours", "wall_over_module [1]", "dedendum_over_module [1]",
                  "flank_angle [rad]", "pitches [1]")
    for wall, dedendum, degrees in ((6.0, 1.1, 22.0), (20.0, 1.1, 22.0), (40.0, 1.3, 18.0)):
        slope = tan(radians(degrees))
        out = neighbour_table(wall, pi / 2 + 2 * dedendum * slope, dedendum - pi / 4 * slope, 20)
        for n in (1, 2, 5, 8, 20):
            for case, column in zip(("tangential", "radial", "mixed"), out):
                value = column[n - 1]  # 12 digits of the largest value, 1
                table.add(case, (wall, dedendum, radians(degrees), n), value, "1",
                          "waves of a layer by its differential equation",
                          digits=12 + min(0, int(floor(log10(abs(value))))), printed=15)
    return table


def ring_rows():
    """Moments of outer ring and circular spline, and the hoop force of the latter.

    The curvatures come from the shapes of the rings on a grid, differentiated by a discrete Fourier
    transform.  The hoop force is a staircase with a step at each flank; the housing takes its mean,
    its first wave, and an even traction that holds the torque; what is left of the waves up to N is
    shared with the housing."""
    from reference_csv import Table

    table = Table("ring_states", "size [1]", "ratio [1]", "torque [N*m]", "position [rad]")
    drive = typical(25, 100, spline_support=0.5)
    model = Coupled(drive)
    R, N, count = model.R, model.N, 256
    E, support = drive["youngs_modulus"], drive["spline_support"]
    t_c, R_c = model.spline_ring()
    grid = 2 * pi * np.arange(count) / count
    wave = np.fft.fftfreq(count, 1 / count)

    def curvature(w, radius):
        return np.fft.ifft((wave ** 2 - 1) * np.fft.fft(w)).real / radius ** 2

    m = model.n[1:]
    spline_shape = np.hstack((np.cos(np.outer(grid, m)), np.sin(np.outer(grid, m))))
    loads = (14.0, 48.0, 76.8)
    for sign in (1, -1):
        states = [state for _, _, state in model.curve([sign * T for T in loads])]
        for T, state in zip(loads, states):
            outer = drive["groove_factor"] * strip_bending(
                E, drive["race_width"], drive["outer_race_thickness"]) * curvature(
                    model.radial(grid) @ state.x, R)
            spline = strip_bending(E, drive["spline_width"], t_c) * curvature(
                spline_shape @ state.x[model.ring:model.rings], R_c)
            theta = np.tile((model.index + 0.5) * 2 * pi / round(2 * drive["ratio"]), 2)
            lever = drive["pitch_diameter"] / 2 / R_c
            step = (np.repeat([1, -1], model.teeth) * np.cos(model.angle) * state.flank_force
                    * lever)
            order = np.argsort(theta)
            edges = np.concatenate((theta[order], [theta[order][0] + 2 * pi]))
            tread = -np.cumsum(step[order])
            hoop = np.zeros(count)
            for n in range(2, N + 1):  # the waves of a staircase, by the integral over its treads
                even = tread @ (np.sin(n * edges[1:]) - np.sin(n * edges[:-1])) / (n * pi)
                odd = -tread @ (np.cos(n * edges[1:]) - np.cos(n * edges[:-1])) / (n * pi)
                # the even traction is a ramp over the turn from the first tooth on
                even += step.sum() / pi * np.sin(n * edges[0]) / n
                odd -= step.sum() / pi * np.cos(n * edges[0]) / n
                hoop += even * np.cos(n * grid) + odd * np.sin(n * grid)
            for k in range(0, count, 19):
                inputs = (25, 100, sign * T, grid[k])
                for name, value, unit in (("outer_ring.moment", outer[k], "N*m"),
                                          ("circular_spline.moment", spline[k], "N*m"),
                                          ("circular_spline.hoop_force", support * hoop[k], "N")):
                    table.add(name, inputs, value, unit, SOURCE, digits=8, printed=12)
    return table


def tables():
    return [curve_table(), maker_table(), drive_table(), kernel_table(), neighbour_rows(),
            ring_rows()]


def some_tables():
    """The same tables, the long one for two drives only."""
    return [curve_table([(25, 100), (14, 50)], ()), maker_table(), drive_table(), kernel_table(),
            neighbour_rows(), ring_rows()]


def main():
    if "--digits" in sys.argv[1:]:
        for size, ratio in SIZES:
            for case, (changes, sign) in CASES.items():
                drive = typical(size, ratio, **changes)
                model, direct = Coupled(drive), Coupled(drive)
                loads = [sign * T for T in torques(drive)]
                stepped = model.curve(loads)
                other = direct.curve(loads[::-1])[::-1]
                change = max(abs(a[1] / b[1] - 1) for a, b in zip(stepped, other))
                residual = max(a[2].residual for a in stepped)
                margin = min(np.abs(a[2].closing).min() for a in stepped)
                print(f"{size:3} {ratio:4} {case:24} {change:8.1e} {residual:8.1e} {margin:8.1e}")
        return
    from reference_csv import publish

    publish(*tables())


if __name__ == "__main__":
    main()
