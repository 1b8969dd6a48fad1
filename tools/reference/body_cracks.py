"""Elliptical crack sheared along its minor axis; circular crack under torsion.

Both from the displacement of the faces, which has a closed shape, and from the stress that it
makes on the plane of the crack, in Fourier or Hankel transforms:

  * ellipse: slip delta0 sqrt(1 - x^2/c^2 - y^2/a^2) along y.  The symbol of a slip along y is
    mu [(1 - nu) kx^2 + ky^2]/(2 (1 - nu) |k|); the stress is mu/(2 (1 - nu)) delta0 times
    the integral of [(1 - nu) X + Y]/sqrt(X + Y) over a quarter turn, X = (cos t/c)^2 and
    Y = (sin t/a)^2;
  * circle: displacement u0 (r/a) sqrt(1 - r^2/a^2) of each face around the axis; u0 by energy.

K from the slip next to the front, energy = half of the work of the stress on the slip.  The
script stops if the energy is not the integral of G over the area swept at constant shape.

Independent: no complete elliptic integral; nothing of a handbook.
"""
from mpmath import mp

from reference_csv import Table, publish

SOURCE = "derived from the slip"


def minor_shear(a, rho, nu, mu=1):
    """delta0 per unit stress"""
    c = a / rho

    def symbol(t):
        X, Y = (mp.cos(t) / c) ** 2, (mp.sin(t) / a) ** 2
        return ((1 - nu) * X + Y) / mp.sqrt(X + Y)
    return 2 * (1 - nu) / mu / mp.quad(symbol, [0, mp.pi / 8, mp.pi / 4, mp.pi / 2])


def front_K(a, rho, nu, phi, slip, mu=1):
    """(K_II, K_III) of a slip along y: near the front it is slip sqrt(2 g d), g the slope."""
    normal = mp.cos(phi) * rho / a, mp.sin(phi) / a
    g = mp.hypot(*normal)
    K = mu * slip * mp.sqrt(2 * g) * mp.sqrt(2 * mp.pi) / 4
    return K / (1 - nu) * normal[1] / g, K * normal[0] / g


def torsion_displacement():
    """u_0/(tau/mu) of the face displacement u_0 r sqrt(1 - r^2), a = 1, by energy.

    Its transform of order 1 is j_2(k)/k.  Twice the energy of one half, 2 pi mu u_0^2 int
    j_2^2 dk, is the work 2 pi tau int r^3 sqrt(1 - r^2) dr u_0 of the linear stress."""
    def j2(k):
        return (3 / k ** 3 - 1 / k) * mp.sin(k) - 3 / k ** 2 * mp.cos(k)
    far = 100 * mp.pi  # beyond, sin^2(k)/k^2 is 1/(2 k^2) on average
    energy = mp.quad(lambda k: j2(k) ** 2, mp.linspace(mp.mpf("1e-3"), far, 101)) + 1 / (2 * far)
    return mp.quad(lambda r: r ** 3 * mp.sqrt(1 - r * r), [0, 1]) / energy


def tables():
    mp.dps = 30
    table = Table("body_cracks", "semi_minor [m]", "aspect_ratio [1]", "poissons_ratio [1]",
                  "front_angle [rad]")
    a = mp.mpf("0.002")
    for nu in map(mp.mpf, ("0.3", "0.2")):
        for rho in map(mp.mpf, "0.1 0.4 0.8 1".split()):
            slip = minor_shear(a, rho, nu)
            energy = slip * (2 * mp.pi / 3) * a * a / rho / 2
            # G = (1 - nu)/2 K_II^2 + K_III^2/2 for mu = 1

            def rate(phi):
                K2, K3 = front_K(a, rho, nu, phi, slip)
                return (1 - nu) / 2 * K2 ** 2 + K3 ** 2 / 2
            swept = 4 * mp.quad(rate, [0, mp.pi / 8, mp.pi / 4, mp.pi / 2]) * a * a / rho / 3
            assert abs(swept / energy - 1) < mp.mpf("1e-15")
            for phi in map(mp.mpf, ("0", "0.7", "1.4")):
                K2, K3 = front_K(a, rho, nu, phi, slip)
                table.add("minor_shear.K_II", (a, rho, nu, phi), K2, "m^0.5", SOURCE, digits=15)
                table.add("minor_shear.K_III", (a, rho, nu, phi), K3, "m^0.5", SOURCE, digits=15)
            table.add("minor_shear.mu_energy", (a, rho, nu, ""), energy, "m^3", SOURCE, digits=15)
    mp.dps = 40
    assert abs(torsion_displacement() / (4 / (3 * mp.pi)) - 1) < mp.mpf("1e-5")
    # face displacement (4/(3 pi)) (tau/mu) r sqrt(1 - r^2/a^2): K = mu u sqrt(2 pi/d)/2 at d -> 0
    K = mp.mpf(4) / (3 * mp.pi) * a * mp.sqrt(2 / a) * mp.sqrt(2 * mp.pi) / 2
    energy = mp.mpf(4) / (3 * mp.pi) / a * 2 * mp.pi * mp.quad(
        lambda r: r ** 3 * mp.sqrt(1 - (r / a) ** 2), [0, a])
    table.add("penny.torsion.K_III", (a, 1, "", ""), K, "m^0.5", SOURCE, digits=15)
    table.add("penny.torsion.mu_energy", (a, 1, "", ""), energy, "m^3", SOURCE, digits=15)
    return [table]


if __name__ == "__main__":
    publish(*tables())
