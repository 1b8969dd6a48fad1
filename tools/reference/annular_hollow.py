"""Hollow (or solid) round shaft with an annular external crack: torsion and tension.

Lengths in units of the outer radius: inner radius rho, wall t = 1 - rho, crack depth a = alpha t,
ligament rho < r < r_e = 1 - a in the plane z = 0.

TORSION (values of annular_hollow_torsion.csv).  u_theta = r psi, div(r^3 grad psi) = 0, and
psi = 0 on the ligament.  In z > 0, expanded in the torsional modes of the shaft,

    psi = z + z0 - sum_n c_n phi_n(r) exp(-k_n z),   (r^3 phi')' + k^2 r^3 phi = 0,
    phi_n(r) = [Y2(k) J1(k r) - J2(k) Y1(k r)]/r,    J2(k rho) Y2(k) = J2(k) Y2(k rho),

and the added compliance is 2 z0/(mu I_p).  Two Galerkin solutions of the dual series bracket z0:
  * stress: h = dpsi/dz on the ligament = polynomial(r_e - r)/sqrt(r_e - r), psi = 0 weakly
    (z0 from above);
  * opening: psi on the crack face = polynomial(r - r_e) sqrt(r - r_e), stress = 0 weakly
    (z0 from below).
Both bases have the exact form of the solution at the front, so they converge exponentially; the
sums over modes converge like 1/N and are extrapolated.  Reported:

    C_T = added compliance * mu I_p / [(4 t/pi) ln sec(pi alpha/2)],

the factor relative to that of a thin-walled tube (antiplane edge crack in a strip, tada2000, secondary).

TENSION (values of annular_hollow_tension.csv).  Axisymmetric elasticity, displacement finite
elements of degree p on a tensor-product mesh graded geometrically to the front; because the mesh
is a product, every 2-D matrix is a Kronecker product of 1-D ones.  Load: unit stress on the crack
face (Bueckner), so the added compliance comes without a difference of large numbers; it is a
lower bound.  Reported, with A = pi (1 - rho^2):

    C_P = added compliance / [2 (1 - nu^2) 1.1215^2 pi^2 a^2/(E A^2)].

Independent: no finite elements and no conformal map in the first, no handbook K in either.

    annular_hollow.py --write          both tables (about three minutes)
    annular_hollow.py --library        the nodes of the library's interpolation (ten minutes)
    annular_hollow.py --check          penny crack, torsion by finite elements, mesh sequence
"""
import sys

import numpy as np
import scipy.sparse as sp
from numpy.polynomial.chebyshev import chebvander
from numpy.polynomial.legendre import Legendre, leggauss, legvander
from scipy.sparse.linalg import splu
from scipy.special import j0, j1, jn_zeros, y0, y1

from reference_csv import Table, publish


def j2(x):
    return 2 / x * j1(x) - j0(x)


def y2(x):
    return 2 / x * y1(x) - y0(x)


# --- torsion ---------------------------------------------------------------------------------


def mode_numbers(rho, n):
    """The first n roots k of J2(k rho) Y2(k) - J2(k) Y2(k rho); of J2(k) for a solid shaft."""
    if rho == 0:
        few = min(n, 40)
        b = (np.arange(1, n + 1) + 0.75) * np.pi
        k = b - 15 / (8 * b)  # McMahon
        k[:few] = jn_zeros(2, few)
        for _ in range(4):
            k -= j2(k) / (j1(k) - 2 / k * j2(k))
        return k

    def f(k):
        return j2(k * rho) * y2(k) - j2(k) * y2(k * rho)

    grid = np.pi / (1 - rho) * np.linspace(0.3, n + 2.5, 8 * (n + 3))
    sign = np.sign(f(grid))
    i = np.nonzero(sign[:-1] * sign[1:] < 0)[0][:n]
    low, high = grid[i], grid[i + 1]
    for _ in range(50):
        middle = (low + high) / 2
        same = sign[i] * f(middle) > 0
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return (low + high) / 2


class Torsion:
    """Modes of one radius ratio; shift(alpha) is z0."""

    def __init__(self, rho, n=1600):
        self.rho, self.n = rho, n
        self.k = mode_numbers(rho, n)
        ends = self.modes(np.array([rho, 1.0]) if rho else np.array([1.0]))
        # int phi^2 r^3 dr = [r^4 phi^2 / 2]: the cylinder function of order 2 vanishes at the ends
        self.norm = ends[:, -1] ** 2 / 2 - (rho ** 4 * ends[:, 0] ** 2 / 2 if rho else 0)

    def modes(self, r):
        kr = np.outer(self.k, r)
        if self.rho == 0:
            return j1(kr) / r
        return (y2(self.k)[:, None] * j1(kr) - j2(self.k)[:, None] * y1(kr)) / r

    def shift(self, alpha, trial, n_trial=14):
        r_e = 1 - alpha * (1 - self.rho)
        length = r_e - self.rho if trial == "stress" else 1 - r_e
        x, w = leggauss(int(1.3 * self.k[-1] * length / np.pi) + 60)
        v, w = (x + 1) / 2, w / 2  # distance from the front = length v^2
        r = r_e + (-length if trial == "stress" else length) * v ** 2
        root = 1 if trial == "stress" else v ** 2  # (1/v or v) times dr = 2 length v dv
        weighted = (w * 2 * length * root * r ** 3)[:, None] * chebvander(2 * v ** 2 - 1,
                                                                         n_trial - 1)
        b = weighted.sum(axis=0)
        moments = self.modes(r) @ weighted
        factor = 1 / (self.k * self.norm) if trial == "stress" else self.k / self.norm

        def kernel(n):
            return (moments[:n].T * factor[:n]) @ moments[:n]

        whole, half, quarter = (kernel(self.n // m) for m in (1, 2, 4))
        first, second = 2 * whole - half, 2 * half - quarter  # Richardson in 1/n and 1/n^2
        form = b @ np.linalg.solve((4 * first - second) / 3, b)
        m0 = (1 - self.rho ** 4) / 4
        return m0 / form if trial == "stress" else form / m0


def strip(rho, alpha):
    """2 z0 of a thin-walled tube."""
    return 4 * (1 - rho) / np.pi * np.log(1 / np.cos(np.pi * alpha / 2))


def torsion_factor(modes, alpha):
    """C_T by the stress road, and the relative distance of the opening road, the coarser one."""
    stress, opening = (modes.shift(alpha, trial) for trial in ("stress", "opening"))
    return 2 * stress / strip(modes.rho, alpha), opening / stress - 1


# --- tension ---------------------------------------------------------------------------------


def shape_functions(p, y):
    """Lagrange polynomials through the Gauss-Lobatto points, and their slopes, at y."""
    x = np.concatenate(([-1], np.sort(Legendre.basis(p).deriv().roots().real), [1]))
    modal = np.linalg.inv(legvander(x, p))
    slopes = np.stack([Legendre.basis(j).deriv()(y) + 0 * y for j in range(p + 1)], axis=1)
    return x, legvander(y, p) @ modal, slopes @ modal


def line_matrices(ends, p, **forms):
    """Nodes, and int weight(s) u^(i) v^(j) ds for each form = (weight, i, j)."""
    y, w = leggauss(p + 8)
    x, *values = shape_functions(p, y)
    n = p * (len(ends) - 1) + 1
    nodes, matrices = np.zeros(n), {name: sp.lil_matrix((n, n)) for name in forms}
    for e, (a, b) in enumerate(zip(ends[:-1], ends[1:])):
        h, dofs = (b - a) / 2, np.arange(e * p, e * p + p + 1)
        nodes[dofs] = a + h * (x + 1)
        for name, (weight, i, j) in forms.items():
            scaled = (w * h * weight(a + h * (y + 1)))[:, None]
            matrices[name][np.ix_(dofs, dofs)] += (
                (values[i] / h ** i * scaled).T @ (values[j] / h ** j))
    return nodes, {name: m.tocsr() for name, m in matrices.items()}


def graded(front, end, layers, largest, factor=0.15):
    ends = front + (end - front) * np.concatenate(([0], factor ** np.arange(layers - 1, -1, -1.0)))
    pieces = [np.linspace(a, b, int(np.ceil(abs(b - a) / largest)) + 1)[1:]
              for a, b in zip(ends[:-1], ends[1:])]
    return np.concatenate(([front], *pieces))


def one(s):
    return np.ones_like(s)


def solve(K, f, fixed):
    free = np.setdiff1d(np.arange(K.shape[0]), fixed)
    lu = splu(K[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
              options={"SymmetricMode": True})
    return f[free] @ lu.solve(f[free])


class CrackedShaft:
    """Quarter meridian 0 < z < 3, crack either outside r = front or (penny) inside it."""

    def __init__(self, rho, front, p=8, layers=7, crack="outside"):
        inner = graded(front, rho, layers, 0.25)[::-1]
        outer = graded(front, 1.0, layers, 0.25)[1:]
        ends = np.concatenate((inner, outer))
        self.rho, self.p = rho, p
        self.r, self.R = line_matrices(
            ends, p, S=(lambda r: r, 1, 1), M=(lambda r: r, 0, 0), I=(lambda r: 1 / r, 0, 0),
            D=(one, 1, 0), D0=(one, 0, 0), Dr=(lambda r: r, 1, 0),
            S3=(lambda r: r ** 3, 1, 1), M3=(lambda r: r ** 3, 0, 0))
        self.z, self.Z = line_matrices(graded(0, 3.0, layers + 2, 0.4), p, S=(one, 1, 1),
                                       M=(one, 0, 0), D=(one, 1, 0))
        self.index = np.arange(len(self.r) * len(self.z)).reshape(len(self.r), len(self.z))
        tip = p * (len(inner) - 1)
        outside = crack == "outside"
        self.cracked = slice(tip, None) if outside else slice(0, tip + 1)
        self.ligament = self.index[slice(0, tip + 1) if outside else slice(tip, None), 0]
        self.face_ends = np.concatenate((inner[-1:], outer)) if outside else inner

    def face_load(self, weight):
        """int weight(r) v dr over the crack face, as a nodal vector."""
        load = np.zeros(self.index.size)
        _, m = line_matrices(self.face_ends, self.p, L=(weight, 0, 0))
        load[self.index[self.cracked, 0]] = np.asarray(m["L"].sum(axis=1)).ravel()
        return load

    def opening_volume(self, nu, E=1.0):
        """int u_z dA over one crack face under unit stress on the faces."""
        mu, lame = E / (2 * (1 + nu)), E * nu / ((1 + nu) * (1 - 2 * nu))
        c, R, Z = lame + 2 * mu, self.R, self.Z
        uu = (c * sp.kron(R["S"] + R["I"], Z["M"]) + lame * sp.kron(R["D"] + R["D"].T, Z["M"])
              + mu * sp.kron(R["M"], Z["S"]))
        uw = lame * sp.kron(R["Dr"] + R["D0"], Z["D"].T) + mu * sp.kron(R["Dr"].T, Z["D"])
        ww = c * sp.kron(R["M"], Z["S"]) + mu * sp.kron(R["S"], Z["M"])
        n = self.index.size
        axis = self.index[0] if self.rho == 0 else []
        f = np.concatenate((np.zeros(n), self.face_load(lambda r: r)))
        K = sp.bmat([[uu, uw], [uw.T, ww]]).tocsr()
        return 2 * np.pi * solve(K, f, np.concatenate((axis, n + self.ligament)).astype(int))

    def torsion_shift(self):
        """z0 of the torsion problem (a lower bound), the check of the dual series."""
        R, Z = self.R, self.Z
        K = (sp.kron(R["S3"], Z["M"]) + sp.kron(R["M3"], Z["S"])).tocsr()
        m0 = (1 - self.rho ** 4) / 4
        return solve(K, self.face_load(lambda r: r ** 3), self.ligament) / m0


def finite_element_torsion_factor(rho, alpha):
    return 2 * CrackedShaft(rho, 1 - alpha * (1 - rho)).torsion_shift() / strip(rho, alpha)


def tension_factor(rho, alpha, nu, **mesh):
    a = alpha * (1 - rho)
    compliance = 2 * CrackedShaft(rho, 1 - a, **mesh).opening_volume(nu)  # times A^2/E
    return compliance / (2 * (1 - nu ** 2) * 1.1215 ** 2 * np.pi ** 2 * a ** 2)


# --- tables ----------------------------------------------------------------------------------


def torsion_table():
    table = Table("annular_hollow_torsion", "radius_ratio [1]", "depth_ratio [1]")

    def add(case, modes, alpha):
        value, gap = torsion_factor(modes, alpha)
        assert abs(gap) < 1e-4
        table.add(case, (repr(modes.rho), repr(alpha)), value, "1",
                  "annular_hollow.py dual series", 7, 9)

    for rho in (0.1, 0.3, 0.45, 0.55, 0.65, 0.75, 0.85, 0.95):
        modes = Torsion(rho)
        for alpha in (0.05, 0.15, 0.25, 0.35, 0.45, 0.55, 0.65, 0.75):
            add("C_T", modes, alpha)
    # The article's shaft, 70/45 mm, cracks of 0.1, 0.5, 1 and 2 mm; the first is too shallow for
    # the dual series.
    rho = 45 / 70
    table.add("article.C_T", (repr(rho), "0.008"), finite_element_torsion_factor(rho, 0.008), "1",
              "annular_hollow.py finite elements p = 8", 6, 8)
    modes = Torsion(rho, 2400)
    for alpha in (0.04, 0.08, 0.16):
        add("article.C_T", modes, alpha)
    return table


def tension_table():
    table = Table("annular_hollow_tension", "radius_ratio [1]", "depth_ratio [1]",
                  "poissons_ratio [1]")
    for rho in (0.2, 0.5, 0.7, 0.85):
        for alpha in (0.1, 0.2, 0.35, 0.5, 0.7):
            for nu in (0.25, 0.3, 0.35):
                table.add("C_P", (repr(rho), repr(alpha), repr(nu)),
                          tension_factor(rho, alpha, nu), "1",
                          "annular_hollow.py axisymmetric finite elements p = 8", 5, 8)
    for rho in (0.05, 0.25, 0.55, 0.75, 0.92):  # between the nodes of the library's table
        for alpha in (0.15, 0.45, 0.75):
            table.add("C_P", (repr(rho), repr(alpha), repr(0.3)),
                      tension_factor(rho, alpha, 0.3), "1",
                      "annular_hollow.py axisymmetric finite elements p = 8", 5, 8)
    return table


def library_tables():
    """The nodes that src/sif/shaft_annular.cpp interpolates, to its printed digits."""
    depths = (0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8)
    for rho in (0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 9 / 14, 0.7, 0.8, 0.9):
        modes = Torsion(rho)
        row = [finite_element_torsion_factor(rho, depths[0])]  # too shallow for the dual series
        row += [torsion_factor(modes, alpha)[0] for alpha in depths[1:]]
        print("C_T", rho, *(f"{value:.6f}" for value in row), flush=True)
    for rho in (0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 9 / 14, 0.7, 0.8, 0.85, 0.9, 0.95):
        row = [tension_factor(rho, alpha, 0.3) for alpha in depths]
        print("C_P", rho, *(f"{value:.5f}" for value in row), flush=True)


def check():
    a, nu = 0.02, 0.3
    volume = CrackedShaft(0.0, a, crack="inside").opening_volume(nu)
    print(f"penny in a thick cylinder: volume / exact - 1 = "
          f"{volume / (8 * (1 - nu ** 2) / 3 * a ** 3) - 1:.1e}")
    for rho, alpha in ((0.3, 0.25), (0.65, 0.05), (0.85, 0.75)):
        value, gap = torsion_factor(Torsion(rho), alpha)
        elements = finite_element_torsion_factor(rho, alpha)
        print(f"torsion {rho} {alpha}: C_T = {value:.8f}, opening road {gap:+.1e}, "
              f"finite elements {elements / value - 1:+.1e}")
    for rho, alpha in ((0.2, 0.1), (0.85, 0.7)):
        values = [tension_factor(rho, alpha, nu, p=p, layers=m)
                  for p, m in ((6, 6), (8, 7), (10, 7))]
        print(f"tension {rho} {alpha}:", *(f"{value:.7f}" for value in values))


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    elif "--library" in sys.argv[1:]:
        library_tables()
    else:
        publish(torsion_table(), tension_table())
