"""Edge crack through the width of a strip (ring section): K factors and added compliance.

Depth a, strip depth t, width B, alpha = a/t; sigma = N/(B t) or 6 M/(B t^2), K = sigma sqrt(pi a) F
(tada2000, secondary: typed from memory, stated better than 0.5 % for any alpha):

    root = sqrt(2/(pi alpha) tan(pi alpha/2)),  q = 1 - sin(pi alpha/2)
    F_t  = root (0.752 + 2.02 alpha + 0.37 q^3)/cos(pi alpha/2)
    F_b  = root (0.923 + 0.199 q^4)/cos(pi alpha/2)
    compliance_ij = int_0^a 2 (1 - nu^2)/E k_i k_j B da                        (plane strain)

Independent: quadrature in a.  F_t is compared with the Gross-Srawley polynomial
1.12 - 0.231 alpha + 10.55 alpha^2 - 21.72 alpha^3 + 30.39 alpha^4 (0.5 %, alpha <= 0.6) in the
table; antiplane: int_0^a (K/tau)^2 da with K = tau sqrt(2 t tan(pi a/(2 t))) is exact.
"""
from mpmath import mp

from reference_csv import Table, publish

SOURCE = "tada2000 (secondary)"


def factor(alpha, numerator):
    half = mp.pi * alpha / 2
    root = mp.sqrt(mp.tan(half) / half) if alpha else mp.mpf(1)
    return root * numerator(1 - mp.sin(half)) / mp.cos(half)


def F_tension(alpha):
    return factor(alpha, lambda q: mp.mpf("0.752") + mp.mpf("2.02") * alpha
                  + mp.mpf("0.37") * q ** 3)


def F_bending(alpha):
    return factor(alpha, lambda q: mp.mpf("0.923") + mp.mpf("0.199") * q ** 4)


def gross_srawley(alpha):
    return mp.polyval([mp.mpf(c) for c in ("30.39", "-21.72", "10.55", "-0.231", "1.12")], alpha)


def compliance(a, t, B, E, nu):
    """Tension-tension, tension-bending, bending-bending."""
    def k_tension(s):
        return mp.sqrt(mp.pi * s) * F_tension(s / t) / (B * t)

    def k_bending(s):
        return mp.sqrt(mp.pi * s) * F_bending(s / t) * 6 / (B * t ** 2)

    pairs = (k_tension, k_tension), (k_tension, k_bending), (k_bending, k_bending)
    return [mp.quad(lambda s: 2 * (1 - nu ** 2) / E * ki(s) * kj(s) * B, [0, a / 2, a],
                    method="gauss-legendre") for ki, kj in pairs]


def tables():
    table = Table("edge_crack", "depth_ratio [1]", "thickness [m]", "width [m]",
                  "youngs_modulus [Pa]", "poissons_ratio [1]")
    t, B = mp.mpf("0.01"), mp.mpf("0.02")
    E, nu = mp.mpf("210e9"), mp.mpf("0.3")
    blank = ("",) * 4
    for alpha in map(mp.mpf, "0 0.01 0.1 0.2 0.3 0.4 0.5 0.6 0.8 0.9".split()):
        table.add("F_tension", (alpha, *blank), F_tension(alpha), "1", SOURCE)
        table.add("F_bending", (alpha, *blank), F_bending(alpha), "1", SOURCE)
        if alpha <= mp.mpf("0.6"):
            assert abs(F_tension(alpha) / gross_srawley(alpha) - 1) < mp.mpf("0.015")
            table.add("F_tension_gross_srawley", (alpha, *blank), gross_srawley(alpha), "1",
                      "tada2000 (secondary): least-squares fit 0.5 %")
        if alpha:
            row = (alpha, t, B, E, nu)
            units = {"axial": "m/N", "coupling": "rad/N", "bending": "rad/(N*m)"}
            for (name, unit), value in zip(units.items(), compliance(alpha * t, t, B, E, nu)):
                table.add(f"{name}_compliance", row, value, unit, SOURCE)
    half = mp.mpf("0.5")
    antiplane = mp.quad(lambda s: 2 * mp.tan(mp.pi * s / 2), [0, half])  # t = 1 m
    assert abs(antiplane - 4 / mp.pi * mp.log(mp.sec(mp.pi * half / 2))) < mp.mpf("1e-30")
    table.add("antiplane_energy_integral", (half, 1, "", "", ""), antiplane, "m^2",
              "exact (tada2000; secondary)")
    return [table]


if __name__ == "__main__":
    publish(*tables())
