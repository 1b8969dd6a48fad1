# SPDX-License-Identifier: Apache-2.0
"""Annular cracks of a shaft in torsion, one behind the other: added rotation by finite elements.

A shaft of outer radius 1 and inner radius rho has annular cracks of depths a_j from its outer surface at the
places z_j.  The circumferential displacement is v = r psi(r, z), and psi minimises

    pi G integral r^3 |grad psi|^2 dr dz - T [psi(end) - psi(other end)].

Bilinear elements on a grid that grows geometrically from the tips; the nodes of a crack are doubled.  The
ends are rigid and two radii away from the cracks.  The rotation that crack j adds is the work of the stress of the sound
shaft, r/J, on its jump (J polar moment of the section):

    phi_j/T = 2 pi/J integral r^3 [psi]_j dr        (G = 1).

The sum over j must be the rotation of the ends less that of the sound shaft; the script requires this to 0.1 %, the error of the
elements.  The table has the ratio of phi_j to that of crack j alone on the same grid, which loses most of this error: halving all elements
changes it by 4e-4 or less.  The ratio of K_III is that of the jumps of the two computations at the tip: a line through their ratios in the first
twentieth of the depth, at least 0.005, without the first two nodes; halving all elements changes it by 1e-3 or less.

Independent: the library sums the modes of the shaft and never meshes.

    annular_cracks.py           JSON
    annular_cracks.py --check   halves the elements
    annular_cracks.py --write   tests/data/annular_cracks.csv
"""
import math
import sys

import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve

from reference_csv import Table, publish

END = 2.0  # from the last crack to the end of the shaft
SMALLEST, GROWTH = 5e-4, 1.1
# inner radius, ((place, depth), ...)
CASES = (
    (0.0, ((0.0, 0.3), (0.1, 0.3))),
    (0.0, ((0.0, 0.3), (0.6, 0.3))),
    (0.0, ((0.0, 0.5), (0.1, 0.1))),
    (0.0, ((0.0, 0.8), (0.24, 0.8))),
    (0.6, ((0.0, 0.2), (0.05, 0.2))),
    (0.6, ((0.0, 0.12), (0.1, 0.12), (0.15, 0.04))),
    (0.9, ((0.0, 0.05), (0.03, 0.08))),
)


def away(length, smallest, growth):
    """Nodes from 0 to the length; the first element is the smallest."""
    nodes, step = [0.0], smallest
    while nodes[-1] < length:
        nodes.append(nodes[-1] + step)
        step *= growth
    return np.array(nodes) * (length / nodes[-1])


def grid(begin, tips, end, smallest, growth):
    """Nodes from begin to end whose elements grow away from each of the tips."""
    nodes = [tips[0] - away(tips[0] - begin, smallest, growth)[::-1]]
    for left, right in zip(tips[:-1], tips[1:]):
        half = away((right - left) / 2, smallest, growth)
        nodes += [left + half[1:], right - half[::-1][1:]]
    nodes.append(tips[-1] + away(end - tips[-1], smallest, growth)[1:])
    return np.concatenate(nodes)


def rotations(inner, cracks, slit, smallest, growth):
    """Rotation per torque of each crack in `slit`, their jumps per torque over the distance from the tip, and the rotation of the ends, on
    the grid of all `cracks`."""
    tips = sorted({round(1 - depth, 12) for _, depth in cracks})
    planes = sorted(place for place, _ in cracks)
    r = grid(inner, tips, 1.0, smallest, growth)
    z = grid(planes[0] - END, planes, planes[-1] + END, smallest, growth)
    below = np.arange(len(r) * len(z)).reshape(len(z), len(r))
    above = below.copy()  # of the elements that begin at this plane
    count = below.size
    for place, depth in slit:
        plane = int(np.argmin(abs(z - place)))
        open_nodes = r > 1 - depth + 1e-9
        above[plane][open_nodes] = count + np.arange(open_nodes.sum())
        count += open_nodes.sum()

    width = np.diff(r)
    points, weights = np.polynomial.legendre.leggauss(3)
    mass, slope = np.zeros((len(width), 2, 2)), np.zeros((len(width), 2, 2))
    for point, weight in zip(points, weights):
        w = weight * width / 2 * ((r[:-1] + r[1:]) / 2 + point * width / 2)**3
        shape, gradient = ((1 - point) / 2, (1 + point) / 2), (-1 / width, 1 / width)
        for i in range(2):
            for j in range(2):
                mass[:, i, j] += w * shape[i] * shape[j]
                slope[:, i, j] += w * gradient[i] * gradient[j]
    rows, columns, values = [], [], []
    for plane, height in enumerate(np.diff(z)):
        nodes = (above[plane], below[plane + 1])
        for p in range(2):
            for q in range(2):
                for i in range(2):
                    for j in range(2):
                        rows.append(nodes[p][i:len(width) + i])
                        columns.append(nodes[q][j:len(width) + j])
                        values.append(2 * math.pi * (slope[:, i, j] * height * (2 if p == q else 1) / 6
                                                     + mass[:, i, j] * (1 if p == q else -1) / height))
    matrix = sparse.csr_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))),
                               shape=(count, count))
    psi = np.zeros(count)
    psi[below[-1]] = 1
    held = np.zeros(count, bool)
    held[below[0]] = held[below[-1]] = True
    psi[~held] = spsolve(matrix[~held][:, ~held].tocsc(), -matrix[~held][:, held] @ psi[held])
    torque = psi @ (matrix @ psi)

    polar = math.pi / 2 * (1 - inner**4)
    of_cracks, jumps = [], []
    for place, depth in slit:
        plane = int(np.argmin(abs(z - place)))
        jump = psi[above[plane]] - psi[below[plane]]
        total = 0.0
        for point, weight in zip(points, weights):
            at = (r[:-1] + r[1:]) / 2 + point * width / 2
            total += np.sum(weight * width / 2 * at**3
                            * (jump[:-1] * (1 - point) / 2 + jump[1:] * (1 + point) / 2))
        of_cracks.append(2 * math.pi / polar * total / torque)
        jumps.append((r - (1 - depth), jump / torque))
    return of_cracks, jumps, 1 / torque - (z[-1] - z[0]) / polar


def ratios(inner, cracks, smallest=SMALLEST, growth=GROWTH):
    """Rotation of each crack over that of the crack alone, and the same of K_III."""
    together, jumps, ends = rotations(inner, cracks, cracks, smallest, growth)
    if abs(sum(together) / ends - 1) > 1e-3:
        raise ArithmeticError(f"the cracks turn by {sum(together)}, the ends by {ends}")
    turned, factors = [], []
    for crack, among, (away_from_tip, jump) in zip(cracks, together, jumps):
        alone, ((_, jump_alone),), _ = rotations(inner, cracks, [crack], smallest, growth)
        turned.append(among / alone[0])
        near = np.flatnonzero((away_from_tip > 1e-9) & (away_from_tip < max(crack[1] / 20, 0.005)))[2:]
        factors.append(np.polyfit(away_from_tip[near], jump[near] / jump_alone[near], 1)[1])
    return turned, factors


def some_tables():
    return [table(CASES[4:5])]


def table(cases):
    out = Table("annular_cracks", "inner [1]", "place_0 [1]", "depth_0 [1]", "place_1 [1]", "depth_1 [1]",
                "place_2 [1]", "depth_2 [1]")
    for inner, cracks in cases:
        inputs = [inner] + [number for crack in cracks for number in crack]
        inputs += [""] * (7 - len(inputs))
        turned, factors = ratios(inner, cracks)
        for name, of_cracks in (("rotation", turned), ("factor", factors)):
            for j, ratio in enumerate(of_cracks):
                out.add(f"{name}_{j}", inputs, ratio, "1", "bilinear axisymmetric elements", digits=3, printed=5)
    return out


def tables():
    return [table(CASES)]


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        for inner, cracks in CASES:
            print(inner, cracks, ratios(inner, cracks), ratios(inner, cracks, SMALLEST / 2, math.sqrt(GROWTH)))
    else:
        publish(*tables())
