# SPDX-License-Identifier: Apache-2.0
"""Cups with a steel rim on a barrel of plies by finite elements of a shell, and bottoms of plies.

`cup` and `open` are the shell of revolution of flexspline_shell.py, whose barrel has the matrices A,
B and D of its plies in place of the isotropic ones.  All couplings are in it: shear and twist are a
quarter of a wave behind the other strains, so the displacements are complex.  The corner to the
steel bottom stays right.

`bottom` is a flat plate of plies, clamped at its inner edge; the outer edge moves by cos(n theta).
The fibres keep their directions, so the plate is solved by Rayleigh and Ritz over several waves at
once.  The value is the mean over the directions of the wave.

Independent of the library, whose (LA-16) leaves out the couplings and the bending along the axis,
and whose (LA-17) takes the mean of the bending stiffness over the directions.

    laminate_wall.py --write   tests/data/laminate_wall.csv
"""
from math import hypot, pi

import numpy as np
from scipy.linalg import solveh_banded

import flexspline_shell as shell
from laminate import T300, STEEL, plane_stress, tensor, turned
from reference_csv import Table, publish

SOURCE = "shell of revolution with A B D; plate by Rayleigh and Ritz"
STEEL_SHELL = (shell.E, shell.E, shell.E / (2 * (1 + shell.NU)), shell.NU, shell.NU)


def ABD(plies, thickness):
    """The 6 x 6 matrix over strains and curvatures of axis, hoop and shear."""
    total = sum(t for *_, t in plies)
    M = np.zeros((6, 6))
    z = -thickness / 2
    for layer, angle, t in plies:
        a = plane_stress(turned(tensor(layer), angle))
        Q = np.linalg.inv(np.array([[a[0], a[1], a[3]], [a[1], a[2], a[4]], [a[3], a[4], a[5]]]))
        end = z + t / total * thickness
        for k, (p, q) in enumerate(((0, 0), (0, 3), (3, 3))):
            M[p:p + 3, q:q + 3] += Q * (end ** (k + 1) - z ** (k + 1)) / (k + 1)
        z = end
    M[3:, :3] = M[:3, 3:]
    return M


def cup(n, g, plies, fine=20):
    """(stiffness, tilt) of mode n with a barrel of plies."""
    parts = shell.parts_of(g, fine)
    barrel = 1 if g["bottom_thickness"] else 0
    nodes = 1 + sum(part[-1] for part in parts)
    K = np.zeros((shell.BAND, 6 * nodes), complex)
    first = 0
    for number, (r0, z0, r1, z1, t, count) in enumerate(parts):
        h = hypot(r1 - r0, z1 - z0) / count
        sine, cosine = (r1 - r0) / (count * h), (z1 - z0) / (count * h)
        T = np.eye(shell.BAND)
        for k in (0, 6):
            T[k, k], T[k, k + 2], T[k + 2, k], T[k + 2, k + 2] = sine, cosine, cosine, -sine
        M = ABD(plies if number == barrel else [(STEEL_SHELL, 0.0, 1.0)], t)
        for i in range(count):
            Ke = np.zeros((shell.BAND, shell.BAND), complex)
            for x, weight in zip(*shell.GAUSS):
                r = r0 + sine * h * (i + (1 + x) / 2)
                membrane, bending = shell.strains(n, (1 + x) / 2, h, sine, cosine, r)
                rows = np.array([*membrane, *bending], complex)
                rows[[2, 5]] *= -1j  # sin(n theta)
                Ke += pi * r * h * weight / 2 * rows.conj().T @ M @ rows
            Ke = T.T @ Ke @ T
            at = 6 * (first + i)
            for k in range(shell.BAND):
                K[:shell.BAND - k, at + k] += Ke[k:, k]
        first += count
    K[0, -2:] = 1
    size = K.shape[1]
    middle = size // 6 - 1 - fine
    load = np.zeros(size, complex)
    K[0, 6 * middle] += g["ring_bending"] * pi * (n * n - 1) ** 2 / g["radius"] ** 3
    load[6 * middle] = 1
    for k in range(4) if g["bottom_thickness"] else range(2):
        K[1:, k] = 0
        for j in range(1, min(shell.BAND, k + 1)):
            K[j, k - j] = 0
        K[0, k], load[k] = 1, 0
    state = solveh_banded(K, load, lower=True)
    W, slope = state[6 * middle], state[6 * middle + 3]
    return (1 / W).real, (slope / W).real


def bottom(n, plies, thickness, inner, outer, terms=9, waves=8):
    """Mean over the directions of the wave of the stiffness of the outer edge; corner left free."""
    D = ABD(plies, thickness)[3:, 3:]
    orders = range(n % 2, n + waves + 1, 2)
    x, wx = np.polynomial.legendre.leggauss(24)
    around = 64
    unknown = [(k, phase) for k in orders for phase in ((0, 1) if k else (0,))]
    size = terms * len(unknown)
    K = np.zeros((size, size))
    # Shapes (s^2 P_j) of s from 0 at the clamped edge to 1.
    shapes = [np.polynomial.Polynomial([0, 0, 1]) *
              np.polynomial.Legendre.basis(j, domain=[0, 1]).convert(kind=np.polynomial.Polynomial)
              for j in range(terms)]
    width = outer - inner
    for point, weight in zip(x, wx):
        s = (1 + point) / 2
        r = inner + width * s
        f = np.array([p(s) for p in shapes])
        df = np.array([p.deriv()(s) for p in shapes]) / width
        ddf = np.array([p.deriv(2)(s) for p in shapes]) / width ** 2
        for m in range(around):
            a = 2 * pi * (m + 0.5) / around
            rows = np.zeros((3, size))
            for i, (k, phase) in enumerate(unknown):
                c, dc = ((np.cos(k * a), -k * np.sin(k * a)) if phase == 0 else
                         (np.sin(k * a), k * np.cos(k * a)))
                at = slice(terms * i, terms * (i + 1))
                rr = -ddf * c
                tt = -(df / r - k * k * f / r ** 2) * c
                rt = -2 * (df / r - f / r ** 2) * dc
                C, S = np.cos(a), np.sin(a)
                rows[0, at] = C * C * rr + S * S * tt - C * S * rt
                rows[1, at] = S * S * rr + C * C * tt + C * S * rt
                rows[2, at] = 2 * C * S * (rr - tt) + (C * C - S * S) * rt
            K += weight / 2 * width * r * (2 * pi / around) * rows.T @ D @ rows
    edge = np.array([p(1.0) for p in shapes])
    constraint = np.zeros((len(unknown), size))
    for i in range(len(unknown)):
        constraint[i, terms * i:terms * (i + 1)] = edge
    compliance = constraint @ np.linalg.solve(K, constraint.T)
    stiffness = np.linalg.inv(compliance)
    own = [i for i, (k, _) in enumerate(unknown) if k == n]
    return np.mean([stiffness[i, i] for i in own])


def angles(*degrees):
    return [(T300, np.radians(a), 1.0) for a in degrees]


BARRELS = {
    "steel": [(STEEL_SHELL, 0.0, 1.0)],
    "angle_ply": angles(45, -45, -45, 45),
    "steep": angles(60, -60, 0, 0, -60, 60),
    "cross_ply": angles(0, 90, 90, 0),
    "quasi": angles(0, 45, -45, 90, 90, -45, 45, 0),
}
BOTTOMS = {
    "steel": [(STEEL, 0.0, 1.0)],
    "quasi": angles(0, 45, -45, 90, 90, -45, 45, 0),
    "many": angles(*(3 * (0, 60, -60) + 3 * (-60, 60, 0))),
}


def cases():
    for name, plies in BARRELS.items():
        for shape in ("cup", "open"):
            for length in (0.3, 0.42, 0.85):
                for barrel in (1.0, 2.5):
                    yield shape, name, plies, shell.drive(length, shape, barrel)


def tables(chosen=None, plates_of=BOTTOMS):
    units = {"ring_bending": "N*m^2"}
    table = Table("laminate_wall", "mode [1]",
                  *(f"{name} [{units.get(name, 'm')}]" for name in shell.NAMES))
    for shape, name, plies, g in chosen or cases():
        for n in (2, 3, 6):
            stiffness, tilt = cup(n, g, plies)
            inputs = n, *g.values()
            table.add(f"{shape}.{name}.stiffness", inputs, stiffness, "N/m", SOURCE, 5, 9)
            if n == 2:
                table.add(f"{shape}.{name}.tilt", inputs, tilt, "1/m", SOURCE, 5, 9)
    plates = Table("laminate_bottom", "mode [1]", "inner [m]", "outer [m]", "thickness [m]")
    for name, plies in plates_of.items():
        for n in (2, 3, 4):
            for inner in (0.018, 0.025):
                plates.add(name, (n, inner, 0.031, 0.001), bottom(n, plies, 0.001, inner, 0.031),
                           "N/m", SOURCE, 5, 9)
    return [table, plates]


def some_tables():
    """Four drives of the table, and no plate."""
    return tables(list(cases())[::17], {})


if __name__ == "__main__":
    publish(*tables())
