"""Laminated tubes: stiffness from tensors, torsion by elasticity theory, energy of cracks by roots.

The layers are three-dimensional here.  Their stiffness tensor is turned by index, and the tube is a
stack of cylinders in elasticity theory: the displacements are u_r = w(r), u_theta = phi r z and
u_z = e z, and minimal energy over w and e gives the torque per twist phi.  So radial stress and the
exact hoop strain w/r are included, which the theory of thin walls leaves out.  The energy at the
tip of a crack comes from the four roots of the characteristic equation, with 40 digits.  The added
compliance of a crack in a tube comes from the displacements of its faces behind the tip: if they
overlap, a pressure on the faces brings the opening back to 0.

Independent: no matrix of a layer in plane stress is turned by a formula, no integral A, B, D, and
no cubic for the sum of the roots.
"""
import numpy as np
from mpmath import mp

from reference_csv import Table, publish

SOURCE = "elasticity theory of layered cylinders; roots of the characteristic equation"
# E1, E2, G12, nu12, nu23 in Pa; the layer is isotropic across its fibres.
T300 = (181e9, 10.3e9, 7.17e9, 0.28, 0.4)
GLASS = (45.6e9, 16.2e9, 5.83e9, 0.278, 0.4)
STEEL = (208e9, 208e9, 80e9, 0.3, 0.3)
VOIGT = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))


def tensor(layer):
    """Stiffness tensor with the fibres along axis 0, axis 2 through the wall."""
    E1, E2, G12, nu12, nu23 = layer
    S = np.zeros((6, 6))
    S[:3, :3] = [[1 / E1, -nu12 / E1, -nu12 / E1], [-nu12 / E1, 1 / E2, -nu23 / E2],
                 [-nu12 / E1, -nu23 / E2, 1 / E2]]
    S[3, 3], S[4, 4], S[5, 5] = 2 * (1 + nu23) / E2, 1 / G12, 1 / G12
    C = np.linalg.inv(S)
    c = np.zeros((3, 3, 3, 3))
    for p, (i, j) in enumerate(VOIGT):
        for q, (k, m) in enumerate(VOIGT):
            for a, b in ((i, j), (j, i)):
                for d, e in ((k, m), (m, k)):
                    c[a, b, d, e] = C[p, q]
    return c


def turned(c, angle):
    R = np.array([[np.cos(angle), -np.sin(angle), 0], [np.sin(angle), np.cos(angle), 0],
                  [0, 0, 1]])
    return np.einsum("ia,jb,kc,ld,abcd->ijkl", R, R, R, R, c)


def plane_stress(c):
    """Compliance in the wall, 11, 12, 22, 16, 26, 66, of a tensor."""
    C = np.array([[c[i, j, k, m] for k, m in VOIGT] for i, j in VOIGT])
    S = np.linalg.inv(C)
    return [S[0, 0], S[0, 1], S[1, 1], S[0, 5], S[1, 5], S[5, 5]]


def tube(plies, radius, thickness, elements=60):
    """(torque per twist, axial strain per torque) of a tube; y is against the hoop direction."""
    inner = radius - thickness / 2
    total = sum(t for *_, t in plies)
    points, weights = np.polynomial.legendre.leggauss(6)
    nodes = 2 * elements * len(plies) + 1
    n = nodes + 2  # w at the nodes, e, phi
    K = np.zeros((n, n))
    r0, first = inner, 0
    for layer, angle, t in plies:
        c = turned(tensor(layer), angle)
        C = np.array([[c[i, j, k, m] for k, m in VOIGT] for i, j in VOIGT])
        h = t / total * thickness / elements
        for _ in range(elements):
            index = [first, first + 1, first + 2, nodes, nodes + 1]
            for x, weight in zip(points, weights):
                r = r0 + h * (x + 1) / 2
                N = [x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2]
                dN = [(x - 0.5) * 2 / h, -2 * x * 2 / h, (x + 0.5) * 2 / h]
                B = np.zeros((6, 5))
                B[1, :3] = np.array(N) / r
                B[2, :3] = dN
                B[0, 3] = 1
                B[5, 4] = -r  # shear against the sense of y
                K[np.ix_(index, index)] += 2 * np.pi * r * weight * h / 2 * B.T @ C @ B
            r0 += h
            first += 2
    u = np.linalg.solve(K[:-1, :-1], -K[:-1, -1])
    torque = K[-1, -1] + K[-1, :-1] @ u
    return torque, u[-1] / torque


def sheet(plies):
    """Compliance of the wall as a sheet: the plies have the same strain."""
    total = sum(t for *_, t in plies)
    A = np.zeros((3, 3))
    for layer, angle, t in plies:
        a = plane_stress(turned(tensor(layer), angle))
        S = np.array([[a[0], a[1], a[3]], [a[1], a[2], a[4]], [a[3], a[4], a[5]]])
        A += t / total * np.linalg.inv(S)
    return np.linalg.inv(A)


def turned_sheet(S, angle):
    """Compliance of a sheet in the axes of a crack."""
    c, s = np.cos(angle), np.sin(angle)
    T = np.array([[c * c, s * s, 2 * c * s], [s * s, c * c, -2 * c * s],
                  [-c * s, c * s, c * c - s * s]])
    inverse = np.linalg.inv(T)
    return inverse.T @ S @ inverse, T


def upper_roots(a):
    scale = mp.mpf(1) / a[0, 0]
    coefficients = [1, -2 * a[0, 2] * scale, (2 * a[0, 1] + a[2, 2]) * scale,
                    -2 * a[1, 2] * scale, a[1, 1] * scale]
    roots = mp.polyroots([mp.mpf(x) for x in coefficients], maxsteps=500, extraprec=400)
    upper = sorted((z for z in roots if z.imag > 0), key=lambda z: z.imag)
    assert len(upper) == 2
    return upper


def crack_in_tube(S, radius, thickness, angle, half_length):
    """Added compliance under torque about +z and -z, without friction.

    The upper face behind the tip moves by K sqrt(2r/pi) times the factors of Sih, Paris and Irwin.
    Closing the crack by the stress ahead of the tip takes half of K times the factor as G.
    """
    a, T = turned_sheet(S, angle)
    s1, s2 = upper_roots(a)

    def p(z):
        return a[0, 0] * z * z + a[0, 1] - a[0, 2] * z

    def q(z):
        return a[0, 1] * z + a[1, 1] / z - a[1, 2]

    def face(value):
        return float((mp.mpc(0, 1) * value / (s1 - s2)).real)

    opening = face(s1 * q(s2) - s2 * q(s1)), face(q(s2) - q(s1))  # by K_I, by K_II
    sliding = face(s1 * p(s2) - s2 * p(s1)), face(p(s2) - p(s1))
    added = []
    for sense in (1, -1):
        # y is against the hoop direction, so the shear of a positive torque is negative.
        shear = -sense / (2 * np.pi * radius ** 2 * thickness)
        _, K_I, K_II = T @ np.array([0.0, 0.0, shear])  # over sqrt(pi a)
        if opening[0] * K_I + opening[1] * K_II < 0:
            K_I = -opening[1] * K_II / opening[0]  # with the pressure of the faces
        G = (K_I * (opening[0] * K_I + opening[1] * K_II)
             + K_II * (sliding[0] * K_I + sliding[1] * K_II)) / 2
        added.append(4 * thickness * G * np.pi * half_length ** 2 / 2)  # both tips, from 0 to a
    return added


def energy(S, angle):
    """(opening, coupling, sliding) of a crack at an angle in a sheet."""
    a, _ = turned_sheet(S, angle)
    upper = upper_roots(a)
    p, q = upper[0] + upper[1], upper[0] * upper[1]
    opening = -a[1, 1] / 2 * (p / q).imag
    sliding = a[0, 0] / 2 * p.imag
    # half of the sum of both cross terms, which need not be equal in the formulas
    coupling = (a[0, 0] * q.imag - a[1, 1] * (1 / q).imag) / 4
    return opening, coupling, sliding


WALLS = {
    "isotropic": [(STEEL, 0.3, 1.0), (STEEL, -0.7, 2.0)],
    "along": [(T300, 0.0, 1.0)],
    "plus45": [(T300, np.pi / 4, 1.0)],
    "plus30": [(T300, np.pi / 6, 1.0)],
    "minus20": [(GLASS, -np.pi / 9, 1.0)],
    "angle_ply": [(T300, np.pi / 4, 1.0), (T300, -np.pi / 4, 1.0), (T300, -np.pi / 4, 1.0),
                  (T300, np.pi / 4, 1.0)],
    "two_plies": [(T300, np.pi / 6, 1.0), (T300, -np.pi / 4, 2.0)],
    "hybrid": [(STEEL, 0.0, 1.0), (GLASS, 1.1, 1.0), (T300, -0.4, 0.5)],
}


def tables():
    table = Table("laminate", "radius [m]", "thickness [m]", "angle [rad]")
    for name, plies in WALLS.items():
        for radius, thickness in ((0.08, 0.002), (0.08, 0.008)):
            coarse, fine = (tube(plies, radius, thickness, n) for n in (12, 24))
            assert abs(coarse[0] / fine[0] - 1) < 1e-9
            table.add(f"{name}.rigidity", (radius, thickness, ""), fine[0], "N*m^2", SOURCE, 8, 10)
            table.add(f"{name}.axial_strain", (radius, thickness, ""),
                      fine[1] if abs(fine[1]) > 1e-15 else 0, "1/(N*m)", SOURCE, 8, 10)
        for angle in (0.0, 0.5, np.pi / 4, -1.2, np.pi / 2):
            for part, value in zip(("opening", "coupling", "sliding"), energy(sheet(plies), angle)):
                if abs(value) < 1e-20:
                    value = 0
                table.add(f"{name}.{part}", ("", "", angle), value, "1/Pa", SOURCE, 10, 12)
    cracks = Table("laminate_cracks", "first [rad]", "second [rad]", "angle [rad]")
    for first, second in ((45, 45), (10, 10), (-20, -20), (30, -45)):
        S = sheet([(T300, np.radians(first), 1.0), (T300, np.radians(second), 1.0)])
        for angle in (-80, -50, -10, 5, 20, 60):
            for sense, value in zip(("positive", "negative"),
                                    crack_in_tube(S, 0.06, 0.0012, np.radians(angle), 0.002)):
                cracks.add(sense, [np.radians(x) for x in (first, second, angle)], value, "rad/(N*m)",
                           "displacements of the faces behind the tip", 10, 12)
    return [table, cracks]


if __name__ == "__main__":
    publish(*tables())
