"""Torsion of the sound flexspline (tube, flat diaphragm, boss) and bending of a thin ring.

    tube, boss   compliance = L/(mu int r^2 dA)
    diaphragm    annular plate twisted in its plane: compliance = int dr/(2 pi mu h r^3),
                 shear stress T/(2 pi r^2 h), h thickness (exact)
    ring         thin ring under U equal radial loads F, equally spaced; radial displacement under
                 a load per load, from the bending energy of the sector between two loads,
                 half angle theta = pi/U.  Equilibrium: N0 = F/(2 sin theta) in mid-sector, moment
                 M(phi) = M0 + N0 R (1 - cos phi); symmetry: int M dphi = 0 gives M0.  Each load
                 does the work of one sector: u = 2 (energy of a sector)/F.

Source: statics; the ring is a table entry of Roark's formulas (secondary).
Independent: quadratures without polar moment and without a closed ring formula.  One load alone
(U = 1) cannot be in equilibrium.
"""
from mpmath import mp

from reference_csv import Table, publish


def shaft_compliance(outer, inner, length, mu):
    moment = mp.quad(lambda r: r ** 2 * 2 * mp.pi * r, [inner, outer])
    return length / (mu * moment)


def diaphragm_compliance(outer, inner, thickness, mu):
    def twist(r):  # d(u_theta/r)/dr per unit torque = gamma/r
        return 1 / (2 * mp.pi * r ** 2 * thickness * mu) / r
    return mp.quad(twist, mp.linspace(inner, outer, 3))


def ring_compliance(radius, waves, bending_stiffness):
    theta = mp.pi / waves
    N0 = 1 / (2 * mp.sin(theta))  # F = 1

    def bending(phi):
        return N0 * radius * (1 - mp.cos(phi))

    M0 = -mp.quad(bending, [-theta, theta]) / (2 * theta)
    energy = mp.quad(lambda phi: (M0 + bending(phi)) ** 2 * radius / (2 * bending_stiffness),
                     [-theta, theta])
    return 2 * energy


def torsion_table():
    table = Table("tube_and_diaphragm", "outer_radius [m]", "inner_radius [m]",
                  "length_or_thickness [m]", "shear_modulus [Pa]")
    mu = mp.mpf("80e9")

    def add(case, compliance, *geometry):
        geometry = tuple(map(mp.mpf, geometry))
        table.add(case, (*geometry, mu), compliance(*geometry, mu), "rad/(N*m)", "statics")

    add("tube", shaft_compliance, "0.08", "0.07776", "0.16")  # the article's flexspline
    add("tube", shaft_compliance, "0.0308", "0.03", "0.06")
    add("tube", shaft_compliance, "0.035", "0.0225", "0.2")  # the article's output shaft
    add("boss", shaft_compliance, "0.03", "0.02", "0.012")
    add("boss", shaft_compliance, "0.03", "0", "0.2")
    for inner in ("0.03", "0.05", "0.075"):
        add("diaphragm", diaphragm_compliance, "0.07888", inner, "0.00224")
    return table


def ring_table():
    table = Table("ring_bending", "mean_radius [m]", "wave_number [1]",
                  "bending_stiffness [N*m^2]")
    for radius, stiffness in (("0.06", "350"), ("0.03", "12.5")):
        for waves in (2, 3, 4):
            row = (mp.mpf(radius), waves, mp.mpf(stiffness))
            table.add("radial_compliance_per_load", row, ring_compliance(*row), "m/N", "statics")
    return table


def tables():
    with mp.workdps(60):
        return [torsion_table(), ring_table()]


if __name__ == "__main__":
    publish(*tables())
