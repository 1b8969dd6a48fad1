"""Through crack in the wall of a tube: added compliance over (axial force P, torque T).

Half-length a, angle beta from the generator toward -theta, mean radius r, wall delta:

    sigma_n = P sin^2(beta)/(2 pi r delta) + T sin(2 beta)/(2 pi r^2 delta),
    tau_n   = P sin(beta) cos(beta)/(2 pi r delta) + T cos(2 beta)/(2 pi r^2 delta),
    K_I = sigma_n sqrt(pi s),  K_II = tau_n sqrt(pi s),
    compliance_ij = int_0^a (2/E)(k_I,i k_I,j + k_II,i k_II,j) 2 delta ds      (plane stress),

of the flat sheet; shell_crack.py computes the curved wall.

Independent: the stresses on the crack come from rotating the stress tensor, the compliance from a
quadrature in s; the closed forms a^2/(2 pi E r^2 delta) [...] are not used.  The crack is open.
"""
from mpmath import mp

from reference_csv import Table, publish


def direction(degrees):
    """(z, theta) components of the crack line; exact zeros at multiples of 90 degrees."""
    return mp.cospi(mp.mpf(degrees) / 180), -mp.sinpi(mp.mpf(degrees) / 180)


def traction(degrees, r, wall):
    """[(sigma_n, tau_n) per unit P, per unit T]"""
    z, theta = direction(degrees)
    if abs(degrees) == 45:  # cos(2 beta) = 0 exactly
        theta = z if degrees < 0 else -z
    n, section = (-theta, z), 2 * mp.pi * r * wall
    out = []
    for sigma_z, tau in ((1 / section, 0), (0, 1 / (section * r))):
        t = (sigma_z * n[0] + tau * n[1], tau * n[0])  # stress tensor times the normal
        out.append((t[0] * n[0] + t[1] * n[1], t[0] * z + t[1] * theta))
    return out


def compliance(a, degrees, r, wall, E):
    """PP, PT, TT"""
    loads = traction(degrees, r, wall)

    def entry(i, j):
        def integrand(s):
            products = loads[i][0] * loads[j][0] + loads[i][1] * loads[j][1]
            return 2 / E * mp.pi * s * products * 2 * wall
        return mp.quad(integrand, [0, a], method="gauss-legendre")

    return entry(0, 0), entry(0, 1), entry(1, 1)


def tables():
    table = Table("through_crack", "half_length [m]", "angle [rad]", "mean_radius [m]",
                  "wall_thickness [m]", "youngs_modulus [Pa]", "poissons_ratio [1]")
    r, wall = mp.mpf("78.88e-3"), mp.mpf("2.24e-3")
    E, nu = mp.mpf("210e9"), mp.mpf("0.3")
    units = {"axial": "m/N", "coupling": "rad/N", "torsion": "rad/(N*m)"}
    for a in map(mp.mpf, ("1e-4", "1e-3", "5e-3")):
        for degrees in (-60, -45, -30, 0, 30, 45, 70, 90):
            values = compliance(a, degrees, r, wall, E)
            row = (a, mp.pi * degrees / 180, r, wall, E, nu)
            for (entry, unit), value in zip(units.items(), values):
                table.add(f"flat.{entry}", row, value, unit, "Griffith")
    # Griffith: plate of thickness delta under uniform tension, energy pi sigma^2 a^2 delta/E
    tt = compliance(mp.mpf("1e-3"), 45, r, wall, E)[2]
    sigma = 1 / (2 * mp.pi * r ** 2 * wall)
    assert abs(tt / (2 * mp.pi * sigma ** 2 * mp.mpf("1e-6") * wall / E) - 1) < mp.mpf("1e-30")
    return [table]


if __name__ == "__main__":
    publish(*tables())
