#!/usr/bin/env python3
"""Torsional stiffness of a strain wave drive with three cracks, in plain numpy and scipy.

The peer of strainwave's default ("corrected") evaluation of examples/article.toml, written the way
an engineer would write it for one drive; it never imports strainwave.

    wave generator   semi-elliptical crack in the inner ring, Newman-Raju, energy by dblquad
    flexspline       through crack at 45 degrees, shell (Folias) correction, energy by quad
    output shaft     hollow, annular crack: torsion factor from a table, bicubic spline

    three_crack_drive.py --repeat 100
    {"stiffness_positive": ... [N*m/rad], "stiffness_negative": ..., "seconds_per_evaluation": ...}

    three_crack_drive.py --draws 100000
    {"median": [...], "seconds_per_draw": ...}

The draws are those of examples/article_scatter.toml: the same closed forms in columns of numpy, with fixed
rules of Gauss and Legendre, which are exact to 1e-10 here.  The answer has the quantiles 0.05, 0.5 and 0.95 of both stiffnesses.
"""
import argparse
import json
import time
from math import cos, log, pi, radians, sin, sqrt

import numpy as np
from scipy.integrate import dblquad, quad
from scipy.interpolate import RectBivariateSpline

RTOL = 1e-10

# SI units throughout
E, MU, NU = 210e9, 80e9, 0.3
U, D1 = 2, 0.160  # waves, pitch diameter
K_R, C_F, K_G0 = 0.35, 1.15, 1.2e8  # force transmission, load factor, lobe stiffness
RING, A_C, B_C, BETA = 0.010, 0.005, 0.002, 0.45  # ring thickness, contact semi-axes and factor
RING_CRACK, ASPECT = 1e-4, 0.52147039
DELTA, LENGTH, K_CUP, K_U = 2.24e-3, 0.160, 0.83, 1.1
WALL_CRACK, ANGLE = 1e-4, radians(45)
D_O, D_I, SHAFT_LENGTH, SHAFT_CRACK = 0.070, 0.045, 0.200, 1e-4

# Added torsional compliance of a hollow shaft over that of a thin-walled tube, by ratio of radii
# (rows) and depth/wall (columns); the first column is the exact shallow limit.
RATIOS = np.array([0, 0.2, 0.4, 0.5, 0.6, 9 / 14, 0.7, 0.8, 0.9])
DEPTHS = np.array([0, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8])
FACTORS = np.array([
    [4.00789, 4.04223, 4.14726, 4.52852, 5.18960, 6.29163, 8.21287, 11.92712, 20.53631, 48.44633],
    [3.20909, 3.22657, 3.27931, 3.46303, 3.75689, 4.19142, 4.82890, 5.78692, 7.29749, 9.86515],
    [2.46467, 2.47203, 2.49388, 2.56711, 2.67649, 2.82387, 3.01542, 3.26184, 3.58011, 3.99849],
    [2.13426, 2.13859, 2.15138, 2.19347, 2.25455, 2.33392, 2.43265, 2.55323, 2.69984, 2.87963],
    [1.83870, 1.84104, 1.84788, 1.87002, 1.90136, 1.94087, 1.98834, 2.04406, 2.10889, 2.18465],
    [1.72313, 1.72486, 1.72990, 1.74611, 1.76883, 1.79715, 1.83076, 1.86966, 1.91425, 1.96553],
    [1.57934, 1.58044, 1.58364, 1.59384, 1.60797, 1.62535, 1.64566, 1.66881, 1.69488, 1.72433],
    [1.35504, 1.35545, 1.35663, 1.36034, 1.36539, 1.37147, 1.37843, 1.38618, 1.39471, 1.40412],
    [1.16309, 1.16317, 1.16342, 1.16418, 1.16520, 1.16641, 1.16777, 1.16926, 1.17087, 1.17262]])
SHALLOW = 4 / ((1 + RATIOS) * (1 + RATIOS ** 2))
TORSION_FACTOR = RectBivariateSpline(RATIOS, DEPTHS, np.column_stack((SHALLOW, FACTORS)))


def newman_raju(depth, aspect, thickness, phi):
    """K_I per unit stress of a semi-elliptical surface crack [m^0.5]."""
    alpha = depth / thickness
    q = 1 + 1.464 * aspect ** 1.65
    m = (1.13 - 0.09 * aspect + (0.89 / (0.2 + aspect) - 0.54) * alpha ** 2
         + (0.5 - 1 / (0.65 + aspect) + 14 * (1 - aspect) ** 24) * alpha ** 4)
    sine, cosine = sin(phi), cos(phi)
    g = 1 + (0.1 + 0.35 * alpha ** 2) * (1 - sine) ** 2
    f = ((aspect * cosine) ** 2 + sine ** 2) ** 0.25
    return sqrt(pi * depth / q) * m * g * f


def wave_generator():
    """Sound and added compliance [rad/(N*m)]."""
    lobe_force = 2 * C_F * K_R / (U * D1)  # per torque
    stress = BETA / 2 * 3 / (2 * pi * A_C * B_C)  # per lobe force
    # lengths in units of the crack depth: dblquad's tolerances are then relative
    energy, _ = dblquad(
        lambda phi, s: newman_raju(s, ASPECT, RING / RING_CRACK, phi) ** 2 * s / ASPECT,
        0, 1, 0, pi, epsabs=0, epsrel=RTOL)
    added = 2 * (1 - NU ** 2) / E * stress ** 2 * energy * RING_CRACK ** 3
    return lobe_force ** 2 * U / K_G0, lobe_force ** 2 * added


def flexspline():
    radius = (D1 - DELTA) / 2
    sound = K_CUP * 32 * LENGTH / (pi * MU * (D1 ** 4 - (D1 - 2 * DELTA) ** 4))
    shear = K_U / (2 * pi * radius ** 2 * DELTA)  # per torque
    bulging = pi / 64 * (5 * cos(ANGLE) ** 2 + sin(ANGLE) ** 2)

    def integrand(s):
        shell = 1 + bulging * sqrt(12 * (1 - NU ** 2)) * s ** 2 / (radius * DELTA)
        opening, sliding = shell * shear * sin(2 * ANGLE), shear * cos(2 * ANGLE)
        return 2 / E * (opening ** 2 + sliding ** 2) * pi * s * 2 * DELTA

    added, _ = quad(integrand, 0, WALL_CRACK, epsabs=0, epsrel=RTOL)
    return sound, added


def output_shaft():
    polar_moment = pi / 32 * (D_O ** 4 - D_I ** 4)
    wall = (D_O - D_I) / 2
    alpha = SHAFT_CRACK / wall
    thin = 4 * wall / (pi * MU * polar_moment) * -log(cos(pi * alpha / 2))
    added = thin * TORSION_FACTOR(D_I / D_O, alpha)[0, 0]
    return SHAFT_LENGTH / (MU * polar_moment), added


def stiffness():
    """Under torque that opens the flexspline crack, and under torque that closes it."""
    (h, dh), (f, df), (s, ds) = wave_generator(), flexspline(), output_shaft()
    return 1 / (h + dh + f + df + s + ds), 1 / (h + dh + f + s + ds)


def gauss(n, low, high):
    """Nodes and weights of the rule of Gauss and Legendre."""
    x, w = np.polynomial.legendre.leggauss(n)
    return low + (high - low) * (x + 1) / 2, w * (high - low) / 2


def stiffness_in_columns(young, shear_modulus, wall, lobe, ring_crack, half_length, angle, shaft_crack):
    """As `stiffness`, for columns of the numbers that scatter in examples/article_scatter.toml."""
    # wave generator: axes are (row, relative depth, angle along the front)
    s, ws = gauss(8, 0, 1)
    phi, wphi = gauss(16, 0, pi / 2)
    alpha2 = ((ring_crack / RING)[:, None] * s) ** 2
    q = 1 + 1.464 * ASPECT ** 1.65
    m = (1.13 - 0.09 * ASPECT + (0.89 / (0.2 + ASPECT) - 0.54) * alpha2
         + (0.5 - 1 / (0.65 + ASPECT) + 14 * (1 - ASPECT) ** 24) * alpha2 ** 2)
    g = 1 + (0.1 + 0.35 * alpha2)[:, :, None] * (1 - np.sin(phi)) ** 2
    f2 = np.sqrt((ASPECT * np.cos(phi)) ** 2 + np.sin(phi) ** 2)
    energy = ((g ** 2 @ (2 * wphi * f2)) * m ** 2) @ (ws * pi * s ** 2 / q / ASPECT)
    lobe_force = 2 * C_F * K_R / (U * D1)
    stress = BETA / 2 * 3 / (2 * pi * A_C * B_C)
    h = lobe_force ** 2 * U / lobe
    dh = lobe_force ** 2 * 2 * (1 - NU ** 2) / young * stress ** 2 * energy * ring_crack ** 3
    # flexspline
    radius = (D1 - wall) / 2
    sound = K_CUP * 32 * LENGTH / (pi * shear_modulus * (D1 ** 4 - (D1 - 2 * wall) ** 4))
    shear = K_U / (2 * pi * radius ** 2 * wall)
    cosine, sine = np.cos(angle), np.sin(angle)
    bulging = pi / 64 * (5 * cosine ** 2 + sine ** 2) * sqrt(12 * (1 - NU ** 2)) / (radius * wall)
    s, ws = gauss(4, 0, 1)
    shell = 1 + bulging[:, None] * (half_length[:, None] * s) ** 2
    opening = shear * 2 * sine * cosine
    sliding = shear * (cosine ** 2 - sine ** 2)
    squares = (shell * opening[:, None]) ** 2 + (sliding ** 2)[:, None]
    df = 2 / young * (squares @ (ws * pi * s)) * half_length ** 2 * 2 * wall
    # output shaft
    polar_moment = pi / 32 * (D_O ** 4 - D_I ** 4)
    depth = (D_O - D_I) / 2
    alpha = shaft_crack / depth
    thin = 4 * depth / (pi * shear_modulus * polar_moment) * -np.log(np.cos(pi * alpha / 2))
    ds = thin * TORSION_FACTOR.ev(D_I / D_O, alpha)
    rest = h + dh + sound + SHAFT_LENGTH / (shear_modulus * polar_moment) + ds
    return 1 / (rest + df), 1 / rest


def draws(n, at_a_time=250):
    """Quantiles of both stiffnesses over n draws."""
    random = np.random.default_rng(1)
    # median, relative standard deviation, whether log-normal
    inputs = [(E, 0.01, True), (MU, 0.01, True), (DELTA, 0.01, False), (K_G0, 0.15, True),
              (RING_CRACK, 0.25, True), (WALL_CRACK, 0.10, True), (ANGLE, 0.05, False),
              (SHAFT_CRACK, 0.25, True)]
    values = np.empty((2, n))
    for first in range(0, n, at_a_time):
        rows = min(at_a_time, n - first)
        columns = []
        for centre, deviation, logarithmic in inputs:
            u = random.standard_normal(rows)
            if logarithmic:
                columns.append(centre * np.exp(sqrt(log(1 + deviation ** 2)) * u))
            else:
                columns.append(centre * (1 + deviation * u))
        values[:, first:first + rows] = stiffness_in_columns(*columns)
    return np.quantile(values, [0.05, 0.5, 0.95], axis=1)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--repeat", type=int, default=1, metavar="N")
    parser.add_argument("--draws", type=int, metavar="N")
    given = parser.parse_args()
    if given.draws:
        start = time.perf_counter()
        quantiles = draws(given.draws)
        seconds = (time.perf_counter() - start) / given.draws
        print(json.dumps({"median": list(quantiles[1]), "seconds_per_draw": seconds}))
        return
    n = max(1, given.repeat)
    start = time.perf_counter()
    for _ in range(n):
        positive, negative = stiffness()
    seconds = (time.perf_counter() - start) / n
    print(json.dumps({"stiffness_positive": positive, "stiffness_negative": negative,
                      "seconds_per_evaluation": seconds}))


if __name__ == "__main__":
    main()
