"""Quarter of an elliptical crack in a block: K_I along the front by finite elements.

Upper half z >= 0 of a block 0 <= x <= b, 0 <= y <= t, crack (x/c)^2 + (y/a)^2 < 1 in z = 0,
tractions on z = H.  One mesh serves three cracks, which differ in their mirrors:

    embedded   mirrors x = 0 and y = 0     (ellipse in the middle of a plate of thickness 2 t)
    surface    mirror x = 0                (y = 0 is the cracked surface)
    corner     none

Loads: tension 1; bending 1 - 2 y/t (surface and corner).  Isoparametric hexahedra of degree 2 or
3, graded geometrically to the front in its plane and away from the plane; the angle theta of the
mesh is the parametric one.  Energy release rate along the front from the domain form of the
J-integral with virtual advances that are linear in theta, projected; K = sqrt(G E/(1 - nu^2)),
nu = 0.3.  Where the front meets a free face no K exists; the values there are those of the
projection.

Reported: F = K/(sigma sqrt(pi a)), a the semi-axis along y.

    cracked_block.py --check     penny in a large block against 2/pi, finer meshes, width
    cracked_block.py --write     tests/data/cracked_block.csv (ten minutes)
"""
import sys

import numpy as np
import scipy.sparse as sp
from numpy.polynomial.legendre import leggauss
from scipy.sparse.linalg import splu

from reference_csv import Table, publish

NU = 0.3
E = 1.0


def lagrange(p, x):
    """Values and slopes (points, p + 1) of the Lagrange polynomials at p + 1 equal steps."""
    nodes = np.linspace(-1, 1, p + 1)
    coeff = np.linalg.inv(np.vander(nodes, increasing=True))
    N = np.vander(x, p + 1, increasing=True) @ coeff
    dN = (np.vander(x, p, increasing=True) * np.arange(1, p + 1)) @ coeff[1:]
    return N, dN


def refine(lines, p):
    lines = np.asarray(lines, float)
    inner = lines[:-1, None] + np.arange(p) / p * np.diff(lines)[:, None]
    return np.append(inner.ravel(), lines[-1])


def geometric(length, first, ratio, layers, growth=2.0):
    """0 ... length: smallest steps at 0."""
    steps = [0.0] + [first * ratio ** k for k in range(layers, -1, -1)]
    size = first
    while steps[-1] < length * (1 - 1e-9):
        rest = length - steps[-1]
        size *= growth
        steps.append(length if rest < 1.4 * size else steps[-1] + size)
    return np.array(steps)


def dissect(boxes):
    """Order of the nodes of a tensor grid by nested dissection; boxes = index ranges of nodes."""
    order = []

    def visit(ranges):
        spans = [hi - lo for lo, hi, _ in ranges]
        best = max(range(3), key=lambda k: spans[k] // ranges[k][2])
        lo, hi, p = ranges[best]
        if spans[best] <= 2 * p:
            order.append(np.stack(np.meshgrid(*[np.arange(a, b) for a, b, _ in ranges],
                                              indexing="ij"), -1).reshape(-1, 3))
            return
        cut = (lo + hi) // 2 // p * p
        if cut <= lo:
            cut += p
        for part in ((lo, cut, p), (cut + 1, hi, p), (cut, cut + 1, p)):
            if part[0] < part[1]:
                new = list(ranges)
                new[best] = part
                if part[1] - part[0] == 1 and part[0] == cut:
                    order.append(np.stack(np.meshgrid(*[np.arange(a, b) for a, b, _ in new],
                                                      indexing="ij"), -1).reshape(-1, 3))
                else:
                    visit(new)
    visit(boxes)
    return np.concatenate(order)


def block(kind, a, c, t, b, H, loads, p=2, sectors=8, layers=2, ratio=0.2):
    """(theta of the front nodes, {load: K})"""
    # radial lines: s in [0, 1] inside, [1, 2] outside
    inside = 1 - geometric(1.0, 0.3, ratio, layers)[::-1]
    outside = 1 + geometric(1.0, min(0.3, 0.6 * min(a / (t - a), c / (b - c), 1)), ratio, layers)
    radial = np.concatenate([inside, outside[1:]])
    vertical = geometric(H, 0.3 * min(a, c), ratio, layers)
    corner = np.arctan2(t - 0.3 * a, b - 0.3 * c) if b > c else 0
    # the sector boundary at which the outer end turns round the corner of the block
    lines = np.linspace(0, np.pi / 2, sectors + 1)
    turn = int(np.clip(np.round(corner / (np.pi / 2) * sectors), 1, sectors - 1))
    turn_at = lines[turn]
    th, s, z = refine(lines, p), refine(radial, p), refine(vertical, p)
    n = len(th), len(s), len(z)
    front = int(np.argmin(np.abs(s - 1)))
    T, S = np.meshgrid(th, s, indexing="ij")
    ellipse = np.stack([c * np.cos(T), a * np.sin(T)], -1)
    # the outer ends of all radial lines except the last lie opposite the front
    low = np.minimum(T / turn_at, 1) ** 2 * (t - a * np.sin(turn_at)) + a * np.sin(T)
    high = (np.clip((np.pi / 2 - T) / (np.pi / 2 - turn_at), 0, 1) ** 2 *
            (b - c * np.cos(turn_at)) + c * np.cos(T))
    wall = np.where((T <= turn_at + 1e-12)[..., None],
                    np.stack([np.full_like(T, b), low], -1),
                    np.stack([high, np.full_like(T, t)], -1))
    inner = np.minimum(S, 1)[..., None]
    outer = np.maximum(S - 1, 0)[..., None]
    plane = ellipse * inner * (1 - outer) + wall * outer
    xyz = np.concatenate([np.broadcast_to(plane[:, :, None], (*n, 2)),
                          np.broadcast_to(z[None, None, :, None], (*n, 1))], -1)

    number = np.arange(n[0] * n[1] * n[2]).reshape(n)
    number[:, 0, :] = number[:1, 0, :]  # the axis of the collapsed sectors
    cells = [(k - 1) // p for k in n]
    grid = np.stack(np.meshgrid(*[np.arange(k) * p for k in cells], indexing="ij"),
                    -1).reshape(-1, 3)
    local = np.stack(np.meshgrid(*[np.arange(p + 1)] * 3, indexing="ij"), -1).reshape(-1, 3)
    ijk = grid[:, None] + local
    nodes = number[ijk[..., 0], ijk[..., 1], ijk[..., 2]]
    X = xyz[ijk[..., 0], ijk[..., 1], ijk[..., 2]]  # (cells, nodes, 3)

    g, w = leggauss(p + 1)
    N1, D1 = lagrange(p, g)
    shape3 = [np.einsum("ai,bj,ck->abcijk", *[D1 if k == d else N1 for k in range(3)]).reshape(
        (p + 1) ** 3, -1) for d in range(3)]
    D = np.stack(shape3, 1)  # (points, 3, nodes)
    W3 = np.einsum("a,b,c->abc", w, w, w).ravel()
    jac = np.einsum("gdn,eni->egdi", D, X)
    det = np.linalg.det(jac)
    assert (det > 0).all() or (det < 0).all()
    weight = np.abs(det) * W3
    grad = np.einsum("egid,gdn->egin", np.linalg.inv(jac), D)

    lam, mu = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU))
    count, m = len(X), (p + 1) ** 3
    Ke = np.empty((count, m, 3, m, 3))
    for e in range(count):
        G, we = grad[e], weight[e]
        Q = (G.transpose(1, 2, 0)[:, :, :] * we).reshape(3, -1)  # (i, n g)
        left = Q.reshape(3, m, -1)
        right = G.transpose(1, 2, 0)
        A = np.einsum("ing,jmg->injm", left, right, optimize=True)
        trace = sum(A[i, :, i, :] for i in range(3))
        for i in range(3):
            for j in range(3):
                Ke[e, :, i, :, j] = lam * A[i, :, j, :] + mu * A[j, :, i, :]
            Ke[e, :, i, :, i] += mu * trace
    dof = (nodes[..., None] * 3 + np.arange(3)).reshape(count, -1)
    size = number.size * 3
    rows = np.repeat(dof, m * 3, axis=1).ravel()
    cols = np.tile(dof, (1, m * 3)).ravel()
    K = sp.csr_matrix((Ke.ravel(), (rows, cols)), (size, size))
    del Ke, rows, cols

    fixed = np.zeros((number.size, 3), bool)
    fixed[number[:, front:, 0].ravel(), 2] = True
    if kind in ("embedded", "surface"):
        fixed[number[-1].ravel(), 0] = True
        fixed[number[:, 0].ravel(), 0] = True
    else:
        fixed[number[0, -1, 0], 0] = True
    if kind == "embedded":
        fixed[number[0].ravel(), 1] = True
        fixed[number[:, 0].ravel(), 1] = True
    else:
        fixed[number[0, -1, 0], 1] = True
    if kind == "corner":
        # the third rigid motion in the plane: rotation about z
        fixed[number[turn * p, -1, 0], 0] = True

    order = dissect([(0, n[0], p), (0, n[1], p), (0, n[2], p)])
    sequence = number[order[:, 0], order[:, 1], order[:, 2]]
    _, at = np.unique(sequence[::-1], return_index=True)  # the axis last
    sequence = sequence[np.sort(len(sequence) - 1 - at)]
    dofs = (sequence[:, None] * 3 + np.arange(3)).ravel()
    free = dofs[~fixed.ravel()[dofs]]
    factors = splu(K[free][:, free].tocsc(), permc_spec="NATURAL", diag_pivot_thresh=0.0,
                   options={"SymmetricMode": True})

    # tractions on z = H
    top = grid[:, 2] == (cells[2] - 1) * p
    face = local[:, 2] == p
    Xf = X[top][:, face]
    Df = np.stack([np.einsum("ai,bj->abij", D1, N1).reshape((p + 1) ** 2, -1),
                   np.einsum("ai,bj->abij", N1, D1).reshape((p + 1) ** 2, -1)], 1)
    Nf = np.einsum("ai,bj->abij", N1, N1).reshape((p + 1) ** 2, -1)
    jf = np.einsum("gdn,eni->egdi", Df, Xf[..., :2])
    wf = np.abs(np.linalg.det(jf)) * np.outer(w, w).ravel()
    yf = np.einsum("gn,en->eg", Nf, Xf[..., 1])

    # virtual advances
    normal = np.stack([np.cos(th) / c, np.sin(th) / a], -1)
    normal /= np.linalg.norm(normal, axis=1)[:, None]

    def ramp(x, edges):
        lo, hi = edges[layers:layers + 2]
        return np.clip((hi - x) / (hi - lo), 0, 1)
    radial_part = np.where(s < 1, ramp(1 - s, 1 - inside[::-1]), ramp(s - 1, outside - 1))
    z_part = ramp(z, vertical)
    basis = np.array([np.interp(th, lines, hat) for hat in np.eye(sectors + 1)])
    mass = np.zeros((len(lines),) * 2)
    gq, wq = leggauss(12)
    Nq, _ = lagrange(1, gq)
    for k in range(sectors):
        mid, half = (lines[k] + lines[k + 1]) / 2, (lines[k + 1] - lines[k]) / 2
        angle = mid + half * gq
        ds = np.hypot(c * np.sin(angle), a * np.cos(angle)) * wq * half
        mass[k:k + 2, k:k + 2] += (Nq.T * ds) @ Nq

    def displacement(load):
        stress = np.ones_like(yf) if load == "tension" else 1 - 2 * yf / t
        fe = np.einsum("eg,eg,gn->en", wf, stress, Nf)
        f, u = np.zeros(size), np.zeros(size)
        np.add.at(f, nodes[top][:, face] * 3 + 2, fe)
        u[free] = factors.solve(f[free])
        return u

    scalar = basis[:, :, None, None] * radial_part[None, None, :, None] * z_part
    direction = np.concatenate([normal, np.zeros((n[0], 1))], 1)[:, None, None]

    def release_rate(u):
        """G at the sector boundaries."""
        du = np.einsum("egin,enk->egik", grad, u[dof].reshape(count, m, 3))  # u_k,i
        strain = (du + du.transpose(0, 1, 3, 2)) / 2
        sigma = 2 * mu * strain + lam * np.einsum("egii->eg", strain)[..., None, None] * np.eye(3)
        energy = np.einsum("egij,egij->eg", sigma, strain) / 2
        # P_ij = sigma_ik u_k,j - W delta_ij; J = int P_ij q_j,i
        P = np.einsum("egik,egjk->egij", sigma, du) - energy[..., None, None] * np.eye(3)
        release = np.empty(len(lines))
        for k in range(len(lines)):
            q = scalar[k][..., None] * direction
            qe = q[ijk[..., 0], ijk[..., 1], ijk[..., 2]]
            touched = np.flatnonzero(np.abs(qe).max((1, 2)) > 0)
            dq = np.einsum("egin,enj->egij", grad[touched], qe[touched])
            release[k] = 2 * np.einsum("eg,egij,egij->", weight[touched], P[touched], dq)
        return np.linalg.solve(mass, release)

    modulus = E / (1 - NU ** 2)
    u = displacement("tension")
    result = {"tension": np.sqrt(release_rate(u) * modulus)}
    for load in loads:
        if load != "tension":  # by the mixed term, which has a sign
            other = displacement(load)
            mixed = (release_rate(u + other) - release_rate(u - other)) / 4
            result[load] = mixed * modulus / result["tension"]
    return lines, result


ASPECTS = (0.25, 0.5, 1, 2)
DEPTHS = (0.2, 0.5, 0.8)


def factors(kind, a_c, a_t, c_b=0.2, **options):
    a, c = 1.0, 1 / a_c
    t, b = a / a_t, c / c_b
    loads = ["tension"] if kind == "embedded" else ["tension", "bending"]
    angles, K = block(kind, a, c, t, b, 1.5 * max(b, t), loads, **options)
    return angles, {load: k / np.sqrt(np.pi * a) for load, k in K.items()}


def table(cases):
    out = Table("cracked_block", "aspect_ratio [1]", "depth_ratio [1]", "front_angle [rad]")
    for a_c, kind, a_t in cases:
        angles, F = factors(kind, a_c, a_t)
        for load, values in F.items():
            for theta, value in list(zip(angles, values))[::2]:
                out.add(f"{kind}.{load}", (a_c, a_t, theta), value, "1",
                        "finite elements of degree 2", digits=2, printed=6)
    return out


def some_tables():
    return [table([(1, "embedded", 0.5)])]


def tables():
    return [table([(a_c, kind, a_t) for a_c in ASPECTS for kind in ("surface", "corner", "embedded")
                   for a_t in DEPTHS])]


def check():
    for b in (6.0, 12.0):
        for p, sectors, layers in ((2, 6, 2), (2, 8, 3), (3, 6, 2)):
            _, K = block("embedded", 1.0, 1.0, b, b, b, ["tension"], p=p, sectors=sectors,
                         layers=layers)
            print("penny", b, p, layers, K["tension"] / np.sqrt(np.pi) * np.pi / 2, flush=True)
    for kind, a_c, a_t in (("surface", 0.5, 0.5), ("corner", 2, 0.5)):
        for options in ({}, {"sectors": 10, "layers": 3}):
            print(kind, a_c, a_t, options, factors(kind, a_c, a_t, **options)[1], flush=True)
    for a_c, a_t in ((0.5, 0.5), (1, 0.8), (2, 0.8)):
        for c_b in (0.05, 0.2, 0.4):
            print("corner", a_c, a_t, c_b, factors("corner", a_c, a_t, c_b)[1], flush=True)


if __name__ == "__main__":
    if "--check" in sys.argv[1:]:
        check()
    else:
        publish(*tables())
