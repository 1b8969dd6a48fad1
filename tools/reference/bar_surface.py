"""Round bar, solid or hollow, with a crack on one side: three-dimensional finite elements.

Lengths in units of the outer radius.  The crack lies in z = 0, its mouth at (x, y) = (1, 0).  Solid:
its front is the part inside the circle of the ellipse (1 - x)^2/a^2 + y^2/b^2 = 1, or of the
straight line x = 1 - a where a/b = 0.  Hollow: a semi-ellipse in depth and arc length, from the
outer or the inner surface.  Quarter of the bar, y > 0, 0 < z < 3.  The mesh is the product of a
plane one of the cross-section, whose curves s = const. are ellipses that run from the mouth through
the front to the far side, and a line in z; both are graded geometrically to the front.  Every
three-dimensional matrix is therefore a Kronecker product.  Load: the stress of the uncracked bar
on the crack face, 1 (tension), x (bending), torsion (-y, x).

K comes from the opening and the sliding of the faces between 0.03 and 0.55 of the depth.  Elements
of degree 3 make it a little low, by the same factor along a front: sizes scale with the depth, and
so the factor hardly depends on the crack.  It is taken from the energy: the derivative of the
energy with respect to the depth over the integral of K^2 along the front is BIAS^2 (--check).

    bar_surface.py --write      tests/data/bar_surface*.csv (minutes)
    bar_surface.py --library    nodes of the library's table, coefficients over the front
    bar_surface.py --check      BIAS
"""
import sys

import numpy as np
import scipy.sparse as sp
from numpy.polynomial.legendre import leggauss
from scipy.sparse.linalg import splu

from annular_hollow import line_matrices, one, shape_functions
from reference_csv import Table, publish

NU = 0.3
# Of K_I, and of K_II and K_III together (--check).  Solid: 1.0158 to 1.0194 in three cracks and two
# loads, 1.009 to 1.021.  Hollow: 1.0248 and 1.0244 in one crack and two loads, 1.0153.
BIAS = {"solid": (1.0178, 1.013), "hollow": (1.0246, 1.015)}


def curve(depth, k, t):
    """Point at t (0 on the axis y = 0, 1 on the circle) of the ellipse of depth a, k = a/b."""
    u_e = depth ** 2 / (k * k + np.sqrt(k ** 4 + (1 - k * k) * depth ** 2))
    y_e = np.sqrt(np.maximum(2 * u_e - u_e ** 2, 0))
    psi = np.arcsin(np.clip(k * y_e / np.maximum(depth, 1e-300), -1, 1))
    small = psi < 1e-8
    psi_ = np.where(small, 1.0, psi)
    return 1 - depth * np.cos(psi * t), y_e * np.where(small, t, np.sin(psi_ * t) / np.sin(psi_))


def distances(a, end):
    """Element ends at distances from the front that scale with the depth a, up to `end`."""
    ends = [0.0] + [a * x for x in (0.0225, 0.15, 1, 3, 9, 27, 81) if a * x < 0.75 * end]
    return np.array(ends + [end])


class Section:
    """Plane mesh of half of a section: patches, each a product mesh (s, t) and a map to (x, y).

    In the first patch, lines of constant s are crack fronts, and s = a is the front itself.  Nodes of the same place
    are one node.
    """

    def __init__(self, a, patches, p):
        self.a, self.p, self.map = a, p, patches[0][0]
        y, w = leggauss(p + 4)
        reference, N, dN = shape_functions(p, y)
        numbers, points, elements = {}, [], []

        def line(ends):
            nodes = [c + h * (reference + 1) for c, h in zip(ends[:-1], np.diff(ends) / 2)]
            return np.concatenate([nodes[0][:1]] + [n[1:] for n in nodes])

        for which, (to_plane, s, t) in enumerate(patches):
            S, T = np.meshgrid(line(s), line(t), indexing="ij")
            X, Y = to_plane(S, T)
            number = np.zeros(S.shape, dtype=int)
            for index in np.ndindex(*S.shape):
                key = round(X[index], 8) + 0.0, round(Y[index], 8) + 0.0
                if key not in numbers:
                    numbers[key] = len(points)
                    points.append((X[index], Y[index]))
                number[index] = numbers[key]
            if which == 0:
                self.number, self.s_nodes, self.t, self.t_nodes = number, line(s), t, line(t)
                self.tip = p * int(np.argmin(np.abs(s - a)))
            for e in range(len(s) - 1):
                for f in range(len(t) - 1):
                    elements.append((to_plane, s[e:e + 2], t[f:f + 2],
                                     number[e * p:e * p + p + 1, f * p:f * p + p + 1].ravel(),
                                     which == 0 and s[e + 1] <= a * (1 + 1e-12)))
        self.shape = self.number.shape
        self.n = n = len(points)
        self.x, self.y = np.array(points).T
        self.axis = np.nonzero(np.abs(self.y) < 1e-7)[0]
        self.ligament = np.setdiff1d(np.arange(n), self.number[:self.tip].ravel())
        names = ("M", "Sxx", "Sxy", "Syy", "Gx", "Gy")
        rows, cols, values = [], [], {name: [] for name in names}
        self.area = 0.0
        self.load = {name: np.zeros(n) for name in ("1", "x", "y")}
        for to_plane, (s0, s1), (t0, t1), dofs, face in elements:
            hs, ht = (s1 - s0) / 2, (t1 - t0) / 2
            S, T = np.meshgrid(s0 + hs * (y + 1), t0 + ht * (y + 1), indexing="ij")
            X, Y = to_plane(S, T)
            ds, dt = 1e-6 * hs, 1e-6 * ht
            Xs, Ys = [(q - r) / (2 * ds) for q, r in zip(to_plane(S + ds, T), to_plane(S - ds, T))]
            Xt, Yt = [(q - r) / (2 * dt) for q, r in zip(to_plane(S, T + dt), to_plane(S, T - dt))]
            J = (Xs * Yt - Xt * Ys).ravel()
            if abs(np.sign(J).sum()) != len(J):
                raise ValueError("mesh folds over")
            W = np.outer(w * hs, w * ht).ravel() * np.abs(J)
            phi = np.einsum("ia,jb->ijab", N, N).reshape(len(J), -1)
            ps = np.einsum("ia,jb->ijab", dN / hs, N).reshape(len(J), -1)
            pt = np.einsum("ia,jb->ijab", N, dN / ht).reshape(len(J), -1)
            px = (ps * Yt.ravel()[:, None] - pt * Ys.ravel()[:, None]) / J[:, None]
            py = (pt * Xs.ravel()[:, None] - ps * Xt.ravel()[:, None]) / J[:, None]
            for name, u, v in (("M", phi, phi), ("Sxx", px, px), ("Sxy", px, py),
                               ("Syy", py, py), ("Gx", px, phi), ("Gy", py, phi)):
                values[name].append(((u * W[:, None]).T @ v).ravel())
            rows.append(np.repeat(dofs, len(dofs)))
            cols.append(np.tile(dofs, len(dofs)))
            self.area += W.sum()
            if face:
                for name, q in (("1", 1.0), ("x", X.ravel()), ("y", Y.ravel())):
                    np.add.at(self.load[name], dofs, (phi * (W * q)[:, None]).sum(axis=0))
        rows, cols = np.concatenate(rows), np.concatenate(cols)
        for name in names:
            setattr(self, name, sp.csr_matrix((np.concatenate(values[name]), (rows, cols)),
                                              shape=(n, n)))


def solid(a, k, p=3):
    """Depth a over the radius, k = a/b."""
    def to_plane(s, t):
        return curve(s, k * (1 - np.clip((s - a) / (2 - a), 0, 1)), t)

    s = np.concatenate((a - distances(a, a)[::-1], a + distances(a, 2.0 - a)[1:]))
    return Section(a, [(to_plane, s, np.array([0, 0.375, 0.75, 1.0]))], p)


def hollow(a, k, rho, outer, p=3):
    """Depth a over the outer radius, k = a/c, c the half length along the surface."""
    wall, r_s = 1 - rho, 1.0 if outer else rho
    c = a / k
    end = max(wall, c + 0.6 * wall)  # of the first patch, along the surface

    def place(u, v):
        r = r_s - u if outer else r_s + u
        return r * np.cos(v / r_s), r * np.sin(v / r_s)

    def to_plane(s, t):
        e = np.minimum(s, a) if np.ndim(s) else min(s, a)
        u, v = e * np.cos(np.pi / 2 * t), e / k * np.sin(np.pi / 2 * t)
        f = np.clip((s - a) / a, 0, None)  # 1 on the edge of the patch
        u_e = np.where(t <= 0.5, wall, wall * (2 - 2 * t))
        v_e = np.where(t <= 0.5, end * 2 * t, end)
        return place(u + f * (u_e - u), v + f * (v_e - v))

    def side(s, t):  # s along the surface, t through the wall as in the first patch
        return place(wall * (2 - 2 * t), s)

    s = np.concatenate((a - distances(a, a)[::-1], a + distances(a, a)[1:]))
    far = np.pi * r_s
    lengths = end + (far - end) * np.array([0, 0.1, 0.35, 1.0])
    return Section(a, [(to_plane, s, np.array([0, 0.25, 0.5, 0.75, 1.0])),
                       (side, lengths, np.array([0.5, 0.75, 1.0]))], p)


class Bar:
    """A section and its half length."""

    def __init__(self, section, p=3):
        self.a, self.p = section.a, p
        q = self.q = section
        self.z, self.Z = line_matrices(distances(section.a, 3.0), p, S=(one, 1, 1),
                                       M=(one, 0, 0), D=(one, 1, 0))
        self.mu, self.lame = 1 / (2 * (1 + NU)), NU / ((1 + NU) * (1 - 2 * NU))
        mu, lame, Z, kr = self.mu, self.lame, self.Z, sp.kron
        c = lame + 2 * mu
        uu = kr(c * q.Sxx + mu * q.Syy, Z["M"]) + mu * kr(q.M, Z["S"])
        vv = kr(c * q.Syy + mu * q.Sxx, Z["M"]) + mu * kr(q.M, Z["S"])
        ww = c * kr(q.M, Z["S"]) + mu * kr(q.Sxx + q.Syy, Z["M"])
        uv = kr(lame * q.Sxy + mu * q.Sxy.T, Z["M"])
        uw = lame * kr(q.Gx, Z["D"].T) + mu * kr(q.Gx.T, Z["D"])
        vw = lame * kr(q.Gy, Z["D"].T) + mu * kr(q.Gy.T, Z["D"])
        self.K = sp.bmat([[uu, uv, uw], [uv.T, vv, vw], [uw.T, vw.T, ww]]).tocsr()
        self.index = np.arange(q.n * len(self.z)).reshape(q.n, len(self.z))
        self.N = self.index.size

    def solve(self, loads, fixed):
        free = np.setdiff1d(np.arange(3 * self.N), np.unique(fixed))
        lu = splu(self.K[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A",
                  diag_pivot_thresh=0.0, options={"SymmetricMode": True})
        result = []
        for f in loads:
            x = np.zeros(3 * self.N)
            x[free] = lu.solve(f[free])
            result.append((x.reshape(3, self.q.n, -1)[:, :, 0], 4 * (f @ x)))
        return result

    def face(self, u=None, v=None, w=None):
        f = np.zeros((3, self.q.n, len(self.z)))
        for i, load in enumerate((u, v, w)):
            if load is not None:
                f[i, :, 0] = load
        return f.ravel()

    def opening(self, layer=slice(0, 2)):
        """[(K_I/sqrt(pi a)) along t, compliance integral] for tension and bending, E = 1."""
        q, N = self.q, self.N
        fixed = np.concatenate((N + self.index[q.axis].ravel(), 2 * N + self.index[q.ligament, 0],
                                [self.index[q.axis[0], -1]]))
        out = []
        for plane, energy in self.solve([self.face(w=q.load["1"]), self.face(w=q.load["x"])],
                                        fixed):
            out.append((self.at_front(plane[2]) / (4 * (1 - NU ** 2)) / np.sqrt(np.pi * self.a),
                        energy))
        return out

    def at_front(self, w):
        """sqrt(2 pi/d) w at d -> 0, for each t of the nodes."""
        q, p = self.q, self.p
        rows = np.arange(1, q.tip)
        result = []
        for j in range(q.shape[1]):
            X, Y = q.x[q.number[q.tip, j]], q.y[q.number[q.tip, j]]
            dofs = q.number[rows, j]
            dX, dY = q.x[dofs] - X, q.y[dofs] - Y
            nx, ny = self.normal(j)
            d = dX * nx + dY * ny
            keep = (d > 0.03 * self.a) & (d < 0.55 * self.a)
            A = np.vander(d[keep] / self.a, 4, increasing=True)
            result.append(np.sqrt(2 * np.pi) * np.linalg.lstsq(
                A, w[dofs][keep] / np.sqrt(d[keep]), rcond=None)[0][0])
        return np.array(result)

    def normal(self, j):
        """Normal of the front toward the crack."""
        q = self.q
        t = q.t_nodes[j]
        d = 1e-6
        A, B = (q.map(np.array(self.a), np.array(t + s * d)) for s in (-1, 1))
        tx, ty = B[0] - A[0], B[1] - A[1]
        length = np.hypot(tx, ty)
        inward = self.q.map(np.array(0.99 * self.a), np.array(t))
        at = self.q.map(np.array(self.a), np.array(t))
        n = np.array([ty, -tx]) / length
        return n * np.sign(n @ [inward[0] - at[0], inward[1] - at[1]])

    def swept(self):
        """Weights dA/da of the nodes along the half front, growth at constant a/b."""
        q, p, d = self.q, self.p, 1e-6
        x, w = leggauss(p + 4)
        nodes, N, _ = shape_functions(p, x)
        weights = np.zeros(q.shape[1])
        for f in range(len(q.t) - 1):
            h = (q.t[f + 1] - q.t[f]) / 2
            t = q.t[f] + h * (x + 1)
            (Xa, Ya), (Xb, Yb) = q.map(self.a, t), q.map(self.a - d, t)
            (Xs, Ys), (Xt, Yt) = q.map(self.a, t + d), q.map(self.a, t - d)
            J = np.abs((Xa - Xb) * (Ys - Yt) - (Ya - Yb) * (Xs - Xt)) / (2 * d * d)
            weights[f * p:f * p + p + 1] += N.T @ (w * h * J)
        return weights

    def twisting(self):
        """(K_II, K_III)/sqrt(pi a) along t under torsion, tau = r, and the energy, E = 1."""
        q, N = self.q, self.N
        fixed = np.concatenate((self.index[q.axis].ravel(), 2 * N + self.index[q.axis].ravel(),
                                self.index[q.ligament, 0], N + self.index[q.ligament, 0],
                                [2 * N + self.index[np.argmax(q.y), -1]]))
        [(plane, energy)] = self.solve([self.face(u=-q.load["y"], v=q.load["x"])], fixed)
        n = np.array([self.normal(j) for j in range(q.shape[1])])
        fu, fv = self.at_front(plane[0]), self.at_front(plane[1])
        K_II = (fu * n[:, 0] + fv * n[:, 1]) / (4 * (1 - NU ** 2))
        K_III = (-fu * n[:, 1] + fv * n[:, 0]) * self.mu / 2
        root = np.sqrt(np.pi * self.a)
        return K_II / root, K_III / root, energy


def factors(bar, kind="solid"):
    """The four factors of (SB-7) along t, free of the bias; magnitudes of sliding and tearing."""
    (tension, _), (bending, _) = bar.opening()
    sliding, tearing, _ = bar.twisting()
    opening, shear = BIAS[kind]
    return {"tension": opening * tension, "bending": opening * bending,
            "sliding": shear * np.abs(sliding), "tearing": shear * np.abs(tearing)}


DEPTHS = (0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.0)


def table():
    result = Table("bar_surface", "radius_ratio [1]", "depth_ratio [1]", "aspect_ratio [1]",
                   "position [1]")

    def add(kind, bar, rho, alpha, k, positions):
        values = factors(bar, "solid" if rho == 0 else "hollow")
        for t in positions:
            j = int(np.argmin(np.abs(bar.q.t_nodes - t)))
            for name, value in values.items():
                if (name, t) == ("sliding", 0.0):
                    continue
                result.add(f"{kind}.{name}", (repr(rho), repr(alpha), repr(k), repr(t)), value[j],
                           "1", "bar_surface.py three-dimensional elements p = 3", 2, 5)

    nodes = [(a, k) for a in DEPTHS for k in (0.0, 0.25, 0.5, 0.75, 1.0)]
    # The library's nodes, and four between them.
    for a, k in [*nodes, (0.5, 0.6), (0.7, 0.1), (0.15, 0.6), (0.07, 0.9)]:
        add("solid", Bar(solid(a, k)), 0.0, a, k, (0.0, 0.375, 0.75))
    for rho, outer, alpha, k in HOLLOW:
        bar = Bar(hollow(alpha * (1 - rho), k, rho, outer))
        add("outer" if outer else "inner", bar, rho, alpha, k, (0.0, 0.5, 0.75))
    return result


def compliance_table():
    """Added compliance times E, outer radius 1, from the energy of the elements, without their K."""
    result = Table("bar_surface_compliance", "radius_ratio [1]", "depth_ratio [1]",
                   "aspect_ratio [1]")

    def add(rho, alpha, k, bar):
        (_, tension), (_, bending) = bar.opening()
        inertia = np.pi / 4 * (1 - rho ** 4)
        for name, energy, load in (("tension", tension, np.pi * (1 - rho ** 2)),
                                   ("bending", bending, inertia),
                                   ("torsion", bar.twisting()[2], 2 * inertia)):
            result.add(name, (repr(rho), repr(alpha), repr(k)), energy / load ** 2, "1",
                       "energy of the elements of bar_surface.py", 2, 5)

    for a, k in ((0.1, 0.5), (0.2, 0.5), (0.4, 0.75), (0.6, 0.5), (0.4, 1.0), (0.8, 0.25)):
        add(0.0, a, k, Bar(solid(a, k)))
    for rho, alpha, k in ((0.5, 0.5, 1.0), (0.8, 0.5, 0.5), (0.5, 0.3, 0.5), (0.65, 0.6, 0.5),
                          (0.9, 0.6, 0.4), (0.5, 0.6, 0.4), (0.3, 0.5, 0.6)):
        add(rho, alpha, k, Bar(hollow(alpha * (1 - rho), k, rho, True)))
    return result


HOLLOW = ((0.5, True, 0.5, 1.0), (0.8, True, 0.5, 0.5), (0.5, True, 0.3, 0.5),
          (0.5, False, 0.5, 1.0), (0.8, False, 0.5, 0.5), (0.5, False, 0.3, 0.5))


def library_table():
    for a in DEPTHS:
        for k in (0.0, 0.25, 0.5, 0.75, 1.0):
            bar = Bar(solid(a, k))
            t = bar.q.t_nodes[bar.q.t_nodes < 0.95]
            for name, value in factors(bar).items():
                terms = np.vander(t ** 2, 4, increasing=True)
                if name == "sliding":
                    terms = terms * t[:, None]
                c = np.linalg.lstsq(terms, value[:len(t)], rcond=None)[0]
                print(name, a / 2, k, *(f"{x:.4f}" for x in c), flush=True)


def check():
    def pair(label, make, a):
        bar, h = Bar(make(a)), 0.02 * a
        up, down = Bar(make(a + h)), Bar(make(a - h))
        w = 4 * np.pi * a * bar.swept()
        middle, above, below = bar.opening(), up.opening(), down.opening()
        for i, name in enumerate(("tension", "bending")):
            slope = (above[i][1] - below[i][1]) / (2 * h)
            energy = (1 - NU ** 2) * (w * middle[i][0] ** 2).sum()
            print(label, name, np.sqrt(slope / energy), flush=True)
        K_II, K_III, _ = bar.twisting()
        slope = (up.twisting()[2] - down.twisting()[2]) / (2 * h)
        energy = (w * ((1 - NU ** 2) * K_II ** 2 + (1 + NU) * K_III ** 2)).sum()
        print(label, "torsion", np.sqrt(slope / energy), flush=True)

    for a, k in ((0.4, 1.0), (0.2, 0.0), (0.8, 0.5)):
        pair(f"solid {a} {k}", lambda depth, k=k: solid(depth, k), a)
    pair("hollow 0.8 outer 0.5 0.5", lambda depth: hollow(depth, 0.5, 0.8, True), 0.1)


def aside_table():
    """Half of the range of K_I in a turn under a moment, (GR-34), over its largest stress."""
    result = Table("bar_surface_turning", "depth_ratio [1]", "aspect_ratio [1]", "position [1]")
    for a, k in ((0.2, 0.75), (0.4, 0.75), (0.6, 1.0), (0.8, 0.5), (0.8, 0.25)):
        bar = Bar(solid(a, k))
        q, N = bar.q, bar.N
        _, (bending, _) = bar.opening()
        fixed = np.concatenate((bar.index[q.axis].ravel(), 2 * N + bar.index[q.axis].ravel(),
                                2 * N + bar.index[q.ligament, 0], [N + bar.index[q.axis[0], -1]]))
        [(plane, _)] = bar.solve([bar.face(w=q.load["y"])], fixed)
        K = bar.at_front(plane[2]) / (4 * (1 - NU ** 2)) / np.sqrt(np.pi * a)
        for t in (0.375, 0.75, 0.9):
            j = int(np.argmin(np.abs(q.t_nodes - t)))
            result.add("amplitude", (repr(a), repr(k), repr(round(float(q.t_nodes[j]), 6))),
                       BIAS["solid"][0] * np.hypot(bending[j], K[j]), "1",
                       "bar_surface.py three-dimensional elements p = 3", 2, 5)
    return result


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    elif "--library" in sys.argv[1:]:
        library_table()
    else:
        publish(table(), compliance_table(), aside_table())
