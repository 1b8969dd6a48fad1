"""Edge crack through the width of a strip (ring section): K factors and added compliance.

Depth a, strip depth t, width B, alpha = a/t; sigma = N/(B t) or 6 M/(B t^2), K = sigma sqrt(pi a) F:

    F = (c_0 + c_1 alpha + ... + c_8 alpha^8)/(1 - alpha)^(3/2)    (fitted to cracked_strip.py)
    compliance_ij = int_0^a 2 (1 - nu^2)/E k_i k_j B da                        (plane strain)

Independent: the coefficients are typed a second time and held here to the finite elements of
cracked_strip.csv and to the integral equation of weight_function.csv (bending: P_0 - 2 alpha P_1 of
its powers (x/a)^n); compliances by quadrature in a.  The compliances "_by_elements" do not use the
polynomials: they integrate the factors of the finite elements, interpolated by cubics.
Gross and Srawley's polynomials, alpha <= 0.6, are in the table (tada2000, secondary: typed from
memory, stated 0.5 %); antiplane: int_0^a (K/tau)^2 da with K = tau sqrt(2 t tan(pi a/(2 t))) is
exact.
"""
import csv
from functools import cache

from mpmath import mp

from reference_csv import DATA, Table, publish

SOURCE = "polynomial fitted to cracked_strip.py"
TENSION = ("1.1215 -1.6693 8.0801 -24.962 56.3305 -86.0594 82.2275 -43.877 9.9295",
           "1.12 -0.231 10.55 -21.72 30.39")
BENDING = ("1.1215 -3.0255 9.8273 -28.6524 61.7662 -89.4007 81.0079 -41.2108 8.9402",
           "1.122 -1.40 7.33 -13.08 14.0")
LOADS = {"tension": TENSION, "bending": BENDING}
HALF_PLANE = mp.mpf("1.1215222552")  # koiter1965 (secondary)


def polynomial(coefficients, alpha):
    return sum(mp.mpf(c) * alpha ** k for k, c in enumerate(coefficients.split()))


def factor(load, alpha):
    return polynomial(LOADS[load][0], alpha) * (1 - alpha) ** mp.mpf("-1.5")


def gross_srawley(load, alpha):
    return polynomial(LOADS[load][1], alpha)


def read(noun):
    with open(DATA / f"{noun}.csv", encoding="ascii", newline="") as file:
        return list(csv.DictReader(file))


@cache
def elements(load):
    """{alpha: F}, finite elements; the half-plane at 0."""
    return {mp.mpf(0): HALF_PLANE} | {
        mp.mpf(row["size_ratio [1]"]): mp.mpf(row["value"])
        for row in sorted(read("cracked_strip"), key=lambda row: float(row["size_ratio [1]"]))
        if row["case"] == f"edge.{load}"}


@cache
def integral_equation(load):
    power = {(mp.mpf(row["depth_ratio [1]"]), float(row["exponent [1]"])): mp.mpf(row["value"])
             for row in read("weight_function") if row["case"] == "power"}
    return {alpha: F - (2 * alpha * power[alpha, 1] if load == "bending" else 0)
            for (alpha, n), F in power.items() if n == 0}


def interpolated(load):
    """F by cubics through four neighbours of F (1 - alpha)^1.5."""
    nodes, values = zip(*((x, F * (1 - x) ** mp.mpf("1.5")) for x, F in elements(load).items()))

    def F(alpha):
        left = sum(x <= alpha for x in nodes) - 1
        first = min(max(left - 1, 0), len(nodes) - 4)
        total = mp.mpf(0)
        for i in range(first, first + 4):
            weight = mp.mpf(1)
            for j in range(first, first + 4):
                if j != i:
                    weight *= (alpha - nodes[j]) / (nodes[i] - nodes[j])
            total += weight * values[i]
        return total * (1 - alpha) ** mp.mpf("-1.5")
    return F


def compliance(factors, breaks, t, B, E, nu):
    """Tension-tension, tension-bending, bending-bending; the last of `breaks` is a."""
    def k_tension(s):
        return mp.sqrt(mp.pi * s) * factors["tension"](s / t) / (B * t)

    def k_bending(s):
        return mp.sqrt(mp.pi * s) * factors["bending"](s / t) * 6 / (B * t ** 2)

    pairs = (k_tension, k_tension), (k_tension, k_bending), (k_bending, k_bending)
    return [mp.quad(lambda s: 2 * (1 - nu ** 2) / E * ki(s) * kj(s) * B, breaks,
                    method="gauss-legendre") for ki, kj in pairs]


def check():
    """The polynomials against both computations, by the accuracy that the manual states."""
    for load in LOADS:
        for solution in (elements(load), integral_equation(load)):
            for alpha, F in solution.items():
                limit = mp.mpf("2e-4" if alpha <= mp.mpf("0.9") else "8e-4")
                assert abs(factor(load, alpha) / F - 1) < limit, (load, alpha)
        for alpha, F in integral_equation(load).items():
            if alpha in elements(load):
                limit = mp.mpf("2e-5" if alpha < mp.mpf("0.9") else "6e-4")
                assert abs(elements(load)[alpha] / F - 1) < limit, (load, alpha)


def tables():
    check()
    table = Table("edge_crack", "depth_ratio [1]", "thickness [m]", "width [m]",
                  "youngs_modulus [Pa]", "poissons_ratio [1]")
    t, B = mp.mpf("0.01"), mp.mpf("0.02")
    E, nu = mp.mpf("210e9"), mp.mpf("0.3")
    blank = ("",) * 4
    units = {"axial": "m/N", "coupling": "rad/N", "bending": "rad/(N*m)"}
    fitted = {load: lambda x, load=load: factor(load, x) for load in LOADS}
    by_elements = {load: interpolated(load) for load in LOADS}
    for alpha in map(mp.mpf, "0 0.01 0.1 0.2 0.3 0.4 0.5 0.6 0.8 0.9".split()):
        for load in LOADS:
            table.add(f"F_{load}", (alpha, *blank), factor(load, alpha), "1", SOURCE)
            if alpha <= mp.mpf("0.6"):
                table.add(f"F_{load}_gross_srawley", (alpha, *blank), gross_srawley(load, alpha),
                          "1", "tada2000 (secondary): least-squares fit 0.5 %")
        if alpha:
            row = (alpha, t, B, E, nu)
            values = compliance(fitted, [0, alpha * t / 2, alpha * t], t, B, E, nu)
            for (name, unit), value in zip(units.items(), values):
                table.add(f"{name}_compliance", row, value, unit, SOURCE)
        if alpha >= mp.mpf("0.1"):
            breaks = [x * t for x in elements("tension") if x < alpha] + [alpha * t]
            values = compliance(by_elements, breaks, t, B, E, nu)
            for (name, unit), value in zip(units.items(), values):
                table.add(f"{name}_compliance_by_elements", row, value, unit,
                          "quadrature of cracked_strip.csv", digits=4, printed=9)
    half = mp.mpf("0.5")
    antiplane = mp.quad(lambda s: 2 * mp.tan(mp.pi * s / 2), [0, half])  # t = 1 m
    assert abs(antiplane - 4 / mp.pi * mp.log(mp.sec(mp.pi * half / 2))) < mp.mpf("1e-30")
    table.add("antiplane_energy_integral", (half, 1, "", "", ""), antiplane, "m^2",
              "exact (tada2000; secondary)")
    return [table]


if __name__ == "__main__":
    publish(*tables())
