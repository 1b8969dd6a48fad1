"""Hertz point contact: semi-axes, peak pressure, approach; subsurface shear; edge tension.

Relative curvatures A' = 2A <= 2B = B' in the two principal planes (sums over both bodies, convex
positive), 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2, pressure p0 sqrt(1 - x^2/a^2 - y^2/b^2), a >= b.
Equations (johnson1985, harris2001; secondary), with D(w) = sqrt((a^2 + w)(b^2 + w) w):

    A = p0 a b/(2 E*) int_0^inf dw/((a^2 + w) D),   B likewise with b^2 + w,
    approach = p0 a b/(2 E*) int_0^inf dw/D,        load = 2 pi a b p0/3.

Orthogonal shear, rolling along y (semi-axis b): beta = 2 max|tau_yz|/p0 at depth z0; from the
potential of the ellipsoidal pressure, lambda the confocal coordinate of (0, y, z),

    tau_yz = -(p0 a b/2) z y/((b^2 + lambda) D(lambda)) dlambda/dz.

Edge tension at the end of an axis, chords from that point (Boussinesq, surface outside the load):

    sigma = (1 - 2 nu)/(2 pi) int int p cos(2 theta)/r dr dtheta.

Independent: the potential integrals in Carlson's form (one of each is checked by quadrature), a
search for the largest tau_yz and quadrature over the rays; no K(k) and E(k), no cubic for beta, no
closed form of the edge stress.
"""
from functools import cache

from mpmath import mp

from reference_csv import Table, publish

SOURCE = "johnson1985; harris2001 (secondary)"


def potential(ratio, which):
    """int_0^inf dw/(f D) with a = 1, b = ratio; f = 1, a^2 + w or b^2 + w (Carlson's forms)."""
    b2 = ratio ** 2
    if which == "1":
        return 2 * mp.elliprf(0, 1, b2)
    return 2 * mp.elliprd(0, b2, 1) / 3 if which == "a" else 2 * mp.elliprd(0, 1, b2) / 3


def potential_by_quadrature(ratio, which):
    def integrand(theta):  # w = tan^2(theta)
        c2, s2 = mp.cos(theta) ** 2, mp.sin(theta) ** 2
        first, second = c2 + s2, ratio ** 2 * c2 + s2  # (a^2 + w) c2, (b^2 + w) c2
        f = {"1": 1, "a": first / c2, "b": second / c2}[which]
        return 2 / (f * mp.sqrt(first * second))

    return mp.quad(integrand, [0, ratio, mp.pi / 2])


def contact(A2, B2, modulus, load):
    """a, b, p0, approach."""
    def mismatch(t):  # t = log(b/a)
        ratio = mp.exp(t)
        return mp.log(potential(ratio, "a") / potential(ratio, "b") * B2 / A2)

    ratio = mp.mpf(1)
    if A2 != B2:
        ratio = mp.exp(mp.findroot(mismatch, 2 * mp.log(A2 / B2) / 3 + mp.mpf(1) / 3,
                                   solver="secant", tol=mp.mpf("1e-30")))
    # with lengths in units of a:  A = p0 ratio/(2 E* a) I_a,  load = 2 pi a^2 ratio p0/3
    a = mp.cbrt(3 * load * potential(ratio, "a") / (2 * mp.pi * modulus * A2))
    p0 = 3 * load / (2 * mp.pi * a * a * ratio)
    approach = p0 * a * ratio / (2 * modulus) * potential(ratio, "1")
    return a, a * ratio, p0, approach


def tau_yz(ratio, y, z):
    """tau_yz/p0 in the plane x = 0, b = 1, a = 1/ratio."""
    a2 = 1 / ratio ** 2
    half = (y * y + z * z - 1) / 2  # y^2/(1 + l) + z^2/l = 1
    l = half + mp.sqrt(half ** 2 + z * z)
    slope = (2 * z / l) / (y * y / (1 + l) ** 2 + z * z / l ** 2)
    return mp.sqrt(a2) / 2 * z * y / ((1 + l) * mp.sqrt((a2 + l) * (1 + l) * l)) * slope


def orthogonal_shear(ratio):
    """beta and z0/b at the stationary point of tau_yz(y, z)."""
    def gradient(y, z):
        return (mp.diff(lambda s: tau_yz(ratio, s, z), y),
                mp.diff(lambda s: tau_yz(ratio, y, s), z))

    mp.dps += 20
    y, z = mp.findroot(gradient, (mp.mpf("0.87"), mp.mpf("0.45")), tol=mp.mpf("1e-50"))
    beta = 2 * tau_yz(ratio, y, z)
    mp.dps -= 20
    return +beta, +z


def edge_tension(along, across, nu):
    """Radial stress/p0 at the end of the semi-axis `along`."""
    return (1 - 2 * nu) / mp.pi * edge_integral(along, across)


@cache
def edge_integral(along, across):
    """Over the rays; over the chord R of a ray, int sqrt((R - r)/r) dr = pi R/2."""
    def ray(theta):
        c, s = mp.cos(theta), mp.sin(theta)
        chord = mp.pi * (c / along) / mp.sqrt((c / along) ** 2 + (s / across) ** 2)
        return mp.cos(2 * theta) * chord

    kink = mp.atan(across / along)
    return mp.quad(ray, [0, kink, mp.pi / 2])


def tables():
    for which in "1ab":
        ratio = mp.mpf("0.4")
        exact = potential_by_quadrature(ratio, which)
        assert abs(potential(ratio, which) / exact - 1) < mp.mpf("1e-25")
    table = Table("hertz_contact", "relative_curvature_min [1/m]", "relative_curvature_max [1/m]",
                  "contact_modulus [Pa]", "load [N]", "semi_axis_ratio [1]", "poissons_ratio [1]")
    modulus = mp.mpf("210e9") / (2 * (1 - mp.mpf("0.3") ** 2))  # steel on steel
    ball, race = mp.mpf("12.7e-3"), mp.mpf("55e-3")  # diameter; radius of the inner race
    groove = 1 / (mp.mpf("0.52") * ball)  # both races
    pairs = {
        "sphere_on_flat": (mp.mpf(100), mp.mpf(100), 100),  # R = 10 mm
        "ball_on_inner_race": (2 / ball - groove, 2 / ball + 1 / race, 500),
        "ball_on_outer_race": (2 / ball - groove, 2 / ball - 1 / (race + ball), 500),
        "crossed_cylinders": (mp.mpf(50), mp.mpf(125), 250),
        "slender": (mp.mpf(1), mp.mpf(400), 1000),
    }
    units = {"semi_axis_major": "m", "semi_axis_minor": "m", "peak_pressure": "Pa",
             "approach": "m"}
    for name, (A2, B2, load) in pairs.items():
        for (quantity, unit), value in zip(units.items(), contact(A2, B2, modulus, load)):
            table.add(f"{name}.{quantity}", (A2, B2, modulus, load, "", ""), value, unit, SOURCE)
    for ratio in map(mp.mpf, "1e-3 0.1 0.4 0.7 1".split()):
        beta, depth = orthogonal_shear(ratio)
        row = ("", "", "", "", ratio)
        table.add("orthogonal_shear_factor", (*row, ""), beta, "1", SOURCE)
        table.add("orthogonal_shear_depth_ratio", (*row, ""), depth, "1", SOURCE)
        for nu in map(mp.mpf, ("0.25", "0.3")):
            table.add("edge_tension_major_end", (*row, nu), edge_tension(mp.mpf(1), ratio, nu), "1",
                      SOURCE)
            table.add("edge_tension_minor_end", (*row, nu), edge_tension(ratio, mp.mpf(1), nu), "1",
                      SOURCE)
    return [table]


if __name__ == "__main__":
    publish(*tables())
