# SPDX-License-Identifier: Apache-2.0
"""A shaft with an annular crack from outside in torsion, for CalculiX.

One layer of 20-node hexahedra in a thin sector, cylindrical coordinates, u_r = u_z = 0 and the same
u_theta on both sides; half the shaft, because the plane of the crack rotates only on its faces.  The
grid is a product of lines in r and z, graded geometrically towards the tip, without
special elements.  It shares nothing with the meshes of strainwave-fe, which use quadrilaterals of high order and rings.

N, mm, MPa.
"""
import numpy as np

import calculix

SECTOR = np.radians(0.2)  # the error grows with its square: 5e-7 of the compliance


def lines(near, far, count, ratio):
    """From `near` to `far`, `count` cells, each `ratio` longer than the last: ends and middles."""
    n = max(1, round(count))
    sizes = ratio ** np.arange(n)
    ends = near + (far - near) * np.concatenate([[0], np.cumsum(sizes / sizes.sum())])
    return np.sort(np.concatenate([ends, (ends[1:] + ends[:-1]) / 2]))


def solve(outer, inner, length, depth, material, *, ratio=1.4, smallest=1e-3, like=None):
    """Compliance [1/(N*mm)] at unit torque.

    outer, inner: diameters; inner 0 is solid, with a needle of 1e-3 of the radius left out, which
    has 1e-12 of the stiffness.  smallest: cell at the tip over the depth.  like: another depth,
    whose numbers of cells are taken.
    """
    E, nu = material
    ro, ri = outer / 2, max(inner / 2, 1e-3 * outer / 2)
    tip = ro - depth
    usual = like or depth

    def count(span):
        return np.log(1 + span * (ratio - 1) / (smallest * usual)) / np.log(ratio)

    r = np.concatenate([lines(tip, ri, count(ro - usual - ri), ratio)[:-1],
                        lines(tip, ro, count(usual), ratio)])
    z = lines(0.0, length / 2, count(length / 2), ratio)
    theta = SECTOR * np.linspace(-0.5, 0.5, 3)
    R, Th, Z = np.meshgrid(r, theta, z, indexing="ij")
    points = np.column_stack([(R * np.cos(Th)).ravel(), (R * np.sin(Th)).ravel(), Z.ravel()])
    ids = np.arange(len(points)).reshape(R.shape)
    cells = calculix.grid_cells(ids)
    i, j = (2 * v.ravel() for v in np.indices([(len(r) - 1) // 2, 1]))
    faces = np.stack([ids[i + p, j + q, -1] for p, q in
                      [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]], axis=1)
    on_side = np.full(len(points), -1)
    on_side[ids[:, 0].ravel()] = ids[:, 2].ravel()
    ligament = (Z == 0) & (R <= tip * (1 + 1e-12))
    points, cells, number = calculix.used_only(points, cells)
    if not calculix.worst_jacobian(points, cells) > 0:
        raise RuntimeError("tangled mesh")
    J = np.pi / 2 * (ro ** 4 - ri ** 4)
    # In cylindrical coordinates component 2 is along theta: T r/J, as a force per node.
    place = np.hypot(points[:, 0], points[:, 1])
    cartesian = calculix.face_loads(points, number[faces], lambda p: np.column_stack(
        [-p[:, 1], p[:, 0], np.zeros(len(p))]) / J)
    forces = np.zeros_like(points)
    forces[:, 1] = (points[:, 0] * cartesian[:, 1] - points[:, 1] * cartesian[:, 0]) / place
    torque = float(np.sum(forces[:, 1] * place))  # of the sector
    held = set(number[ids[ligament]]) - {-1}
    twins = [(number[a], number[b]) for a, b in enumerate(on_side) if b >= 0 and number[a] >= 0]
    text = ["*TRANSFORM,NSET=ALL,TYPE=C", "0.,0.,0.,0.,0.,1.", "*EQUATION"]
    text += [f"2\n{b + 1},2,1.,{a + 1},2,-1." for a, b in twins if b not in held]
    text += ["*BOUNDARY", "ALL,1,1", "ALL,3,3"] + [f"{n + 1},2,2" for n in sorted(held)]
    displacement, cpu, _, _ = calculix.run(lambda path: calculix.write_input(
        path, points, cells, material, lines=text, forces=forces))
    # *NODE PRINT is in global Cartesian components.
    turned = {n: [0, (u[1] * points[n, 0] - u[0] * points[n, 1]) / place[n], 0]
              for n, u in displacement.items()}
    # Both halves are the same; the sector is a share of the circumference.
    compliance = 2 * calculix.work(forces, turned) / torque ** 2 * SECTOR / (2 * np.pi)
    return {"compliance": compliance, "cells": len(cells), "cpu_s": cpu}


def release_rate(outer, inner, length, depth, material, *, step=0.01, **options):
    """G at unit torque by central difference of the compliance [N/mm]."""
    less, more = (solve(outer, inner, length, depth * (1 + s), material, like=depth, **options)
                  for s in (-step, step))
    radii = outer / 2 - depth * (1 - step), outer / 2 - depth * (1 + step)
    area = np.pi * (radii[0] ** 2 - radii[1] ** 2)
    return (more["compliance"] - less["compliance"]) / area / 2
