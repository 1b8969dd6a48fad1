# SPDX-License-Identifier: Apache-2.0
"""20-node hexahedra for CalculiX (ccx): structured grids, consistent nodal loads, input file and run.

Shared by the scripts in this folder.  They are tests and not part of tools/reference, because they
run strainwave-fe, which a reference must not do.
"""
import os
import pathlib
import subprocess
import tempfile
import time

import numpy as np

# Half steps of the unit cube: corners below, corners above, edges below, edges above, edges between.
PLACES = np.array([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2),
                   (0, 2, 2), (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2),
                   (1, 2, 2), (0, 1, 2), (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)])
# Nodes of the face at the end of the second direction.
FAR_SIDE = [3, 2, 6, 7, 10, 18, 14, 19]


def grid_cells(ids):
    """Cells of a structured grid; `ids[i, j, k]` is the node at each half step."""
    shape = [(n - 1) // 2 for n in ids.shape]
    i, j, k = (2 * a.ravel() for a in np.indices(shape))
    return np.stack([ids[i + a, j + b, k + c] for a, b, c in PLACES], axis=1)


def shape_slopes(point):
    """Slopes of the 20 shape functions, [node, direction], at a point of [-1, 1]^3."""
    corner = PLACES - 1.0
    slopes = np.zeros((20, 3))
    for n, c in enumerate(corner):
        for d in range(3):
            e, f = (d + 1) % 3, (d + 2) % 3
            x, y, z = point[d], point[e], point[f]
            if np.all(c != 0):
                u, v, w = 1 + x * c[d], 1 + y * c[e], 1 + z * c[f]
                slopes[n, d] = c[d] * v * w * ((u + v + w - 5) + u) / 8
            elif c[d] == 0:
                slopes[n, d] = -2 * x * (1 + y * c[e]) * (1 + z * c[f]) / 4
            else:
                m = e if c[e] == 0 else f
                o = f if m == e else e
                slopes[n, d] = (1 - point[m] ** 2) * c[d] * (1 + point[o] * c[o]) / 4
    return slopes


def worst_jacobian(points, cells):
    """Smallest scaled determinant at the 27 integration points."""
    g = np.sqrt(0.6) * np.array([-1, 0, 1])
    worst = 1.0
    for point in np.stack(np.meshgrid(g, g, g), axis=-1).reshape(-1, 3):
        J = np.einsum("cni,nd->cid", points[cells], shape_slopes(point))
        worst = min(worst, (np.linalg.det(J) / np.prod(np.linalg.norm(J, axis=1), axis=1)).min())
    return worst


def face_loads(points, faces, traction):
    """Nodal forces [number of points, 3] of a traction(points) on 8-node faces."""
    forces = np.zeros_like(points)
    g, weights = np.polynomial.legendre.leggauss(4)
    c = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1), (0, -1), (1, 0), (0, 1), (-1, 0)])
    for a, wa in zip(g, weights):
        for b, wb in zip(g, weights):
            N, Na, Nb = np.zeros(8), np.zeros(8), np.zeros(8)
            for n, (p, q) in enumerate(c):
                if p and q:
                    u, v = 1 + a * p, 1 + b * q
                    N[n], Na[n], Nb[n] = (u * v * (u + v - 3) / 4, p * v * (2 * u + v - 3) / 4,
                                          q * u * (2 * v + u - 3) / 4)
                elif p == 0:
                    N[n], Na[n], Nb[n] = ((1 - a * a) * (1 + b * q) / 2, -a * (1 + b * q),
                                          (1 - a * a) * q / 2)
                else:
                    N[n], Na[n], Nb[n] = ((1 - b * b) * (1 + a * p) / 2, (1 - b * b) * p / 2,
                                          -b * (1 + a * p))
            at = points[faces]
            normal = np.cross(np.einsum("fni,n->fi", at, Na), np.einsum("fni,n->fi", at, Nb))
            area = wa * wb * np.linalg.norm(normal, axis=1)
            pull = traction(np.einsum("fni,n->fi", at, N)) * area[:, None]
            np.add.at(forces, faces, pull[:, None, :] * N[None, :, None])
    return forces


def used_only(points, cells):
    """Removes points without a cell: (points, cells, new number of each old point)."""
    used = np.unique(cells)
    number = np.full(len(points), -1)
    number[used] = np.arange(len(used))
    return points[used], number[cells], number


def write_input(path, points, cells, material, *, held=(), lines=(), forces):
    """`held`: nodes without displacement; `lines`: more model data; `forces`: [node, 3]."""
    loaded = np.flatnonzero(np.any(forces != 0, axis=1))
    with open(path, "w") as file:
        file.write("*NODE,NSET=ALL\n")
        np.savetxt(file, np.column_stack([np.arange(1, len(points) + 1), points]),
                   fmt="%d,%.12e,%.12e,%.12e")
        file.write("*ELEMENT,TYPE=C3D20,ELSET=BODY\n")
        rows = np.column_stack([np.arange(1, len(cells) + 1), cells + 1])
        for row in rows:
            text = [str(n) for n in row]
            file.write(",".join(text[:15]) + ",\n" + ",".join(text[15:]) + "\n")
        file.write(f"*MATERIAL,NAME=STEEL\n*ELASTIC\n{material[0]:.12e},{material[1]:.12e}\n"
                   "*SOLID SECTION,ELSET=BODY,MATERIAL=STEEL\n")
        file.writelines(line + "\n" for line in lines)
        if len(held):
            file.write("*BOUNDARY\n")
            file.writelines(f"{n + 1},1,3\n" for n in held)
        file.write("*NSET,NSET=LOADED\n")
        file.writelines(f"{n + 1}\n" for n in loaded)
        file.write("*STEP\n*STATIC\n*CLOAD\n")
        for n in loaded:
            file.writelines(f"{n + 1},{i + 1},{forces[n, i]:.12e}\n"
                            for i in range(3) if forces[n, i] != 0)
        file.write("*NODE PRINT,NSET=LOADED\nU\n*END STEP\n")


def run(write):
    """Runs ccx on the file that write(path) writes: ([node, 3] displacements by node, CPU seconds
    of the process, wall seconds, peak megabytes)."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1",
                       CCX_NPROC_STIFFNESS="1", CCX_NPROC_RESULTS="1", NUMBER_OF_CPUS="1")
    with tempfile.TemporaryDirectory() as folder:
        job = pathlib.Path(folder) / "job"
        write(job.with_suffix(".inp"))
        start = time.perf_counter()
        with open(job.with_suffix(".log"), "w+") as log:
            child = subprocess.Popen(["ccx", "job"], cwd=folder, env=environment, stdout=log,
                                     stderr=subprocess.STDOUT)
            _, status, usage = os.wait4(child.pid, 0)
            wall = time.perf_counter() - start
            child.returncode = os.waitstatus_to_exitcode(status)
            log.seek(0)
            text = log.read()
        if child.returncode or "*ERROR" in text or not job.with_suffix(".dat").exists():
            raise RuntimeError("ccx failed:\n" + text[-2000:])
        rows = [line.split() for line in job.with_suffix(".dat").read_text().splitlines()
                if line[:1] == " " and line.split()[:1] and line.split()[0].isdigit()]
    displacement = {int(row[0]) - 1: [float(x) for x in row[1:4]] for row in rows}
    return displacement, usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss / 1024


def work(forces, displacement):
    """Forces times displacements."""
    return sum(float(np.dot(forces[n], u)) for n, u in displacement.items())
