# SPDX-License-Identifier: Apache-2.0
"""Rows of equal through cracks round a thin tube: added compliance by solid finite elements.

A tube of mean radius r and wall t has N equal straight through cracks at one place of its axis, evenly
spaced round it: pitch p = 2 pi r/N.  Each crack has the half length a and stands at the angle beta from
the generator; on the unrolled tube it is a straight line.  lambda = (12 (1 - nu^2))^(1/4) a/sqrt(r t).

The question is how far the interaction in the tube is from that in a flat sheet.  Compared are

    ratio = (added compliance of the row per crack)/(added compliance of one crack alone in the tube)

with the same ratio of a flat sheet and of an endless shallow shell, each with an endless row of pitch p.
The table also has the ratio of the release rates under torsion for beta = 45 degrees (mean of the tips,
from two half lengths 4 % apart), and `mesh_change`, by which the ratio grew from the coarse mesh.

Tube.  One sector of the tube, 2 pi/N, by bricks of 20 nodes (C3D20R of CalculiX, `ccx`).  The mesh is
drawn on the unrolled sector, whose lines follow the crack, and rolled up.  Equations in cylindrical axes
tie the two faces of the sector.  The crack alone is the sector of N = 1, which is the whole tube; near
the crack it has the same mesh as the row.  The ends are rigid in the hoop sense: each node has
u_theta = rho phi.  They are free to stretch, to warp and to move along the radius.  The torque turns one
end, the axial force is a uniform stress on it.  Cracks do not touch: their faces are free.

Added compliance, by two roads from the same runs.  `face`: the work of the stress of the whole tube
(tau = T rho/J, sigma = P/A) on the jump between the crack faces, which is twice the added energy.
`end`: the displacement at the end, less that of the same mesh with merged faces.  The table has `face`,
which loses no digits by subtraction.

Sheet.  Dislocations on one crack of the row, summed along the row with cot and 1/sin^2, by
Gauss-Chebyshev quadrature.  `--check` compares it with the closed forms of collinear rows.

Shell.  The jumps and the kernel of shell_crack.py; an integral along the axis and a sum over the wave
numbers round the tube give the row.  It has no depth of the wall and no closed tube.

Lengths in the run are in walls and E = 1; the table is for t = 1 mm and E = 206 GPa, in SI units.
Independent of the library, which takes the interaction from the sheet.

Needs numpy, scipy, mpmath and ccx; one run of ccx at a time, on one processor, a minute at most.

    crack_rows.py --check   sheet, plain tube, both roads, crack alone, flat limit, ends (three minutes)
    crack_rows.py --write   tests/data/crack_rows.csv (half an hour)
"""
import os
import subprocess
import sys
import tempfile
from math import cos, pi, radians, sin, sqrt, tan
from pathlib import Path

import numpy as np
from scipy.special import jv

E, NU = 206e9, 0.3
WALL = 1e-3
G_OVER_E = 1 / (2 * (1 + NU))
RATIO = 30.0  # mean radius over wall


# ---------------------------------------------------------------------------------- the flat sheet


def traction(z, z0, factor, angle, pitch):
    """N + iT on a line at `angle` from dislocations `factor` at z0 + k pitch; without pitch only at z0."""
    d = z - z0
    if pitch is None:
        single, double = 1 / d, 1 / d**2
    else:
        single = pi / pitch / np.tan(pi * d / pitch)
        double = (pi / pitch / np.sin(pi * d / pitch)) ** 2
    phi = factor * single
    # conj(z) phi' + psi; the sum over the row of conj(z0 + k pitch)/(z - z0 - k pitch)^2 is in it.
    rest = (np.conj(factor) - factor) * single + factor * (d - np.conj(d)) * double
    return phi + np.conj(phi) + np.exp(2j * angle) * rest


def sheet(a, beta, pitch, load, points=60):
    """Work of N + iT = load on the jump, and (K_I, K_II)/sqrt(pi a), for one crack of a row.

    beta is the angle from the normal of the row.  The work is that of one crack alone without pitch,
    in units that leave ratios unchanged."""
    angle = pi / 2 - beta
    turn = np.exp(1j * angle)
    knot = np.pi * (2 * np.arange(1, points + 1) - 1) / (2 * points)
    s, x = np.cos(knot), np.cos(np.pi * np.arange(1, points) / points)
    z, z0 = a * x[:, None] * turn, a * s[None, :] * turn
    rows = 2 * points
    matrix, right = np.zeros((rows, rows)), np.zeros(rows)
    for part, unit in enumerate((1.0, 1j)):
        factor = turn * np.conj(unit)  # one crack alone: N + iT = 2 unit/(x - s)
        t = traction(z, z0, factor, angle, pitch) * a * pi / points
        columns = slice(part * points, (part + 1) * points)
        matrix[: points - 1, columns] = t.real
        matrix[points - 1 : 2 * points - 2, columns] = t.imag
        matrix[2 * points - 2 + part, columns] = 1
    right[: points - 1], right[points - 1 : 2 * points - 2] = load.real, load.imag
    solved = np.linalg.solve(matrix, right)
    density = solved[:points] + 1j * solved[points:]
    jump = density * s  # int (1 - s^2)^(-1/2) density s ds is the integral of the jump
    work = a**2 * np.pi / points * np.sum(load.real * jump.real + load.imag * jump.imag)
    signs = (-1.0) ** np.arange(points)
    tip = np.sum(signs / np.tan(knot / 2) * density) / points
    return float(work), 2 * np.pi * tip


def crack_stress(beta, loading):
    """Normal and shear stress on the plane of the crack; its left side has the normal (-cos, sin)."""
    if loading == "torsion":
        return sin(2 * beta), cos(2 * beta)
    return sin(beta) ** 2, sin(beta) * cos(beta)


def sheet_ratio(a, beta, pitch, loading):
    """Ratio of the compliances and of G of a row in a flat sheet under `torsion` or `axial` stress."""
    load = complex(*crack_stress(beta, loading))
    row, tip = sheet(a, beta, pitch, load)
    alone, tip_alone = sheet(a, beta, None, load)
    return row / alone, abs(tip) ** 2 / abs(tip_alone) ** 2


# ------------------------------------------------------------------------------- the shallow shell


TERMS = 5
BEND = (1 - NU) * (3 + NU) / 4  # Kirchhoff plate, in units of the membrane


def jump_transforms(xi):
    """Fourier transforms of the jumps (opening, sliding, rotation, deflection) of shell_crack.py."""
    xi = np.where(np.abs(xi) < 1e-12, 1e-12, xi)
    smooth = [pi * (n + 1) * (-1) ** (n // 2) * jv(n + 1, xi) / xi for n in range(0, 2 * TERMS, 2)]
    deflection = [
        pi / 2 * (n + 1) * (n + 2) * (n + 3) * (-1) ** ((n - 1) // 2) * jv(n + 2, xi) / xi**2
        for n in range(1, 2 * TERMS, 2)
    ]
    return np.array([smooth, smooth, smooth, deflection])


def curvature_symbol(xi, eta, axial, lam):
    """Kernel of the curvature at the wave numbers xi along the crack, eta across, `axial` of the tube."""
    e, x = eta**2, xi**2
    k4, ell = (e + x) ** 2, lam**2 * axial**2
    delta = k4**2 + ell**2
    S = [x, -xi * eta]
    B = [e + NU * x, eta * (e + (2 - NU) * x)]
    out = np.zeros((4, 4) + xi.shape)
    for i in range(2):
        for j in range(2):
            out[i, j] = -(ell**2) / (k4 * delta) * S[i] * S[j]
            out[2 + i, 2 + j] = ell**2 / (k4 * delta) * B[i] * B[j]
            out[i, 2 + j] = out[2 + j, i] = ell / delta * S[i] * B[j]
    return out


def curvature_of_row(lam, beta, pitch, highest=60.0):
    """Matrix of the curvature for cracks of half length 1: integral along the axis, sum round the tube."""
    c, s = cos(beta), sin(beta)
    x, w = np.polynomial.legendre.leggauss(12)
    out = np.zeros((4 * TERMS, 4 * TERMS))
    for m in range(int(highest * pitch / (2 * pi)) + 1):
        kx = 2 * pi * m / pitch
        marks = {0.0, -kx * s / c} if m and c > 1e-9 else {0.0}
        steps = np.geomspace(1e-4, 300, 60)
        edges = np.unique(np.concatenate([[k, *(k - steps), *(k + steps)] for k in marks]))
        half = np.diff(edges) / 2
        ky = ((edges[:-1] + half)[:, None] + half[:, None] * x).ravel()
        weight = (half[:, None] * w).ravel() / (2 * pi * pitch) * (2 if m else 1)
        xi, eta = kx * s + ky * c, ky * s - kx * c
        f = jump_transforms(xi)
        K = curvature_symbol(xi, eta, ky, lam)
        out += np.einsum("imx,ijx,jnx,x->imjn", f, K, f, weight, optimize=True).reshape(out.shape)
    return out


def neighbours_in_sheet(beta, pitch, points=80):
    """Matrix of the other cracks of the row in a flat sheet, for opening and sliding."""
    angle = pi / 2 - beta
    turn = np.exp(1j * angle)
    knot = pi * (2 * np.arange(1, points + 1) - 1) / (2 * points)
    place = pi * np.arange(1, points + 1) / (points + 1)
    even = np.arange(0, 2 * TERMS, 2)
    U = np.sin((even[:, None] + 1) * place) / np.sin(place)
    weighted = U * pi / (points + 1) * np.sin(place) ** 2
    slope = (even + 1) * np.cos((even + 1) * knot[:, None]) / (8 * pi)
    z, z0 = np.cos(place)[:, None] * turn, np.cos(knot) * turn + 1e-13
    out = np.zeros((4 * TERMS, 4 * TERMS))
    for part, unit in enumerate((1.0, 1j)):
        factor = turn * np.conj(unit)
        others = traction(z, z0, factor, angle, pitch) - traction(z, z0, factor, angle, None)
        t = others @ slope * pi / points
        columns = slice(part * TERMS, (part + 1) * TERMS)
        out[:TERMS, columns], out[TERMS : 2 * TERMS, columns] = -weighted @ t.real, -weighted @ t.imag
    return out


def crack_alone(lam, beta):
    """Matrix of one crack in a flat sheet, and that of the curvature of shell_crack.py."""
    import shell_crack

    membrane = [pi * (n + 1) / 8 for n in range(0, 2 * TERMS, 2)]
    rotation = [BEND * 4 * k for k in membrane]
    deflection = [
        BEND * pi / 4 * ((n + 1) * (n + 2) * (n + 3)) ** 2 / (2 * (n + 2)) for n in range(1, 2 * TERMS, 2)
    ]
    xi, w = shell_crack.joined(
        shell_crack.graded(0, 20.0, 40, 24, 0),
        *[shell_crack.graded(k, k + 10.0, 1, 24, k) for k in np.arange(20.0, 200.0, 10.0)],
    )
    K, f = shell_crack.kernel(xi, lam, beta, NU, 12), jump_transforms(xi)
    curved = np.einsum("imx,ijx,jnx,x->imjn", f, K, f, w / pi, optimize=True)
    return np.diag([*membrane, *membrane, *rotation, *deflection]), curved.reshape([4 * TERMS] * 2)


def shell_ratio(lam, beta, pitch, loading):
    """Ratio of the compliances on an endless shallow shell, pitch over a.

    The neighbours act on each other by the membrane of the sheet and by all of the curvature; that they
    bend each other in a flat plate is left out."""
    load = np.zeros(4 * TERMS)
    normal, shear = crack_stress(beta, loading)
    load[0], load[TERMS] = normal * pi / 2, shear * pi / 2
    flat, curved = crack_alone(lam, beta)
    row = flat + neighbours_in_sheet(beta, pitch) + curvature_of_row(lam, beta, pitch)
    return (load @ np.linalg.solve(row, load)) / (load @ np.linalg.solve(flat + curved, load))


# ------------------------------------------------------------------------------------------ the mesh


class Case:
    """One row: N cracks of half length a at the angle beta; lengths in walls, t = 1.

    `scale` multiplies the half length and keeps the pitch."""

    def __init__(self, cracks, pitch_over_length, degrees, ratio=RATIO, scale=1.0):
        self.cracks, self.degrees, self.radius = cracks, degrees, ratio
        self.beta = radians(degrees)
        self.pitch = 2 * pi * ratio / cracks
        self.half = scale * self.pitch / (2 * pitch_over_length)
        self.lam = (12 * (1 - NU**2)) ** 0.25 * self.half / sqrt(ratio)


class Grading:
    """Sizes of the elements, over a: at the tips and at the crack line, near the crack; their growth."""

    def __init__(self, fine=False, layers=1):
        self.tip, self.growth, self.near = (1 / 300, 1.6, 1 / 6) if fine else (1 / 100, 2.0, 1 / 4)
        self.far, self.layers = 1.5 if fine else 1.0, layers

    def steps(self, length, half, far, first=None):
        """Places from 0 to `length`; the sizes grow from the tip's or from `first`, up to a cap."""
        at, size = [0.0], first or self.tip * half
        while at[-1] < length:
            at.append(at[-1] + size)
            cap = self.near * half if at[-1] < 1.5 * half else far / self.far
            size = min(size * self.growth, max(cap, size if first else self.near * half))
        return np.array(at) * length / at[-1]


def with_middles(corners):
    out = np.empty(2 * len(corners) - 1)
    out[0::2], out[1::2] = corners, (corners[1:] + corners[:-1]) / 2
    return out


def mirrored(places):
    return np.concatenate([-places[:0:-1], places])


class Mesh:
    """Sector of a tube with `copies` cracks, by default those of the case.

    With one copy it is the whole tube with one crack alone, with the mesh of the row near the crack.
    The lines X = constant follow the crack: x = X + offset(y), and y = Y.  A crack at beta = 90 degrees
    is on a line y = 0."""

    def __init__(self, case, grading, copies=None, cracked=True, length=None):
        self.case, self.copies = case, copies or case.cracks
        self.whole = whole = self.copies == 1
        r, a, beta = case.radius, case.half, case.beta
        self.around = case.degrees == 90
        self.period = 2 * pi * r / self.copies
        decay = sqrt(r)
        if length is None:
            length = (4 * r if whole else 6 * decay) + 3 * a
        self.length = length
        high = 0.0 if self.around else a * cos(beta)  # half height of the crack along the axis
        far = min(decay / 2, 2 * a)
        beyond = grading.steps(length - high, a, max(far, length / 30))
        half_line = a - grading.steps(a, a, a)[::-1]
        if self.around:
            wide = self.period / 2
            self.X = self.over_circumference(grading, half_line, wide - a, case.pitch / 2 - a, a, r)
            self.Y = mirrored(beyond)
        else:
            first = grading.steps(case.pitch / 2, a, far)
            self.X = mirrored(self.continued(grading, first, self.period / 2, a, r))
            inner = mirrored(half_line * cos(beta))
            self.Y = np.concatenate([-high - beyond[:0:-1], inner, high + beyond[1:]])
        self.X, self.Y = with_middles(self.X), with_middles(self.Y)
        self.layers = grading.layers
        self.number_nodes(cracked, a, high)

    def continued(self, grading, places, end, a, r):
        """The places of the row, and for the whole tube more of them, up to `end`."""
        if end <= places[-1] * (1 + 1e-9):
            return places
        last = places[-1] - places[-2]
        more = grading.steps(end - places[-1], a, r / 4, last * grading.growth)
        return np.concatenate([places, places[-1] + more[1:]])

    def over_circumference(self, grading, half_line, gap, row_gap, a, r):
        beyond = grading.steps(row_gap, a, sqrt(r) / 2)
        beyond = self.continued(grading, beyond, gap, a, r)
        return mirrored(np.concatenate([half_line, a + beyond[1:]]))

    def offset(self, y):
        """Shift of the lines round the tube: slope tan(beta) at the crack, none at the ends."""
        if self.around or self.case.degrees == 0:
            return 0 * y
        a = self.case.half
        begin, width = a * cos(self.case.beta) + 0.75 * a, 2 * a
        s = np.clip(np.abs(y) - begin, 0, width)
        inner = np.minimum(np.abs(y), begin)
        return np.sign(y) * tan(self.case.beta) * (
            inner + s / 2 + width / (2 * pi) * np.sin(pi * s / width)
        )

    def number_nodes(self, cracked, a, high):
        """Numbers of the nodes, their coordinates rho, theta, z, and the bricks."""
        nx, ny, nk = len(self.X), len(self.Y), 2 * self.layers + 1
        i, j, k = np.meshgrid(np.arange(nx), np.arange(ny), np.arange(nk), indexing="ij")
        odd = i % 2 + j % 2 + k % 2
        exists = odd <= 1
        self.grid = np.full((nx, ny, nk), -1)
        self.grid[exists] = np.arange(exists.sum())
        x, y = self.X[i[exists]], self.Y[j[exists]]
        x = x + self.offset(y)
        rho = self.case.radius - 0.5 + k[exists] / (nk - 1)
        self.nodes = np.stack([rho, x / self.case.radius, y], 1)
        self.find_crack(a, high)
        upper = self.grid.copy()  # numbers seen by the elements beyond the crack
        if cracked:
            inside = self.line[1:-1]
            old = self.grid[inside[:, 0], inside[:, 1]]
            old = old[old >= 0]
            new = len(self.nodes) + np.arange(len(old))
            twin = np.arange(len(self.nodes))
            twin[old] = new
            self.nodes = np.concatenate([self.nodes, self.nodes[old]])
            upper = np.where(upper >= 0, twin[upper], -1)
        self.upper = upper
        if self.whole:
            self.grid[-1], self.upper[-1] = self.grid[0], self.upper[0]
        self.bricks = self.make_bricks()

    def find_crack(self, a, high):
        """Places (i, j) along the crack from tip to tip."""
        if self.around:
            j = np.argmin(np.abs(self.Y))
            i = np.flatnonzero(np.abs(self.X) < a * (1 + 1e-9))
            self.line = np.stack([i, np.full_like(i, j)], 1)
        else:
            i = np.argmin(np.abs(self.X))
            j = np.flatnonzero(np.abs(self.Y) < high * (1 + 1e-9))
            self.line = np.stack([np.full_like(j, i), j], 1)

    def make_bricks(self):
        corners = [(0, 0), (2, 0), (2, 2), (0, 2)]
        sides = [(1, 0), (2, 1), (1, 2), (0, 1)]
        local = [(*c, 0) for c in corners] + [(*c, 2) for c in corners]
        local += [(*s, 0) for s in sides] + [(*s, 2) for s in sides] + [(*c, 1) for c in corners]
        bricks = []
        middle_i, middle_j = self.line[0]
        for i in range(0, len(self.X) - 1, 2):
            for j in range(0, len(self.Y) - 1, 2):
                beyond = j >= middle_j if self.around else i >= middle_i
                table = self.upper if beyond else self.grid
                for k in range(0, 2 * self.layers, 2):
                    bricks.append([table[i + p, j + q, k + m] for p, q, m in local])
        bricks = np.array(bricks)
        assert bricks.min() >= 0
        return bricks

    def cartesian(self):
        rho, theta, z = self.nodes.T
        return np.stack([rho * np.cos(theta), rho * np.sin(theta), z], 1)

    def face(self, table, places):
        """Eight-node faces over a line of places: corners, then middles of the sides."""
        faces = []
        for (i0, j0), (i1, j1), (i2, j2) in zip(places[:-2:2], places[1:-1:2], places[2::2]):
            for k in range(0, 2 * self.layers, 2):
                faces.append(
                    [table[i0, j0, k], table[i2, j2, k], table[i2, j2, k + 2], table[i0, j0, k + 2]]
                    + [table[i1, j1, k], table[i2, j2, k + 1], table[i1, j1, k + 2], table[i0, j0, k + 1]]
                )
        return np.array(faces)

    def end(self, j):
        """Faces of the end j (0 or -1), in the order of the X lines."""
        j %= len(self.Y)
        return self.face(self.grid, [(i, j) for i in range(len(self.X))])

    def used(self):
        return np.unique(self.bricks)


def face_shapes(s, m):
    """Values and slopes of the eight functions of a face at (s, m) in [-1, 1]."""
    cs, cm = np.array([-1, 1, 1, -1.0]), np.array([-1, -1, 1, 1.0])
    N, ds, dm = np.zeros(8), np.zeros(8), np.zeros(8)
    N[:4] = (1 + cs * s) * (1 + cm * m) * (cs * s + cm * m - 1) / 4
    ds[:4] = cs * (1 + cm * m) * (2 * cs * s + cm * m) / 4
    dm[:4] = cm * (1 + cs * s) * (cs * s + 2 * cm * m) / 4
    for n, sign in ((4, -1), (6, 1)):
        N[n], ds[n], dm[n] = (1 - s * s) * (1 + sign * m) / 2, -s * (1 + sign * m), sign * (1 - s * s) / 2
    for n, sign in ((5, 1), (7, -1)):
        N[n], ds[n], dm[n] = (1 - m * m) * (1 + sign * s) / 2, sign * (1 - m * m) / 2, -m * (1 + sign * s)
    return N, ds, dm


def face_forces(mesh, faces, stress_of):
    """{node: force} in (theta, z) of the traction of stress_of(rho) = (s_theta z, s_zz) on the faces.

    The area is taken on the cylinder: its normal has no part along the radius."""
    forces = {}
    points, weights = np.polynomial.legendre.leggauss(3)
    for nodes in faces:
        place = mesh.nodes[nodes]
        if mesh.whole:
            place = place.copy()
            turn = place[:, 1] - place[0, 1]
            place[:, 1] -= 2 * pi * np.round(turn / (2 * pi))
        for s, ws in zip(points, weights):
            for m, wm in zip(points, weights):
                N, ds, dm = face_shapes(s, m)
                rho = N @ place[:, 0]
                e_s, e_m = ds @ place, dm @ place
                # (d_rho, rho d_theta, d_z) along both coordinates; their cross product is the area.
                area_theta = e_s[2] * e_m[0] - e_s[0] * e_m[2]
                area_z = rho * (e_s[0] * e_m[1] - e_s[1] * e_m[0])
                shear, axial = stress_of(rho)
                t = ws * wm * np.array([shear * area_z, shear * area_theta + axial * area_z])
                for node, shape in zip(nodes, N):
                    forces[node] = forces.get(node, 0) + shape * t
    return forces


# ------------------------------------------------------------------------------------- the run of ccx


def section(r):
    """Polar moment and area of the whole tube, t = 1."""
    outer, inner = r + 0.5, r - 0.5
    return pi / 2 * (outer**4 - inner**4), pi * (outer**2 - inner**2)


def stress(case, loading):
    """Stress (theta z, zz) over rho in the plain tube under the torque 1 or the axial force 1."""
    J, A = section(case.radius)
    return (lambda rho: (rho / J, 0.0)) if loading == "torsion" else (lambda rho: (0.0, 1 / A))


def deck(mesh, loadings, free_ends=False, held=False):
    """Lines of the input of ccx, the nodes whose displacements it prints, and the loads."""
    used = mesh.used()
    pivot = int(mesh.nodes.shape[0])  # carries phi as its first displacement
    xyz = mesh.cartesian()
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{n + 1}, {x:.12e}, {y:.12e}, {z:.12e}" for n in used for x, y, z in [xyz[n]]]
    lines += [f"{pivot + 1}, 0., 0., 0.", "*ELEMENT, TYPE=C3D20R, ELSET=BODY"]
    for e, brick in enumerate(mesh.bricks):
        cells = [str(n + 1) for n in [e, *brick]]
        lines += [", ".join(cells[:12]) + ",", ", ".join(cells[12:])]
    lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"1., {NU}", "*SOLID SECTION, ELSET=BODY, MATERIAL=M"]
    bottom, top = np.unique(mesh.end(0)), np.unique(mesh.end(-1))
    first, last = mesh.grid[0].ravel(), mesh.grid[-1].ravel()
    pairs = [] if mesh.whole else [(a, b) for a, b in zip(first, last) if a >= 0]
    tied = {b for _, b in pairs}
    flat = np.unique([mesh.grid[..., mesh.layers], mesh.upper[..., mesh.layers]])[1:] if held else []
    axes = sorted({*bottom, *top, *flat, *(n for pair in pairs for n in pair)})
    lines += ["*NSET, NSET=ROUND", *(f"{n + 1}," for n in axes)]
    lines += ["*TRANSFORM, NSET=ROUND, TYPE=C", "0., 0., 0., 0., 0., 1."]
    for a, b in pairs:
        for dof in (1, 2, 3):
            lines += ["*EQUATION", "2", f"{b + 1}, {dof}, 1., {a + 1}, {dof}, -1."]
    if not free_ends:
        for n in top:
            if n not in tied:
                lines += ["*EQUATION", "2", f"{n + 1}, 2, 1., {pivot + 1}, 1, {-mesh.nodes[n, 0]:.12e}"]
    lines += ["*BOUNDARY", f"{pivot + 1}, 2, 3"]
    if free_ends:
        lines += [f"{pivot + 1}, 1, 1"]
    fixed = [n for n in bottom if n not in tied]
    three = support(mesh)
    lines += [f"{n + 1}, 2, 2" for n in (three if free_ends else fixed)]
    lines += [f"{n + 1}, 3, 3" for n in (three if free_ends else three[:1])]
    lines += [f"{n + 1}, 1, 1" for n in flat if n not in tied]
    faces = [mesh.face(table, [tuple(p) for p in mesh.line]) for table in (mesh.grid, mesh.upper)]
    seen = sorted({*top, *bottom, *np.unique(faces[0]), *np.unique(faces[1])})
    lines += ["*NSET, NSET=SEEN", *(f"{n + 1}," for n in [*seen, pivot])]
    crack = sorted({*np.unique(faces[0]), *np.unique(faces[1])} - set(axes))
    lines += ["*NSET, NSET=LIPS", *(f"{n + 1}," for n in crack)]
    lines += ["*TRANSFORM, NSET=LIPS, TYPE=C", "0., 0., 0., 0., 0., 1."]
    end_forces = {}
    for loading in loadings:
        share = 1 / mesh.copies
        lines += ["*STEP", "*STATIC", "*CLOAD, OP=NEW"]
        if loading == "torsion" and not free_ends:
            lines += [f"{pivot + 1}, 1, {share:.12e}"]
        else:
            forces = end_loads(mesh, loading)
            end_forces[loading] = forces
            for n, (around, along) in forces.items():
                for dof, f in ((2, around), (3, along)):
                    if f:
                        lines += [f"{n + 1}, {dof}, {f:.12e}"]
        lines += ["*NODE PRINT, NSET=SEEN, GLOBAL=NO", "U", "*END STEP"]
    return lines, pivot, faces, end_forces


def support(mesh):
    """Nodes of the lower end that take the rigid motions: one of a sector, three of a whole tube."""
    places = 2 * ((np.arange(3) * (len(mesh.X) - 1) / 3).astype(int) // 2)
    return [int(n) for n in mesh.grid[places if mesh.whole else places[:1], 0, 0]]


def end_loads(mesh, loading):
    """Nodal forces of the stress of the plain tube on both ends; they balance."""
    out = {}
    for j, sign in ((-1, 1), (0, -1)):
        faces = mesh.end(j)
        forces = face_forces(mesh, faces, stress(mesh.case, loading))
        total = sum(f for f in forces.values())
        sense = sign * np.sign(total[0] if loading == "torsion" else total[1])
        for n, f in forces.items():
            out[n] = out.get(n, 0) + sense * f
    return out


def run(mesh, loadings=("torsion",), free_ends=False, held=False):
    """{loading: (displacement at the end, work on the jump)} of one sector under its share of the load.

    The work is twice the added energy of one crack under the load 1 of the whole tube.  `held` takes
    the radial displacement from the middle of the wall, which makes a flat sheet of the tube."""
    lines, pivot, faces, end_forces = deck(mesh, loadings, free_ends, held)
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "row.inp").write_text("\n".join(lines) + "\n", encoding="ascii")
        one = dict(os.environ, OMP_NUM_THREADS="1")
        subprocess.run(["ccx", "row"], cwd=folder, check=True, stdout=subprocess.DEVNULL, env=one)
        steps = displacements(Path(folder, "row.dat"))
    out = {}
    for loading, u in zip(loadings, steps):
        if loading in end_forces:
            end = mesh.copies * sum(f @ u[n][1:] for n, f in end_forces[loading].items())
        else:
            end = u[pivot][0]
        forces = face_forces(mesh, faces[0], stress(mesh.case, loading))
        twin = dict(zip(faces[0].ravel(), faces[1].ravel()))
        jump = sum(f @ (u[twin[n]][1:] - u[n][1:]) for n, f in forces.items())
        out[loading] = end, abs(jump)
    return out


def displacements(path):
    steps = []
    for line in path.read_text().splitlines():
        cells = line.split()
        if line.strip().startswith("displacements"):
            steps.append({})
        elif len(cells) in (4, 5) and cells[0].isdigit():
            steps[-1][int(cells[0]) - 1] = np.array(cells[1:4], float)
    return steps


# ---------------------------------------------------------------------------------------- the results


BRICKS = "crack_rows.py bricks of CalculiX"
SHEET = "crack_rows.py dislocations in a sheet"
SHELL = "crack_rows.py shallow shell"

CASES = [(n, q, 45) for n, q in ((39, 1.0), (26, 1.5), (16, 2.5), (16, 1.0), (10, 1.5), (6, 2.5))]
CASES += [(n, 1.0, 45) for n in (78, 26, 8)]
CASES += [(n, q, 90) for n, q in ((20, 2.0), (27, 1 / 0.7), (8, 2.0), (11, 1 / 0.7))]
CASES += [(39, 1.0, 0), (16, 1.0, 0)]
STEP = 0.02  # of the half length, for the release rate


def loadings_of(case):
    return ("torsion", "axial") if case.degrees == 90 else ("torsion",)


def compliances(case, fine, loadings):
    """{loading: (row per crack, alone)} for t = 1, E = 1."""
    row = run(Mesh(case, Grading(fine)), loadings)
    alone = run(Mesh(case, Grading(fine), copies=1), loadings)
    return {name: (row[name][1], alone[name][1]) for name in loadings}


def release_ratio(cracks, pitch_over_length, degrees):
    """G of the row over G alone under torsion, mean of both tips, from two half lengths."""
    row, alone = 0.0, 0.0
    for sign in (1, -1):
        case = Case(cracks, pitch_over_length, degrees, scale=1 + sign * STEP)
        each = compliances(case, False, ("torsion",))["torsion"]
        row, alone = row + sign * each[0], alone + sign * each[1]
    return row / alone


def in_si(value, loading):
    return value / (E * WALL**3) if loading == "torsion" else value / (E * WALL)


def inputs_of(case, pitch_over_length):
    lengths = case.radius * WALL, WALL, case.half * WALL
    return case.cracks, *lengths, case.beta, case.lam, pitch_over_length


def add_theory(table, cracks, pitch_over_length, degrees):
    """Ratios in the sheet and on the shallow shell; they need no ccx."""
    case = Case(cracks, pitch_over_length, degrees)
    inputs = inputs_of(case, pitch_over_length)
    for name in loadings_of(case):
        work, release = sheet_ratio(case.half, case.beta, case.pitch, name)
        shell = shell_ratio(case.lam, case.beta, case.pitch / case.half, name)
        table.add(f"{name}.sheet_ratio", inputs, work, "1", SHEET, digits=9, printed=9)
        table.add(f"{name}.shell_ratio", inputs, shell, "1", SHELL, digits=3, printed=6)
        if degrees == 45:
            table.add(f"{name}.sheet_release_ratio", inputs, release, "1", SHEET, digits=9, printed=9)


def add_bricks(table, cracks, pitch_over_length, degrees):
    """Compliances and ratios of the solid elements, and the change of the ratio from the coarse mesh."""
    case = Case(cracks, pitch_over_length, degrees)
    inputs = inputs_of(case, pitch_over_length)
    loadings = loadings_of(case)
    coarse, fine = (compliances(case, f, loadings) for f in (False, True))
    for name in loadings:
        row, alone = fine[name]
        unit = "rad/(N*m)" if name == "torsion" else "m/N"
        change = (row / alone) / (coarse[name][0] / coarse[name][1]) - 1
        table.add(f"{name}.row", inputs, in_si(row, name), unit, BRICKS, digits=2, printed=6)
        table.add(f"{name}.alone", inputs, in_si(alone, name), unit, BRICKS, digits=2, printed=6)
        table.add(f"{name}.ratio", inputs, row / alone, "1", BRICKS, digits=3, printed=5)
        table.add(f"{name}.mesh_change", inputs, change, "1", BRICKS, digits=1, printed=2)
    if degrees == 45:
        ratio = release_ratio(cracks, pitch_over_length, degrees)
        table.add("torsion.release_ratio", inputs, ratio, "1", BRICKS, digits=2, printed=4)


def empty_table():
    from reference_csv import Table

    lengths = "radius [m]", "wall [m]", "half_length [m]"
    shape = "angle [rad]", "shell_parameter [1]", "pitch_over_length [1]"
    return Table("crack_rows", "cracks [1]", *lengths, *shape)


def tables():
    table = empty_table()
    for case in CASES:
        add_bricks(table, *case)
        add_theory(table, *case)
    return [table]


def some_tables():
    """The rows of four cases that need no ccx."""
    table = empty_table()
    for case in CASES[::4]:
        add_theory(table, *case)
    return [table]


def check_sheet():
    print("Sheet: ratios of compliance and of G less those of the closed forms of collinear cracks")
    for share in (0.3, 0.5, 0.7, 0.9):
        ours = sheet_ratio(share, pi / 2, 2.0, "axial")
        k = pi * share / 2
        print(f"  2a/p {share}: {ours[0] + 2 * np.log(cos(k)) / k**2:.1e} {ours[1] - tan(k) / k:.1e}")
    far = shell_ratio(1e-3, pi / 4, 2.0, "torsion") / sheet_ratio(1.0, pi / 4, 2.0, "torsion")[0]
    print(f"Shell of nearly no curvature over the sheet: {far:.5f}")


def check_tube():
    print("Plain tube: turn of the end over L/(G J), stretch over L/(E A); both roads to the added one")
    case = Case(16, 1.0, 45)
    J, A = section(case.radius)
    both = ("torsion", "axial")
    for copies in (None, 1):
        plain = Mesh(case, Grading(), copies, cracked=False)
        whole, cracked = run(plain, both), run(Mesh(case, Grading(), copies), both)
        for name, exact in zip(both, (2 * plain.length / (J * G_OVER_E), 2 * plain.length / A)):
            end = (cracked[name][0] - whole[name][0]) / plain.copies
            print(
                f"  {plain.copies} cracks, {name}: {whole[name][0] / exact:.6f}; "
                f"end {end:.5e} face {cracked[name][1]:.5e}"
            )


def check_alone():
    print("Crack alone at 45 degrees: compliance over that in a sheet, by bricks and by the shallow shell")
    for cracks in (39, 16):
        case = Case(cracks, 1.0, 45)
        base = 2 * pi * case.half**2 * (case.radius / section(case.radius)[0]) ** 2
        flat, curved = crack_alone(case.lam, case.beta)
        bricks = run(Mesh(case, Grading(True), copies=1))["torsion"][1] / base
        load = np.eye(4 * TERMS)[0] * pi / 2
        shell = (load @ np.linalg.solve(flat + curved, load)) / (load @ np.linalg.solve(flat, load))
        print(f"  lambda {case.lam:.3f}: {bricks:.4f} {shell:.4f}", flush=True)


def check_flat():
    print("No radial displacement of the middle of the wall: ratio by bricks, in the sheet")
    for cracks, q in ((39, 1.0), (16, 1.0), (10, 1.5)):
        case = Case(cracks, q, 45)
        row, alone = (run(Mesh(case, Grading(), copies), held=True)["torsion"][1] for copies in (None, 1))
        sheet = sheet_ratio(case.half, case.beta, case.pitch, "torsion")[0]
        print(f"  N {cracks}, p/2a {q}: {row / alone:.4f} {sheet:.4f}", flush=True)


def check_ends():
    print("Other ends, lengths and layers: change of the compliance under torsion of the row, alone")
    case = Case(16, 1.0, 45)
    first = [run(Mesh(case, Grading(), copies))["torsion"][1] for copies in (None, 1)]
    for what in ("free ends", "twice as long", "two layers"):
        changes = []
        for copies, value in zip((None, 1), first):
            usual = Mesh(case, Grading(), copies).length
            length = 2 * usual if what == "twice as long" else None
            mesh = Mesh(case, Grading(layers=2 if what == "two layers" else 1), copies, length=length)
            changes.append(run(mesh, free_ends=what == "free ends")["torsion"][1] / value - 1)
        print(f"  {what}: {100 * changes[0]:.3f} % {100 * changes[1]:.3f} %", flush=True)


def check():
    check_sheet()
    check_tube()
    check_alone()
    check_flat()
    check_ends()


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    else:
        from reference_csv import publish

        publish(*tables())
