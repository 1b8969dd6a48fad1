"""Straight edge crack at an angle to the edge of a half-plane, under tension along the edge.

Half-plane Im z > 0, edge Im z = 0 free, crack z = s exp(i w), 0 < s < a, stress 1 along the edge.
Dislocations along the crack with Muskhelishvili's potentials Phi0 = A/(z - z0),
Psi0 = conj(A)/(z - z0) + A conj(z0)/(z - z0)^2; the free edge adds

    Phi1 = -[Phi0* + z Phi0*' + Psi0*],  Psi1 = -Phi0* - Phi1 - z Phi1',  f*(z) = conj(f(conj z)).

Normal and shear stress on the crack vanish: two Cauchy equations.  With s = 1 - t^2 the root at the
tip becomes an even function of t over (-1, 1).  The integrals use Gauss-Legendre points, and the
equations hold at the zeros of the Legendre function of the second kind.  The density is finite at the mouth.

Reported: K_I and the magnitude of K_II over sqrt(pi a), against the angle from the normal of the
edge; extrapolated from 30 and 60 points.  Digits: 1.121522 of the normal crack, other pairs of n.
"""
from functools import cache

import numpy as np
from numpy.polynomial.legendre import leggauss
from scipy.special import eval_legendre

from reference_csv import Table, publish

SOURCE = "dislocations along the crack; singular integral equation"


@cache
def second_kind_zeros(n):
    """Positive zeros of Q_n, n even, one between neighbouring zeros of P_n and one beyond."""
    nodes, weights = leggauss(n)

    def f(x):  # Q_n = (P_n/2) ln((1 + x)/(1 - x)) - W, W by the quadrature of its kernel
        return eval_legendre(n, x) * (np.log((1 + x) / (1 - x)) - (weights / (x - nodes)).sum())

    positive = np.append(nodes[nodes > 0], 1 - 1e-14)
    out = []
    for lo, hi in zip(positive[:-1], positive[1:]):
        lo, hi = lo + 1e-13, hi - (1e-13 if hi < 0.9999999 else 0)
        flo = f(lo)
        for _ in range(60):
            mid = (lo + hi) / 2
            if (f(mid) > 0) == (flo > 0):
                lo = mid
            else:
                hi = mid
        out.append((lo + hi) / 2)
    return np.array(out)


def stress(z, z0, A, w):
    """N + i T on the direction w at z of a dislocation A at z0, its own Cauchy part left out."""
    c = np.conj
    # starred functions of the dislocation: poles at conj(z0)
    d = z - c(z0)
    phi_s, dphi_s, ddphi_s = c(A) / d, -c(A) / d ** 2, 2 * c(A) / d ** 3
    psi_s = A / d + c(A) * z0 / d ** 2
    dpsi_s = -A / d ** 2 - 2 * c(A) * z0 / d ** 3
    phi1 = -(phi_s + z * dphi_s + psi_s)
    dphi1 = -(2 * dphi_s + z * ddphi_s + dpsi_s)
    psi1 = -phi_s - phi1 - z * dphi1
    return phi1 + c(phi1) + np.exp(2j * w) * (c(z) * dphi1 + psi1)


def factors(degrees, n=60):
    """(F_I, F_II), the crack at `degrees` from the normal of the edge."""
    w = np.pi / 2 - np.radians(degrees)
    e = np.exp(1j * w)
    nodes, weights = leggauss(2 * n)
    t, dt = nodes[n:], weights[n:]
    tc = second_kind_zeros(2 * n)
    s0, s = 1 - t ** 2, 1 - tc ** 2
    # density p + i q = B(s0)/sqrt(1 - s0), A = exp(i w) conj(B); ds0/sqrt = 2 dt
    M = np.zeros((2 * n, 2 * n))
    for k, unit in enumerate((1.0, 1j)):
        A = e * np.conj(unit)
        field = stress(s[:, None] * e, s0[None] * e, A, w) * 2 * dt
        field += 2 * unit / (s[:, None] - s0[None]) * 2 * dt
        M[:n, k * n:(k + 1) * n], M[n:, k * n:(k + 1) * n] = field.real, field.imag
    # sigma_xx = 1: N + i T of the direction w
    N, T = np.sin(w) ** 2, -np.sin(w) * np.cos(w)
    B = np.linalg.solve(M, -np.concatenate([np.full(n, N), np.full(n, T)]))
    # value at the tip, t = 0, of the even interpolation
    full = lambda v: np.concatenate([v[::-1], v])
    bary = (-1.0) ** np.arange(2 * n) * np.sqrt((1 - nodes ** 2) * weights)
    at_tip = lambda v: (bary / nodes * full(v)).sum() / (bary / nodes).sum()
    return -2 * np.pi * np.sqrt(2) * np.array([at_tip(B[:n]), at_tip(B[n:])])


def extrapolated(degrees):
    """The error falls with the square of n."""
    few, many = factors(degrees, 30), factors(degrees, 60)
    return many + (many - few) / 3


def tables():
    table = Table("inclined_edge_crack", "angle [rad]")
    assert abs(extrapolated(0)[0] + 1.121522) < 2e-5
    for degrees in range(0, 66, 5):
        K_I, K_II = -extrapolated(degrees)
        angle = np.pi * degrees / 180
        table.add("F_I", (angle,), K_I, "1", SOURCE, digits=4, printed=7)
        if degrees:
            table.add("F_II", (angle,), abs(K_II), "1", SOURCE, digits=4, printed=7)
    return [table]


if __name__ == "__main__":
    publish(*tables())
