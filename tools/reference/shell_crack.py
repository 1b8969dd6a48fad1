"""Through crack in a cylindrical shell: stress intensity of shallow-shell theory.

Half-length a, angle beta from the generator, radius r, wall t; shell parameter
lambda = (12 (1 - nu^2))^(1/4) a/sqrt(r t).  Donnell's shallow shell with Kirchhoff bending, membrane
stress sigma normal to the crack or tau along it, far away, not changed by the curvature.

Method: the jumps across the crack line (opening, sliding, rotation, deflection) are eigenstrains
and eigencurvatures on that line.  In two-dimensional Fourier space the shell answers algebraically;
integrated over the wave number across the crack it leaves one symmetric 4 x 4 kernel of the wave
number along it.  Galerkin's method with sqrt(1 - x^2) U_n for opening, sliding and rotation, and
(1 - x^2)^(3/2) C_n^(2) for deflection: the flat part is diagonal, the rest decays fast.

Results, all divided by sqrt(pi a) times the stress:
  membrane stress intensity of modes I and II from sigma (nn, tn) and from tau (nt, tt), and the
  surface stress intensity of linear variation through the wall whose energy is that of Kirchhoff
  bending, sqrt((1+nu)/(3+nu)) times Kirchhoff's K_b (bn, bt: opening; cn, ct: sliding).
  G E/(pi a sigma^2) = nn^2 + tn^2 + (bn^2 + cn^2)/3.

Independent: the library holds an interpolated table of these; the tests compare it with rows at
other places.  Checks here (--check): 1 + 5 pi/64 lambda^2 and 1 + pi/64 lambda^2, energy against
its derivative, reciprocity, more terms, denser quadrature.
"""
import sys

import numpy as np
from scipy.special import jv

from reference_csv import Table, publish


def graded(a, b, panels, nodes, toward, ratio=0.5):
    """Gauss nodes and weights on [a, b], panels shrinking toward one end."""
    x, w = np.polynomial.legendre.leggauss(nodes)
    edges = (b - a) * ratio ** np.arange(panels, -1, -1.0)
    edges[0] = 0
    edges = a + edges if toward == a else b - edges[::-1]
    half = np.diff(edges) / 2
    return ((edges[:-1] + half)[:, None] + half[:, None] * x).ravel(), (half[:, None] * w).ravel()


def joined(*parts):
    return tuple(np.concatenate(column) for column in zip(*parts))


def kernel(xi, lam, beta, nu, nodes):
    """Kernel of the curvature over (V, U, Theta, W): the flat part is taken off.

    The entries with W are imaginary; they are returned divided by i (row) or -i (column).
    """
    c, s = np.cos(beta), np.sin(beta)
    zero = np.arctan2(-c, s) if s > 0 else -np.pi / 2  # where the axial wave number vanishes
    zero = -np.pi / 2 if abs(zero + np.pi / 2) < 1e-12 else zero
    panels, right = 30, np.pi / 2
    middle = (zero + right) / 2
    parts = [graded(zero, middle, panels, nodes, zero), graded(middle, right, panels, nodes, right)]
    if zero > -np.pi / 2:
        middle = (zero - np.pi / 2) / 2
        parts += [graded(-np.pi / 2, middle, panels, nodes, -np.pi / 2),
                  graded(middle, zero, panels, nodes, zero)]
    phi, w = joined(*parts)
    xi = xi[:, None]
    eta = xi * np.tan(phi)
    w = w * xi / np.cos(phi) ** 2 / (2 * np.pi)
    e, x = eta ** 2, xi ** 2
    k4 = (e + x) ** 2
    ell = lam ** 2 * (eta * s + xi * c) ** 2
    delta = k4 ** 2 + ell ** 2
    p, q = e + nu * x, eta * (e + (2 - nu) * x)
    S = [x, -xi * eta]
    B = [p, q]
    result = np.zeros((4, 4, xi.shape[0]))
    membrane = w * (-ell ** 2 / (k4 * delta))  # k4/delta - 1/k4
    bending = w * ell ** 2 / (k4 * delta)
    cross = w * ell / delta
    for i in range(2):
        for j in range(2):
            result[i, j] = (membrane * S[i] * S[j]).sum(1)
            result[2 + i, 2 + j] = (bending * B[i] * B[j]).sum(1)
            result[i, 2 + j] = (cross * S[i] * B[j]).sum(1)
            result[2 + j, i] = result[i, 2 + j]
    return result


def solve(lam, beta, nu=0.3, terms=8, nodes=12, energy=False):
    """{nn, tn, bn, cn, nt, tt, bt, ct}; with energy also the jumps' work a^-2 (sigma, tau)."""
    xi, w = joined(graded(0, 20.0, 40, 2 * nodes, 0), *[
        graded(a, a + 10.0, 1, 2 * nodes, a) for a in np.arange(20.0, 200.0, 10.0)])
    K = kernel(xi, lam, beta, nu, nodes)
    even, odd = np.arange(0, 2 * terms, 2), np.arange(1, 2 * terms, 2)
    # Fourier transforms without their factor (-i)^n; W carries i times (-i)^odd: real, with a sign
    smooth = [np.pi * (n + 1) * (-1) ** (n // 2) * jv(n + 1, xi) / xi for n in even]
    deflection = [np.pi / 2 * (n + 1) * (n + 2) * (n + 3) * (-1) ** ((n - 1) // 2)
                  * jv(n + 2, xi) / xi ** 2 for n in odd]
    # i W: K_VW = i k, W^ = (-i)^n ..., (-i)^n = -i (-1)^((n-1)/2): the product is + k ...
    functions = np.array([smooth, smooth, smooth, deflection])
    size = 4 * terms
    matrix = np.einsum("imx,ijx,jnx,x->imjn", functions, K, functions, w / np.pi,
                       optimize=True).reshape(size, size)
    flat_b = (1 - nu) * (3 + nu) / 4
    for m, n in enumerate(even):
        diagonal = np.pi * (n + 1) ** 2 / (2 * (n + 1))
        for block, stiffness in enumerate((0.25, 0.25, flat_b)):
            matrix[block * terms + m, block * terms + m] += stiffness * diagonal
    for m, n in enumerate(odd):  # |xi|^3 (J/xi^2)^2 = J^2/|xi|
        diagonal = np.pi / 4 * ((n + 1) * (n + 2) * (n + 3)) ** 2 / (2 * (n + 2))
        matrix[3 * terms + m, 3 * terms + m] += flat_b * diagonal
    load = np.zeros((size, 2))
    load[0, 0] = load[terms, 1] = np.pi / 2
    jumps = np.linalg.solve(matrix, load)
    V, U, Theta, W = jumps.reshape(4, terms, 2)
    tip_W = np.array([(n + 1) * (n + 2) * (n + 3) / 2 for n in odd])
    bend = flat_b * np.sqrt(3 / (1 - nu ** 2)) * np.sqrt((1 + nu) / (3 + nu))
    result = {}
    for load_index, name in enumerate("nt"):
        result["n" + name] = (even + 1) @ V[:, load_index] / 4
        result["t" + name] = (even + 1) @ U[:, load_index] / 4
        result["b" + name] = bend * ((even + 1) @ Theta[:, load_index])
        result["c" + name] = bend * (tip_W @ W[:, load_index])
    if energy:
        result["work"] = load.T @ jumps / 2
    return result


def release(result, name):
    return (result["n" + name] ** 2 + result["t" + name] ** 2
            + (result["b" + name] ** 2 + result["c" + name] ** 2) / 3)


def check():
    for degrees, kappa in ((0, 5 * np.pi / 64), (90, np.pi / 64)):
        for lam in (0.02, 0.1):
            print(degrees, lam, (solve(lam, np.radians(degrees))["nn"] - 1) / lam ** 2 / kappa)
    for degrees in (0, 45, 70, 90):
        for lam in (0.5, 2.0, 5.0):
            b = np.radians(degrees)
            r = solve(lam, b)
            h = 1e-3  # U = a^2 u(lambda), G = dU/d(2a)... two tips
            work = [((lam * f) ** 2 * solve(lam * f, b, energy=True)["work"]) for f in (1 + h, 1 - h)]
            slope = (work[0] - work[1]) / (2 * h) / lam ** 2 / (2 * np.pi)
            rel = [release(r, "n") / slope[0, 0] - 1, release(r, "t") / slope[1, 1] - 1]
            more = solve(lam, b, terms=12, nodes=16)
            print(degrees, lam, {k: round(float(v), 6) for k, v in r.items()}, "energy", rel,
                  "terms", max(abs(more[k] - r[k]) for k in r), "reciprocity",
                  work[0][0, 1] - work[0][1, 0])


def tables():
    table = Table("shell_crack", "shell_parameter [1]", "angle [rad]")
    for degrees in (0, 20, 50, 90):
        for lam in (0.3, 0.7, 1.5, 3.3, 6.5):
            beta = float(np.radians(degrees))
            for name, value in solve(lam, beta, terms=10).items():
                if abs(value) > 1e-12:
                    table.add(name, (lam, beta), float(value), "1", "shallow shell; Galerkin",
                              digits=5, printed=8)
    for lam, ratio in ((0.23, 1.0127), (0.455, 1.0582), (1.37, 1.507)):
        table.add("release_finite_elements", (lam, float(np.pi / 4)), ratio, "1",
                  "three-dimensional finite elements", digits=4, printed=5)
    return [table]


if __name__ == "__main__":
    check() if "--check" in sys.argv else publish(*tables())
