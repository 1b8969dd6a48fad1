"""Circumferential through crack of finite angle in a long cylindrical shell (Sanders and Koiter).

Half-angle alpha, radius r = 1, wall t.  Sanders' and Koiter's linear shell, which is exact for the
bending and twisting of the tube as a beam, so that long cracks are covered; shell_crack.py, shallow,
is not.  Loads: axial force (sigma = 1 all round), bending moment (sigma = cos(theta), 1 at the
middle of the crack), torque (tau = 1).

Method: as in shell_crack.py, the jumps (opening, rotation; sliding, deflection) are eigenstrains on
the circle z = 0.  For each pair (n, eta) of wave numbers the strain energy that no displacement can
relieve is found by projection (QR of the strain matrix); integrated over eta it is the kernel of
the harmonic n.  Galerkin's method on |theta| < alpha with Chebyshev functions, sum over n with its
asymptotic tail.

Results over sigma sqrt(pi r alpha): membrane K_I and linear part (as in shell_crack.py) of axial
force (t, tb) and bending moment (b, bb); K_II and linear part of torque (s, sc).
"""
import sys

import numpy as np
from scipy.special import jv

from reference_csv import Table, publish
from shell_crack import graded, joined


def kernels(n, t, nu, nodes=10, panels=16):
    """Kernels of harmonic n over (V, Theta, U, W) times (1, d, 1, d), per Et; d^2 = t^2/(12(1-nu^2))."""
    m = max(n, 1)
    phi, w = joined(graded(0, np.pi / 4, panels, nodes, 0),
                    graded(np.pi / 4, np.pi / 2, 8, nodes, np.pi / 2))
    eta = m * np.tan(phi)
    w = w * m / np.cos(phi) ** 2 / np.pi  # both signs of eta
    one, zero, i = np.ones_like(eta), np.zeros_like(eta), 1j
    d = t / np.sqrt(12 * (1 - nu ** 2))

    def column(eps_z, eps_t, gamma, kz, kt, kzt2):
        """Strains to energy coordinates; bending strains carry d."""
        a, b = np.sqrt((1 + nu) / 2), np.sqrt((1 - nu) / 2)
        m_ = 1 / np.sqrt(1 - nu ** 2)
        k_ = 1.0
        plus, minus = (eps_z + eps_t) / np.sqrt(2), (eps_z - eps_t) / np.sqrt(2)
        kplus, kminus = (kz + kt) / np.sqrt(2), (kz - kt) / np.sqrt(2)
        shear = np.sqrt((1 - nu) / 2)
        return np.stack([m_ * a * np.sqrt(2) * plus, m_ * b * np.sqrt(2) * minus, m_ * shear * gamma,
                         k_ * a * np.sqrt(2) * kplus, k_ * b * np.sqrt(2) * kminus,
                         k_ * shear * kzt2], -1)

    o = zero
    u = column(i * eta, o, i * n * one, o, o, d * i * n / 2 * one)
    v = column(o, i * n * one, i * eta, o, -d * i * n * one, -d * 1.5 * i * eta)
    w_ = column(o, one, o, -d * eta ** 2, -d * n ** 2 * one, -2 * d * n * eta)
    # (1-nu^2)-scaled moments: bending energy D kappa^2 = Et d^2 kappa^2, kappa carries d
    B = np.stack([u, v, w_], -1)
    B = B / np.linalg.norm(B, axis=-2, keepdims=True)
    V = column(one, o, o, o, o, o)
    Theta = column(o, o, o, one, o, o)
    U = column(o, o, one, o, o, -1.5 * d * one)
    W = column(o, o, o, i * eta, o, 2 * i * n * one)
    J = np.stack([V, Theta, U, W], -1)
    Q = np.linalg.qr(B)[0]
    for _ in range(2):
        J = J - Q @ (np.conj(np.swapaxes(Q, -1, -2)) @ J)
    K = np.einsum("eki,ekj,e->ij", np.conj(J), J, w)
    # W is paired with U by i: rows and columns of W are made real as in shell_crack.py
    K[3, :] *= i
    K[:, 3] *= -i
    K[:2, 2:] = K[2:, :2] = 0  # odd in eta
    return K.real


def solve(alpha, t, nu=0.3, terms=10, exact_harmonics=400, harmonics=20000, energy=False, cache={}):
    """{t, tb, b, bb, s, sc}"""
    flat_b = (1 - nu) * (3 + nu) / 4
    key = (t, nu, exact_harmonics)
    if key not in cache:
        cache[key] = np.array([kernels(n, t, nu) for n in range(exact_harmonics)])
    K = cache[key]
    even, odd = np.arange(0, 2 * terms, 2), np.arange(1, 2 * terms, 2)
    n = np.arange(harmonics, dtype=float)
    x = n * alpha
    x[0] = 1e-9
    weight = np.where(n == 0, 0.5, 1.0) / np.pi
    smooth = np.array([alpha * np.pi * (k + 1) * (-1) ** (k // 2) * jv(k + 1, x) / x for k in even])
    deflection = np.array([alpha ** 2 * np.pi / 2 * (k + 1) * (k + 2) * (k + 3)
                           * (-1) ** ((k - 1) // 2) * jv(k + 2, x) / x ** 2 for k in odd])
    functions = [smooth, smooth, smooth, deflection]  # W scaled by alpha: -W' = alpha^0 (...)
    flat = [n / 4, flat_b * n, n / 4, flat_b * n ** 3]
    size = 4 * terms
    matrix = np.zeros((size, size))
    for i in range(4):
        for j in range(4):
            k = K[:, i, j]
            full = (weight[:exact_harmonics] * k * functions[i][:, :exact_harmonics]) \
                @ functions[j][:, :exact_harmonics].T
            if i == j:
                rest = slice(exact_harmonics, harmonics)
                full = full + (weight[rest] * flat[i][rest] * functions[i][:, rest]) \
                    @ functions[j][:, rest].T
                # tail: J J -> 1/(pi x) on average, all of one sign
                orders = even + 1 if i < 3 else (odd + 1) * (odd + 2) * (odd + 3) / 2
                stiffness = flat[i][1]
                full = full + stiffness * np.outer(orders, orders) / alpha / (harmonics - 0.5)
            matrix[i * terms:(i + 1) * terms, j * terms:(j + 1) * terms] = full
    load = np.zeros((size, 3))
    load[0, 0] = load[2 * terms, 2] = alpha * np.pi / 2
    load[:terms, 1] = smooth[:, 1]
    V, Theta, U, W = np.linalg.solve(matrix, load).reshape(4, terms, 3)
    tip_W = np.array([(k + 1) * (k + 2) * (k + 3) / 2 for k in odd])
    scale = flat_b * np.sqrt(3 / (1 - nu ** 2)) * np.sqrt((1 + nu) / (3 + nu)) / alpha
    result = {}
    for load_index, (membrane, linear) in enumerate((("t", "tb"), ("b", "bb"))):
        result[membrane] = (even + 1) @ V[:, load_index] / 4 / alpha
        result[linear] = scale * ((even + 1) @ Theta[:, load_index])
    result["s"] = (even + 1) @ U[:, 2] / 4 / alpha
    result["sc"] = scale * (tip_W @ W[:, 2])
    if energy:
        result["work"] = load.T @ np.linalg.solve(matrix, load) / 2
    return result


def zahoor(alpha, r_t):
    x = alpha / np.pi
    A = (0.125 * r_t - 0.25) ** 0.25 if r_t <= 10 else (0.4 * r_t - 3) ** 0.25
    return (1 + A * (5.3303 * x ** 1.5 + 18.773 * x ** 4.24),
            1 + A * (4.5967 * x ** 1.5 + 2.6422 * x ** 4.24))


def tables():
    table = Table("circumferential_crack", "half_angle [rad]", "radius_ratio [1]")
    for alpha, r_t in ((0.2, 8.0), (0.5, 15.0), (1.0, 30.0), (1.4, 50.0)):
        for name, value in solve(alpha, 1 / r_t).items():
            table.add(name, (alpha, r_t), float(value), "1", "Sanders-Koiter shell; Galerkin",
                      digits=5, printed=8)
    for x in (0.1, 0.2, 0.35, 0.5):
        for r_t in (10.0, 20.0):
            for name, value in zip(("zahoor_axial", "zahoor_bending"), zahoor(x * np.pi, r_t)):
                table.add(name, (float(x * np.pi), r_t), float(value), "1", "zahoor1985 (secondary)",
                          printed=17)
    return [table]


def check():
    import shell_crack
    for r_t in (5, 10, 20, 50):
        for x in (0.02, 0.05, 0.1, 0.2, 0.35, 0.5):
            alpha = x * np.pi
            r = solve(alpha, 1 / r_t)
            lam = (12 * (1 - 0.09)) ** 0.25 * alpha * r_t ** 0.5
            s = shell_crack.solve(lam, np.pi / 2)
            print(r_t, x, round(lam, 2), {k: round(float(v), 4) for k, v in r.items()}, "shallow",
                  {k: round(float(s[k]), 4) for k in ("nn", "bn", "tt", "ct")}, "zahoor",
                  np.round(zahoor(alpha, r_t), 3), flush=True)
    d = 1e-3 / np.sqrt(12 * 0.91)
    for n in (2, 3, 4):  # semi-membrane theory: n sqrt((n^2 - 1) d)/(2 sqrt(2)), next term n^2 d
        semi_membrane = n * np.sqrt((n ** 2 - 1) * d / 8)
        print("semi-membrane", n, kernels(n, 1e-3, 0.3)[0, 0] / semi_membrane - 1)
    for r_t in (10, 40):  # energy against its derivative
        for alpha in (0.4, 1.2):
            r, h = solve(alpha, 1 / r_t), 1e-3
            work = [solve(alpha + d, 1 / r_t, energy=True)["work"] for d in (h, -h)]
            slope = (work[0] - work[1]) / (2 * h) / (2 * np.pi * alpha)
            for k, (f, g) in enumerate((("t", "tb"), ("b", "bb"), ("s", "sc"))):
                print("energy", r_t, alpha, f, (r[f] ** 2 + r[g] ** 2 / 3) / slope[k, k] - 1)
            more = solve(alpha, 1 / r_t, terms=14, exact_harmonics=800)
            print("terms", max(abs(more[k] - r[k]) for k in r))


if __name__ == "__main__":
    check() if "--check" in sys.argv else publish(*tables())
