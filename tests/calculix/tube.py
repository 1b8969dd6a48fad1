# SPDX-License-Identifier: Apache-2.0
"""The tube with a through crack at 45 degrees of examples/through_crack.toml, for CalculiX.

The mesh is a structured O-grid in confocal elliptic coordinates, x + iy = a cosh(mu + i nu): mu = 0
is the crack, with nu > 0 on one side and nu < 0 on the other.  A node exists twice only if
it has two values of nu.  Next to a tip, the distance is the square of that in (mu, nu).  The middle
nodes therefore lie at quarter points, and the displacements contain the square root.
The meshes of strainwave-fe share nothing with this grid: they are rings about the tips.

N, mm, MPa.
"""
import argparse
import dataclasses
import json

import numpy as np

import calculix

E, NU = 210e3, 0.3
R, T, L = 78.88, 2.24, 160.0
TORQUE = 100e3  # N*mm
J = np.pi / 2 * ((R + T / 2) ** 4 - (R - T / 2) ** 4)
COMPLIANCE_WITHOUT = L * 2 * (1 + NU) / (E * J)  # 1/(N*mm)


@dataclasses.dataclass(frozen=True)
class Fineness:
    round_crack: int = 32   # number of cells in nu; a multiple of 4
    away: int = 12          # number of cells in mu
    round_tube: int = 12    # number of cells on the rest of the circumference
    through_wall: int = 1
    towards_tip: float = 0.0  # 0: nu even; < 1: closer at the tips
    square_root: bool = True  # False: middle nodes halfway in the plane, not in (mu, nu)


def mesh(a, fine, cracked=True):
    """points, cells, faces of the loaded end, nodes of the held end."""
    n, m, layers = fine.round_crack, fine.away, fine.through_wall
    half = L / 2
    x = 2 * np.pi * np.arange(2 * n) / (2 * n)
    nu = x - fine.towards_tip * np.sin(2 * x) / 2
    last = np.log(2 * half / a)
    # Cells in mu are as long as those in nu at the tips and grow towards the square.
    first = (nu[2] - nu[0]) / last
    growth = root(lambda q: first * sum(q ** i for i in range(m)) - 1, 0.2, 5.0)
    lengths = growth ** np.arange(m)
    steps = np.concatenate([[0], np.cumsum(lengths / lengths.sum())])
    mu = last * np.sort(np.concatenate([steps, (steps[1:] + steps[:-1]) / 2]))
    mu_, nu_ = np.meshgrid(mu, nu, indexing="ij")
    ellipse = np.exp(1j * np.pi / 4) * a * np.cosh(mu_ + 1j * nu_)
    ray = np.exp(1j * (nu_ + np.pi / 4))
    square = half * np.exp(mu_ - last) * ray / np.maximum(abs(ray.real), abs(ray.imag))
    s = np.clip((mu_ - 0.8) / (last - 0.8), 0, 1)
    share = s ** 3 * (10 - 15 * s + 6 * s * s)
    plane = (1 - share) * ellipse + share * square  # [mu, nu], real: round the tube, imaginary: along
    if not fine.square_root:  # straight edges within the grid of ellipses
        closed = np.concatenate([plane, plane[:, :1]], axis=1)
        inside = slice(0, 2 * (m // 2) + 1)
        closed[inside, 1::2] = (closed[inside, 0:-1:2] + closed[inside, 2::2]) / 2
        closed[1:inside.stop:2] = (closed[0:inside.stop - 1:2] + closed[2:inside.stop:2]) / 2
        plane = closed[:, :-1]
    # The rest of the circumference, from the right side of the square to its left side.
    edge = plane[-1]
    corner = 2 * n // 4  # nodes of a side; nu = 0 is the upper right corner
    left = edge[corner:2 * corner + 1]                         # downwards
    right = edge[(np.arange(4 * corner, 3 * corner - 1, -1)) % (2 * n)]  # downwards
    w = np.linspace(0, 1, 2 * fine.round_tube + 1)
    rest = np.outer(1 - w, right) + np.outer(w, left + 2 * np.pi * R)
    number = np.arange(plane.size).reshape(plane.shape)
    rest_number = plane.size + np.arange(rest.size).reshape(rest.shape)
    rest_number[0] = number[-1, (np.arange(4 * corner, 3 * corner - 1, -1)) % (2 * n)]
    rest_number[-1] = number[-1, corner:2 * corner + 1]
    # Each tip is one node; all other places of mu = 0 have two nodes if there is a crack.
    if not cracked:
        number[0, n + 1:] = number[0, n - 1:0:-1]
    flat = np.concatenate([plane.ravel(), rest.ravel()])
    wall = T * np.linspace(-0.5, 0.5, 2 * layers + 1)
    angle, z = flat.real / R, flat.imag + half
    points = np.concatenate([np.column_stack([(R + h) * np.cos(angle), (R + h) * np.sin(angle), z])
                             for h in wall])
    through = len(flat) * np.arange(len(wall))
    o_ids = np.concatenate([number, number[:, :1]], axis=1)[:, :, None] + through
    r_ids = rest_number[:, :, None] + through
    cells = np.concatenate([oriented(points, calculix.grid_cells(ids)) for ids in (o_ids, r_ids)])
    faces = []
    for ids in (o_ids[-1, :corner + 1], r_ids[:, 0]):  # the upper side; the upper end of the rest
        i, k = (2 * v.ravel() for v in np.indices([(d - 1) // 2 for d in ids.shape]))
        faces.append(np.stack([ids[i + p, k + q] for p, q in
                               [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]],
                              axis=1))
    points, cells, new = calculix.used_only(points, cells)
    held = np.flatnonzero(abs(points[:, 2]) < 1e-9 * L)
    return points, cells, new[np.concatenate(faces)], held


def root(f, low, high):
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if f(middle) < 0 else (low, middle)
    return (low + high) / 2


def oriented(points, cells):
    """Makes the cells right-handed by reversing the order through the wall; all cells of a grid have the same orientation."""
    J = np.einsum("cni,nd->cid", points[cells], calculix.shape_slopes(np.zeros(3)))
    swap = [4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11, 16, 17, 18, 19]
    return cells if np.linalg.det(J).min() > 0 else cells[:, swap]


def solve(a, fine, cracked=True):
    """Compliance over the exact compliance of the tube without a crack, and its cost."""
    points, cells, faces, held = mesh(a, fine, cracked)
    worst = calculix.worst_jacobian(points, cells)
    if not worst > 0:
        raise RuntimeError(f"tangled mesh: {worst}")
    rate = TORQUE / J
    forces = calculix.face_loads(points, faces, lambda p: rate * np.column_stack(
        [-p[:, 1], p[:, 0], np.zeros(len(p))]))
    applied = float(np.sum(points[:, 0] * forces[:, 1] - points[:, 1] * forces[:, 0]))
    if abs(applied / TORQUE - 1) > 2e-3:
        raise RuntimeError(f"torque {applied} instead of {TORQUE}")
    displacement, cpu, wall, megabytes = calculix.run(
        lambda path: calculix.write_input(path, points, cells, (E, NU), held=held, forces=forces))
    compliance = calculix.work(forces, displacement) / applied ** 2
    return {"compliance": compliance / COMPLIANCE_WITHOUT, "unknowns": 3 * (len(points) - len(held)),
            "cells": len(cells), "cpu_s": cpu, "wall_s": wall, "peak_MB": megabytes,
            "worst_jacobian": worst}


def added_compliance(a, fine):
    """Added compliance over that of the tube: with minus without the crack, both on the same mesh, so the coarse
    circle does not matter."""
    return solve(a, fine)["compliance"] - solve(a, fine, cracked=False)["compliance"]


def release_rate(a, fine, step=0.03):
    """G/(K0^2/E) by central difference of the compliance, K0 = tau sqrt(pi a), tau = T R/J."""
    less, more = solve(a * (1 - step), fine), solve(a * (1 + step), fine)
    G = TORQUE ** 2 / 2 * COMPLIANCE_WITHOUT * (more["compliance"] - less["compliance"]) / (4 * step * a * T)
    return {**more, "cpu_s": min(less["cpu_s"], more["cpu_s"]),
            "G": G / ((TORQUE * R / J) ** 2 * np.pi * a / E)}


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    for field in dataclasses.fields(Fineness):
        parser.add_argument("--" + field.name.replace("_", "-"), type=type(field.default),
                            default=field.default)
    fineness = Fineness(**vars(parser.parse_args()))
    print(json.dumps({**release_rate(10.0, fineness), "added": added_compliance(10.0, fineness)}))
