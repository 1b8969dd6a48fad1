"""Green's function of an edge crack in a strip: K of any stress on the faces, by integral equation.

Depth a, thickness t = 1, alpha = a/t; free edges, ends free to move and to rotate.  Edge
dislocations g(s) along the crack, of an infinite plane, their stress on the edges x = 0 and x = 1
taken off by Airy functions f(x) cos(p y) of the strip:

    (1/pi) int_0^a g(s) [1/(x - s) + k(x, s)] ds = -sigma(x),        K = sqrt(2 pi) lim g sqrt(a - s)
    k = 1/(x+s) - 6x/(x+s)^2 + 4x^2/(x+s)^3 (half-plane) + int_0^inf (f'' of the far edge) dp

With x = a (1 - u^2), s = a (1 - v^2), g = phi/v, phi = sum c_j P_2j(v), the Cauchy part is exact,
-2 Q_2j(u)/u; collocation in u, least squares.  The stress P_2j(v) gives the moments of the weight
function, whose Legendre coefficients they are.  Nothing is taken from a handbook; the half-plane is
held to the value 1.1215222552 of an exact solution (Koiter; secondary).
"""
import sys

import numpy as np
from numpy.polynomial import chebyshev, legendre

from reference_csv import Table, publish

LD = np.longdouble


def gauss(a, b, n):
    x, w = legendre.leggauss(n)
    return (a + b) / 2 + (b - a) / 2 * x, (b - a) / 2 * w


def graded(n, levels=40):
    """Nodes in (0, 1) crowded at 1, as 1 - v and weights."""
    edges = [0.0] + [2.0 ** -k for k in range(levels, -1, -1)]
    parts = [gauss(lo, hi, n) for lo, hi in zip(edges, edges[1:])]
    return np.concatenate([p[0] for p in parts]), np.concatenate([p[1] for p in parts])


def far_edge_kernel(x, s):
    """k of the strip less k of the half-plane, t = 1, on the grid (x, s)."""
    reach = 2 - x.max() - s.max()
    edges = [0.0, 0.5, 1.0] + list(np.geomspace(2, max(60, 45 / reach), 9))
    parts = [gauss(lo, hi, 16) for lo, hi in zip(edges, edges[1:])]
    p = np.concatenate([q[0] for q in parts]).astype(LD)[:, None]
    w = np.concatenate([q[1] for q in parts]).astype(LD)[:, None]
    s = s.astype(LD)[None, :]
    x = x.astype(LD)[None, :]
    e = np.exp(-p)
    es, er = np.exp(-p * s), np.exp(-p * (1 - s))
    A0 = -s / p * es
    B0 = es * (1 - 2 * p * s) / p ** 2
    r1 = (1 - s) / p * er - (A0 + B0 * p) * e                          # f(1)
    r2 = (1 - p * (1 - s)) * er / p ** 2 - (B0 - A0 - B0 * p) * e      # f'(1)/p
    # A = -(C + D p) e, B = A - (C - D + D p) e from the edge x = 0; coefficients of C and D
    Ac, Ad = -e, -p * e
    Bc, Bd = -2 * e, (1 - 2 * p) * e
    m11, m12 = (Ac + Bc * p) * e + 1, (Ad + Bd * p) * e
    m21, m22 = (Bc - Ac - Bc * p) * e + 1, (Bd - Ad - Bd * p) * e - 1
    det = m11 * m22 - m12 * m21
    C = (r1 * m22 - r2 * m12) / det
    D = (m11 * r2 - m21 * r1) / det
    A, B = Ac * C + Ad * D, Bc * C + Bd * D
    ex, ey = np.exp(-p * x), np.exp(-p * (1 - x))
    q = w * p ** 2
    terms = ((ex, A - 2 * B), (p * x * ex, B), (ey, C - 2 * D), (p * (1 - x) * ey, D))
    return sum((q * fx).T @ fs for fx, fs in terms).astype(float)


def legendre_Q(n, u):
    """Q_0 ... Q_n at 0 < u < 1."""
    Q = [np.arctanh(u), u * np.arctanh(u) - 1]
    for k in range(1, n):
        Q.append(((2 * k + 1) * u * Q[k] - k * Q[k - 1]) / (k + 1))
    return Q


def even_legendre(j, v):
    return legendre.legval(v, np.eye(2 * j + 1)[2 * j])


def intensities(alpha, loads, terms=36):
    """K/sqrt(pi a) of stresses, functions of (x/a, v = sqrt(1 - x/a)); alpha = 0: half-plane."""
    n = terms
    y, w = graded(10)  # 1 - v
    v = 1 - y
    s = y * (2 - y)  # 1 - v^2, in units of a
    yi = (1 - np.cos((np.arange(3 * n) + 0.5) * np.pi / (3 * n))) / 2
    u = 1 - yi
    x = yi * (2 - yi)
    X, S = x[:, None], s[None, :]
    k = 1 / (X + S) - 6 * X / (X + S) ** 2 + 4 * X ** 2 / (X + S) ** 3
    if alpha:
        k = k + alpha * far_edge_kernel(alpha * x, alpha * s)
    P = np.array([even_legendre(j, v) for j in range(n)])
    Q = legendre_Q(2 * n, u)
    cauchy = np.array([-2 * Q[2 * j] / u for j in range(n)]).T
    matrix = (cauchy + 2 * (k * w) @ P.T) / np.pi
    load = -np.array([f(x, u) for f in loads]).T
    weight = np.sqrt(u * np.sqrt(x))[:, None]
    c = np.linalg.lstsq(matrix * weight, load * weight, rcond=None)[0]
    at_tip = np.array([even_legendre(j, 0.0) for j in range(n)])
    return np.sqrt(2.0) * at_tip @ c


MOMENTS = [lambda x, v, j=j: even_legendre(j, v) for j in range(6)]
DEGREE = 10


def fit():
    """Chebyshev coefficients over 2 alpha - 1 of (1 - alpha)^1.5 times the moments, and the misfit."""
    nodes = 0.475 * (1 + np.cos(np.pi * (np.arange(25) + 0.5) / 25))
    alphas = np.concatenate([nodes, [0.96, 0.97, 0.98]])
    data = np.array([(1 - al) ** 1.5 * intensities(al, MOMENTS, 36 if al < 0.9 else 64)
                     for al in alphas])
    V = chebyshev.chebvander(2 * alphas - 1, DEGREE)
    c = np.linalg.lstsq(V, data, rcond=None)[0]
    return c.T, np.abs(V @ c - data).max(axis=0)


DEPTHS = (0.0, 0.05, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.95)


def tables():
    table = Table("weight_function", "depth_ratio [1]", "exponent [1]", "decay [1]")
    source = "weight_function.py (integral equation)"
    exact = ((0, 1.1215222552),)
    powers = [lambda x, v, n=n: x ** n for n in range(6)]
    decays = (1.0, 5.0, 10.0)
    exponentials = [lambda x, v, k=k: np.exp(-k * x) for k in decays]
    for alpha in DEPTHS:
        n = 40 if alpha < 0.9 else 60
        coarse = intensities(alpha, powers + exponentials, n - 8)
        fine = intensities(alpha, powers + exponentials, n)
        assert np.all(np.abs(fine / coarse - 1) < 3e-7), (alpha, fine / coarse - 1)
        for j, value in enumerate(fine):
            name = "power" if j < 6 else "exponential"
            inputs = (alpha, j, "") if j < 6 else (alpha, "", decays[j - 6])
            table.add(name, inputs, value, "1", source, digits=7, printed=9)
        if not alpha:
            assert all(abs(fine[j] / value - 1) < 1e-8 for j, value in exact)
    return [table]


if __name__ == "__main__":
    if "--fit" in sys.argv:
        coefficients, misfit = fit()
        for row in coefficients:
            print("    {" + ", ".join(f"{c:.9e}" for c in row) + "},")
        print("misfit", misfit)
    else:
        publish(*tables())
