"""Radial edge crack in a ring, plane strain: stress intensity by finite elements.

Ring of mean radius r, wall t = 1, crack of depth a from the inner or the outer face; a pressure
inside (also on the faces of an inner crack), or a uniform hoop stress, or wall bending from given
forces.  Hoop stress and wall bending act as tractions on the faces of the crack, because these
release the same energy.
Half of the ring, eight-node elements, graded toward the tip down to 1e-3; G is the central
difference of the strain energy over a, each with its own mesh of the same kind.

Result: K/sqrt(pi a) per unit of load.  E = 1, nu = 0.3; K does not depend on them.
Independent of the library, which adds a beam to a strip.
"""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import spsolve

from reference_csv import Table, publish

NU = 0.3


def shape(xi, eta):
    """Values and derivatives of the eight-node element."""
    corner = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    N, dN = np.zeros(8), np.zeros((8, 2))
    for k, (p, q) in enumerate(corner):
        N[k] = (1 + p * xi) * (1 + q * eta) * (p * xi + q * eta - 1) / 4
        dN[k] = [p * (1 + q * eta) * (2 * p * xi + q * eta) / 4,
                 q * (1 + p * xi) * (2 * q * eta + p * xi) / 4]
    for k, (p, q) in enumerate([(0, -1), (1, 0), (0, 1), (-1, 0)], 4):
        if p == 0:
            N[k] = (1 - xi ** 2) * (1 + q * eta) / 2
            dN[k] = [-xi * (1 + q * eta), (1 - xi ** 2) * q / 2]
        else:
            N[k] = (1 + p * xi) * (1 - eta ** 2) / 2
            dN[k] = [p * (1 - eta ** 2) / 2, -eta * (1 + p * xi)]
    return N, dN


def grades(length, smallest, ratio=1.45, largest=np.inf):
    steps = [smallest]
    while sum(steps) < length:
        steps.append(min(steps[-1] * ratio, largest))
    edges = np.concatenate([[0], np.cumsum(steps)])
    return edges * length / edges[-1]


def energy(a, r, inner):
    """E times the compliance matrix of half of the ring over (tension, bending, pressure)."""
    tip = a if inner else 1 - a  # distance from the inner face
    below = tip - grades(tip, 1e-3)[::-1]
    above = tip + grades(1 - tip, 1e-3)[1:]
    radial = np.concatenate([below, above]) + r - 0.5
    angle = grades(np.pi * r, 1e-3, 1.45, 0.35) / r
    radial = np.sort(np.concatenate([radial, (radial[1:] + radial[:-1]) / 2]))
    angle = np.sort(np.concatenate([angle, (angle[1:] + angle[:-1]) / 2]))
    nr, na = len(radial), len(angle)
    number = np.arange(nr * na).reshape(nr, na)
    R, A = np.meshgrid(radial, angle, indexing="ij")
    xy = np.stack([(R * np.cos(A)).ravel(), (R * np.sin(A)).ravel()], 1)
    i, j = np.meshgrid(np.arange(0, nr - 1, 2), np.arange(0, na - 1, 2), indexing="ij")
    i, j = i.ravel(), j.ravel()
    nodes = np.stack([number[i, j], number[i + 2, j], number[i + 2, j + 2], number[i, j + 2],
                      number[i + 1, j], number[i + 2, j + 1], number[i + 1, j + 2],
                      number[i, j + 1]], 1)
    x = xy[nodes]
    D = np.array([[1 - NU, NU, 0], [NU, 1 - NU, 0], [0, 0, 0.5 - NU]]) / (1 + NU) / (1 - 2 * NU)
    K = np.zeros((len(nodes), 16, 16))
    g, gw = np.polynomial.legendre.leggauss(3)
    for p, wp in zip(g, gw):
        for q, wq in zip(g, gw):
            J = np.einsum("ekd,kc->ecd", x, shape(p, q)[1])
            d = np.einsum("ecd,kd->ekc", np.linalg.inv(J), shape(p, q)[1])
            B = np.zeros((len(nodes), 3, 16))
            B[:, 0, 0::2], B[:, 1, 1::2] = d[:, :, 0], d[:, :, 1]
            B[:, 2, 0::2], B[:, 2, 1::2] = d[:, :, 1], d[:, :, 0]
            K += wp * wq * np.linalg.det(J)[:, None, None] * np.einsum("eai,ab,ebj->eij", B, D, B)
    dof = np.stack([2 * nodes, 2 * nodes + 1], 2).reshape(len(nodes), 16)
    size = 2 * len(xy)
    K = coo_matrix((K.ravel(), (np.repeat(dof, 16, 1).ravel(), np.tile(dof, (1, 16)).ravel())),
                   (size, size)).tocsc()
    F = np.zeros((size, 3))
    depth = (radial - radial[0]) if inner else (radial[-1] - radial)
    on_crack = depth <= a + 1e-9
    for k in range(0, nr - 2, 2):  # the crack's face, theta = 0: traction -y on the body
        if not on_crack[k] or not on_crack[k + 2]:
            continue
        for p, wp in zip(g, gw):
            N = [p * (p - 1) / 2, 1 - p * p, p * (p + 1) / 2]
            x0 = np.dot(N, depth[k:k + 3])
            length = (radial[k + 2] - radial[k]) / 2
            rho = np.dot(N, radial[k:k + 3])
            i2, o2 = (r - 0.5) ** 2, (r + 0.5) ** 2
            lame = i2 / (o2 - i2) * (1 + o2 / rho ** 2) + (1 if inner else 0)
            for m in range(3):
                F[2 * number[k + m, 0] + 1] -= wp * length * N[m] * np.array([1, 1 - 2 * x0, lame])
    fixed = [2 * number[k, 0] + 1 for k in range(nr) if not on_crack[k] or abs(depth[k] - a) < 1e-9]
    fixed += [2 * number[k, na - 1] + 1 for k in range(nr)] + [2 * number[nr // 2, na - 1]]
    centres = number[1::2, 1::2].ravel()  # not nodes
    free = np.setdiff1d(np.arange(size), [*fixed, *(2 * centres), *(2 * centres + 1)])
    u = spsolve(K[free][:, free], F[free])
    return F[free].T @ u


def intensity(a, r, inner):
    """K/sqrt(pi a) of tension, bending, pressure."""
    h = 0.01
    G = (energy(a + h, r, inner) - energy(a - h, r, inner)) / (2 * h)  # of one half: (1/2) d/da
    K2 = G / (1 - NU ** 2)  # both halves: G = d(C_half)/da, K^2 = E' G
    return np.sqrt(np.diag(K2) / (np.pi * a))


def rows(cases):
    table = Table("cracked_ring", "radius_ratio [1]", "depth_ratio [1]", "inner_face [1]")
    for inner, r, a in cases:
        values = intensity(a, r, inner == 1)
        for name, value in zip(("tension", "bending", "pressure"), values):
            table.add(name, (r, a, inner), float(value), "1", "plane-strain finite elements",
                      digits=3, printed=6)
    return [table]


CASES = [(inner, r, a) for inner in (1, 0) for r in (5.0, 10.0, 20.0) for a in (0.2, 0.4, 0.6)]


def tables():
    return rows(CASES)


def some_tables():
    return rows(CASES[4::9])


if __name__ == "__main__":
    publish(*tables())
