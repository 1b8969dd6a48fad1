"""Semi-elliptical surface crack in tension; elliptical crack in an infinite body.

surface_crack.csv (newmanraju1981, secondary: coefficients typed from memory, not re-read).
Depth a, half-length c, rho = a/c <= 1, alpha = a/t; phi from the surface point, deepest at pi/2;
wide plate (f_w = 1), membrane stress sigma:

    K_I = sigma sqrt(pi a/Q) M g f,   Q = 1 + 1.464 rho^1.65,
    M = 1.13 - 0.09 rho + (0.89/(0.2 + rho) - 0.54) alpha^2
        + (0.5 - 1/(0.65 + rho) + 14 (1 - rho)^24) alpha^4,
    g = 1 + (0.1 + 0.35 alpha^2)(1 - sin phi)^2,   f^4 = rho^2 cos^2 phi + sin^2 phi.

Energy integral of the crack grown at constant rho, swept area dA = c da dphi:

    W = int int (K_I/sigma)^2 dA,   added compliance = 2 (1 - nu^2)/E (sigma/load)^2 W.

elliptical_crack_shear.csv (kassirsih1966, secondary).  Embedded ellipse, shear tau along the
major axis, k^2 = 1 - rho^2, complete elliptic integrals K, E of modulus k:

    K_II  = tau sqrt(pi a) rho cos(phi) k^2/(B f),   B = (k^2 - nu) E + nu rho^2 K,
    K_III = tau sqrt(pi a) (1 - nu) sin(phi) k^2/(B f),
    energy = int int [K_II^2 (1 - nu^2)/E + K_III^2 (1 + nu)/E] dA over the whole ellipse.

Tension on the embedded ellipse (Irwin, Green and Sneddon; tada2000, secondary) is in the same
file: K_I = sigma sqrt(pi a) f/E(k).

Independent: W is a two-dimensional quadrature over (a, phi), no elliptic integral enters.  The
energies of the embedded ellipse come from the opening (slip) delta0 sqrt(1 - x^2/c^2 - y^2/a^2)
and the Fourier symbol of the crack operator: energy = stress x volume / 2 and K from the slip at
the front; the script stops if these, the handbook K and the quadrature of G over the swept
area do not agree.
"""
from functools import cache

from mpmath import mp
from mpmath.calculus.quadrature import GaussLegendre

from reference_csv import Table, publish

d = cache(mp.mpf)  # decimal constant
NEWMAN_RAJU = "newmanraju1981 (secondary)"


@cache
def gauss(degree):
    """3 * 2^(degree - 1) Gauss-Legendre points and weights on (-1, 1)."""
    return GaussLegendre(mp).calc_nodes(degree, mp.prec)


def rule(ends, degree):
    return [((lo + hi) / 2 + x * (hi - lo) / 2, w * (hi - lo) / 2)
            for lo, hi in zip(ends[:-1], ends[1:]) for x, w in gauss(degree)]


def quad2(f, a, degree):
    """int_0^a ds int_0^(pi/2) dphi f(s, phi): exact in s (a polynomial; 3 * 2^(degree - 1) points),
    better than 1e-20 in phi (panels graded to the surface point: slender ellipses)."""
    angles = rule([0, d("0.15"), d("0.6"), mp.pi / 2], 4)
    return mp.fsum(w * v * f(s, phi) for s, w in rule([0, a], degree) for phi, v in angles)


def front(rho, phi):
    """f^2"""
    return mp.sqrt((rho * mp.cos(phi)) ** 2 + mp.sin(phi) ** 2)


def newman_raju(a, rho, t, phi):
    """K_I per unit stress; t = inf is the half-space."""
    alpha2 = (a / t) ** 2
    M1 = d("1.13") - d("0.09") * rho
    M2 = d("0.89") / (d("0.2") + rho) - d("0.54")
    M3 = d("0.5") - 1 / (d("0.65") + rho) + 14 * (1 - rho) ** 24
    g = 1 + (d("0.1") + d("0.35") * alpha2) * (1 - mp.sin(phi)) ** 2
    scale = mp.sqrt(mp.pi * a / flaw_shape(rho) * front(rho, phi))
    return scale * (M1 + M2 * alpha2 + M3 * alpha2 ** 2) * g


@cache
def flaw_shape(rho):
    """Q"""
    return 1 + d("1.464") * rho ** d("1.65")


@cache
def energy_integral(a, rho, t):
    """W"""
    return 2 * quad2(lambda s, phi: newman_raju(s, rho, t, phi) ** 2 * s / rho, a, 3)


# --- embedded ellipse ---


def K_opening(a, rho, phi):
    return mp.sqrt(mp.pi * a * front(rho, phi)) / opening_shape(rho)


def K_shear(a, rho, nu, phi):
    scale = mp.sqrt(mp.pi * a / front(rho, phi)) * shear_shape(rho, nu)
    return scale * rho * mp.cos(phi), scale * (1 - nu) * mp.sin(phi)


@cache
def opening_shape(rho):
    """E(k), with mpmath's parameter m = k^2"""
    return mp.ellipe(1 - rho ** 2)


@cache
def shear_shape(rho, nu):
    """k^2/B, in the limit k -> 0 for the penny"""
    m = 1 - rho ** 2
    if m == 0:
        return 4 / ((2 - nu) * mp.pi)
    return m / ((m - nu) * mp.ellipe(m) + nu * rho ** 2 * mp.ellipk(m))


def swept(release_rate, a, rho):
    """int int G dA over the whole ellipse grown at constant rho."""
    return 4 * quad2(lambda s, phi: release_rate(s, phi) * s / rho, a, 1)


def tension_energy(a, rho, E, nu):
    return swept(lambda s, phi: K_opening(s, rho, phi) ** 2 * (1 - nu ** 2) / E, a, rho)


def shear_energy(a, rho, E, nu):
    def release_rate(s, phi):
        K2, K3 = K_shear(s, rho, nu, phi)
        return K2 ** 2 * (1 - nu ** 2) / E + K3 ** 2 * (1 + nu) / E
    return swept(release_rate, a, rho)


def slip(a, rho, E, nu, mode):
    """delta0 per unit stress.  The Fourier symbol of the opening is mu |k|/(2(1 - nu)), that of
    a slip along x is mu [kx^2 + (1 - nu) ky^2]/(2(1 - nu)|k|)."""
    mu, c = E / (2 * (1 + nu)), a / rho

    def symbol(theta):
        x2, y2 = (mp.cos(theta) / c) ** 2, (mp.sin(theta) / a) ** 2
        return mp.sqrt(x2 + y2) if mode == "opening" else (x2 + (1 - nu) * y2) / mp.sqrt(x2 + y2)

    stress = mu / (8 * (1 - nu)) * 4 * mp.quad(symbol, [0, mp.pi / 4, mp.pi / 2])
    return 1 / stress


def slip_energy(a, rho, E, nu, mode):
    volume = slip(a, rho, E, nu, mode) * 2 * mp.pi / 3 * a * a / rho
    return volume / 2


def slip_K(a, rho, E, nu, phi):
    """(K_II, K_III) from the slip near the front, delta = delta0 sqrt(2 g d)."""
    mu, c = E / (2 * (1 + nu)), a / rho
    normal = mp.cos(phi) / c, mp.sin(phi) / a
    g = mp.hypot(*normal)
    K = mu * slip(a, rho, E, nu, "shear") * mp.sqrt(2 * g) * mp.sqrt(2 * mp.pi) / 4
    return K / (1 - nu) * normal[0] / g, K * normal[1] / g


def close(x, y, tolerance="1e-20"):
    return abs(x - y) <= mp.mpf(tolerance) * max(abs(x), abs(y), mp.mpf("1e-30"))


def surface_table():
    table = Table("surface_crack", "depth [m]", "aspect_ratio [1]", "depth_ratio [1]",
                  "front_angle [rad]")
    a = mp.mpf("1e-3")
    for rho in map(mp.mpf, "0.2 0.4 0.6 0.8 1".split()):
        for alpha in map(mp.mpf, "0 0.01 0.2 0.5 0.8".split()):
            t = a / alpha if alpha else mp.inf
            table.add("energy_integral", (a, rho, alpha, ""), energy_integral(a, rho, t), "m^3",
                      NEWMAN_RAJU)
            for quarter in range(3):
                phi = quarter * mp.pi / 4
                table.add("K_I_per_stress", (a, rho, alpha, phi), newman_raju(a, rho, t, phi),
                          "m^0.5", NEWMAN_RAJU)
    for rho in map(mp.mpf, "0.2 0.5 1".split()):
        table.add("Q", ("", rho, "", ""), flaw_shape(rho), "1", NEWMAN_RAJU)
        table.add("Phi", ("", rho, "", ""), opening_shape(rho), "1", "exact")
    # Boundary correction F = K sqrt(Q/(pi a))/sigma
    for rho, alpha, quarter in (("1", "0", 2), ("1", "0", 0), ("0.4", "0.4", 2)):
        rho, alpha, phi = mp.mpf(rho), mp.mpf(alpha), quarter * mp.pi / 4
        t = a / alpha if alpha else mp.inf
        F = newman_raju(a, rho, t, phi) * mp.sqrt(flaw_shape(rho) / (mp.pi * a))
        table.add("F", (a, rho, alpha, phi), F, "1", NEWMAN_RAJU)
    return table


def ellipse_table():
    table = Table("elliptical_crack_shear", "depth [m]", "aspect_ratio [1]",
                  "youngs_modulus [Pa]", "poissons_ratio [1]", "front_angle [rad]")
    E = mp.mpf("210e9")
    source = "kassirsih1966 (secondary); re-derived from the slip"
    a = mp.mpf("1e-3")
    for nu in map(mp.mpf, "0.3 0.25".split()):
        for rho in map(mp.mpf, "0.1 0.2 0.5 0.8 0.999 1".split()):
            for quarter in range(3):
                phi = quarter * mp.pi / 4
                K2, K3 = K_shear(a, rho, nu, phi)
                assert all(map(close, (K2, K3), slip_K(a, rho, E, nu, phi)))
                row = (a, rho, E, nu, phi)
                table.add("K_II_per_stress", row, 0 if quarter == 2 else K2,  # no 1e-41
                          "m^0.5", source)
                table.add("K_III_per_stress", row, K3, "m^0.5", source)
            row = (a, rho, E, nu, "")
            energies = shear_energy(a, rho, E, nu), tension_energy(a, rho, E, nu)
            for energy, mode in zip(energies, ("shear", "opening")):
                assert close(energy, slip_energy(a, rho, E, nu, mode))
            table.add("shear_energy_per_stress_squared", row, energies[0], "J/Pa^2", source)
            table.add("tension_energy_per_stress_squared", row, energies[1], "J/Pa^2",
                      "tada2000 (secondary); re-derived from the opening")
    # Textbook closed values: penny in tension and in shear, ellipse 1:2 in tension
    nu = mp.mpf("0.3")
    one = mp.mpf(1)
    exact = {
        ("penny.tension_energy", 1): (tension_energy(one, one, 1, nu), 8 * (1 - nu ** 2) / 3),
        ("penny.shear_energy", 1): (shear_energy(one, one, 1, nu),
                                    16 * (1 - nu ** 2) / (3 * (2 - nu))),
        ("ellipse.tension_energy", 0.5): (
            tension_energy(one, one / 2, 1, nu),
            4 * mp.pi / 3 * (1 - nu ** 2) * 2 / mp.ellipe(mp.mpf("0.75")))}
    for (case, rho), (value, closed) in exact.items():
        assert close(value, closed)
        table.add(f"unit_{case}", (1, mp.mpf(rho), 1, nu, ""), value, "J/Pa^2", "exact")
    return table


def tables():
    return [surface_table(), ellipse_table()]


if __name__ == "__main__":
    publish(*tables())
