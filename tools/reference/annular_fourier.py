"""Round bar, solid or hollow, with an annular crack: stress intensity by finite elements.

Lengths in units of the outer radius: inner radius rho, wall t = 1 - rho, crack depth a = alpha t
from the outer or from the inner surface, front at r_f.  Meridian mesh and line matrices are those
of annular_hollow.py; the displacement is one Fourier harmonic m of the angle,

    u_r = U(r, z) cos m theta,   u_theta = V(r, z) sin m theta,   u_z = W(r, z) cos m theta,

m = 0 for tension (V = 0), m = 1 for bending; torsion is the scalar problem of annular_hollow.py.
Load: stress on the crack face as the uncracked bar has it on that plane (Bueckner): 1, r cos theta,
and r of the shear.  The stress intensity comes from the opening of the faces at distances d from
the front, W/sqrt(d) = k0 + k1 d + k2 d^2 + ..., and, as a second road, from the derivative of the
energy (--check).  Reported:

    F_t = K_I/(sigma sqrt(pi a)),            sigma = P/A
    F_b = K_I/(sigma sqrt(pi a) cos theta),  sigma = M r_s/I  (r_s = 1 outer, r_f inner crack)
    F_s = K_III/(tau sqrt(pi a)),            tau = T r_s/I_p

and the energy integrals C = [E or mu] x added compliance x (A^2, I^2, I_p^2) of the same solution.

    annular_fourier.py --write      tests/data/annular_fourier.csv (some minutes)
    annular_fourier.py --library    the nodes of the library's tables (half an hour)
    annular_fourier.py --check      energy derivative, penny crack, mesh sequence
"""
import sys

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

from annular_hollow import CrackedShaft, graded, line_matrices, one
from reference_csv import Table, publish

NU = 0.3


class Bar(CrackedShaft):
    """Crack "outside" (from the outer surface) or "inside" (from the inner one; a penny, rho=0)."""

    def __init__(self, rho, alpha, crack, p=6, layers=6):
        self.a = alpha * (1 - rho)
        self.front = 1 - self.a if crack == "outside" else rho + self.a
        super().__init__(rho, self.front, p, layers, crack)
        length = min(3.0, 12 * np.sqrt(1 - rho))  # many decay lengths sqrt(r t) of a thin wall
        self.z, self.Z = line_matrices(graded(0, length, layers + 2, length / 7), p,
                                       S=(one, 1, 1), M=(one, 0, 0), D=(one, 1, 0))
        self.index = np.arange(len(self.r) * len(self.z)).reshape(len(self.r), len(self.z))
        tip = p * (len(graded(self.front, rho, layers, 0.25)) - 1)
        outside = crack == "outside"
        self.ligament = self.index[slice(0, tip + 1) if outside else slice(tip, None), 0]
        self.surface = 1.0 if crack == "outside" else self.front
        faces = self.index[self.cracked, 0]
        d = np.abs(self.r[self.cracked] - self.front)
        near = (d > 3e-4 * self.a) & (d < 0.25 * min(self.a, 0.3 * self.front))
        self.face, self.d = faces[near], d[near]

    def amplitude(self, w):
        """k0 of w = sqrt(d) (k0 + k1 d + ...)."""
        x = self.d / self.d.max()
        powers = np.vander(x, 5, increasing=True)
        return np.linalg.lstsq(powers, w / np.sqrt(self.d), rcond=None)[0][0]

    def normal(self, m):
        """(K_I, energy integral) under the face stress 1 (m = 0) or r cos theta (m = 1), E = 1."""
        mu, lame = 1 / (2 * (1 + NU)), NU / ((1 + NU) * (1 - 2 * NU))
        c, R, Z, k = lame + 2 * mu, self.R, self.Z, sp.kron
        n = self.index.size
        uu = (k(c * (R["S"] + R["I"]) + lame * (R["D"] + R["D"].T) + mu * m * m * R["I"], Z["M"])
              + mu * k(R["M"], Z["S"]))
        uw = lame * k(R["Dr"] + R["D0"], Z["D"].T) + mu * k(R["Dr"].T, Z["D"])
        ww = c * k(R["M"], Z["S"]) + mu * k(R["S"] + m * m * R["I"], Z["M"])
        load = self.face_load(lambda r: r ** (1 + m))
        if m == 0:
            K = sp.bmat([[uu, uw], [uw.T, ww]]).tocsr()
            f = np.concatenate((np.zeros(n), load))
            fixed = list(n + self.ligament) + (list(self.index[0]) if self.rho == 0 else [])
        else:
            uv = k((c + mu) * R["I"] + lame * R["D"] - mu * R["D"].T, Z["M"])
            vv = (k(c * R["I"] + mu * (R["S"] - R["D"] - R["D"].T + R["I"]), Z["M"])
                  + mu * k(R["M"], Z["S"]))
            vw = lame * k(R["D0"], Z["D"].T) - mu * k(R["D0"], Z["D"])
            # order W last; V = S - U, so that S = 0 on the axis is a plain boundary condition
            K = sp.bmat([[uu - uv - uv.T + vv, uv - vv, uw - vw],
                         [uv.T - vv, vv, vw],
                         [uw.T - vw.T, vw.T, ww]]).tocsr()
            f = np.concatenate((np.zeros(2 * n), load))
            fixed = list(2 * n + self.ligament) + [self.index[-1, -1]]  # no sideways motion
            if self.rho == 0:
                fixed += list(n + self.index[0]) + list(2 * n + self.index[0])
        free = np.setdiff1d(np.arange(K.shape[0]), np.array(fixed, dtype=int))
        lu = splu(K[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                  options={"SymmetricMode": True})
        x = np.zeros(K.shape[0])
        x[free] = lu.solve(f[free])
        w = x[-n:]
        K_I = self.amplitude(w[self.face]) * np.sqrt(2 * np.pi) / (4 * (1 - NU ** 2))
        angle = 2 * np.pi if m == 0 else np.pi
        return K_I, 2 * angle * (f @ x)  # both halves of the bar

    def torsion(self):
        """(K_III, energy integral) under the face stress r, mu = 1."""
        R, Z = self.R, self.Z
        K = (sp.kron(R["S3"], Z["M"]) + sp.kron(R["M3"], Z["S"])).tocsr()
        f = self.face_load(lambda r: r ** 3)
        free = np.setdiff1d(np.arange(K.shape[0]), self.ligament)
        lu = splu(K[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                  options={"SymmetricMode": True})
        x = np.zeros(K.shape[0])
        x[free] = lu.solve(f[free])
        r = self.front + (self.d if self.surface == 1.0 else -self.d)
        K_III = self.amplitude(r * x[self.face]) * np.sqrt(2 * np.pi) / 2
        return K_III, 2 * 2 * np.pi * (f @ x)

    def factor(self, load):
        """F of the docstring, and the energy integral."""
        K, energy = (self.torsion() if load == "torsion" else
                     self.normal(0 if load == "tension" else 1))
        stress = 1.0 if load == "tension" else self.surface
        return K / (stress * np.sqrt(np.pi * self.a)), energy


def by_energy(rho, alpha, crack, load, h=0.01, **mesh):
    """F from the derivative of the energy integral with respect to the depth."""
    h *= min(1.0, (1 - alpha) / alpha)  # small against the ligament, too
    up, down = (Bar(rho, alpha * (1 + s * h), crack, **mesh).factor(load)[1] for s in (1, -1))
    slope = (up - down) / (2 * h * alpha * (1 - rho))
    b = Bar(rho, alpha, crack, p=2, layers=1)
    if load == "torsion":
        K = np.sqrt(slope / (2 * np.pi * b.front))
    else:
        around = 2 * np.pi if load == "tension" else np.pi
        K = np.sqrt(slope / (2 * (1 - NU ** 2) * around * b.front))
    return K / ((1.0 if load == "tension" else b.surface) * np.sqrt(np.pi * b.a))


def check():
    for rho, alpha, crack in ((0.5, 0.3, "inside"), (0.0, 0.4, "outside"), (0.7, 0.6, "outside"),
                              (0.95, 0.6, "inside"), (0.1, 0.1, "inside"), (0.0, 0.3, "inside")):
        for load in ("tension", "bending", "torsion"):
            F, energy = Bar(rho, alpha, crack).factor(load)
            fine = Bar(rho, alpha, crack, p=9, layers=7).factor(load)
            other = by_energy(rho, alpha, crack, load)
            print(f"{crack} {load} {rho} {alpha}: F = {F:.6f}, finer mesh {fine[0] / F - 1:+.1e} "
                  f"(energy {fine[1] / energy - 1:+.1e}), energy derivative {other / F - 1:+.1e}",
                  flush=True)


class Strip:
    """Edge-cracked strip in plane strain, ends free: the limit of a thin wall."""

    def __init__(self, alpha, p=6, layers=6):
        inner, outer = graded(alpha, 0.0, layers, 0.25)[::-1], graded(alpha, 1.0, layers, 0.25)[1:]
        forms = {"S": (one, 1, 1), "M": (one, 0, 0), "D": (one, 1, 0)}
        x, X = line_matrices(np.concatenate((inner, outer)), p, **forms)
        z, Z = line_matrices(graded(0, 3.0, layers + 2, 0.4), p, **forms)
        mu, lame = 1 / (2 * (1 + NU)), NU / ((1 + NU) * (1 - 2 * NU))
        c, k = lame + 2 * mu, sp.kron
        uu = c * k(X["S"], Z["M"]) + mu * k(X["M"], Z["S"])
        ww = c * k(X["M"], Z["S"]) + mu * k(X["S"], Z["M"])
        uw = lame * k(X["D"], Z["D"].T) + mu * k(X["D"].T, Z["D"])
        index = np.arange(len(x) * len(z)).reshape(len(x), len(z))
        n, tip = index.size, p * (len(inner) - 1)
        f = np.zeros(2 * n)
        _, m = line_matrices(inner, p, L=(one, 0, 0))
        f[n + index[:tip + 1, 0]] = np.asarray(m["L"].sum(axis=1)).ravel()
        K = sp.bmat([[uu, uw], [uw.T, ww]]).tocsr()
        free = np.setdiff1d(np.arange(2 * n), np.append(n + index[tip:, 0], index[-1, -1]))
        lu = splu(K[free][:, free].tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                  options={"SymmetricMode": True})
        self.energy = 2 * (f[free] @ lu.solve(f[free]))


def strip_tension(alpha):
    """K_I/(sigma sqrt(pi a)) of the strip."""
    h = 0.01 * min(alpha, 1 - alpha)
    slope = (Strip(alpha + h).energy - Strip(alpha - h).energy) / (2 * h)
    return np.sqrt(slope / (2 * (1 - NU ** 2) * np.pi * alpha))


def table():
    """Points between the nodes of the library's tables."""
    result = Table("annular_fourier", "radius_ratio [1]", "depth_ratio [1]")
    source = "annular_fourier.py axisymmetric Fourier elements p = 6"

    def add(case, rho, alpha, value):
        result.add(case, (repr(rho), repr(alpha)), value, "1", source, 3, 7)
        print(case, rho, alpha, value, file=sys.stderr, flush=True)

    for rho in (0.15, 0.5, 0.75, 0.9, 0.97):
        for alpha in (0.15, 0.45, 0.74):
            add("outer.bending", rho, alpha, by_energy(rho, alpha, "outside", "bending"))
            for load in ("tension", "bending", "torsion"):
                add("inner." + load, rho, alpha, by_energy(rho, alpha, "inside", load))
    for alpha in (0.06, 0.33, 0.65, 0.9):
        add("solid.bending", 0.0, alpha, by_energy(0.0, alpha, "outside", "bending"))
    for x in (0.25, 0.5, 0.68, 0.85):
        for load in ("tension", "bending", "torsion"):
            add("penny." + load, 0.0, x, by_energy(0.0, x, "inside", load))
    for rho, alpha in ((0.5, 0.45), (0.9, 0.74)):  # added compliance x E or mu x I^2, A^2, I_p^2
        add("outer.bending.energy", rho, alpha, Bar(rho, alpha, "outside").factor("bending")[1])
        for load in ("tension", "bending", "torsion"):
            add("inner." + load + ".energy", rho, alpha,
                Bar(rho, alpha, "inside").factor(load)[1])
    add("solid.bending.energy", 0.0, 0.5, Bar(0.0, 0.5, "outside").factor("bending")[1])
    for load in ("tension", "bending", "torsion"):
        add("penny." + load + ".energy", 0.0, 0.6, Bar(0.0, 0.6, "inside").factor(load)[1])
    for alpha in (0.5, 0.8):
        add("strip.tension", 1.0, alpha, strip_tension(alpha))
    return result


LOBATTO_8 = (1 - np.cos(np.arange(9) * np.pi / 8)) / 2
LOBATTO_7 = (1 - np.cos(np.arange(8) * np.pi / 7)) / 2
LOBATTO_10 = (1 - np.cos(np.arange(11) * np.pi / 10)) / 2


def library_tables():
    """The nodes that src/sif/bar_tables.cpp interpolates; the strip is the row of a thin wall."""
    for alpha in 0.8 * LOBATTO_8[1:]:
        print("strip", alpha, strip_tension(alpha), flush=True)
    for crack, lowest, loads in (("outside", 0.0, ("bending",)),
                                 ("inside", 0.1, ("tension", "bending", "torsion"))):
        for q in np.sqrt(1 - lowest) * LOBATTO_7[1:]:
            for alpha in 0.8 * LOBATTO_8[1:]:
                for load in loads:
                    rho = max(1 - q * q, 0.0)
                    print(crack, load, rho, alpha, by_energy(rho, alpha, crack, load), flush=True)
    for x in 0.9 * LOBATTO_10[1:]:
        for load in ("tension", "bending", "torsion"):
            print("penny", load, x, by_energy(0.0, x, "inside", load), flush=True)


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    elif "--library" in sys.argv[1:]:
        library_tables()
    else:
        publish(table())
