"""Newman and Raju's fits of 1984 (secondary: typed from memory): surface, corner, embedded crack.

K = (S_t + H S_b) sqrt(pi a/Q) F; a into the thickness, c along the width, phi from the end of c.
The table has F/sqrt(Q) and H F/sqrt(Q) as the library defines its factors; plate width and
thickness included.  Written down here in the form of the report, coefficient by coefficient, in
the angle functions of its text; the library shares powers and branches.

Independent: only the typing.  cracked_block.py decides whether the fits are right.
"""
from mpmath import mp

from reference_csv import Table, publish

d = mp.mpf
SOURCE = "newmanraju1984 (secondary)"


def f_phi(a_c, phi):
    if a_c <= 1:
        return (a_c ** 2 * mp.cos(phi) ** 2 + mp.sin(phi) ** 2) ** d("0.25")
    return (a_c ** -2 * mp.sin(phi) ** 2 + mp.cos(phi) ** 2) ** d("0.25")


def Q(a_c):
    return 1 + d("1.464") * (a_c if a_c <= 1 else 1 / a_c) ** d("1.65")


def secant(c_b, a_t):
    return mp.sqrt(mp.sec(mp.pi * c_b / 2 * mp.sqrt(a_t)))


def H(a_c, a_t, phi, constant):
    c_a = 1 / a_c
    if a_c <= 1:
        p = d("0.2") + a_c + d("0.6") * a_t
        H1 = 1 - d("0.34") * a_t - d("0.11") * a_c * a_t
        G21 = -d("1.22") - d("0.12") * a_c
        G22 = constant - d("1.05") * a_c ** d("0.75") + d("0.47") * a_c ** d("1.5")
    else:
        p = d("0.2") + c_a + d("0.6") * a_t
        G11 = -d("0.04") - d("0.41") * c_a
        G12 = d("0.55") - d("1.93") * c_a ** d("0.75") + d("1.38") * c_a ** d("1.5")
        H1 = 1 + G11 * a_t + G12 * a_t ** 2
        G21 = -d("2.11") + d("0.77") * c_a
        G22 = constant - d("0.72") * c_a ** d("0.75") + d("0.14") * c_a ** d("1.5")
    H2 = 1 + G21 * a_t + G22 * a_t ** 2
    return H1 + (H2 - H1) * mp.sin(phi) ** p


def surface(a_c, a_t, c_b, phi):
    c_a, s = 1 / a_c, mp.sin(phi)
    if a_c <= 1:
        M = (d("1.13") - d("0.09") * a_c, -d("0.54") + d("0.89") / (d("0.2") + a_c),
             d("0.5") - 1 / (d("0.65") + a_c) + 14 * (1 - a_c) ** 24)
        g = 1 + (d("0.1") + d("0.35") * a_t ** 2) * (1 - s) ** 2
    else:
        M = (mp.sqrt(c_a) * (1 + d("0.04") * c_a), d("0.2") * c_a ** 4, -d("0.11") * c_a ** 4)
        g = 1 + (d("0.1") + d("0.35") * c_a * a_t ** 2) * (1 - s) ** 2
    F = (M[0] + M[1] * a_t ** 2 + M[2] * a_t ** 4) * g * f_phi(a_c, phi) * secant(c_b, a_t)
    return F / mp.sqrt(Q(a_c)), H(a_c, a_t, phi, d("0.55"))


def corner(a_c, a_t, c_b, phi):
    c_a, s, c = 1 / a_c, mp.sin(phi), mp.cos(phi)
    if a_c <= 1:
        M = (d("1.08") - d("0.03") * a_c, -d("0.44") + d("1.06") / (d("0.3") + a_c),
             -d("0.5") + d("0.25") * a_c + d("14.8") * (1 - a_c) ** 15)
        short_t = a_t
    else:
        M = (mp.sqrt(c_a) * (d("1.08") - d("0.03") * c_a), d("0.375") * c_a ** 2,
             -d("0.25") * c_a ** 2)
        short_t = a_t * c_a
    g1 = 1 + (d("0.08") + d("0.4") * short_t ** 2) * (1 - s) ** 3
    g2 = 1 + (d("0.08") + d("0.15") * short_t ** 2) * (1 - c) ** 3
    x = c_b * mp.sqrt(a_t)
    f_w = (1 - d("0.2") * x + d("9.4") * x ** 2 - d("19.4") * x ** 3 + d("27.1") * x ** 4)
    F = (M[0] + M[1] * a_t ** 2 + M[2] * a_t ** 4) * g1 * g2 * f_phi(a_c, phi) * f_w
    return F / mp.sqrt(Q(a_c)), H(a_c, a_t, phi, d("0.64"))


def embedded(a_c, a_t, c_b, phi):
    M1 = 1 if a_c <= 1 else mp.sqrt(1 / a_c)
    M2 = d("0.05") / (d("0.11") + a_c ** d("1.5"))
    M3 = d("0.29") / (d("0.23") + a_c ** d("1.5"))
    g = 1 - a_t ** 4 * mp.sqrt(d("2.6") - 2 * a_t) / (1 + 4 * a_c) * abs(mp.cos(phi))
    F = (M1 + M2 * a_t ** 2 + M3 * a_t ** 4) * g * f_phi(a_c, phi) * secant(c_b, a_t)
    return F / mp.sqrt(Q(a_c)), None


def tables():
    table = Table("newman_raju", "aspect_ratio [1]", "depth_ratio [1]", "width_ratio [1]",
                  "front_angle [rad]")
    for name, crack in (("surface", surface), ("corner", corner), ("embedded", embedded)):
        for a_c in map(d, "0.2 0.5 1 1.25 2".split()):
            for a_t in map(d, "0.3 0.7".split()):
                for c_b in map(d, "0.1 0.4".split()):
                    for phi in map(d, "0 0.6 1.5".split()):
                        F, ratio = crack(a_c, a_t, c_b, phi)
                        row = (a_c, a_t, c_b, phi)
                        table.add(f"{name}.tension", row, F, "1", SOURCE)
                        if ratio is not None:
                            table.add(f"{name}.bending", row, F * ratio, "1", SOURCE)
    return [table]


if __name__ == "__main__":
    publish(*tables())
