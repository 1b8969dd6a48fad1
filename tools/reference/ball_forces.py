# SPDX-License-Identifier: Apache-2.0
"""Forces of balls and teeth at the rated torque (TC-37), against equilibrium and a stated life.

For size 25 at the ratios 50 and 100 the script prints the force of every loaded ball with the Hertz
pressures of both races, the forces of the drive flanks, the least possible largest ball force, and
the basic rating life of the bearing by Lundberg and Palmgren from the ball forces.

Equilibrium of the cam without friction: the balls turn it with the input torque T/i, so
sum Q sin(2 psi) = T/(2 i w0).  If the loaded balls share this equally over 90 degrees beside each
lobe, their force is the least possible largest one.

Life (all in N and mm): Q_c = 98.1 (2f/(2f - 1))^0.41 (1 -+ g)^1.39/(1 +- g)^(1/3) g^0.3 D^1.8 Z^(-1/3),
g = D/D_pw, upper signs for the inner race.  The load stands still against the inner race,
Q_e = (mean Q^(10/3))^0.3, and turns against the outer race, Q_e = (mean Q^3)^(1/3).
L = (L_i^(-10/9) + L_o^(-10/9))^(-9/10) million turns.

    ball_forces.py    Markdown tables on stdout
"""
from math import cos, pi, radians, sin, sqrt

import numpy as np

import coupled_drive

RATED = {50: 51.0, 100: 87.0}  # maximum of the average torque of size 25, N*m
SPEED = 2000.0  # of the input, 1/min
DRIVE = dict(spline_support=0.5, tooth="straight", tips="relieved")


def pressure(force, g, convex):
    """Largest Hertz pressure of a ball on its race, from the approach law Q = (d/c)^1.5."""
    E, nu = g["youngs_modulus"], g["poissons_ratio"]
    race = g["inner_race_diameter"] if convex else g["outer_race_diameter"]
    f = g["inner_conformity"] if convex else g["outer_conformity"]
    D = g["ball_diameter"]
    rolling = 2 / D + (2 if convex else -2) / race
    across = 2 / D - 1 / (f * D)
    low, high = sorted((rolling, across))
    s = coupled_drive.brentq(
        lambda s: coupled_drive.elliprd(0, s * s, 1) / coupled_drive.elliprd(0, 1, s * s)
        - low / high, 1e-3, 1)
    modulus = E / (2 * (1 - nu ** 2))
    a = (force * coupled_drive.elliprd(0, s * s, 1) / (pi * modulus * low)) ** (1 / 3)
    return 1.5 * force / (pi * s * a * a)


def rating(g, inner):
    """Q_c of one race, N."""
    D = 1e3 * g["ball_diameter"]
    pitch = 500 * (g["inner_race_diameter"] + g["outer_race_diameter"])
    f = g["inner_conformity"] if inner else g["outer_conformity"]
    sign = -1 if inner else 1
    ratio = D / pitch
    return (98.1 * (2 * f / (2 * f - 1)) ** 0.41 * (1 + sign * ratio) ** 1.39
            / (1 - sign * ratio) ** (1 / 3) * ratio ** 0.3 * D ** 1.8
            * g["ball_count"] ** (-1 / 3))


def life(Q, g):
    """Basic rating life, h."""
    inner = np.mean(Q ** (10 / 3)) ** 0.3
    outer = np.mean(Q ** 3) ** (1 / 3)
    lives = [(rating(g, True) / inner) ** 3, (rating(g, False) / outer) ** 3]
    return sum(x ** (-10 / 9) for x in lives) ** -0.9 * 1e6 / (60 * SPEED)


def least_largest(g, torque, span):
    """The largest ball force if the balls within `span` of the loaded side share equally."""
    psi = 2 * pi * np.arange(g["ball_count"]) / g["ball_count"]
    beside = np.remainder(psi + pi / 2, pi) - pi / 2  # from the nearest lobe
    lever = np.sin(2 * beside)
    loaded = max((np.sum(lever[(side * beside > 0) & (side * beside <= span)]) * side
                  for side in (1, -1)))
    return torque / (2 * g["ratio"] * g["radial_displacement"]) / loaded


def main():
    for ratio, torque in RATED.items():
        g = coupled_drive.typical(25, ratio, **DRIVE)
        model = coupled_drive.Coupled(g)
        state = model.curve([torque / 4, torque / 2, torque])[-1][2]
        Q = state.ball_force
        psi = np.degrees(np.remainder(2 * pi * np.arange(len(Q)) / len(Q) + pi / 2, pi) - pi / 2)
        print(f"\nratio {ratio}, {torque:g} N*m: largest {Q.max():.0f} N, at rest "
              f"{model.start.ball_force.max():.0f} N; balance of the cam "
              f"{abs(np.sum(Q * np.sin(2 * np.radians(psi)))):.0f} N of "
              f"{torque / (2 * ratio * g['radial_displacement']):.0f} N; least possible largest "
              f"{least_largest(g, torque, pi / 2):.0f} N; life {life(Q, g):.0f} h, with the groove "
              f"0.515 {life(Q, g | dict(inner_conformity=0.515, outer_conformity=0.515)):.0f} h")
        print("| ball, degrees from its lobe | force, N | inner, MPa | outer, MPa |\n|--:|--:|--:|--:|")
        for k in np.argsort(-Q):
            if Q[k] > 0:
                print(f"| {psi[k]:.0f} | {Q[k]:.0f} | {pressure(Q[k], g, True) / 1e6:.0f} | "
                      f"{pressure(Q[k], g, False) / 1e6:.0f} |")
        F = state.flank_force[:model.teeth]
        print(f"{np.sum(F > 0)} drive flanks, largest {F.max():.1f} N, "
              f"sum {F.sum():.0f} N; coast flanks {state.flank_force[model.teeth:].sum():.1f} N")


if __name__ == "__main__":
    main()
