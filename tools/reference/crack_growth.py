"""Growth of cracks: a second road for strainwave's laws, cycles of a duty, and lives.

Written from the formulas of the theory manual (chapters FR, FA, SB, SP, GR) and from the published
cases, not from the library's source.  It takes another road wherever there is one:

* The library integrates over the length of a path in the logarithms of the sizes.  Here the sizes
  themselves are integrated, over the other size or over the number of repetitions, by a method of
  order 8 (scipy DOP853), and lives of one size by quadrature (QUADPACK).
* The library joins extremes of the steps of a duty.  Here every wave of the duty is a number in one
  long history, and three points of ASTM E1049 count it.
* Newman and Raju's factors are those of newman_raju.py, a second text of the fits.
* Load interaction is a loop over single cycles.
* Rates from a table: the library finds the position of a range between the ends of the two curves
  beside it.  Here the points of the curve at the wanted R are made first, those of both curves, and
  numpy interpolates along it.

Cases P1 to P3, G3, G8, G18: surface crack in a plate; NASGRO of an aluminium (easigrow's
7050-T7451) under a block; Paris in a finite plate; single cycles; a law that falls to its
threshold; a block.  easigrow prints 139 380 (P3) and 21 247.5 (P2) for its loops.

Drive cases: an annular crack in a solid shaft (handbook's K of torsion and tension, (SB-3) of
bending) under three blocks with rotating bending; a surface crack in the wall of a flexspline under
torque and wave; where they rest and start; and a crack through the wall whose K over a turn is a
table (examples/tables/turn_through.csv, which --table writes from its closed form).  A surface crack
in a solid shaft under torque and rotating bending.  A crack of the rim from a tooth root (GR-38).

In double precision; the integrators work to 1e-12.  Each row states its digits.
"""
import csv
import functools
import math
import sys
from pathlib import Path

import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

from gradient import Hole
from reference_csv import DATA, Table, publish
from weight_function import intensities

PI = math.pi
TURN_TABLE = Path(__file__).resolve().parents[2] / "examples" / "tables" / "turn_through.csv"


# --- Laws, in MPa, m ----------------------------------------------------------------------------

def paris(C, m):
    return lambda K_max, R, a: C * (K_max * (1 - R)) ** m


def walker(C, m, gamma):
    def rate(K_max, R, a):
        return C * (K_max if R < 0 else K_max * (1 - R) ** gamma) ** m
    return rate


def nasgro(C, n, p, q, K_c, datum, form, slopes, alpha, s, a_0):
    """Newman's opening and the NASGRO equation; form 0 or 1: stress ratio of the datum."""
    A0 = (0.825 - 0.34 * alpha + 0.05 * alpha ** 2) * math.cos(PI * s / 2) ** (1 / alpha)
    A1 = (0.415 - 0.071 * alpha) * s
    A3 = 2 * A0 + A1 - 1
    A2 = 1 - A0 - A1 - A3

    def rate(K_max, R, a):
        f = A0 + A1 * max(R, -2) if R < 0 else max(R, A0 + A1 * R + A2 * R ** 2 + A3 * R ** 3)
        th = datum * math.sqrt(a / (a + a_0))
        slope = slopes[0] if R >= 0 else slopes[1]
        if form == 0:
            th *= ((1 - A0) * (1 - R) / (1 - f)) ** (1 + slope * R)
        else:
            th *= ((1 - R) / (1 - f)) ** (1 + slope * R)
            th /= (1 - A0) ** (slopes[0] * (1 - R) if R >= 0 else slopes[0] - R * slopes[1])
        DK = K_max * (1 - R)
        if DK <= th:
            return 0.0
        return (C * ((1 - f) / (1 - R) * DK) ** n * (1 - th / DK) ** p / (1 - K_max / K_c) ** q)
    return rate


# --- Counting -----------------------------------------------------------------------------------

def reversals(values):
    out = []
    for v in values:
        if out and v == out[-1]:
            continue
        if len(out) > 1 and (out[-1] - out[-2]) * (v - out[-1]) > 0:
            out[-1] = v
        else:
            out.append(v)
    return out


def three_points(values):
    """ASTM E1049 5.4.4: (from, to, count)."""
    stack, cycles = [], []
    for v in reversals(values):
        stack.append(v)
        while len(stack) >= 3:
            x, y = abs(stack[-1] - stack[-2]), abs(stack[-2] - stack[-3])
            if x < y:
                break
            if len(stack) == 3:
                cycles.append((stack[0], stack[1], 0.5))
                stack.pop(0)
            else:
                cycles.append((stack[-3], stack[-2], 1.0))
                del stack[-3:-1]
    cycles += [(a, b, 0.5) for a, b in zip(stack, stack[1:])]
    return cycles


def repeated(values):
    """Of a history that follows on itself: it begins and ends at its largest value."""
    top = max(range(len(values)), key=lambda i: values[i])
    turned = list(values[top:]) + list(values[:top]) + [values[top]]
    merged = {}
    for a, b, count in three_points(turned):
        key = (max(a, b), min(a, b))
        merged[key] = merged.get(key, 0.0) + count
    return merged


# --- Published cases -----------------------------------------------------------------------------

def newman_raju(a, c, t, phi, bending):
    """K over the stress times sqrt(pi a), wide plate, a <= c."""
    r, al, s = a / c, a / t, math.sin(phi)
    M = (1.13 - 0.09 * r + (-0.54 + 0.89 / (0.2 + r)) * al ** 2
         + (0.5 - 1 / (0.65 + r) + 14 * (1 - r) ** 24) * al ** 4)
    g = 1 + (0.1 + 0.35 * al ** 2) * (1 - s) ** 2
    f = (r ** 2 * math.cos(phi) ** 2 + s ** 2) ** 0.25
    F = M * g * f / math.sqrt(1 + 1.464 * r ** 1.65)
    if not bending:
        return F
    H1 = 1 - 0.34 * al - 0.11 * r * al
    H2 = (1 - (1.22 + 0.12 * r) * al
          + (0.55 - 1.05 * r ** 0.75 + 0.47 * r ** 1.5) * al ** 2)
    return F * (H1 + (H2 - H1) * s ** (0.2 + r + 0.6 * al))


def plate(bending):
    """P1: cycles and half length when a = 8 mm.  Independent variable: the depth."""
    t, stress, C, m = 10e-3, 200.0, 6.9e-12, 3

    def rates(a, c):
        root = stress * math.sqrt(PI * a)
        deep = root * newman_raju(a, c, t, PI / 2, bending)
        end = root * newman_raju(a, c, t, 0.0, bending)
        return C * deep ** m, C * end ** m

    def slope(a, y):
        da, dc = rates(a, max(y[0], a))
        return [dc / da, 1 / da]
    solved = solve_ivp(slope, (1e-3, 8e-3), [1e-3, 0.0], method="DOP853", rtol=1e-12, atol=1e-18)
    return solved.y[1, -1], solved.y[0, -1]


def finite_plate(a):
    x = a / 50e-3
    return (1 - x / 2 + 0.37 * x ** 2 - 0.044 * x ** 3) / math.sqrt(1 - x)


def easigrow_block():
    """P2: blocks from 1 to 10 mm."""
    law = nasgro(6.35e-10, 2.5, 1, 1, 35.16, 0.8, 0, (2.2, 2.2), 2, 0.3, 38.1e-6)
    cycles = repeated([0, 1, .1, .8, .3, .9, .2, .6, 0])

    def inverse(a):
        K = 120 * finite_plate(a) * math.sqrt(PI * a)
        return 1 / sum(n * law(K * hi, lo / hi, a) for (hi, lo), n in cycles.items())
    return quad(inverse, 1e-3, 10e-3, epsrel=1e-12, limit=400)[0]


def finite_plate_paris():
    """P3"""
    return quad(lambda a: 1 / (6.9e-12 * (200 * finite_plate(a) * math.sqrt(PI * a)) ** 3), 1e-3,
                10e-3, epsrel=1e-12)[0]


def single_cycles():
    """G3: cycles of a loop, Paris, Y 1.12, 200 MPa, 1 to 10 mm."""
    a, N = 1e-3, 0
    while a < 1e-2:
        a += 6.9e-12 * (1.12 * 200 * math.sqrt(PI * a)) ** 3
        N += 1
    return N


def falls_to_threshold():
    """G8: C DK^2 (1 - 3/DK), Y 1.12, 60 MPa, 1 to 10 mm: cycles, size at rest."""
    def inverse(a):
        K = 1.12 * 60 * math.sqrt(PI * a)
        return 1 / (1e-10 * K ** 2 * (1 - 3 / K))
    return quad(inverse, 1e-3, 1e-2, epsrel=1e-13)[0], (3 / (1.12 * 60)) ** 2 / PI


ASTM = [-2, 1, -3, 5, -1, 3, -4, 4, -2]


def block(tensile, loop):
    """G18: the standard's history times 40 MPa as a block, half cycles, 1 to 10 mm."""
    total = 0.0
    for a, b, count in three_points(ASTM):
        low = max(min(a, b), 0) if tensile else min(a, b)
        total += count * max(max(a, b) - low, 0) ** 3

    def rate(a):
        return 6.9e-12 * total * (1.12 * 40 * math.sqrt(PI * a)) ** 3
    if not loop:
        return quad(lambda a: 1 / rate(a), 1e-3, 1e-2, epsrel=1e-13)[0]
    a, N = 1e-3, 0
    while a < 1e-2:
        a += rate(a)
        N += 1
    return N


# --- Drives ---------------------------------------------------------------------------------------

NU = 0.3


def equivalent(K):
    """(GR-13)"""
    return math.sqrt(max(K[0], 0) ** 2 + K[1] ** 2 + K[2] ** 2 / (1 - NU))


def tip_cycle(A, B):
    """(GR-22)"""
    largest = max(equivalent(A), equivalent(B))
    if largest <= 0:
        return 0.0, 0.0
    return largest, 1 - equivalent([abs(x - y) for x, y in zip(A, B)]) / largest


def count_duty(steps, value, waves):
    """Cycles of a duty, each wave of it an entry of one history.

    steps: loads of each step; value(load, turned): the counted number, with equal waves in all
    steps; waves: their number in each step.  The loads change between two steps while the wave goes
    on from one extreme to the next one, so a change downwards leaves a peak and reaches a valley,
    and half of half a wave belongs to either step.  A step that is higher or lower than both
    neighbours thus has a half number of waves, any other one a whole number.
    Returns {(step high, step low): count}; two steps must not share a value."""
    history, owner = [], {}
    for j, load in enumerate(steps):
        hi, lo = value(load, 1), value(load, -1)
        owner[hi], owner[lo] = j, j
        rises = steps[j] > steps[j - 1]
        goes_on = steps[(j + 1) % len(steps)] > load
        extremes = [hi, lo] if rises else [lo, hi]
        if rises == goes_on:
            assert waves[j] == int(waves[j])
            history += extremes * int(waves[j])
        else:
            assert waves[j] == int(waves[j]) + 0.5
            history += extremes * int(waves[j]) + extremes[:1]
    counted = {}
    for (hi, lo), n in repeated(history).items():
        key = owner[hi], owner[lo]
        counted[key] = counted.get(key, 0.0) + n
    return counted


def wider_phase(state, high, low):
    """The wider of the two phases of the turning load."""
    one, other = (tip_cycle(state(high, sign), state(low, -sign)) for sign in (1, -1))
    ranges = [K * (1 - R) for K, R in (one, other)]
    if abs(ranges[0] - ranges[1]) <= 1e-9 * max(ranges):  # equal ranges: the larger K_max counts
        return max(one, other)
    return one if ranges[0] > ranges[1] else other


class Shaft:
    """Solid shaft of 60 mm, annular crack, three blocks of 2.5, 2.5 and 2 turns: torque 4000, -1500,
    2600 N m, bending moment 700 N m, axial force 0."""
    d = 60e-3
    steps = ((4000.0, 700.0), (-1500.0, 700.0), (2600.0, 700.0))
    turns = (2.5, 2.5, 2)
    C, m, gamma = 6.9e-12, 3, 0.5

    def factors(self, a, T, M):
        de = self.d - 2 * a
        x = de / self.d
        p3 = 1 + x / 2 + 3 / 8 * x ** 2 + 5 / 16 * x ** 3 + 35 / 128 * x ** 4 + 0.208 * x ** 5
        p2 = (1 + x / 2 + 3 / 8 * x ** 2 + 0.58424627 * x ** 3 - 1.86002070 * x ** 4
              + 6.24772954 * x ** 5 - 7.75789181 * x ** 6 + 3.90166257 * x ** 7)
        root = 3 / 8 * math.sqrt(x * PI * a) * 1e-6
        return [root * p2 * 32 * M / (PI * de ** 3), 0.0, root * p3 * 16 * T / (PI * de ** 3)]

    @functools.lru_cache
    def cycles(self):
        # Torque alone is counted: bending is another mode.  A little of it keeps the waves apart.
        return count_duty(self.steps, lambda s, turned: s[0] + 1e-6 * turned, self.turns)

    def tip_cycles(self, a, factor=1.0):
        def state(load, sign):
            return self.factors(a, factor * load[0], factor * sign * load[1])
        return [(wider_phase(state, self.steps[j], self.steps[k]), n)
                for (j, k), n in self.cycles().items()]

    def growth(self, a):
        law = walker(self.C, self.m, self.gamma)
        return sum(n * law(*cycle, a) for cycle, n in self.tip_cycles(a))

    def repetitions(self, a_end):
        return quad(lambda a: 1 / self.growth(a), 0.5e-3, a_end, epsrel=1e-12, limit=200)[0]

    def start(self, threshold):
        """Factor on the loads from which a crack of 0.5 mm grows, and the size from which it grows
        at the given loads, for a threshold of the full range."""
        def widest(a, factor=1.0):
            return max(K * (1 - R) for (K, R), _ in self.tip_cycles(a, factor))
        return (brentq(lambda f: widest(0.5e-3, f) - threshold, 0.1, 50, xtol=1e-14),
                brentq(lambda a: widest(a) - threshold, 1e-5, 20e-3, xtol=1e-16))


class Wall:
    """Flexspline of 160 mm, wall 2.24 mm, E 210 GPa, w_0 0.8 mm; surface crack at 60 degrees, a 0.4
    mm, c 0.7 mm; torque 6000, 1000, -3000 N m in steps of 807.5, 808 and
    807.5 waves."""
    r, t, beta, E = 78.88e-3, 2.24e-3, PI / 3, 210e9
    w0 = 0.8e-3
    steps = (6000.0, 1000.0, -3000.0)
    waves = (807.5, 808, 807.5)
    C, m, gamma = 6.9e-12, 3, 0.5

    def factors(self, a, c, phi, T, wave):
        rho, root = a / c, math.sqrt(PI * a)
        sigma_b = self.E / (1 - NU ** 2) * self.t / 2 * 3 * self.w0 / self.r ** 2
        sin, cos = math.sin(self.beta), math.cos(self.beta)
        bredt = T / (2 * PI * self.r ** 2 * self.t)
        normal = bredt * math.sin(2 * self.beta)
        shear = bredt * math.cos(2 * self.beta)
        normal_b = wave * sigma_b * (cos ** 2 + NU * sin ** 2)
        shear += wave * -(1 - NU) * sigma_b * sin * cos
        k2 = 1 - rho ** 2
        E, K = ellipe(k2), ellipk(k2)
        B = ((k2 - NU) * E + NU * (1 - k2) * K) / k2 if k2 > 1e-6 else PI * (2 - NU) / 4
        f = (rho ** 2 * math.cos(phi) ** 2 + math.sin(phi) ** 2) ** 0.25
        return [1e-6 * root * (normal * newman_raju(a, c, self.t, phi, False)
                               + normal_b * newman_raju(a, c, self.t, phi, True)),
                1e-6 * root * shear * rho * math.cos(phi) / (B * f),
                1e-6 * root * shear * (1 - NU) * math.sin(phi) / (B * f)]

    @functools.lru_cache
    def cycles(self):
        # Mode I at the deepest point: torque and wave in their proportion.
        value = lambda T, turned: self.factors(0.4e-3, 0.7e-3, PI / 2, T, turned)[0]
        return count_duty(self.steps, value, self.waves)

    def growth(self, a, c, phi, factor=1.0):
        law = walker(self.C, self.m, self.gamma)

        def state(T, sign):
            return self.factors(a, c, phi, factor * T, sign)
        return sum(n * law(*wider_phase(state, self.steps[j], self.steps[k]), a)
                   for (j, k), n in self.cycles().items())

    def until_length(self, c_end):
        """Repetitions and depth; independent variable: the repetitions."""
        def slope(N, y):
            a, c = y
            return [self.growth(a, c, PI / 2), self.growth(a, c, 0.0)]

        def reached(N, y):
            return y[1] - c_end
        reached.terminal = True
        scale = 0.7e-3 / self.growth(0.4e-3, 0.7e-3, 0.0)
        solved = solve_ivp(slope, (0, 100 * scale), [0.4e-3, 0.7e-3], method="DOP853", rtol=1e-12,
                           atol=1e-18, events=reached)
        return solved.t_events[0][0], solved.y_events[0][0][0]


class Turn:
    """The wall above with a crack through it, 2 mm half length, and K over a turn from a table.

    The closed form of the table, with the angle theta from the lobe, T in N m and the station s (-1
    inner face, 1 outer face), in MPa and m:
    K_I   = g sqrt(pi a) (0.01 T + 40 s (cos 2 theta + 0.6 cos 4 theta)),
    K_II  = g sqrt(pi a) 15 s sin 2 theta,
    K_III = g sqrt(pi a) 0.002 T s, with g = 1 + 0.1 ln(a / 2 mm).
    So the modes have different phases, and each wave has a second, smaller cycle."""
    steps, waves = Wall.steps, Wall.waves
    C, m, gamma = 6.9e-12, 3, 0.5
    sizes = [2.0, 3.0, 4.0, 6.0, 8.0]  # mm
    torques = [-9000.0, 0.0, 9000.0]
    stations = [-1, 1]
    angles = [10 * i for i in range(19)]  # deg

    @staticmethod
    def shape(T, s, theta):
        return [0.01 * T + 40 * s * (math.cos(2 * theta) + 0.6 * math.cos(4 * theta)),
                15 * s * math.sin(2 * theta), 0.002 * T * s]

    @classmethod
    def text(cls):
        text = ("# K over a turn of the wave generator, invented for an example and a test by\n"
                "# tools/reference/crack_growth.py --table: K = (1 + 0.1 ln(a/2 mm)) sqrt(pi a) S with\n"
                "# S_I = 0.01 T + 40 s (cos 2 theta + 0.6 cos 4 theta), S_II = 15 s sin 2 theta,\n"
                "# S_III = 0.002 T s in MPa; a half_length, T torque in N*m, s station, theta angle.\n"
                "half_length [mm],torque [N*m],station,angle [deg],"
                "K_I [MPa*m^0.5],K_II [MPa*m^0.5],K_III [MPa*m^0.5]\n")
        for a in cls.sizes:
            root = (1 + 0.1 * math.log(a / 2)) * math.sqrt(PI * a * 1e-3)
            for T in cls.torques:
                for s in cls.stations:
                    for angle in cls.angles:
                        K = [root * x for x in cls.shape(T, s, math.radians(angle))]
                        K = [0.0 if abs(x) < 1e-12 else x for x in K]
                        text += f"{a:g},{T:g},{s},{angle},{K[0]!r},{K[1]!r},{K[2]!r}\n"
        return text

    def __init__(self):
        lines = [line for line in TURN_TABLE.read_text().splitlines() if line[0] not in "#h"]
        rows = np.array([[float(x) for x in line.split(",")] for line in lines])
        shape = (len(self.sizes), len(self.torques), len(self.stations), len(self.angles), 3)
        # Over sqrt(pi a): linear in ln a, as the closed form is.
        self.over_root = (rows[:, 4:] / np.sqrt(PI * rows[:, :1] * 1e-3)).reshape(shape)
        self.ln = np.log(np.array(self.sizes) * 1e-3)

    def turn(self, a, T, station):
        """K at the angles of the table without the last one."""
        i = min(max(np.searchsorted(self.ln, math.log(a)) - 1, 0), len(self.sizes) - 2)
        share = (math.log(a) - self.ln[i]) / (self.ln[i + 1] - self.ln[i])
        at_size = ((1 - share) * self.over_root[i] + share * self.over_root[i + 1])
        j = 0 if T < self.torques[1] else 1
        part = (T - self.torques[j]) / (self.torques[j + 1] - self.torques[j])
        K = (1 - part) * at_size[j, station] + part * at_size[j + 1, station]
        return (math.sqrt(PI * a) * K)[:-1]

    @staticmethod
    def norm(K):
        return np.sqrt(K[..., 0] ** 2 + K[..., 1] ** 2 + K[..., 2] ** 2 / (1 - NU))

    def widest(self, one, other):
        """(GR-31): the largest K of both turns, and the largest range of any two moments."""
        opened = np.concatenate([one, other])
        opened[:, 0] = np.maximum(opened[:, 0], 0)
        range_ = self.norm(np.abs(one[:, None, :] - other[None, :, :])).max()
        largest = self.norm(opened).max()
        return largest, 1 - range_ / largest

    def within(self, turn):
        """Smaller cycles of a wave, counted along the direction of its widest range."""
        n = len(turn)
        pairs = self.norm(np.abs(turn[:, None, :] - turn[None, :, :]))
        p, q = divmod(int(pairs.argmax()), n)
        along = turn @ (turn[p] - turn[q])
        top = int(along.argmax())
        order = [(top + k) % n for k in range(n + 1)]
        index = {along[k]: k for k in range(n)}
        counted = [(abs(x - y), x, y, count)
                   for x, y, count in three_points([along[k] for k in order])]
        counted.sort(reverse=True)
        left, smaller = 1.0, []
        for _, x, y, count in counted:
            taken = min(left, count)
            left -= taken
            if count > taken:
                smaller.append((tip_cycle(turn[index[x]], turn[index[y]]), count - taken))
        return smaller

    @functools.lru_cache
    def cycles(self):
        # Mode I at the outer face.
        hump = [math.cos(2 * x) + 0.6 * math.cos(4 * x) for x in np.radians(self.angles)]
        return count_duty(self.steps,
                          lambda T, turned: 0.01 * T + 40 * (max(hump) if turned > 0 else min(hump)),
                          self.waves)

    def growth(self, a, minor=True):
        law = walker(self.C, self.m, self.gamma)
        turns = [[self.turn(a, T, s) for s in range(len(self.stations))] for T in self.steps]
        grown = sum(n * max(law(*self.widest(one, other), a)
                            for one, other in zip(turns[j], turns[k]))
                    for (j, k), n in self.cycles().items())
        if minor:
            grown += sum(n * max(sum(count * law(*cycle, a) for cycle, count in self.within(turn))
                                 for turn in at_step)
                         for n, at_step in zip(self.waves, turns))
        return grown

    def repetitions(self, a_end, minor=True):
        ends = [x * 1e-3 for x in self.sizes if 2e-3 < x * 1e-3 < a_end]
        return sum(quad(lambda a: 1 / self.growth(a, minor), lo, hi, epsrel=1e-9)[0]
                   for lo, hi in zip([2e-3, *ends], [*ends, a_end]))


def willenborg_loop():
    """The shaft under torque 0 to 3000 N m twice and 0 to 6000 N m once, in this order, 15-5PH of
    the library (part-through), generalised Willenborg with beta 2, R_so 2.65, minimum closed, cycle
    by cycle at the changing size.  K = K_III (Richard).  From 1 mm to 1.01 mm, after one repetition
    at the first size: repetitions."""
    law = nasgro(1.359e-12, 4, 0.25, 0.25, 71.42, 2.165, 1, (1.36, -0.10), 2.5, 0.3, 38.1e-6)
    yield_, beta, R_so = 1100.0, 2, 2.65
    A0 = (0.825 - 0.34 * 2.5 + 0.05 * 2.5 ** 2) * math.cos(PI * 0.3 / 2) ** (1 / 2.5)
    shaft = Shaft()

    def threshold(a):
        return 2.165 * math.sqrt(a / (a + 38.1e-6)) / (1 - A0) / (1 - A0) ** 1.36

    def zone(K):
        return (K / yield_) ** 2 / (beta * PI)
    a, a_over, K_over, N = 1e-3, 1e-3, 0.0, -1
    grown = 0.0
    while True:
        if N == 0:
            a_over -= a - 1e-3  # the repetition before took place at the first size
            a = 1e-3
        if a >= 1.01e-3:
            return N, grown
        N += 1
        for T in (3000.0, 3000.0, 6000.0):
            K = shaft.factors(a, T, 0.0)[2]
            if a + zone(K) >= a_over + zone(K_over):
                a += law(K, 0.0, a)
                a_over, K_over = a, K
                continue
            through = (a - a_over) / zone(K_over)
            share = max(1 - threshold(a) / K, 0) / (R_so - 1)
            down = share * max(K_over * math.sqrt(max(1 - through, 0)) - K, 0)
            if K - down > 0:
                a += law(K - down, 0.0, a)


# --- Crack of the rim from a tooth root ----------------------------------------------------------

def root_concentration(pitch, radius):
    """K_t of a row of deep grooves: K = sigma sqrt(pitch/2) of the row of cracks, and the stress
    2 K/sqrt(pi radius) at a blunt tip."""
    return 2 * math.sqrt(pitch / 2) / math.sqrt(PI * radius)


def root_crack(pitch, radius, thickness, depth):
    """K per unit of membrane and of bending stress of the wall under the roots.  Stress of the
    elliptical hole by Muskhelishvili's potentials, crack in the strip by an integral equation,
    flanks by the fit (SW-11)."""
    D = (root_concentration(pitch, radius) - 1) ** 2 / 4  # over the radius
    hole = Hole(D)

    def notch(x):
        return np.array([float(hole.tension(hole.D + depth * y / radius)) for y in x])
    loads = [lambda x, v: notch(x), lambda x, v: notch(x) * (1 - 2 * depth * x / thickness)]
    a = depth / radius
    flanks = 1 - 0.286 * a / (a + 0.4) / (1 + 0.8 * a / D)
    return flanks * math.sqrt(PI * depth) * intensities(depth / thickness, loads)


def shallow_root_crack(pitch, radius, depth):
    """The same in tension for a depth far below the thickness, without weight function and fit: two
    cracks at the hole, and 1.1215 for a surface where the crack is deep against the notch."""
    D = radius * (root_concentration(pitch, radius) - 1) ** 2 / 4
    return (math.sqrt(PI * depth) * Hole(D / radius).cracks(depth / radius, 40)
            * (1 + 0.1215 * depth / (depth + D)))


def root_rows():
    table = Table("rim_root", "pitch [m]", "root_radius [m]", "thickness [m]", "depth [m]")
    pitch, thickness = PI * 62.801e-3 / 200, 0.755e-3
    for radius in (20e-6, 50e-6, 100e-6, 200e-6):
        table.add("concentration", (pitch, radius, "", ""), root_concentration(pitch, radius), "1",
                  OURS, digits=14, printed=16)
        for depth in (2e-6, 20e-6, 100e-6, 300e-6, 600e-6):
            for name, K in zip(("tension", "bending"), root_crack(pitch, radius, thickness, depth)):
                table.add(name, (pitch, radius, thickness, depth), K, "m^0.5", OURS, digits=5,
                          printed=8)
    for radius in (20e-6, 50e-6):  # (SW-11) is stated for D of at least the radius
        for depth in (2e-6, 10e-6, 30e-6):
            table.add("shallow", (pitch, radius, "", depth),
                      shallow_root_crack(pitch, radius, depth), "m^0.5", OURS, digits=4, printed=8)
    return table


def closure_loop():
    """As willenborg_loop, with 7000 N m twice and 10 000 N m once, to 1.05 mm.  The opening of the overload,
    f(0) K_OL, is held in its zone.  The cycle keeps R = 0; its range above the held opening makes
    the rate."""
    law = nasgro(1.359e-12, 4, 0.25, 0.25, 71.42, 2.165, 1, (1.36, -0.10), 2.5, 0.3, 38.1e-6)
    f = (0.825 - 0.34 * 2.5 + 0.05 * 2.5 ** 2) * math.cos(PI * 0.3 / 2) ** (1 / 2.5)
    shaft = Shaft()

    def zone(K):
        return (K / 1100.0) ** 2 / (2 * PI)
    a, a_over, K_over, N = 1e-3, 1e-3, 0.0, -1
    while True:
        if N == 0:
            a_over -= a - 1e-3  # the repetition before took place at the first size
            a = 1e-3
        if a >= 1.05e-3:
            return N
        N += 1
        for T in (7000.0, 7000.0, 10000.0):
            K = shaft.factors(a, T, 0.0)[2]
            if a + zone(K) >= a_over + zone(K_over):
                a += law(K, 0.0, a)
                a_over, K_over = a, K
            else:
                opened = max(K - f * K_over, 0)
                if opened > 0:
                    a += law(min(opened / (1 - f), K), 0.0, a)


# --- Rates from a table ---------------------------------------------------------------------------

CURVES = ((0.1, (5, 8, 15, 40), (1e-10, 2e-9, 2e-8, 6e-7)),
          (0.7, (3, 6, 25), (8e-11, 3e-9, 5e-7)))


def curve_at(R):
    """ln of ranges and rates of the curve at R, and whether the table has curves on both sides."""
    logs = [(np.log(x), np.log(y)) for _, x, y in CURVES]
    if R <= CURVES[0][0]:
        return logs[0]
    if R >= CURVES[1][0]:
        return logs[1]
    w = (R - CURVES[0][0]) / (CURVES[1][0] - CURVES[0][0])
    places = [(x - x[0]) / (x[-1] - x[0]) for x, _ in logs]
    place = np.union1d(*places)
    x = sum(v * np.interp(place, p, c[0]) for v, p, c in zip((1 - w, w), places, logs))
    y = sum(v * np.interp(place, p, c[1]) for v, p, c in zip((1 - w, w), places, logs))
    return x, y


def table_life(R):
    """Cycles from 1 to 6 mm, Y = 1.12, 150 MPa of full range; each line has a closed form there:
    da/dN is a power of the range."""
    x, y = curve_at(R)
    slope = np.diff(y) / np.diff(x)
    size = (np.exp(x) / (1.12 * 150)) ** 2 / PI  # at each point
    size[-1] = np.inf  # the last line goes on
    total = 0.0
    for low, high, x0, y0, m in zip(size[:-1], size[1:], x[:-1], y[:-1], slope):
        low, high = max(low, 1e-3), min(high, 6e-3)
        if low < high:
            at_one = math.exp(y0 + m * (math.log(1.12 * 150 * math.sqrt(PI)) - x0))
            total += (high ** (1 - m / 2) - low ** (1 - m / 2)) / (1 - m / 2) / at_one
    return total


class BentShaft:
    """Solid shaft of 60 mm with a surface crack, a 1 mm, half length 1.5 mm along the arc: constant
    torque 3000 N m, and a bending moment of 2000 N m round which it turns.  K from the coefficients
    of bar_surface.py in library_tables.csv, joined here by polynomials in Newton's form."""
    r, T, M = 30e-3, 3000.0, 2000.0
    C, m = 6.9e-12, 3
    shallow, deep, aspects = (0.025, 0.05), (0.1, 0.2, 0.3, 0.4, 0.5), (0, 0.25, 0.5, 0.75, 1)

    def __init__(self):
        self.table = {name: np.zeros((7, 5, 4))
                      for name in ("tension", "bending", "sliding", "tearing")}
        with open(DATA / "library_tables.csv", encoding="ascii", newline="") as file:
            for row in csv.DictReader(file):
                if row["case"].startswith("front."):
                    at = tuple(int(row[f"{name} [1]"]) for name in "ijk")
                    self.table[row["case"][6:]][at] = float(row["value"])

    @staticmethod
    def newton(x, y, at):
        """Divided differences; y may be arrays."""
        y = [np.array(v, dtype=float) for v in y]
        value, product = y[0].copy(), 1.0
        for order in range(1, len(x)):
            y = [(y[i + 1] - y[i]) / (x[i + order] - x[i]) for i in range(len(y) - 1)]
            product *= at - x[order - 1]
            value = value + y[0] * product
        return value

    def factor(self, name, d, k, t):
        over_k = [self.newton(self.aspects, list(row), k) for row in self.table[name]]
        value = self.newton(self.deep, over_k[2:], d)
        if d < 0.1:
            ends = [(over_k[i] - self.newton(self.deep, over_k[2:], x)) / (x - 0.1) ** 2
                    for i, x in enumerate(self.shallow)]
            value = value + (d - 0.1) ** 2 * self.newton(self.shallow, ends, d)
        return float(sum(c * t ** (2 * n) for n, c in enumerate(value))) \
            * (t if name == "sliding" else 1)

    def growth(self, a, s, t):
        """In one turn, at the place t of half of the front; (FR-22), (SB-7), (GR-34)."""
        r, end = self.r, s / self.r
        sunk = (1 - math.cos(end)) * r / a
        k = a * math.sqrt(1 - sunk ** 2) / (r * math.sin(end))
        d = a / (2 * r)
        F = {name: self.factor(name, d, k, t) for name in self.table}
        psi = math.acos(sunk)
        y = math.sin(t * psi) * a / k / r
        root = math.sqrt(PI * a) * 1e-6
        bending = math.hypot(F["bending"], 2 / 3 * F["tension"] * y) \
            * 4 * self.M / (PI * r ** 3) * root
        shear = 2 * self.T / (PI * r ** 3) * root
        states = [[sign * bending, F["sliding"] * shear, F["tearing"] * shear] for sign in (1, -1)]
        return paris(self.C, self.m)(*tip_cycle(*states), a)

    def until_depth(self, a_end):
        """Turns and half length."""
        solved = solve_ivp(lambda a, y: [1 / self.growth(a, y[1], 0.0),
                                         self.growth(a, y[1], 0.9) / self.growth(a, y[1], 0.0)],
                           (1e-3, a_end), [0.0, 1.5e-3], method="DOP853", rtol=1e-11, atol=1e-15)
        return solved.y[0][-1], solved.y[1][-1]


OURS = "computed here"


def tables():
    table = Table("crack_growth", "size [m]")
    none = ""
    for name, bending in (("P1.tension", False), ("P1.bending", True)):
        N, c = plate(bending)
        table.add(f"{name}.cycles", (none,), N, "1", OURS, digits=10, printed=12)
        table.add(f"{name}.half_length", (none,), c, "m", OURS, digits=10, printed=12)
    table.add("P2.blocks", (none,), easigrow_block(), "1", OURS, digits=10, printed=12)
    table.add("P3.cycles", (none,), finite_plate_paris(), "1", OURS, digits=11, printed=13)
    table.add("G3.cycles", (none,), single_cycles(), "1", OURS)
    N, rest = falls_to_threshold()
    table.add("G8.cycles", (none,), N, "1", OURS, digits=11, printed=13)
    table.add("G8.rest", (none,), rest, "m", OURS, digits=12, printed=14)
    table.add("G18.blocks", (none,), block(False, False), "1", OURS, digits=11, printed=13)
    table.add("G18.tensile_blocks", (none,), block(True, False), "1", OURS, digits=11, printed=13)
    table.add("G18.loop", (none,), block(False, True), "1", OURS)
    shaft = Shaft()
    for mm in (1, 3, 8):
        table.add("shaft.repetitions", (mm * 1e-3,), shaft.repetitions(mm * 1e-3), "1", OURS,
                  digits=10, printed=12)
    factor, size = shaft.start(20.0)
    table.add("shaft.factor_to_grow", (0.5e-3,), factor, "1", OURS, digits=10, printed=12)
    table.add("shaft.size_at_rest", (none,), size, "m", OURS, digits=10, printed=12)
    table.add("shaft.willenborg", (1.01e-3,), willenborg_loop()[0], "1", OURS, digits=4)
    table.add("shaft.closure", (1.05e-3,), closure_loop(), "1", OURS, digits=4)
    for name, R in (("below", -0.5), ("between", 0.4), ("above", 0.8)):
        table.add(f"table.{name}", (none,), table_life(R), "1", OURS, digits=12, printed=14)
    wall = Wall()
    for c in (1e-3, 1.5e-3, 2.5e-3):
        N, a = wall.until_length(c)
        table.add("wall.repetitions", (c,), N, "1", OURS, digits=9, printed=11)
        table.add("wall.depth", (c,), a, "m", OURS, digits=9, printed=11)
    turn = Turn()
    for a in (3e-3, 6e-3):
        table.add("turn.repetitions", (a,), turn.repetitions(a), "1", OURS, digits=8, printed=11)
    table.add("turn.without_smaller_cycles", (6e-3,), turn.repetitions(6e-3, False), "1", OURS,
              digits=8, printed=11)
    bent = BentShaft()
    for a in (1.5e-3, 5e-3, 15e-3):
        turns, length = bent.until_depth(a)
        table.add("bent_shaft.turns", (a,), turns, "1", OURS, digits=9, printed=11)
        table.add("bent_shaft.half_length", (a,), length, "m", OURS, digits=9, printed=11)
    return [table, root_rows()]


if __name__ == "__main__":
    if "--table" in sys.argv[1:]:
        TURN_TABLE.write_text(Turn.text(), encoding="ascii", newline="\n")
    publish(*tables())
