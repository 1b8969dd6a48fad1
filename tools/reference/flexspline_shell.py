# SPDX-License-Identifier: Apache-2.0
"""Cups and silk hats by finite elements of a shell of revolution, one Fourier mode at a time.

Diaphragm, barrel and rim are thin shells on their middle lines (Sanders' strains, membrane and
bending).  Each element of the meridian has quadratic displacements in the surface and a cubic
displacement across it; the right angle between diaphragm and barrel stays right.  A cup is clamped at
the boss, a hat at its flange.  Without a bottom, the lower edge stays round and is free to warp and
to turn.

Mode n >= 2: a line load cos(n theta) at the middle of the face; `stiffness` is twice the energy over
the squared displacement there, with the outer ring of the bearing as a ring that bends under the
middle of the face; `tilt`, of n = 2 only, is
the slope of the wall along the axis over the displacement there, and `clamped_curvature` that of the
diaphragm along the radius at its clamped edge over the displacement at the middle of the face.
Mode 0: uniform tangential traction on the rim; `twist` is the mean rotation of the face per torque.

Independent of the library, whose (TC-2) is a beam along the axis and whose (TC-13) is a sum.

    flexspline_shell.py --write   tests/data/flexspline_shell.csv
    flexspline_shell.py --check   finer meshes; and one hat by the shells S8R of CalculiX (ccx)
"""
import subprocess
import sys
import tempfile
from math import hypot, pi
from pathlib import Path

import numpy as np
from scipy.linalg import solveh_banded

E, NU = 206e9, 0.3
GAUSS = np.polynomial.legendre.leggauss(5)
BAND = 10  # dofs of an element: (U_r, U_t, U_z, slope) of a node, (u, v) of the middle, next node


def strains(n, x, h, sine, cosine, r):
    """Rows of the strains (s, theta, shear) and of the curvatures over the local dofs u, v, w, w'."""
    def row(places, values):
        out = np.zeros(BAND)
        out[places] = values
        return out

    q = (1 - x) * (1 - 2 * x), 4 * x * (1 - x), x * (2 * x - 1)
    dq = (4 * x - 3) / h, (4 - 8 * x) / h, (4 * x - 1) / h
    f = 1 - 3 * x**2 + 2 * x**3, h * (x - 2 * x**2 + x**3), 3 * x**2 - 2 * x**3, h * (x**3 - x**2)
    df = (6 * x * x - 6 * x) / h, 1 - 4 * x + 3 * x * x, (6 * x - 6 * x * x) / h, 3 * x * x - 2 * x
    ddf = (12 * x - 6) / h**2, (6 * x - 4) / h, (6 - 12 * x) / h**2, (6 * x - 2) / h
    u, du = row([0, 4, 6], q), row([0, 4, 6], dq)
    v, dv = row([1, 5, 7], q), row([1, 5, 7], dq)
    w, dw, ddw = (row([2, 3, 8, 9], c) for c in (f, df, ddf))
    if n == 0:  # torsion: v alone
        u, du, w, dw, ddw = (0 * v for _ in range(5))
    hoop = (n * v + u * sine + w * cosine) / r
    shear = dv - v * sine / r - n * u / r
    turn = (v * cosine + n * w) / r  # of the normal, along theta
    dturn = (dv * cosine + n * dw - sine * turn) / r
    twist = dturn - sine / r * turn + n * dw / r + cosine / (2 * r) * (
        dv + sine * v / r + n * u / r)
    return (du, hoop, shear), (-ddw, n * turn / r - sine * dw / r, twist)


def energy(n, parts):
    """Banded stiffness of parts (r0, z0, r1, z1, thickness, elements) that follow on each other."""
    nodes = 1 + sum(part[-1] for part in parts)
    K = np.zeros((BAND, 6 * nodes))
    first = 0
    for r0, z0, r1, z1, t, count in parts:
        h = hypot(r1 - r0, z1 - z0) / count
        sine, cosine = (r1 - r0) / (count * h), (z1 - z0) / (count * h)
        T = np.eye(BAND)
        for k in (0, 6):
            T[k, k], T[k, k + 2], T[k + 2, k], T[k + 2, k + 2] = sine, cosine, cosine, -sine
        C = E * t / (1 - NU**2)
        for i in range(count):
            Ke = np.zeros((BAND, BAND))
            for x, weight in zip(*GAUSS):
                r = r0 + sine * h * (i + (1 + x) / 2)
                membrane, bending = strains(n, (1 + x) / 2, h, sine, cosine, r)
                for (a, b, g), rigidity, shear in ((membrane, C, (1 - NU) / 2),
                                                   (bending, C * t * t / 12, (1 - NU) / 2)):
                    Ke += (pi if n else 2 * pi) * r * h * weight / 2 * rigidity * (
                        np.outer(a, a) + np.outer(b, b) + NU * (np.outer(a, b) + np.outer(b, a))
                        + shear * np.outer(g, g))
            Ke = T.T @ Ke @ T
            at = 6 * (first + i)
            for k in range(BAND):
                K[:BAND - k, at + k] += Ke[k:, k]
        first += count
    K[0, -2:] = 1  # the last node has no element behind it
    return K


def solved(K, fixed, load):
    K, load = K.copy(), load.copy()
    for k in fixed:
        K[1:, k] = 0
        for j in range(1, min(BAND, k + 1)):
            K[j, k - j] = 0
        K[0, k], load[k] = 1, 0
    return solveh_banded(K, load, lower=True)


def clamped_curvature(part, state):
    """Second derivative across the first part at its clamped beginning, where w and w' are zero."""
    r0, z0, r1, z1, _, count = part
    h = hypot(r1 - r0, z1 - z0) / count
    sine, cosine = (r1 - r0) / (count * h), (z1 - z0) / (count * h)
    across = cosine * state[6] - sine * state[8]
    return (6 / h * across - 2 * state[9]) / h


def parts_of(g, fine):
    """Meridian from the clamped edge, or from the lower end of the barrel, to the open end."""
    R, L, b = g["radius"], g["barrel_length"], g["rim_width"]
    bottom = []
    if g["bottom_thickness"]:
        start = g["bottom_outer"] if g["bottom_outer"] > R else g["bottom_inner"]
        bottom = [(start, 0.0, R, 0.0, g["bottom_thickness"], 2 * fine)]
    t_r = g["rim_thickness"]
    return bottom + [(R, 0.0, R, L, g["barrel_thickness"], 2 * fine),
                     (R, L, R, L + b / 2, t_r, fine), (R, L + b / 2, R, L + b, t_r, fine)]


def shell(n, g, fine=20):
    """(stiffness, tilt, curvature at the clamp) of mode n, or the twist for n = 0."""
    parts = parts_of(g, fine)
    K = energy(n, parts)
    size = K.shape[1]
    middle = size // 6 - 1 - fine
    load = np.zeros(size)
    if n:
        K[0, 6 * middle] += g["ring_bending"] * pi * (n * n - 1) ** 2 / g["radius"] ** 3
        load[6 * middle] = 1
        state = solved(K, range(4) if g["bottom_thickness"] else range(2), load)
        W, slope = state[6 * middle], state[6 * middle + 3]
        return 1 / W, slope / W, clamped_curvature(parts[0], state) / W
    for node in range(middle - fine, middle + fine):  # moment of the traction: 1 over the face
        for dof, share in ((1, 1 / 6), (5, 4 / 6), (7, 1 / 6)):
            load[6 * node + dof] += share / (2 * fine * g["radius"])
    idle = [6 * node + k for node in range(size // 6) for k in (0, 2, 3, 4)]
    return load @ solved(K, sorted({*range(4), *idle}), load)


def drive(length, shape="cup", barrel=1.0, bottom=1.0, ratio=100):
    """Size 25 by its typical proportions; length over the pitch diameter."""
    d = 63.5e-3
    m, t_r = d / (2 * ratio), 1e-4 * (65 + 2.5 * ratio ** (2 / 3)) * d
    R = d / 2 - 1.1 * m - t_r / 2
    bore = 2 * R - t_r
    outer_ring = (bore / 8 - 0.61 * bore / 8) / 2
    edges = {"cup": (0.29 * d, R), "hat": (R, 1.4 * R), "open": (0.0, 0.0)}[shape]
    return dict(radius=R, barrel_length=(length - 0.15) * d, barrel_thickness=0.6 * barrel * t_r,
                rim_width=0.15 * d, rim_thickness=t_r, bottom_inner=edges[0], bottom_outer=edges[1],
                bottom_thickness=0.0 if shape == "open" else 0.012 * bottom * d,
                ring_bending=0.8 * E * 0.15 * bore * outer_ring ** 3 / 12)


LENGTHS = 0.2, 0.24, 0.3, 0.42, 0.85
VARIANTS = (1.0, 1.0), (1.5, 1.0), (1.0, 0.5), (1.0, 2.0)  # thickness of barrel, of bottom
NAMES = list(drive(0.42))


def cases():
    for shape in ("cup", "hat", "open"):
        for barrel, bottom in VARIANTS[:1 if shape == "open" else None]:
            for length in LENGTHS:
                yield shape, drive(length, shape, barrel, bottom)
    for length in LENGTHS:
        yield "cup", drive(length, ratio=50)


def tables(chosen=None):
    from reference_csv import Table

    units = {"ring_bending": "N*m^2"}
    table = Table("flexspline_shell", "mode [1]",
                  *(f"{name} [{units.get(name, 'm')}]" for name in NAMES))
    for shape, g in chosen or cases():
        for n in (2, 3, 4, 6):
            stiffness, tilt, curvature = shell(n, g)
            inputs = n, *g.values()
            table.add(f"{shape}.stiffness", inputs, stiffness, "N/m", "shell of revolution",
                      digits=5, printed=9)
            if n == 2:
                table.add(f"{shape}.tilt", inputs, tilt, "1/m", "shell of revolution", digits=5,
                          printed=9)
                if shape != "open":
                    table.add(f"{shape}.clamped_curvature", inputs, abs(curvature), "1/m^2",
                              "shell of revolution", digits=3, printed=9)
        if shape != "open":
            table.add(f"{shape}.twist", (0, *g.values()), shell(0, g), "rad/(N*m)",
                      "shell of revolution", digits=5, printed=9)
    return [table]


def some_tables():
    """One drive of the table in nine."""
    return tables(list(cases())[::9])


def by_calculix(g, around=64):
    """Stiffness and tilt of mode 2 and twist of a whole shell of S8R, without the outer ring."""
    R, b = g["radius"], g["rim_width"]
    line = []  # nodes of the meridian: r, z; and the thickness of each element
    counts = (10, 10, 6, 6)
    thickness = []
    for (r0, z0, r1, z1, t, _), count in zip(parts_of(g, 1), counts):
        steps = np.linspace(0, 1, 2 * count + 1)[0 if not line else 1:]
        line += [(r0 + (r1 - r0) * s, z0 + (z1 - z0) * s) for s in steps]
        thickness += [t] * count
    columns = 2 * around
    number = {}
    text = ["*NODE, NSET=ALL"]
    for j in range(columns):
        a = 2 * pi * j / columns
        for i, (r, z) in enumerate(line):
            if i % 2 and j % 2:
                continue
            number[i, j] = len(number) + 1
            text.append(f"{number[i, j]}, {r * np.cos(a):.12e}, {r * np.sin(a):.12e}, {z:.12e}")
    for t in sorted(set(thickness)):
        name = f"T{round(1e9 * t)}"
        text.append(f"*ELEMENT, TYPE=S8R, ELSET={name}")
        for e, own in enumerate(thickness):
            if own != t:
                continue
            for k in range(around):
                i, j = 2 * e, 2 * k
                ring = [(0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)]
                nodes = [number[i + p, (j + q) % columns] for p, q in ring]
                text.append(f"{1 + e * around + k}, " + ", ".join(map(str, nodes)))
        text += [f"*SHELL SECTION, ELSET={name}, MATERIAL=STEEL", f"{t:.12e}"]
    text += ["*MATERIAL, NAME=STEEL", "*ELASTIC", f"{E}, {NU}", "*BOUNDARY"]
    text += [f"{number[0, j]}, 1, 6" for j in range(columns)]
    middle, end = 2 * sum(counts[:3]), len(line) - 1
    weight = np.where(np.arange(columns) % 2, 2 / 3, 1 / 3)
    angle = 2 * pi * np.arange(columns) / columns
    wave = weight * np.cos(2 * angle)
    wave /= wave @ np.cos(2 * angle)
    text += ["*NSET, NSET=SEEN", *(f"{number[i, j]}," for i in range(end - 24, end + 1)
                                   for j in range(columns) if (i, j) in number)]

    def step(loads):
        out = ["*STEP", "*STATIC", "*CLOAD"]
        for (i, j), (fx, fy) in loads.items():
            out += [f"{number[i, j]}, 1, {fx:.12e}", f"{number[i, j]}, 2, {fy:.12e}"]
        return out + ["*NODE PRINT, NSET=SEEN", "U", "*END STEP"]

    across = {(middle, j): (wave[j] * np.cos(angle[j]), wave[j] * np.sin(angle[j]))
              for j in range(columns)}
    # Traction over an element of eight nodes: -1/12 at corners, 1/3 at the middles of its sides.
    along = {}
    for e in range(sum(counts[:2]), sum(counts)):
        for k in range(around):
            for p, q in ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)):
                at = 2 * e + p, (2 * k + q) % columns
                along[at] = along.get(at, 0.0) + (1 / 3 if p == 1 or q == 1 else -1 / 12)
    torque = {(i, j): (-f * np.sin(angle[j]) / (12 * around * R),
                       f * np.cos(angle[j]) / (12 * around * R)) for (i, j), f in along.items()}
    text += step(across) + step({at: (0.0, 0.0) for at in across} | torque)
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "hat.inp").write_text("\n".join(text) + "\n", encoding="ascii")
        subprocess.run(["ccx", "hat"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        found, blocks = {}, []
        for row in Path(folder, "hat.dat").read_text().splitlines():
            cells = row.split()
            if row.strip().startswith("displacements"):
                blocks.append(found := {})
            elif len(cells) == 4 and cells[0].isdigit():
                found[int(cells[0])] = np.array(cells[1:3], float)

    def amplitude(i):
        return sum(wave[j] * (blocks[0][number[i, j]] @ [np.cos(angle[j]), np.sin(angle[j])])
                   for j in range(columns) if (i, j) in number)

    W = amplitude(middle)
    step_z = b / 2 / counts[3]
    twist = sum(np.dot(f, blocks[1][number[at]]) for at, f in torque.items())
    return 1 / W, (amplitude(middle + 2) - amplitude(middle - 2)) / (2 * step_z) / W, twist


def check():
    worst = 0.0
    for shape, g in cases():
        for n in (2, 3, 4, 6):
            worst = max(worst, *np.abs(np.array(shell(n, g, 40)) / shell(n, g) - 1))
    print(f"twice as many elements change stiffness and tilt by {worst:.1e} at most")
    for shape, length in (("hat", 0.3), ("cup", 0.42)):
        g = drive(length, shape) | dict(ring_bending=0.0)
        print(shape, length, "shell of revolution:", *shell(2, g), shell(0, g))
        print(shape, length, "ccx, S8R:", *by_calculix(g))


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    else:
        from reference_csv import publish

        publish(*tables())
