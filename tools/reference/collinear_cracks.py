"""Two collinear cracks and a row of them: stress intensity from a singular integral equation.

Cracks |x - x_j| < a on one line, unit stress at infinity, the same in modes I, II and III.  The
opening's slope f on each crack satisfies

    (1/pi) sum_j int f(u)/(x - u) du = 1,  int f du = 0 on each crack,

with cot(pi (x - u)/p) pi/p in place of 1/(x - u) for a row of pitch p.  With f = g/sqrt(1 - r^2)
on each crack, Gauss-Chebyshev quadrature makes it a linear system (Erdogan and Gupta), exponential
in the number of points; K/sqrt(pi a) = |g| at the tips.

Independent: no elliptic integral, no complex potential.
"""
import numpy as np

from reference_csv import Table, publish

SOURCE = "Gauss-Chebyshev solution of the integral equation"


def solve(a, centres, kernel, n):
    """[(g(-1), g(1)) of each crack]"""
    angle = np.pi * (2 * np.arange(1, n + 1) - 1) / (2 * n)
    points, x = np.cos(angle), np.cos(np.pi * np.arange(1, n) / n)
    m = len(centres)
    A, right = np.zeros((m * n, m * n)), np.zeros(m * n)
    for i, centre in enumerate(centres):
        for j, other in enumerate(centres):
            distance = centre - other + a * (x[:, None] - points)
            A[i * n:i * n + n - 1, j * n:j * n + n] = a * kernel(distance) / n
        A[i * n + n - 1, i * n:i * n + n] = 1
        right[i * n:i * n + n - 1] = 1
    g = np.linalg.solve(A, right).reshape(m, n)
    # interpolation of g to the ends
    signs = (-1.0) ** np.arange(n)
    upper = g @ (signs / np.tan(angle / 2)) / n
    lower = g @ (signs * np.tan(angle / 2)) / n
    return np.abs(np.stack([lower, upper], 1))


def two(a, d, n):
    left, right = solve(a, [-d, d], lambda x: 1 / x, n)
    assert abs(left[0] - right[1]) < 1e-10
    return right


def row(a, p, n):
    return solve(a, [0.0], lambda x: np.pi / p / np.tan(np.pi * x / p), n)[0, 1]


def tables():
    table = Table("collinear_cracks", "half_length [m]", "half_distance [m]")
    for ratio in (0.01, 0.3, 0.6, 0.9, 0.97):
        a = ratio * 0.01
        few, many = (two(ratio, 1.0, n) for n in (80, 120))
        for name, rough, fine in zip(("inner", "outer"), few, many):
            assert abs(rough / fine - 1) < 1e-9
            table.add(f"two.{name}", (a, 0.01), fine, "1", SOURCE, digits=9, printed=9)
        few, many = (row(ratio, 2.0, n) for n in (80, 120))
        assert abs(few / many - 1) < 1e-9
        table.add("row", (a, 0.01), many, "1", SOURCE, digits=9, printed=9)
    return [table]


if __name__ == "__main__":
    publish(*tables())
