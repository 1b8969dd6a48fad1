"""Solid round shaft with an annular (circumferential, external) crack.

Equations (x = d_e/d = 1 - 2a/d, net diameter d_e, plane strain):

    K_III = 16 T/(pi d_e^3) sqrt(pi a) M_M,   M_M = 3/8 sqrt(x) p3(x)
    K_I   =  4 P/(pi d_e^2) sqrt(pi a) M_p,   M_p = 1/2 sqrt(x) p1(x)
    added compliance = int 2 (K/Q)^2 (1 - nu^2)/E dA   or   int (K/Q)^2 / mu dA,
    swept area dA = pi (d - 2a) da

Polynomials: `handbook` is tada2000, typed from memory (secondary: not re-read in the book);
`improved` keeps both exact limits and is fitted to numerical solutions (annular_hollow.py with
radius ratio 0; p1 of the improved form holds for nu = 0.3).

Independent: the value is a quadrature of K^2 in the physical variable a.  The closed form, a
polynomial in x integrated in exact fractions, is a second road; the script stops if they differ.
"""
from fractions import Fraction as Q

from mpmath import mp

from reference_csv import Table, publish

SQRT_SERIES = [Q(1), Q(1, 2), Q(3, 8), Q(5, 16), Q(35, 128)]  # of 1/sqrt(1 - x)
P3 = {"handbook": SQRT_SERIES + [Q("0.208")],
      "improved": SQRT_SERIES + [Q("0.97947457"), Q("-5.99287797"), Q("13.64034961"),
                                 Q("-13.31097501"), Q("4.88975796")]}
P1 = {"handbook": SQRT_SERIES[:3] + [Q("-0.363"), Q("0.731")],
      "improved": SQRT_SERIES[:3] + [Q("-0.47216221"), Q("4.34028458"), Q("-10.67981481"),
                                     Q("11.90594661"), Q("-4.72621417")]}
SOURCE = {"handbook": "tada2000 (secondary)", "improved": "fit to annular_hollow.py"}


def mpf(q):
    return mp.mpf(q.numerator) / q.denominator


def polynomial(c, x):
    return mp.polyval([mpf(ck) for ck in reversed(c)], x)


def k_torsion(a, d, form):
    """K_III per unit torque."""
    x = 1 - 2 * a / d
    m = mp.mpf(3) / 8 * mp.sqrt(x) * polynomial(P3[form], x)
    return 16 / (mp.pi * (d * x) ** 3) * mp.sqrt(mp.pi * a) * m


def k_tension(a, d, form):
    """K_I per unit axial force."""
    x = 1 - 2 * a / d
    m = mp.sqrt(x) / 2 * polynomial(P1[form], x)
    return 4 / (mp.pi * (d * x) ** 2) * mp.sqrt(mp.pi * a) * m


def torsion_compliance(a, d, mu, form):
    return mp.quad(lambda s: k_torsion(s, d, form) ** 2 / mu * mp.pi * (d - 2 * s), [0, a])


def tension_compliance(a, d, E, nu, form):
    flexibility = 2 * (1 - nu ** 2) / E
    return mp.quad(
        lambda s: flexibility * k_tension(s, d, form) ** 2 * mp.pi * (d - 2 * s), [0, a])


def closed_integral(p, power, x):
    """int_x^1 p(s)^2 (1 - s)/s^power ds, term by term in exact fractions."""
    c = [Q(0)] * (2 * len(p))
    for i, pi in enumerate(p):
        for j, pj in enumerate(p):
            c[i + j] += pi * pj
            c[i + j + 1] -= pi * pj
    assert c[power - 1] == 0, "no logarithm"
    return mp.fsum(mpf(ck / (k - power + 1)) * (1 - x ** (k - power + 1))
                   for k, ck in enumerate(c) if k != power - 1)


def closed_torsion(x, d, mu, form):
    return 9 / (mu * d ** 3) * closed_integral(P3[form], 4, x)


def closed_tension(x, d, E, nu, form):
    return 2 * (1 - nu ** 2) / (E * d) * closed_integral(P1[form], 2, x)


def tables():
    d, mu, E, nu = mp.mpf("0.06"), mp.mpf("80e9"), mp.mpf("210e9"), mp.mpf("0.3")
    table = Table("annular_shaft", "net_diameter_ratio [1]", "diameter [m]", "shear_modulus [Pa]",
                  "youngs_modulus [Pa]", "poissons_ratio [1]")
    for form in P3:
        for x in map(mp.mpf, "0.999 0.99 0.95 0.9 0.7 0.5 0.3 0.1 1e-3".split()):
            a = d * (1 - x) / 2
            torsion = torsion_compliance(a, d, mu, form)
            tension = tension_compliance(a, d, E, nu, form)
            assert abs(torsion / closed_torsion(x, d, mu, form) - 1) < mp.mpf("1e-25")
            assert abs(tension / closed_tension(x, d, E, nu, form) - 1) < mp.mpf("1e-25")
            row = (x, d, mu, E, nu)
            source = SOURCE[form]
            table.add(f"{form}.torsion_compliance", row, torsion, "rad/(N*m)", source)
            table.add(f"{form}.axial_compliance", row, tension, "m/N", source)
            table.add(f"{form}.K_III_per_torque", row, k_torsion(a, d, form), "1/m^2.5", source)
            table.add(f"{form}.K_I_per_force", row, k_tension(a, d, form), "1/m^1.5", source)
        # Deep limit: two half-spaces (Reissner-Sagoci for torsion, flat punch for tension).
        x = mp.mpf("1e-8")
        assert abs(closed_torsion(x, d, mu, form) * mu * (d * x) ** 3 - 3) < 1e-7
        assert abs(closed_tension(x, d, E, nu, form) * E * d * x / (2 * (1 - nu ** 2)) - 1) < 1e-7
        # Shallow limit: edge crack in a half plane; compliances 128 M_M^2 a^2/(mu d^5) and
        # 16 M_p^2 (1 - nu^2) a^2/(E d^3).
        row = (1, "", "", "", "")
        table.add(f"{form}.M_M", row, mpf(Q(3, 8) * sum(P3[form])), "1", source)
        table.add(f"{form}.M_p", row, mpf(Q(1, 2) * sum(P1[form])), "1", source)
    return [table]


if __name__ == "__main__":
    publish(*tables())
