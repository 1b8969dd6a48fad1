"""Compliance of a tooth on its wall, stretch and bending of a toothed wall: plane finite elements.

A straight strip of pitches, tooth with straight flanks and fillets, lengths over the module, E = 1,
nu = 0.3, width 1.  Six-node triangles on a Delaunay mesh of quadtree points.  The bore slides without
friction on a rigid ring, the ends keep the distance.  A flank of the middle tooth carries F = 1 along
its normal at the pitch height, as a Hertz pressure over 2a.

The wall also moves as a bar.  This motion belongs to the ring of (TC-1) and is taken away:

    c_t = n . u(C)/F - cos^2(alpha) S/2,    c_1 = n . u(P)/F - cos^2(alpha) S/2 - c_H

n is the normal, P the middle of the pressure, C the point where its normal crosses the tooth's centre
line at the depth d, S the compliance of the same meshed strip in tension from an end to the middle.
c_H is the approach of P to a point at the depth d in a half-plane.  c_1 does not depend on a.
c_1 - c_t is nearly the same for all teeth (LOCAL) and belongs to the contact.

Plane strain: the tooth and the wall under it bend over one or two modules, and the face is as wide as
9 to 30 modules.  The bar has the modulus E of plane stress in the ring (its waves are longer than the
face); c_t does not contain the bar, in either state.

Independent of the library, which uses the closed formula (TC-9) that `formula` writes down.

    python3 tools/reference/tooth_pair.py --check   # meshes, lengths, pressure, formula; lift-off; ccx
    python3 tools/reference/tooth_pair.py --write   # tests/data/tooth_pair_fe.csv, some minutes
"""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.optimize import nnls
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu
from scipy.spatial import Delaunay, cKDTree

from reference_csv import Table, publish

NU = 0.3
PITCH = np.pi
LINE = 2 * (1 - NU**2) / np.pi
LOCAL = 0.150


class Tooth:
    """Straight-flank tooth on a wall, lengths over the module; y = 0 at the root line."""

    def __init__(self, wall, alpha=22.0, thickness=0.5, dedendum=1.1, addendum=0.8, fillet=0.25):
        self.wall, self.alpha, self.dedendum = wall, np.radians(alpha), dedendum
        self.half = thickness * PITCH / 2  # half of the thickness at the pitch height
        self.tan = np.tan(self.alpha)
        self.addendum = min(addendum, (self.half - 0.12) / self.tan)
        self.root = self.half + dedendum * self.tan  # half width where the flank meets the root line
        space = PITCH / 2 - self.root
        turn = np.pi / 2 - self.alpha
        if space < 0.02:
            raise ValueError("the teeth overlap at the root line")
        self.fillet = min(fillet, 0.98 * space / np.tan(turn / 2))
        self.tangent = self.fillet * np.tan(turn / 2)
        self.depth = self.half / np.cos(self.alpha)  # from the pitch point to the centre line
        self.crossing = dedendum - self.half * self.tan  # height where the line of action crosses it

    def top(self, x):
        """Height of the outline at the distance x from the nearest tooth's centre line."""
        x = np.abs(x)
        tip = self.half - self.addendum * self.tan
        y = np.where(x < tip, self.dedendum + self.addendum, (self.root - x) / self.tan)
        begin = self.root - self.tangent * np.sin(self.alpha)
        end = self.root + self.tangent
        arc = self.fillet - np.sqrt(np.maximum(self.fillet**2 - (end - x) ** 2, 0))
        return np.where(x < begin, y, np.where(x < end, arc, 0.0))

    def outline(self, size, centre, marks=()):
        """Points from the middle of the space to the next one; marks are distances on the right flank."""
        tip = self.half - self.addendum * self.tan
        begin = self.root - self.tangent * np.sin(self.alpha)
        end = self.root + self.tangent
        low, high = self.tangent * np.cos(self.alpha), self.dedendum + self.addendum
        direction = np.array([np.sin(self.alpha), -np.cos(self.alpha)])
        right = [divide([0, high], [tip, high], size, centre)]
        stops = [np.array([tip, high])]
        stops += [np.array([self.half, self.dedendum]) + s * direction for s in sorted(marks)]
        stops += [np.array([begin, low])]
        right += [divide(a, b, size, centre) for a, b in zip(stops, stops[1:])]
        turn = np.pi / 2 - self.alpha
        here = size(np.array([[begin + centre, low]]))[0]
        n = max(4, int(np.ceil(self.fillet * turn / (0.8 * here))))
        angle = self.alpha + turn * np.arange(n + 1) / n
        arc = np.array([end, self.fillet]) - self.fillet * np.stack([np.cos(angle), np.sin(angle)], 1)
        arc[0], arc[-1] = [begin, low], [end, 0]
        right += [arc[:-1], divide([end, 0], [PITCH / 2, 0], size, centre), [[PITCH / 2, 0]]]
        right = np.concatenate(right)
        left = right[:0:-1] * [-1, 1]
        if marks:  # the left side keeps no marks
            bare = self.outline(size, centre)
            left = bare[bare[:, 0] < centre - 1e-12] - [centre, 0]
        return np.concatenate([left, right]) + [centre, 0]


def divide(a, b, size, centre=0.0):
    """Points from a to before b, 0.8 of the size apart."""
    a, b = np.asarray(a, float), np.asarray(b, float)
    length = np.hypot(*(b - a))
    if length < 1e-9:
        return np.zeros((0, 2))
    s = np.linspace(0, 1, 400)
    h = 0.8 * size(a + s[:, None] * (b - a) + [centre, 0])
    count = np.concatenate([[0], np.cumsum((1 / h[1:] + 1 / h[:-1]) / 2) * length / 399])
    n = max(1, int(np.ceil(count[-1])))
    at = np.interp(np.arange(n) / n * count[-1], count, s)
    return a + at[:, None] * (b - a)


class Strip:
    """Mesh of six-node triangles: `teeth` pitches with teeth, `flat` lengths without at each end."""

    def __init__(self, tooth, teeth=15, flat=0.0, patch=0.1, fine=1.0, loaded=(0,)):
        self.tooth, self.patch, self.loaded = tooth, patch, loaded
        self.half_toothed = teeth * PITCH / 2
        self.half_length = self.half_toothed + flat
        self.centres = (np.arange(teeth) - teeth // 2) * PITCH
        pitch_point = np.array([tooth.half, tooth.dedendum])
        bulk = min(tooth.wall / 3, 0.45)

        def size(x):
            h = np.full(len(x), 1e9)
            for c in self.centres:
                own = round(c / PITCH) in loaded
                r = np.hypot(x[:, 0] - c, np.maximum(np.abs(x[:, 1] - 0.5) - 0.5, 0))
                h = np.minimum(h, (0.11 if own else 0.2) + 0.22 * np.maximum(r - 1.2, 0))
                if own:
                    r = np.hypot(*(x - [c, 0] - pitch_point).T)
                    h = np.minimum(h, (patch / 5 if len(loaded) == 1 else 0.06) + 0.22 * np.maximum(r - patch, 0))
            inside = np.abs(x[:, 0]) < self.half_toothed + 1
            h = np.where(inside & (x[:, 1] > -1), np.minimum(h, bulk), h)
            h = np.minimum(h, np.maximum(bulk, 0.22 * tooth.wall))
            return h * fine

        self.build(size)

    def build(self, size):
        tooth, L, t = self.tooth, self.half_length, self.tooth.wall
        marks = {c: () for c in range(-99, 99)}
        marks.update({c: (-self.patch, 0.0, self.patch) for c in self.loaded})
        top = [tooth.outline(size, c, marks[round(c / PITCH)]) for c in self.centres]
        top = np.concatenate([top[0], *[part[1:] for part in top[1:]]])
        corner = [[-L, -t], [L, -t], [L, 0], [-L, 0]]
        edge = [divide(corner[0], corner[1], size), divide(corner[1], corner[2], size),
                divide(corner[2], [self.half_toothed, 0], size), top[::-1],
                divide([-self.half_toothed, 0], corner[3], size)[1:], divide(corner[3], corner[0], size)]
        edge = np.concatenate(edge)
        gap = np.hypot(*(edge - np.roll(edge, 1, 0)).T)
        edge = edge[gap > 1e-9]
        inner = self.leaves(size)
        fixed = np.array([[c, tooth.crossing] for c in self.centres])
        h = size(inner)
        keep = self.inside(inner, 1e-9) & (cKDTree(np.concatenate([edge, fixed])).query(inner)[0] > 0.6 * h)
        points = np.concatenate([edge, fixed, inner[keep]])
        tri = Delaunay(points).simplices
        x = points[tri]
        area = ((x[:, 1, 0] - x[:, 0, 0]) * (x[:, 2, 1] - x[:, 0, 1])
                - (x[:, 2, 0] - x[:, 0, 0]) * (x[:, 1, 1] - x[:, 0, 1])) / 2
        good = (np.abs(area) > 1e-7 * size(x.mean(1)) ** 2) & self.inside(x.mean(1), 0.0)
        tri, area = tri[good], area[good]
        tri[area < 0] = tri[area < 0][:, [0, 2, 1]]
        polygon = 0.5 * np.sum(edge[:, 0] * np.roll(edge[:, 1], -1) - edge[:, 1] * np.roll(edge[:, 0], -1))
        if abs(np.abs(area).sum() / polygon - 1) > 1e-9:
            raise RuntimeError(f"the mesh does not fill the outline: {np.abs(area).sum() / polygon - 1}")
        sides = np.sort(np.concatenate([tri[:, [0, 1]], tri[:, [1, 2]], tri[:, [2, 0]]]), 1)
        unique, number = np.unique(sides, axis=0, return_inverse=True)
        number = number.reshape(3, -1).T + len(points)
        self.points = np.concatenate([points, points[unique].mean(1)])
        self.elements = np.concatenate([tri, number], 1)
        used = np.unique(self.elements)
        assert len(used) == len(self.points), "a point belongs to no element"
        self.edges = {tuple(e): len(points) + k for k, e in enumerate(unique)}
        self.area = np.abs(area)

    def inside(self, x, margin):
        near = np.clip(np.round(x[:, 0] / PITCH), -(len(self.centres) // 2), len(self.centres) // 2) * PITCH
        return ((x[:, 1] < self.tooth.top(x[:, 0] - near) - margin) & (x[:, 1] > -self.tooth.wall + margin)
                & (np.abs(x[:, 0]) < self.half_length - margin))

    def leaves(self, size):
        """Centres of the squares of a quadtree whose sides fall below the size."""
        side = 2.0
        top = self.tooth.dedendum + self.tooth.addendum
        gx = np.arange(-self.half_length, self.half_length, side) + side / 2
        gy = np.arange(-self.tooth.wall, top, side) + side / 2
        cell = np.stack(np.meshgrid(gx, gy, indexing="ij"), -1).reshape(-1, 2)
        done = []
        while len(cell):
            split = size(cell) < side
            done.append(cell[~split])
            side /= 2
            cell = (cell[split][:, None] + np.array([[-1, -1], [1, -1], [-1, 1], [1, 1]]) * side / 2).reshape(-1, 2)
        return np.concatenate(done)

    def stiffness(self, plane="strain"):
        """Matrix for E = 1."""
        if plane == "strain":
            D = np.array([[1 - NU, NU, 0], [NU, 1 - NU, 0], [0, 0, 0.5 - NU]]) / (1 + NU) / (1 - 2 * NU)
        else:
            D = np.array([[1, NU, 0], [NU, 1, 0], [0, 0, (1 - NU) / 2]]) / (1 - NU**2)
        x = self.points[self.elements[:, :3]]
        g = np.zeros((len(x), 3, 2))  # gradients of the area coordinates
        for k in range(3):
            i, j = (k + 1) % 3, (k + 2) % 3
            g[:, k, 0] = x[:, i, 1] - x[:, j, 1]
            g[:, k, 1] = x[:, j, 0] - x[:, i, 0]
        g /= (2 * self.area)[:, None, None]
        K = np.zeros((len(x), 12, 12))
        for at in np.eye(3) / 2 + 1 / 6:
            d = np.zeros((len(x), 6, 2))
            for k in range(3):
                i = (k + 1) % 3
                d[:, k] = (4 * at[k] - 1) * g[:, k]
                d[:, 3 + k] = 4 * (at[k] * g[:, i] + at[i] * g[:, k])
            B = np.zeros((len(x), 3, 12))
            B[:, 0, 0::2], B[:, 1, 1::2] = d[:, :, 0], d[:, :, 1]
            B[:, 2, 0::2], B[:, 2, 1::2] = d[:, :, 1], d[:, :, 0]
            K += (self.area / 3)[:, None, None] * (B.transpose(0, 2, 1) @ (D @ B))
        dof = np.stack([2 * self.elements, 2 * self.elements + 1], 2).reshape(-1, 12)
        n = 2 * len(self.points)
        return coo_matrix((K.ravel(), (np.repeat(dof, 12, 1).ravel(), np.tile(dof, (1, 12)).ravel())),
                          (n, n)).tocsc()

    def at(self, x, y):
        k = np.argmin(np.hypot(self.points[:, 0] - x, self.points[:, 1] - y))
        assert np.hypot(*(self.points[k] - [x, y])) < 1e-9
        return k

    def flank_load(self, c):
        """Hertz pressure of resultant 1 on the right flank of tooth c, along the normal into it."""
        tooth = self.tooth
        P = np.array([c * PITCH + tooth.half, tooth.dedendum])
        along = np.array([np.sin(tooth.alpha), -np.cos(tooth.alpha)])
        normal = -np.array([np.cos(tooth.alpha), np.sin(tooth.alpha)])
        off = self.points - P
        s = off @ along
        on = (np.abs(off @ normal) < 1e-9) & (np.abs(s) < self.patch * (1 + 1e-9))
        node = np.where(on)[0]
        node = node[np.argsort(s[node])]  # corner, middle, corner, ...
        f = np.zeros(2 * len(self.points))
        gauss, weight = np.polynomial.legendre.leggauss(12)
        for a, b, c3 in zip(node[:-2:2], node[1:-1:2], node[2::2]):
            r = (s[c3] - s[a]) / 2
            at = s[b] + gauss * r
            w = weight * r * np.sqrt(np.maximum(1 - (at / self.patch) ** 2, 0))
            for k, N in ((a, gauss * (gauss - 1) / 2), (b, 1 - gauss**2), (c3, gauss * (gauss + 1) / 2)):
                f[2 * k:2 * k + 2] += np.sum(w * N) * normal
        return f / np.hypot(f[0::2].sum(), f[1::2].sum())

    def ends(self):
        return np.where(np.abs(np.abs(self.points[:, 0]) - self.half_length) < 1e-9)[0]

    def bore(self):
        return np.where(np.abs(self.points[:, 1] + self.tooth.wall) < 1e-9)[0]


def solve(K, F, fixed):
    """Displacements under the columns of F with the degrees of freedom `fixed` held."""
    free = np.setdiff1d(np.arange(K.shape[0]), fixed)
    u = np.zeros_like(F)
    u[free] = splu(K[free][:, free], permc_spec="MMD_AT_PLUS_A",
                   options=dict(SymmetricMode=True, DiagPivotThresh=0.001)).solve(F[free])
    return u


def section(tooth, plane="strain", fine=0.7):
    """Of one pitch of the toothed wall, whose ends stay plane: EA on a bore that keeps its height, EA and
    EI about the neutral axis with a free bore, height of this axis over the middle of the wall.

    Over E' t, E' t, E' t^3/12 and t."""
    strip = Strip(tooth, teeth=1, fine=fine, loaded=())
    K = strip.stiffness(plane)
    x, t = strip.points, tooth.wall
    end, bore = strip.ends(), strip.bore()
    side = np.sign(x[end, 0]) / 2 * PITCH
    U = np.zeros((K.shape[0], 3))
    U[2 * end, 0] = U[2 * end, 2] = side
    U[2 * end, 1] = side * (x[end, 1] + t / 2)
    corner = strip.at(-strip.half_length, -t)
    for fixed, columns in (([2 * corner + 1], [0, 1]), (2 * bore + 1, [2])):
        free = np.setdiff1d(np.arange(K.shape[0]), np.concatenate([2 * end, fixed]))
        U[np.ix_(free, columns)] = splu(K[free][:, free]).solve(-(K[free] @ U[:, columns]))
    S = U.T @ (K @ U) / PITCH * (1 - NU**2 if plane == "strain" else 1.0)
    return (S[2, 2] / t, S[0, 0] / t, (S[1, 1] - S[0, 1]**2 / S[0, 0]) / (t**3 / 12),
            S[0, 1] / S[0, 0] / t)


def half_plane(depth, patch, plane="strain"):
    """E times the approach of a point at this depth to the middle of a Hertz pressure."""
    return (2 * (1 - NU**2) / np.pi * (np.log(2 * depth / patch) - NU / (2 * (1 - NU))) if plane == "strain"
            else 2 / np.pi * (np.log(2 * depth / patch) - NU / 2))


class Loaded:
    """Solution under equal flank forces on the teeth `loaded`, on a bore that keeps its height."""

    def __init__(self, tooth, teeth=15, flat=0.0, patch=0.1, fine=1.0, plane="strain", loaded=(0,)):
        strip = Strip(tooth, teeth, flat, patch, fine, loaded)
        self.tooth, self.strip = tooth, strip
        K = strip.stiffness(plane)
        f = sum(strip.flank_load(c) for c in loaded)
        end = strip.ends()
        fixed = np.concatenate([2 * end, 2 * strip.bore() + 1])
        pull = np.zeros_like(f)  # each end drawn outward by 1
        pull[2 * end] = np.sign(strip.points[end, 0])
        self.u, v = solve(K, np.stack([f, -(K @ pull)], 1), fixed).T
        v = v + pull
        self.side = 2 / (v @ (K @ v))  # compliance of the bar from an end to the tooth 0, of this mesh
        E = 1 / (1 - NU**2) if plane == "strain" else 1.0
        self.pitch = (self.side - flat / (E * tooth.wall)) * PITCH / strip.half_toothed
        self.held = PITCH / self.pitch / (E * tooth.wall)
        self.loaded = loaded
        self.c, self.s = np.cos(tooth.alpha), np.sin(tooth.alpha)
        flank = strip.at(tooth.half, tooth.dedendum)
        self.flank = self.closing(flank) - self.rim(0) - half_plane(tooth.depth, patch, plane)  # c_1

    def rim(self, k):
        """Motion of the bar at tooth k along the line of action."""
        def green(i):
            low, high = sorted((i * self.pitch, k * self.pitch))
            return (self.side + low) * (self.side - high) / (2 * self.side)
        return self.c**2 * sum(map(green, self.loaded))

    def closing(self, node):
        return float(-self.u[2 * node] * self.c - self.u[2 * node + 1] * self.s)

    def centre(self, k=0):
        """c_t of tooth k if it is loaded; else what the other teeth add to it."""
        return self.closing(self.strip.at(k * PITCH, self.tooth.crossing)) - self.rim(k)


def formula(tooth):
    """c_t by the closed formula (TC-9), and EA on a held bore, EA and EI on a free one, as `section`."""
    c2, tan = np.cos(tooth.alpha) ** 2, tooth.tan
    base = 2 * tooth.root
    q = 2 * tooth.half / c2 / base  # width at the crossing over the width at the root
    x, wall = tooth.crossing / base, tooth.wall / base
    bending = (1 - NU**2) * 1.5 / tan**3 * (np.log(1 / q) - 2 * (1 - q) + (1 - q * q) / 2)
    length = np.log(1 / q) / (2 * tan)
    root = (4.84 * (x + 0.26) ** 2 * wall / (wall + 0.44) - 2.87 * x - 0.54 * q
            + LINE * np.log(1 + 2.12 * wall))
    tooth_c = (c2 * (bending + 2.4 * (1 + NU) * length + root)
               + (1 - c2) * ((1 - NU**2) * length + LINE * np.log(1 + 6.17 * wall)))
    share = base / PITCH
    held = 1 + 0.091 * share / wall
    free = 1 / (1 - 0.523 * share * (1 - 1 / (1 + 0.175 / wall)))
    bend = 1 / (1 - 0.881 * share**0.741 * (1 - np.exp(-0.369 / wall)))
    return tooth_c, held, free, bend


def layer(tooth, k):
    """What a unit force on tooth 0 adds to tooth k in a thick wall, less the bar: plane layer on a smooth
    rigid base, force and motion spread evenly over the width of the root.  Times E and width.

    The harmonic cos(kappa x) of a traction moves the surface by (2(1-nu^2)/(E kappa)) times
    (cosh 2K + 1)/(sinh 2K + 2K) along itself for a shear traction and (cosh 2K - 1)/(sinh 2K + 2K) for a
    pressure, K = kappa t."""
    wave = np.linspace(0, 40, 200001)[1:]
    K = np.minimum(wave * tooth.wall, 300)
    below = np.sinh(2 * K) + 2 * K
    shear = (np.cosh(2 * K) + 1) / below - 1 / (2 * K)
    pressure = (np.cosh(2 * K) - 1) / below
    c2 = np.cos(tooth.alpha) ** 2
    spread = np.sinc(wave * tooth.root / np.pi) ** 2
    return LINE * np.trapz((c2 * shear + (1 - c2) * pressure) * spread * np.cos(wave * k * PITCH) / wave, wave)


class Bore:
    """A strip whose bore can only push: quadratic programme in the lift of the bore's points."""

    def __init__(self, tooth, teeth=15, plane="stress", loaded=(-1, 0, 1), fine=1.0):
        self.tooth, self.strip, self.plane = tooth, Strip(tooth, teeth, 0.0, 0.2, fine, loaded), plane
        strip = self.strip
        K = strip.stiffness(plane)
        bore = strip.bore()
        bore = bore[np.argsort(strip.points[bore, 0])]
        x = strip.points[bore, 0]
        self.share = np.zeros(len(bore))  # of an even line load
        for a in range(0, len(bore) - 2, 2):
            self.share[a:a + 3] += (x[a + 2] - x[a]) * np.array([1, 4, 1]) / 6
        held = 2 * bore + 1
        free = np.setdiff1d(np.arange(K.shape[0]), np.concatenate([2 * strip.ends(), held]))
        factor = splu(K[free][:, free], permc_spec="MMD_AT_PLUS_A",
                      options=dict(SymmetricMode=True, DiagPivotThresh=0.001))
        coupling = K[free][:, held]
        lift = -np.concatenate([factor.solve(coupling[:, k:k + 64].toarray())
                                for k in range(0, len(held), 64)], 1)
        S = K[held][:, held].toarray() + coupling.T @ lift
        self.root = np.linalg.cholesky((S + S.T) / 2).T
        c, s = np.cos(tooth.alpha), np.sin(tooth.alpha)
        self.load = {k: strip.flank_load(k) for k in loaded}
        sides = {k: factor.solve(f[free]) for k, f in self.load.items()}
        self.push = {k: -(coupling.T @ v) for k, v in sides.items()}  # upward, on a bore that is free
        full = np.zeros(K.shape[0])
        self.held, self.measure = {}, {}
        L = strip.half_length
        side = L / (section(tooth, plane)[1] * tooth.wall * (1 / (1 - NU**2) if plane == "strain" else 1))
        for j in loaded:
            node = strip.at(j * PITCH, tooth.crossing)
            for k, v in sides.items():
                full[free] = v
                rim = c**2 * side / 2 * (1 - max(j, k) * PITCH / L) * (1 + min(j, k) * PITCH / L)
                self.held[j, k] = -full[2 * node] * c - full[2 * node + 1] * s - rim
            row = np.searchsorted(free, [2 * node, 2 * node + 1])
            self.measure[j] = -(lift[row[0]] * c + lift[row[1]] * s)

    def compliance(self, loaded, preload):
        """Compliance at the centre line of each loaded tooth, and the open share of the bore.

        `preload`: inward load per pitch over the radial force of a flank, spread evenly over the bore."""
        push = sum(self.push[k] for k in loaded) - preload * np.sin(self.tooth.alpha) / PITCH * self.share
        up, _ = nnls(self.root, np.linalg.solve(self.root.T, push), maxiter=20 * len(push))
        values = [float(sum(self.held[j, k] for k in loaded) + self.measure[j] @ up) for j in loaded]
        return values, float(np.mean(up > 0))


def by_calculix(tooth):
    """n . u(C) and n . u(P) of a strip of five pitches, by these elements and by ccx's CPE6."""
    own = Loaded(tooth, teeth=5)
    strip = own.strip
    f = strip.flank_load(0)
    end, bore = strip.ends(), strip.bore()
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{k + 1}, {x:.12e}, {y:.12e}, 0." for k, (x, y) in enumerate(strip.points)]
    lines += ["*ELEMENT, TYPE=CPE6, ELSET=BODY"]
    lines += [f"{k + 1}, " + ", ".join(str(n + 1) for n in e) for k, e in enumerate(strip.elements)]
    lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"1., {NU}", "*SOLID SECTION, ELSET=BODY, MATERIAL=M", "1.",
              "*BOUNDARY"]
    lines += [f"{n + 1}, 1, 1" for n in end] + [f"{n + 1}, 2, 2" for n in bore]
    lines += ["*STEP", "*STATIC", "*CLOAD"]
    lines += [f"{k // 2 + 1}, {k % 2 + 1}, {f[k]:.12e}" for k in np.nonzero(f)[0]]
    probe = [strip.at(0, tooth.crossing), strip.at(tooth.half, tooth.dedendum)]
    lines += ["*NODE PRINT, NSET=PROBE", "U", "*END STEP"]
    at = lines.index("*MATERIAL, NAME=M")
    lines[at:at] = ["*NSET, NSET=PROBE", ", ".join(str(n + 1) for n in probe)]
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "tooth.inp").write_text("\n".join(lines) + "\n", encoding="ascii")
        subprocess.run(["ccx", "tooth"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
        rows = [line.split() for line in Path(folder, "tooth.dat").read_text().splitlines()]
    found = {int(r[0]) - 1: np.array(r[1:3], float) for r in rows if len(r) == 4 and r[0].isdigit()}
    return [(own.closing(n), float(-found[n] @ [own.c, own.s])) for n in probe]


def row_of(alpha=22.0, thickness=0.5, dedendum=1.1, fillet=0.25):
    return dict(alpha=alpha, thickness=thickness, dedendum=dedendum, fillet=fillet)


RATIOS = ((30, 0.535), (50, 0.989), (80, 1.78), (100, 2.38), (160, 4.44))
THIN = [(wall, row_of()) for _, wall in RATIOS]
THIN += [(wall, row_of(alpha, thickness, dedendum)) for wall in (0.4, 0.6, 1.0, 1.7, 3.0, 5.0)
         for alpha in (15, 22, 30) for thickness in (0.4, 0.5) for dedendum in (1.0, 1.4)
         if (alpha, thickness, dedendum) != (30, 0.5, 1.4)]  # these teeth overlap at the root
THICK = [(wall, row_of(*shape)) for wall in (8.0, 14.0, 20.0, 32.0, 40.0)
         for shape in ((22, 0.5, 1.1), (15, 0.4, 1.4), (30, 0.5, 1.0), (22, 0.4, 1.2))]


def on_strip(wall, shape, **more):
    """A strip that is long enough for its wall."""
    tooth = Tooth(wall, **shape)
    if wall <= 5:
        return Loaded(tooth, teeth=11, **more)
    return Loaded(tooth, teeth=2 * max(3, round(0.6 * wall / PITCH)) + 1, flat=2.5 * wall, **more)


def rows(cases):
    table = Table("tooth_pair_fe", "wall_over_module [1]", "flank_angle [rad]", "thickness_over_pitch [1]",
                  "dedendum_over_module [1]", "fillet_over_module [1]")
    for wall, shape in cases:
        tooth = Tooth(wall, **shape)
        inputs = (wall, float(tooth.alpha), shape["thickness"], shape["dedendum"], float(tooth.fillet))
        own = on_strip(wall, shape)
        values = [("tooth", own.centre()), ("contact_in_tooth", own.flank - own.centre())]
        if wall <= 5:
            held, free, bending, _ = section(tooth)
            values += [("stretch_held", held), ("stretch_free", free), ("bending", bending)]
        if wall >= 20 and shape == row_of():
            many = Loaded(tooth, teeth=31, flat=2.5 * wall)
            values += [(f"next_{k}", many.centre(k)) for k in (1, 2, 3)]
        for case, value in values:
            table.add(case, inputs, value, "1", "tooth_pair.py plane-strain finite elements",
                      digits=3 if case in ("tooth", "stretch_held", "stretch_free", "bending") else 2, printed=6)
    return [table]


def tables():
    return rows(THIN + THICK)


def some_tables():
    return rows([THIN[3], THIN[20], THICK[0]])


def check():
    print("Mesh, length of the strip, width of the pressure: c_t and c_1 (alpha 22, p/2, h_f 1.1)")
    for wall in (0.535, 2.38):
        for more in (dict(), dict(fine=0.7), dict(fine=0.5), dict(teeth=9), dict(teeth=21),
                     dict(patch=0.05), dict(patch=0.2), dict(patch=0.4)):
            own = Loaded(Tooth(wall), **more)
            print(f"  t/m {wall}: {more or 'as used'}: {len(own.strip.points)} nodes, c_t {own.centre():.4f}, "
                  f"c_1 {own.flank:.4f}, EA held {own.held:.4f}", flush=True)

    print("The same in plane stress; one tooth and all teeth loaded; EA held, free, EI, axis (as section)")
    for ratio, wall in RATIOS:
        one = Loaded(Tooth(wall), plane="stress")
        every = tuple(range(-7, 8))
        all_teeth = Loaded(Tooth(wall), plane="stress", loaded=every, patch=0.2)
        strain = Loaded(Tooth(wall)).centre()
        print(f"  ratio {ratio}, t/m {wall}: stress {one.centre():.2f}, all "
              f"{np.mean([all_teeth.centre(k) for k in every]):.2f}; strain {strain:.3f}, formula "
              f"{formula(Tooth(wall))[0]:.3f}; " + " ".join(f"{x:.3f}" for x in section(Tooth(wall))), flush=True)

    print("Circular spline: c_t in plane stress, plane strain, formula; mean of groups of 7, 15, 31 teeth")
    for wall in (4, 8.1, 14, 20, 32, 40):
        stress = on_strip(wall, {}, plane="stress").centre()
        own = Loaded(Tooth(wall), teeth=63, flat=2.5 * wall)
        mutual = [own.centre(k) for k in range(31)]
        group = [mutual[0] + sum(2 * (n - k) * mutual[k] for k in range(1, n)) / n for n in (7, 15, 31)]
        print(f"  t/m {wall}: {stress:.3f} {mutual[0]:.3f} {formula(Tooth(wall))[0]:.3f}; "
              + " ".join(f"{x:.2f}" for x in group)
              + "; next teeth " + " ".join(f"{mutual[k]:.3f} (layer {layer(own.tooth, k):.3f})"
                                           for k in (1, 2, 3, 5, 8)), flush=True)

    print("Fillet radius: c_t and formula")
    for wall in (0.535, 2.38):
        for fillet in (0.1, 0.2, 0.25, 0.35, 0.45):
            tooth = Tooth(wall, fillet=fillet)
            print(f"  t/m {wall}, {tooth.fillet:.3f} m: {Loaded(tooth).centre():.3f} "
                  f"{formula(tooth)[0]:.3f}", flush=True)

    print("One-sided bore, plane stress, preload q: mean of the loaded teeth, each, open share")
    for ratio, wall in RATIOS:
        bore = Bore(Tooth(wall), fine=1.2)
        for loaded in ((0,), (-1, 0, 1)):
            for q in (0, 0.15):
                each, open_share = bore.compliance(loaded, q)
                print(f"  ratio {ratio}, {len(loaded)} teeth, q {q}: {np.mean(each):.2f} "
                      f"{np.round(each, 2)} {open_share:.2f}", flush=True)

    if shutil.which("ccx"):
        print("n . u of C and P, these elements and ccx:", by_calculix(Tooth(0.989)))
    compare(tables()[0])


def compare(table):
    """The formula against the rows of the table."""
    errors = {}
    for case, wall, alpha, thickness, dedendum, fillet, value, *_ in table.rows:
        tooth = Tooth(float(wall), np.degrees(float(alpha)), float(thickness), float(dedendum),
                      fillet=float(fillet))
        if case.startswith("next"):
            continue
        ours = dict(zip(("tooth", "stretch_held", "stretch_free", "bending"), formula(tooth)),
                    contact_in_tooth=LOCAL)[case]
        errors.setdefault(case, []).append((ours / float(value) - 1, float(wall), thickness, dedendum))
    for case, list_of in errors.items():
        worst = max(list_of, key=lambda e: abs(e[0]))
        rms = np.sqrt(np.mean([e[0] ** 2 for e in list_of]))
        print(f"{case}: {len(list_of)} rows, formula off by {100 * rms:.1f} % rms, {100 * worst[0]:.1f} % at "
              f"most (t/m {worst[1]})")


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    else:
        publish(*tables())
