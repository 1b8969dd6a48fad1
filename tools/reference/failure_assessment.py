"""Failure assessment: line, interaction, limit loads, and the article's three cracks worked out.

Independent of the C++: 40 digits, roots by bisection in the load and in the size, the plastic
torque of a ring by quadrature, K of the hollow shaft from a polynomial fitted to finite elements
of 70/45 mm (6.5e-5), K of the surface crack from Newman and Raju's equations typed anew, the
stress of the assembly by turning the tensor as a matrix.

Cases: line (E/sigma_Y and sigma_U/sigma_Y), interaction V(chi, L_r), ring_torque (plastic torque
over the yield strength in shear), and for the article's drive, cracks of 1 mm, 100 N*m, E = 210,
G = 80 GPa, nu = 0.3, sigma_Y = 900, sigma_U = 1000 MPa, K_Ic = 5 MPa*m^0.5: K, L_r, K_r, reserve
and critical size of each crack, the flexspline's also with the assembly.
"""
from mpmath import mp

from reference_csv import Table, publish

BS7910 = "bs7910 (secondary)"
mm, MPa = mp.mpf("1e-3"), mp.mpf("1e6")


def line(L, E_over_Y, U_over_Y):
    mu = min(E_over_Y / 1000, mp.mpf("0.6"))
    below = lambda x: (3 + 7 * mp.e ** (-mu * x ** 6)) / 10 * mp.sqrt(2 / (2 + x ** 2))
    if L > (1 + U_over_Y) / 2:
        return mp.mpf(0)
    if L <= 1:
        return below(L)
    N = mp.mpf(3) / 10 * (1 - 1 / U_over_Y)
    return below(mp.mpf(1)) * mp.e ** ((N - 1) / (2 * N) * mp.log(L))


def interaction(chi, L):
    if L >= mp.mpf("1.05"):
        return mp.mpf(1)
    return min(1 + L / 5 + chi / 50 * (1 + 2 * L), mp.mpf("3.1") - 2 * L)


def first_root(f, lower, upper):
    """Bisection for the zero of an increasing function."""
    assert f(lower) < 0 < f(upper)
    for _ in range(140):
        middle = (lower + upper) / 2
        lower, upper = (lower, middle) if f(middle) > 0 else (middle, upper)
    return lower


# --- the article's drive ----------------------------------------------------------------------
E, G, nu = 210000 * MPa, 80000 * MPa, mp.mpf("0.3")
Y, U, K_Ic = 900 * MPa, 1000 * MPa, 5 * MPa
T = mp.mpf(100)


def annular(a):
    """K of equal energy release rate and reference stress of the shaft 70/45 mm."""
    r_o, r_i = 35 * mm, mp.mpf("22.5") * mm
    t, I_p = r_o - r_i, mp.pi / 2 * (r_o ** 4 - r_i ** 4)
    c = [mp.mpf(x) for x in "0.474897 -1.264648 1.411537 -0.84478 0.440597 0.003945 1".split()]

    def compliance(depth):
        alpha = depth / t
        return (4 * t / (mp.pi * G * I_p) * mp.log(mp.sec(mp.pi * alpha / 2))
                * mp.mpf("1.7228065") * mp.polyval(c, alpha))
    r_e = r_o - a
    K_III = T * mp.sqrt(G * mp.diff(compliance, a) / (2 * mp.pi * r_e))
    torque = mp.quad(lambda r: 2 * mp.pi * r ** 2, [r_i, r_e])
    return K_III * mp.sqrt(E / (1 - nu ** 2) / (2 * G)), mp.sqrt(3) * T / torque


def race(a):
    """Semi-ellipse a/c = 0.52147039 in 10 mm; stress 0.45/2 times the contact pressure."""
    rho, alpha = mp.mpf("0.52147039"), a / (10 * mm)
    F = 2 * mp.mpf("1.15") * mp.mpf("0.35") * T / (2 * 160 * mm)
    stress = mp.mpf("0.45") / 2 * 3 * F / (2 * mp.pi * 5 * mm * 2 * mm)
    Q = 1 + mp.mpf("1.464") * rho ** mp.mpf("1.65")
    M = (mp.mpf("1.13") - mp.mpf("0.09") * rho
         + (mp.mpf("0.89") / (mp.mpf("0.2") + rho) - mp.mpf("0.54")) * alpha ** 2
         + (mp.mpf("0.5") - 1 / (mp.mpf("0.65") + rho) + 14 * (1 - rho) ** 24) * alpha ** 4)

    def K(i):  # at phi = i/32 of a quadrant
        phi = mp.pi / 2 * i / 32
        g = 1 + (mp.mpf("0.1") + mp.mpf("0.35") * alpha ** 2) * (1 - mp.sin(phi)) ** 2
        f = (rho ** 2 * mp.cos(phi) ** 2 + mp.sin(phi) ** 2) ** mp.mpf("0.25")
        return stress * mp.sqrt(mp.pi * a / Q) * M * g * f
    return max(K(i) for i in range(33)), stress / (1 - alpha)


def through(a):
    """K of load and assembly as (I, II) at 45 degrees in the flat sheet, and the reference stress."""
    r, t = mp.mpf("78.88") * mm, mp.mpf("2.24") * mm
    tau = mp.mpf("1.1") * T / (2 * mp.pi * r ** 2 * t)
    hoop = E / (1 - nu ** 2) * t / 2 * 3 * mp.mpf("0.8") * mm / r ** 2
    c = 1 / mp.sqrt(2)
    e, n = mp.matrix([-c, c]), mp.matrix([c, c])  # (theta, z): along the crack, across it

    def resolved(tensor):
        return (n.T * tensor * n)[0], (e.T * tensor * n)[0]
    load = resolved(mp.matrix([[0, tau], [tau, 0]]))
    bent = resolved(mp.matrix([[hoop, 0], [0, nu * hoop]]))
    root = mp.sqrt(mp.pi * a)
    share = min(1 - 2 * a * c / (mp.pi * r), 1 - 2 * a * c / (160 * mm))
    return ((load[0] * root, load[1] * root), (bent[0] * root, bent[1] * root),
            mp.sqrt(3) * tau / share)


def simple(at):
    """(K_p, K_s, sigma_ref, K(load, V)) of a crack without assembly."""
    def given(a):
        K, sigma = at(a)
        return K, mp.mpf(0), sigma, lambda load, V: load * K
    return given


def with_assembly(a):
    load, bent, sigma = through(a)

    def K(p, s):
        both = [mp.hypot(max(p * load[0] + x * s * bent[0], 0), p * load[1] + x * s * bent[1])
                for x in (1, -1)]
        return max(both)
    return K(1, 0), K(0, 1), sigma, K


def load_alone(a):
    load, _, sigma = through(a)
    size = mp.hypot(*load)
    return size, mp.mpf(0), sigma, lambda p, V: p * size


def worked(at, size, largest):
    K_p, K_s, sigma, K = at(size)

    def point(given, p):
        K_p, K_s, sigma, K = given
        L = p * sigma / Y
        V = interaction(K_s * (sigma / Y) / K_p, L) if K_s else mp.mpf(0)
        return L, K(p, V) / K_Ic

    def beyond(given, p):
        L, K_r = point(given, p)
        f = line(L, E / Y, U / Y)
        return K_r - f if f else mp.mpf(1)
    L, K_r = point(at(size), 1)
    collapse = (Y + U) / (2 * Y) / L
    return {"K": (K(1, 1 if K_s else 0), "Pa*m^0.5"), "L_r": (L, "1"), "K_r": (K_r, "1"),
            "reserve": (first_root(lambda p: beyond(at(size), p), mp.mpf(0), 2 * collapse), "1"),
            "critical_size": (first_root(lambda a: beyond(at(a), 1), size / 1000, largest), "m")
            if beyond(at(largest), 1) > 0 else None}


def tables():
    table = Table("failure_assessment", "youngs_over_yield [1]", "ultimate_over_yield [1]",
                  "L_r [1]", "chi [1]", "outer_radius [m]", "inner_radius [m]", "size [m]")
    blank = ("",) * 7
    for ratio, ultimate in (("300", "1.1"), ("900", "1.5"), ("600", "2"), ("233.25", "1")):
        for L in "0 0.2 0.5 0.8 0.95 1 1.02 1.05 1.1 1.25 1.5 1.6".split():
            values = mp.mpf(ratio), mp.mpf(ultimate), mp.mpf(L)
            table.add("line", (*values, *("",) * 4), line(values[2], *values[:2]), "1", BS7910)
    for chi in "0 0.3 1 2.5 4".split():
        for L in "0 0.3 0.7 0.9 1 1.04 1.05 1.2".split():
            chi_, L_ = mp.mpf(chi), mp.mpf(L)
            table.add("interaction", ("", "", L_, chi_, "", "", ""), interaction(chi_, L_), "1",
                      BS7910)
    for r_o, r_i in ((30, 0), (35, 22), (35, mp.mpf("34.5"))):
        r_o, r_i = r_o * mm, r_i * mm
        table.add("ring_torque", ("", "", "", "", r_o, r_i, ""),
                  mp.quad(lambda r: r * 2 * mp.pi * r, [r_i, r_o]), "m^3", "quadrature")
    size = 1 * mm
    for name, at, largest, digits in (("annular", simple(annular), 9 * mm, 4),
                                      ("race", simple(race), 8 * mm, 15),
                                      ("through", load_alone, 14 * mm, 15),
                                      ("through_assembly", with_assembly, 14 * mm, 15)):
        for quantity, answer in worked(at, size, largest).items():
            if answer:
                table.add(f"{name}_{quantity}", (*blank[:6], size), answer[0], answer[1],
                          "worked here", digits=digits)
    return [table]


if __name__ == "__main__":
    publish(*tables())
