"""Life of a drive without cracks: bearing, critical plane, buckling of the barrel.

Bearing: Lundberg and Palmgren's rating in inches and pounds, with their constant 7450; the life as
the time at which a product of survivals of all places of both rings is 0.9, found by bisection.

Critical plane: a wave hoop = m + a cos, shear = t + b sin, on planes 0.02 degrees apart, with Haigh's
lines written as straight lines through their corners.

Buckling: Donnell's two equations for w and the stress function F over the length, with the waves
around the tube as exp(i n theta), by Chebyshev collocation; the smallest real eigenvalue k.
Independent: no sine series, no eliminated stress function.
"""
from mpmath import mp, mpf

from reference_csv import Table, publish

SOURCE = "tools/reference/drive_life.py"


# --- bearing -------------------------------------------------------------------------------------

def rating(f, gamma, ball, balls, inner):
    """Q_c [N] of a ball [m] from 7450 lb and inches."""
    side = 1 if inner else -1
    lb = mpf("4.4482216152605")
    inch = mpf("0.0254")
    return (lb * 7450 * (2 * f / (2 * f - 1)) ** mpf("0.41") * (1 - side * gamma) ** mpf("1.39")
            / (1 + side * gamma) ** (mpf(1) / 3) * gamma ** mpf("0.3")
            * (ball / inch) ** mpf("1.8") / mpf(balls) ** (mpf(1) / 3))


def survival(hours, qi, qo, duty):
    """Of both rings: each place of the inner ring on its own, the outer ring over all places."""
    e = mpf(10) / 9
    places = len(duty[0][0])
    turns = [speed * share * hours * 3600 for _, speed, share in duty]
    log = mpf(0)
    for i in range(places):
        used = sum(n * (forces[i] / qi) ** 3 for (forces, _, _), n in zip(duty, turns)) / 10 ** 6
        log += used ** e / places
    used = sum(n * sum((q / qo) ** 3 for q in forces) / places
               for (forces, _, _), n in zip(duty, turns)) / 10 ** 6
    return mpf("0.9") ** (log + used ** e)


def life(qi, qo, duty):
    low, high = mpf(10) ** -3, mpf(10) ** 9
    for _ in range(200):
        middle = mp.sqrt(low * high)
        if survival(middle, qi, qo, duty) > mpf("0.9"):
            low = middle
        else:
            high = middle
    return low


def bearing():
    table = Table("bearing_life", "f [1]", "gamma [1]", "ball [m]", "balls [1]")
    f, ball, balls = mpf("0.53"), mpf("0.0046735"), 23
    gamma = ball / (mpf("0.048957") / 2 + mpf("0.058304") / 2)
    for inner in (True, False):
        table.add("rating.inner" if inner else "rating.outer", [f, gamma, ball, balls],
                  rating(f, gamma, ball, balls, inner), "N", SOURCE, digits=3)
    first = [0, 100, 446, 315, 0, 62]
    second = [37, 250, 120, 0, 10, 400]
    duty = [(list(map(mpf, first)), mpf(30), mpf("0.25")),
            (list(map(mpf, second)), mpf(12), mpf("0.75"))]
    for name, loads in (("both", duty), ("first", [(duty[0][0], mpf(30), mpf(1))])):
        table.add(f"life.{name}", ["", "", "", ""], life(mpf(740), mpf(1000), loads) * 3600, "s",
                  SOURCE)
    return table


# --- critical plane ------------------------------------------------------------------------------

def haigh(a, m, M):
    """Amplitude at R = -1 along lines through the corners R = 0 and R = 1/2."""
    if a == 0:
        return mpf(0)
    zero = (1 / (1 + M), 1 / (1 + M))                       # (mean, amplitude) for 1 at R = -1
    half_a = (1 + M / 3) / (1 + M) ** 2
    half = (3 * half_a, half_a)

    def scale(p, q):
        # size s of the corner line through s p and s q that contains (m, a)
        cross = p[0] * q[1] - p[1] * q[0]
        return (m * (q[1] - p[1]) - a * (q[0] - p[0])) / cross
    if m < -a:
        return (1 - M) * a
    if m <= a:
        return scale((mpf(0), mpf(1)), zero)
    if m <= 3 * a:
        return scale(zero, half)
    return a / half_a


def planes():
    table = Table("critical_plane", "m [Pa]", "a [Pa]", "t [Pa]", "b [Pa]", "M [1]")
    strength, ratio = mpf(400), mpf("0.577")
    with mp.workdps(20):
        for m, a, t, b, M in ((0, 200, 0, 0, 0), (0, 0, 0, 100, 0), (50, 150, 60, 0, "0.3"),
                              (-120, 90, 20, 40, "0.2"), (100, 20, 200, 10, "0.25")):
            m, a, t, b, M = map(mpf, (m, a, t, b, M))
            worst = mpf(0)
            for step in range(0, 9000, 10):
                angle = mp.pi * step / 9000
                c, s = mp.cos(2 * angle), mp.sin(2 * angle)
                # hoop (1 + c)/2 + shear s and -hoop s/2 + shear c over a turn
                normal_a = mp.sqrt((a * (1 + c) / 2) ** 2 + (b * s) ** 2)
                normal_m = m * (1 + c) / 2 + t * s
                shear_a = mp.sqrt((a * s / 2) ** 2 + (b * c) ** 2)
                shear_m = abs(-m * s / 2 + t * c)
                used = mp.sqrt((haigh(normal_a, normal_m, M) / strength) ** 2
                               + (haigh(shear_a, shear_m, ratio * M) / (ratio * strength)) ** 2)
                worst = max(worst, used)
            table.add("wave", [m, a, t, b, M], worst, "1", SOURCE, digits=4, printed=8)
    return table


# --- buckling ------------------------------------------------------------------------------------

def chebyshev(n):
    import numpy as np
    x = np.cos(np.pi * np.arange(n + 1) / n)
    c = np.ones(n + 1)
    c[[0, -1]] = 2
    c *= (-1.0) ** np.arange(n + 1)
    dx = x[:, None] - x
    d = np.outer(c, 1 / c) / (dx + np.eye(n + 1))
    return x, d - np.diag(d.sum(axis=1))


def coefficient(Z, beta, n=40):
    """Smallest k > 0; the unknowns are w, w'', F, F'' on a length of pi, zero at both ends."""
    import numpy as np
    import scipy.linalg
    _, d = chebyshev(n)
    d = d * 2 / np.pi
    inner = slice(1, n)
    d1, d2 = d[inner, inner], (d @ d)[inner, inner]
    one, zero = np.eye(n - 1), np.zeros((n - 1, n - 1))
    couple = np.sqrt(12) * Z / np.pi ** 2
    # (D^2 - beta^2)^2 w - couple F'' = -2 i k beta w', (D^2 - beta^2)^2 F + couple w'' = 0
    square = [d2 - 2 * beta ** 2 * one, beta ** 4 * one]     # of the second derivative, of the value
    left = np.block([[d2, -one, zero, zero],
                     [zero, zero, d2, -one],
                     [square[1], square[0], zero, -couple * one],
                     [zero, couple * one, square[1], square[0]]]).astype(complex)
    right = np.zeros_like(left)
    right[2 * (n - 1):3 * (n - 1), 0:n - 1] = -2j * beta * d1
    values = scipy.linalg.eigvals(left, right)
    values = values[np.isfinite(values)]
    real = values[(abs(values.imag) < 1e-5 * abs(values.real)) & (values.real > 0)].real
    return real.min()


def buckling():
    import numpy as np
    from scipy.optimize import minimize_scalar
    table = Table("tube_buckling", "Z [1]")
    for Z in (0, 1, 5, 20, 100, 1000):
        grid = np.exp(np.linspace(np.log(0.5), np.log(30), 40))
        near = grid[np.argmin([coefficient(Z, b, 28) for b in grid])]
        found = minimize_scalar(lambda b: coefficient(Z, b), bounds=(near / 1.15, near * 1.15),
                                method="bounded", options={"xatol": 1e-6})
        table.add("simply supported", [Z], found.fun, "1", SOURCE, digits=5, printed=7)
    return table


def tables():
    return [bearing(), planes(), buckling()]


if __name__ == "__main__":
    publish(*tables())
