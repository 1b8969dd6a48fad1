"""Cracks in stress gradients: reference values for the tests of the family `gradient`.

Every number has its own independent method:
  front      K along the front of a penny crack of radius a under the pressure |y/a|^n, or an
             exponential, over K of the pressure 1: Fourier series and Abel integrals, exact
             (Sneddon); y = a sin(phi)
  stress     below a line contact: integrals of Flamant's point force over Hertz's traction
  contact    K_I, K_II of an edge crack in a half-plane under that stress: integral equation of
             weight_function.py, no weight function
  residual   K of (1 + h x/d) exp(-x/d), freed of force and moment by least squares, in a strip
  hole       K/(sigma sqrt(pi a)) of two cracks at an elliptical hole under tension: edge dislocations
             next to the hole, their stress on its rim taken off by Muskhelishvili's potentials.
             For a circle Newman's (1971; secondary) 1.0409 and 1.0582 of K/(sigma sqrt(pi (a + r)))
"""
import numpy as np
from scipy.integrate import quad
from scipy.special import gammaln

from reference_csv import Table, publish
from weight_function import LD, even_legendre, gauss, graded, intensities, legendre_Q


def penny_ratio(n, phi):
    def abel(p):  # int_0^1 r^p/sqrt(1 - r^2) dr
        return np.sqrt(np.pi) / 2 * np.exp(gammaln((p + 1) / 2) - gammaln(p / 2 + 1))
    theta = (np.arange(20000) + 0.5) * np.pi / 20000
    profile = np.sin(theta) ** n
    return sum((2 if k else 1) * np.mean(profile * np.cos(k * theta)) * np.cos(k * phi)
               * abel(1 + n + k) for k in range(0, 2000, 2))


def penny_exponential(decay, hump, phi):
    """The same quantity under the stress (1 + hump decay |y|) exp(-decay |y|), from harmonics of the pressure
    at each r."""
    count = 2000
    theta = np.arange(2 * count) * np.pi / count
    k = np.arange(0, count, 2)
    total = 0.0
    for t, w in zip(*gauss(0, np.pi / 2, 80)):
        r = np.sin(t)
        y = decay * np.abs(r * np.sin(theta))
        c = np.fft.rfft((1 + hump * y) * np.exp(-y)).real[:count:2] / (2 * count)
        total += w * r * np.sum(np.where(k, 2, 1) * c * r ** k * np.cos(k * phi))
    return total


def flamant(traction, x, z):
    """sigma_x, sigma_z, tau_xz below p (into the body) or q (toward +x) = sqrt(1 - xi^2), b = 1."""
    def component(i):
        def f(theta):
            r_x = x - np.sin(theta)
            r2 = r_x * r_x + z * z
            radial = -2 * (z if traction == "pressure" else r_x) / (np.pi * r2)
            return np.cos(theta) ** 2 * radial * (r_x * r_x, z * z, r_x * z)[i] / r2
        middle = np.arcsin(np.clip(x, -1, 1))
        edges = sorted({-np.pi / 2, np.pi / 2, middle}
                       | {t for d in np.geomspace(z, 1, 6) for t in (middle - d, middle + d)
                          if abs(t) < np.pi / 2})
        return sum(quad(f, lo, hi, epsabs=1e-13, epsrel=1e-11, limit=200)[0]
                   for lo, hi in zip(edges, edges[1:]))
    return [component(i) for i in range(3)]


def contact(traction, position, depth):
    """K_I and K_II over sqrt(pi a), b = 1."""
    seen = {}

    def load(i):
        def f(x, v):
            out = []
            for y in x:
                if y not in seen:
                    seen[y] = flamant(traction, position, depth * y)
                out.append(seen[y][i])
            return np.array(out)
        return f
    return intensities(0, [load(0), load(2)], 20)


def residual(alpha, decay, hump):
    """K/sqrt(pi a), t = 1."""
    x, w = (np.concatenate(p) for p in zip(*(gauss(lo, hi, 40) for lo, hi in
                                             zip((0, 0.1, 0.4), (0.1, 0.4, 1)))))
    def g(x):
        return (1 + hump * x / decay) * np.exp(-x / decay)
    basis = np.array([np.ones_like(x), x])
    c = np.linalg.solve((basis * w) @ basis.T, (basis * w) @ g(x))
    scale = 1 - c[0]
    return intensities(alpha, [lambda s, v: (g(alpha * s) - c[0] - c[1] * alpha * s) / scale])[0]


class Hole:
    """Ellipse of half length D along the cracks and radius 1 at its ends; z = R (q + m/q)."""

    def __init__(self, D):
        D = LD(D)
        b = np.sqrt(D)
        self.D, self.R, self.m = D, (D + b) / 2, (D - b) / (D + b)

    def inverse(self, x):
        return (x + np.sign(x) * np.sqrt(x * x - 4 * self.R ** 2 * self.m)) / (2 * self.R)

    def stress(self, x, q, f1, f2, P1):
        """sigma_y on the axis of phi(q), f1 = phi', f2 = phi'', and psi = -P(1/q) - w(1/q) phi'/w'."""
        R, m = self.R, self.m
        w, w1, w2 = R * (1 / q + m * q), R * (1 - m / q ** 2), 2 * R * m / q ** 3
        dw = -R * (1 - m * q ** 2) / q ** 2  # d w(1/q)/dq
        psi1 = P1 / q ** 2 - (dw / w1 * f1 - w * w2 / w1 ** 2 * f1 + w / w1 * f2)
        return 2 * f1 / w1 + x * (f2 / w1 - f1 * w2 / w1 ** 2) / w1 + psi1 / w1

    def tension(self, x):
        A = -self.R * (1 + self.m) / 2
        q = self.inverse(x)
        return 1 + self.stress(x, q, -A / q ** 2, 2 * A / q ** 3, -A)

    def dislocation(self, x, s):
        """sigma_y at x of a dislocation at s, less 1/(x - s)."""
        q, s0 = self.inverse(x), self.inverse(s)
        s1 = self.m / s0
        c = (1 / s0 - s0) * (1 / s0 - s1) / (s1 - s0)
        f1 = -0.5 * (s1 / (q * (q - s1)) + 1 / (q * (s0 * q - 1)) - c / (q - 1 / s0) ** 2)
        f2 = 0.5 * ((2 * q - s1) * s1 / (q * (q - s1)) ** 2
                    + (2 * s0 * q - 1) / (q * (s0 * q - 1)) ** 2 - 2 * c / (q - 1 / s0) ** 3)
        y = 1 / q
        # (N(y)/D(y) - c/(y - 1/s0)) with its removable pole at x = s removed, then d/dy.
        p = 1 / s0
        n = y * (1 - s1 * p) + p - s0 - s1 + s1 * self.m
        rest = -((1 - s1 * p) * (1 - s1 * y) + s1 * n) / (s0 * (1 - s1 * y) ** 2 * (1 - s1 * p))
        P1 = 0.5 * (1 / (y - s0) - s1 / (1 - s1 * y) + rest)
        return self.stress(x, q, f1, f2, P1)

    def cracks(self, a, n=24):
        """K/(sigma sqrt(pi a)) of two cracks of depth a."""
        y, w = graded(10, 24)
        v, s = 1 - y, y * (2 - y)
        yi = (1 - np.cos((np.arange(3 * n) + 0.5) * np.pi / (3 * n))) / 2
        u, x = 1 - yi, yi * (2 - yi)
        X = self.D + LD(a) * x[:, None]
        S = self.D + LD(a) * s[None, :]
        k = a * (self.dislocation(X, S) + self.dislocation(-X, S) - 1 / (X + S)).astype(float)
        P = np.array([even_legendre(j, v) for j in range(n)])
        Q = legendre_Q(2 * n, u)
        cauchy = np.array([-2 * Q[2 * j] / u for j in range(n)]).T
        weight = np.sqrt(u * np.sqrt(x))
        c = np.linalg.lstsq((cauchy + 2 * (k * w) @ P.T) / np.pi * weight[:, None],
                            -self.tension(X[:, 0]).astype(float) * weight, rcond=None)[0]
        return np.sqrt(2) * np.array([even_legendre(j, 0.0) for j in range(n)]) @ c


def tables():
    table = Table("gradient", "a [1]", "b [1]", "c [1]")
    for n in (1, 2, 3, 4):
        for degrees in (0, 15, 30, 45, 60, 90):
            table.add("front", (n, np.radians(degrees), ""), penny_ratio(n, np.radians(degrees)),
                      "1", "gradient.py (exact series)", digits=5, printed=8)
    for decay, hump in ((1, 0), (2, 0), (4, 0), (4, 1.5)):
        for degrees in (0, 10, 20, 45, 70, 90):
            table.add("front_exponential", (decay, np.radians(degrees), hump),
                      penny_exponential(decay, hump, np.radians(degrees)), "1",
                      "gradient.py (exact series)", digits=5, printed=8)
    for x, z in ((0, 0.3), (0.5, 0.5), (-0.7, 0.2), (1.6, 0.4), (2.5, 3), (-1.3, 1)):
        for traction in ("pressure", "traction"):
            for name, value in zip(("along", "normal", "shear"), flamant(traction, x, z)):
                if abs(value) > 1e-12:  # 0 by symmetry
                    table.add(f"{traction}_{name}", (x, z, ""), value, "1",
                              "gradient.py (Flamant)", digits=9, printed=12)
    for x, a in ((1.3, 0.5), (-0.6, 1.0), (-1.5, 4.0)):
        for traction in ("pressure", "traction"):
            for mode, value in zip(("I", "II"), contact(traction, x, a)):
                table.add(f"contact_{traction}_{mode}", (x, a, ""), value, "1",
                          "gradient.py (integral equation)", digits=5, printed=8)
    for alpha, decay, hump in ((0.02, 0.03, 0), (0.1, 0.03, 1.5), (0.3, 0.05, 2), (0.5, 0.1, 1)):
        table.add("residual", (alpha, decay, hump), residual(alpha, decay, hump), "1",
                  "gradient.py (integral equation)", digits=5, printed=8)
    for depth, expected in ((1.0, 1.0409), (0.5, 1.0582)):
        F = Hole(1 + 1e-9).cracks(depth) * np.sqrt(depth / (1 + depth))
        assert abs(F - expected) < 1e-4, F
    for D in (1 + 1e-9, 4, 25, 100):
        for a in (0.03, 0.1, 0.3, 1, 3, 10, 100):
            if a / D < 1e-3:
                continue
            n = 24 if a < 10 else 56
            F, coarse = Hole(D).cracks(a, n), Hole(D).cracks(a, n - 6)
            assert abs(F / coarse - 1) < 2e-5, (D, a, F, coarse)
            table.add("hole", (a, round(D), ""), F, "1", "gradient.py (integral equation)",
                      digits=5, printed=8)
    return [table]


if __name__ == "__main__":
    publish(*tables())
