"""Cracks in strips and in stacks: stress intensity by plane finite elements of high degree.

Quarter of the body, 0 <= x <= W, 0 <= y <= H, crack on y = 0.  Three crack shapes: "edge"
(x < a, edge x = 0 free), "centre" (x < a, mirror at x = 0) and "double" (x > W - a, mirror at
x = 0: the edges at both sides are cracked).  "stack": centre crack, and a mirror at y = H = h/2.

Load: traction on the crack face (Bueckner), so no remote boundary is needed:

    tension          p = 1
    bending          p = 1 - 2 x/W              (edge crack; 1 at the cracked edge)
    shear            tau = 6 x (W - x)/W^2 of mean 1 (edge), tau = 1.5 (1 - x^2/W^2) (centre and
                     double), uniform 1 (stack): transverse force without moment on the crack
    antiplane        tau_z = 1

Displacement elements of degree p on a tensor product of one-dimensional meshes that are graded
geometrically to the tip; K from the derivative of the discrete energy as the tip moves together
with the mesh (exact, because a product of one-dimensional matrices is stretched).  Plane
strain, nu = 0.3 (the factors do not depend on nu).

Reported: F = K/(unit stress x sqrt(pi a)) over a/W, or a/h of the stack.  Digits: what degree and
grading change; the exact antiplane solutions are met to 1e-6 on the same meshes.

    cracked_strip.py --check     other degrees and gradings
    cracked_strip.py --write     tests/data/cracked_strip.csv (five minutes)
"""
import sys

import numpy as np
import scipy.sparse as sp
from numpy.polynomial.legendre import Legendre, leggauss
from scipy.sparse.linalg import splu

from reference_csv import Table, publish

NU = 0.3
MU = 1.0
LAM = 2 * MU * NU / (1 - 2 * NU)
E_PRIME = 2 * MU / (1 - NU)


class Line:
    """Continuous piecewise polynomials of degree p over `ends`, at Gauss-Lobatto points."""

    def __init__(self, ends, p):
        self.ends, self.p = np.asarray(ends, float), p
        inner = Legendre.basis(p).deriv().roots()
        self.local = np.concatenate([[-1], np.sort(inner.real), [1]])
        n = p + 4
        self.q, self.w = leggauss(n)
        vander = np.vander(self.local, increasing=True)
        coeff = np.linalg.inv(vander)
        self.N = np.vander(self.q, p + 1, increasing=True) @ coeff
        powers = np.arange(1, p + 1)
        self.dN = (np.vander(self.q, p, increasing=True) * powers) @ coeff[1:]
        cells = len(self.ends) - 1
        self.size = cells * p + 1
        lo, hi = self.ends[:-1, None], self.ends[1:, None]
        self.points = ((lo + hi) / 2 + self.q * (hi - lo) / 2)
        self.weights = self.w * (hi - lo) / 2
        nodes = (lo + hi) / 2 + self.local * (hi - lo) / 2
        self.nodes = np.concatenate([nodes[:, :-1].ravel(), [self.ends[-1]]])
        rows = np.arange(cells * n)
        columns = (np.arange(cells)[:, None] * p + np.arange(p + 1))
        columns = np.repeat(columns, n, axis=0)
        shape = (cells * n, self.size)

        def sparse(values):
            return sp.csr_matrix((values.ravel(), (np.repeat(rows, p + 1), columns.ravel())), shape)
        self.value = sparse(np.tile(self.N, (cells, 1)))
        self.slope = sparse((self.dN[None] * (2 / (hi - lo))[:, :, None]).reshape(-1, p + 1))
        W = sp.diags(self.weights.ravel())
        self.mass = (self.value.T @ W @ self.value).tocsr()
        self.stiff = (self.slope.T @ W @ self.slope).tocsr()
        self.cross = (self.slope.T @ W @ self.value).tocsr()  # N'_i N_j


def graded(lo, tip, hi, layers, ratio, first, widest):
    """Mesh lines from lo over the tip to hi: geometric towards the tip up to the size `first`,
    growing twofold beyond it up to `widest`."""
    def side(length):
        end = min(first, length)
        steps = [0.0] + [end * ratio ** k for k in range(layers, -1, -1)]
        size = first
        while steps[-1] < length * (1 - 1e-9):
            rest = length - steps[-1]
            steps.append(length if rest < 1.4 * size else steps[-1] + size)
            size = min(2 * size, widest)
        return np.array(steps)
    left = tip - side(tip - lo)[::-1] if tip > lo else np.array([tip])
    return np.concatenate([left, tip + side(hi - tip)[1:]])


def profiles(shape, mode, x, W):
    """{load: (traction on the face, its slope)}"""
    one, zero = np.ones_like(x), np.zeros_like(x)
    if mode == "III":
        return {"antiplane": (one, zero)}
    if mode == "II":
        if shape == "stack":
            return {"shear": (one, zero)}
        if shape == "edge":
            return {"shear": (6 * x * (W - x) / W ** 2, 6 * (W - 2 * x) / W ** 2)}
        return {"shear": (1.5 * (1 - (x / W) ** 2), -3 * x / W ** 2)}
    if shape == "edge":
        return {"tension": (one, zero), "bending": (1 - 2 * x / W, -2 / W * one)}
    return {"tension": (one, zero)}


def stress_intensity(shape, mode, a, W=1.0, H=None, p=8, layers=5, ratio=0.15):
    """{load: K}; a is the depth (half length) of the crack, W the depth (half width)."""
    stack, double, mirrored = shape == "stack", shape == "double", shape != "edge"
    H = 4 * W if H is None else H
    tip = W - a if double else a
    first = min(a, W - a, H) * 0.75
    widest = 0.75 * min(W, H)
    X = Line(graded(0, tip, W, layers, ratio, first, widest), p)
    Y = Line(graded(0, 0, H, layers, ratio, first, widest), p)
    cracked = X.nodes > tip * (1 + 1e-12) if double else X.nodes < tip * (1 - 1e-12)
    nx, ny = X.size, Y.size
    index = np.arange(nx * ny).reshape(nx, ny)

    # The mesh with its tip moved by dtip: x -> x + q dtip, q = x/tip or (W - x)/(W - tip).
    x, weights = X.points.ravel(), X.weights.ravel()
    q = np.where(x < tip, x / tip, (W - x) / (W - tip))
    stretch = np.where(x < tip, 1 / tip, -1 / (W - tip))
    moved = sp.diags(weights * stretch)
    d_mass, d_stiff = X.value.T @ moved @ X.value, -(X.slope.T @ moved @ X.slope)
    on_face = x > tip if double else x < tip
    loads = {name: (X.value.T @ (weights * on_face * f),
                    X.value.T @ (weights * on_face * (f * stretch + df * q)))
             for name, (f, df) in profiles(shape, mode, x, W).items()}

    no_u, no_v = np.zeros((nx, ny), bool), np.zeros((nx, ny), bool)
    sliding, normal = (no_v, no_u) if mode == "II" else (no_u, no_v)
    # In modes I and II: `normal` is the component that the crack frees.
    normal[~cracked, 0] = True
    if stack:
        normal[:, -1] = True
    if mode == "III":
        K = MU * (sp.kron(X.stiff, Y.mass) + sp.kron(X.mass, Y.stiff))
        dK = MU * (sp.kron(d_stiff, Y.mass) + sp.kron(d_mass, Y.stiff))
        fixed, at = normal.ravel(), index[:, 0]
    else:
        if mirrored:
            sliding[0, :] = True
        else:
            sliding[-1, 0] = True  # rigid motion only
        stiff = LAM + 2 * MU
        uv = LAM * sp.kron(X.cross, Y.cross.T) + MU * sp.kron(X.cross.T, Y.cross)
        K = sp.bmat([[stiff * sp.kron(X.stiff, Y.mass) + MU * sp.kron(X.mass, Y.stiff), uv],
                     [uv.T, MU * sp.kron(X.stiff, Y.mass) + stiff * sp.kron(X.mass, Y.stiff)]])
        dK = sp.block_diag([stiff * sp.kron(d_stiff, Y.mass) + MU * sp.kron(d_mass, Y.stiff),
                            MU * sp.kron(d_stiff, Y.mass) + stiff * sp.kron(d_mass, Y.stiff)])
        fixed = np.concatenate([no_u.ravel(), no_v.ravel()])
        at = index[:, 0] + (nx * ny if mode == "I" else 0)
    modulus = 2 * MU if mode == "III" else E_PRIME
    free = np.flatnonzero(~fixed)
    factors = splu(K.tocsr()[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A",
                   diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    result = {}
    for name, (f, df) in loads.items():
        b, db, u = np.zeros(K.shape[0]), np.zeros(K.shape[0]), np.zeros(K.shape[0])
        b[at], db[at] = f, df
        u[free] = factors.solve(b[free])
        # Energy b.u of both halves; its slope is the energy release rate of one tip.
        G = (2 * db @ u - u @ (dK @ u)) * (-1 if double else 1)
        result[name] = np.sqrt(modulus * G)
    return result


def factor(shape, mode, a, **options):
    """{load: K/sqrt(pi a)}"""
    K = stress_intensity(shape, mode, a, **options)
    return {load: value / np.sqrt(np.pi * a) for load, value in K.items()}


DEPTHS = (0.01, 0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95)
BETWEEN = (0.03, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75, 0.85)  # not seen by the fits
SPACINGS = (0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.5, 2, 3, 5, 8)  # half length over spacing
STACKS_BETWEEN = (0.025, 0.075, 0.15, 0.25, 0.35, 0.45, 0.6, 0.8, 1.25)


def stack_factor(mode, a_h, **options):
    h = 1 / a_h
    return factor("stack", mode, 1.0, W=1 + 3 * h, H=h / 2, **options)


def exact_antiplane(shape, x):
    if shape == "stack":
        return np.sqrt(np.tanh(np.pi * x) / (np.pi * x))
    return np.sqrt(2 / (np.pi * x) * np.tan(np.pi * x / 2))


def rows(cases, **options):
    for shape, x in cases:
        for mode in ("I", "II", "III"):
            F = stack_factor(mode, x, **options) if shape == "stack" else factor(
                shape, mode, x, **options)
            for load, value in F.items():
                if mode == "III":
                    assert abs(value / exact_antiplane(shape, x) - 1) < 5e-6
                else:
                    yield shape, load, x, value


def table(cases, **options):
    out = Table("cracked_strip", "size_ratio [1]")
    for shape, load, x, value in rows(cases, **options):
        digits = 4 if shape == "edge" and x >= 0.9 else 5
        out.add(f"{shape}.{load}", (x,), value, "1", "plane finite elements of degree 8",
                digits=digits, printed=8)
    return out


def some_tables():
    return [table([("edge", 0.3), ("stack", 0.5)])]


def tables():
    shapes = ("edge", "centre", "double")
    return [table([(shape, x) for shape in shapes for x in DEPTHS] +
                  [("stack", x) for x in SPACINGS] +
                  [(shape, x) for shape in shapes for x in BETWEEN] +
                  [("stack", x) for x in STACKS_BETWEEN])]


def check():
    """Degree and grading: largest relative change of any factor."""
    for shape, depths in (("edge", (0.02, 0.5, 0.9)), ("centre", (0.02, 0.5, 0.9)),
                          ("double", (0.02, 0.5, 0.9)), ("stack", (0.1, 1, 5))):
        for x in depths:
            values = [np.array([v for *_, v in rows([(shape, x)], p=p, layers=n)])
                      for p, n in ((8, 5), (10, 4), (6, 5))]
            print(shape, x, *(np.abs(v / values[0] - 1).max() for v in values[1:]), flush=True)


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    else:
        publish(*tables())
