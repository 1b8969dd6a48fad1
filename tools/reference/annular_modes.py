# SPDX-License-Identifier: Apache-2.0
"""Annular cracks of a shaft in torsion: the sums over the modes of (CG-11), (CG-12), mode by mode.

The library lets a few modes at places between whole numbers stand for long blocks of modes (CG-13), and computes its
Bessel functions by phase and amplitude.  This script finds each mode by itself, as a root of

    J_2(k) Y_2(k rho) - Y_2(k) J_2(k rho)       (J_2(k) of a solid shaft)

between two changes of its sign, adds all of them, and takes Legendre's polynomials in place of Jacobi's: both span the same functions, so
the solution is the same.  Outer radius and G are 1; rotation is that per unit of torque, and factor is K_III over that of the crack alone.

    annular_modes.py           JSON
    annular_modes.py --write   tests/data/annular_modes.csv
"""
import math

import numpy as np
from scipy.optimize import brentq
from scipy.special import eval_legendre, jv, yv

from reference_csv import Table, publish

FUNCTIONS = 10
FIRST, LAST = 64.0, 112.0  # products of wave number and depth between which a mode fades
# inner radius, ((place, depth), (place, depth))
CASES = (
    (0.0, ((0.0, 0.011), (0.004, 0.013))),
    (0.6, ((0.0, 0.012), (0.02, 0.1))),
    (0.02, ((0.0, 0.02), (0.1, 0.3))),
)


def fading(phase):
    s = np.clip((phase - FIRST) / (LAST - FIRST), 0, 1)
    return np.maximum(0, 1 - s**3 * (10 - 15 * s + 6 * s**2))


def rest():
    """The integral of (1 - fading(x))/x^2 from 0 to infinity."""
    x, weight = np.polynomial.legendre.leggauss(200)
    x = FIRST + (LAST - FIRST) * (1 + x) / 2
    return np.sum(weight * (LAST - FIRST) / 2 * (1 - fading(x)) / x**2) + 1 / LAST


def wave_numbers(inner, largest):
    """All roots up to a wave number, by the changes of the sign."""
    def condition(k):
        return jv(2, k) * yv(2, k * inner) - yv(2, k) * jv(2, k * inner) if inner > 0 else jv(2, k)

    grid = np.linspace(0.5, largest, int(40 * largest * (1 - inner) / math.pi))
    values = condition(grid)
    return [brentq(condition, grid[i], grid[i + 1], xtol=1e-13, rtol=1e-15)
            for i in np.flatnonzero(values[:-1] * values[1:] < 0)]


class Jump:
    """The functions of a crack: their integrals with each mode and with the stress r of the shaft."""

    def __init__(self, inner, crack, modes):
        self.place, self.depth = crack
        self.tip = 1 - self.depth
        s, weight = np.polynomial.legendre.leggauss(500)
        s, weight = (1 + s) / 2, weight / 2
        r = self.tip + self.depth * s**2
        functions = np.array([r * s * eval_legendre(m, 1 - 2 * s**2) for m in range(FUNCTIONS)])
        measure = weight * 2 * s * self.depth * r
        self.of_torque = functions @ (measure * r)
        kept = [k for k in modes if k * self.depth < LAST]
        self.modes = np.zeros((FUNCTIONS, len(modes)))
        for n, k in enumerate(kept):
            phi = jv(1, k * r) - (jv(2, k * inner) / yv(2, k * inner) * yv(1, k * r) if inner > 0 else 0)
            self.modes[:, n] = functions @ (measure * phi) * math.sqrt(fading(k * self.depth))


def norms(inner, modes):
    def phi(k, r):
        return jv(1, k * r) - (jv(2, k * inner) / yv(2, k * inner) * yv(1, k * r) if inner > 0 else 0)

    return np.array([(phi(k, 1)**2 - (inner**2 * phi(k, inner)**2 if inner > 0 else 0)) / 2 for k in modes])


def answers(inner, cracks):
    """[(rotation, factor)] of the cracks."""
    modes = wave_numbers(inner, LAST / min(depth for _, depth in cracks))
    weights = np.array(modes) / (2 * norms(inner, modes))
    jumps = [Jump(inner, crack, modes) for crack in cracks]
    polar = math.pi / 2 * (1 - inner**4)

    def stress(one, other):
        between = weights * np.exp(-np.array(modes) * abs(one.place - other.place))
        matrix = (one.modes * between) @ other.modes.T
        # Each polynomial of Legendre is 1 at the tip.
        return matrix + (one.tip**3 * rest() / 8 if one is other else 0)

    def solved(of):
        matrix = np.block([[stress(one, other) for other in of] for one in of])
        return np.linalg.solve(matrix, np.concatenate([jump.of_torque for jump in of])).reshape(len(of), -1)

    together = solved(jumps)
    return [(2 * math.pi * jump.of_torque @ x / polar**2, sum(x) / np.sum(solved([jump])[0]))
            for jump, x in zip(jumps, together)]


def table(cases):
    out = Table("annular_modes", "inner [1]", "place_0 [1]", "depth_0 [1]", "place_1 [1]", "depth_1 [1]")
    for inner, cracks in cases:
        inputs = [inner] + [number for crack in cracks for number in crack]
        for j, (rotation, factor) in enumerate(answers(inner, cracks)):
            out.add(f"rotation_{j}", inputs, rotation, "1", "sum over all modes", digits=8, printed=10)
            out.add(f"factor_{j}", inputs, factor, "1", "sum over all modes", digits=8, printed=10)
    return out


def some_tables():
    return [table(CASES[1:2])]


def tables():
    return [table(CASES)]


if __name__ == "__main__":
    publish(*tables())
