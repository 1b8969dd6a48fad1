#!/usr/bin/env python3
"""Lives of cracks whose rate varies from specimen to specimen and along the path.

A crack grows from size 1 to END by Paris' law with K proportional to the root of the size, so its
life is proportional to the integral of a^(-m/2) exp(-y(a)), with the deviation y of (GS-12).  Given
are the mean and the standard deviation of the life over that without scatter, by quadrature of
their double integral, and quantiles, from draws on a fine grid.

Independent of the C++: the product draws the correlated part as a chain of constant cells with
numbers that depend on their place.  This program integrates the covariance of the continuous
process; its draws take the root of the covariance matrix of a grid that is finer.
"""
import numpy as np
from reference_csv import Table, publish

END = 4.0
DRAWS = 200_000
# name: m, level, wander, wander_length, white, white_step
CASES = [
    (3.0, 0.2, 0.0, 1.0, 0.0, 1.0),
    (3.0, 0.0, 0.3, 0.2, 0.0, 1.0),
    (3.0, 0.0, 0.0, 1.0, 0.4, 0.05),
    (3.0, 0.1, 0.25, 0.15, 0.3, 0.1),
    (0.0, 0.0, 0.3, 0.5, 0.2, 0.25),  # constant K
]


def grid(white_step, n):
    """Ends of n parts of equal ln(size), with the ends of the white steps among them."""
    ends = np.exp(np.linspace(0, np.log(END), n + 1))
    steps = 1 + white_step * np.arange(1, int(np.ceil((END - 1) / white_step)))
    return np.unique(np.r_[ends, steps[steps < END - 1e-12]])


def weights(m, ends):
    """Shares of the parts in the life without scatter."""
    antiderivative = np.log(ends) if m == 2 else ends ** (1 - m / 2) / (1 - m / 2)
    parts = np.diff(antiderivative)
    return parts / parts.sum()


def covariance(case, ends):
    m, level, wander, length, white, step = case
    middle = np.sqrt(ends[1:] * ends[:-1])
    change = np.abs(np.log(middle)[:, None] - np.log(middle)[None, :])
    same = np.floor((middle - 1) / step + 1e-12)
    return (level**2 + wander**2 * np.exp(-change / length)
            + white**2 * (same[:, None] == same[None, :]))


def moments(case, n):
    ends = grid(case[5], n)
    w = weights(case[0], ends)
    total = case[1] ** 2 + case[2] ** 2 + case[4] ** 2
    second = np.exp(total) * (w @ np.expm1(covariance(case, ends)) @ w)
    return np.exp(total / 2), np.sqrt(second)


def quantiles(case, probabilities):
    ends = grid(case[5], 300)
    w = weights(case[0], ends)
    C = covariance(case, ends)
    values, vectors = np.linalg.eigh(C)
    root = vectors * np.sqrt(np.maximum(values, 0))
    rng = np.random.default_rng(20261130)
    lives = np.concatenate([np.exp(-rng.standard_normal((DRAWS // 20, len(w))) @ root.T) @ w
                            for _ in range(20)])
    return np.quantile(lives, probabilities)


def table_of(cases, with_draws):
    table = Table("scattered_paths", "m [1]", "level [1]", "wander [1]", "wander_length [1]",
                  "white [1]", "white_step [1]", "end [1]")
    for case in cases:
        mean, _ = moments(case, 1)
        # The kink of the covariance leaves an error of second order in the grid.
        coarse, fine = moments(case, 800)[1], moments(case, 1600)[1]
        deviation = (4 * fine - coarse) / 3
        inputs = [*case, END]
        table.add("mean", inputs, mean, "1", "normal deviations", digits=12)
        table.add("deviation", inputs, deviation, "1", "double integral of the covariance", digits=5)
        if not with_draws:
            continue
        low, median, high = quantiles(case, [0.05, 0.5, 0.95])
        table.add("low", inputs, low, "1", "200000 draws", digits=3, printed=6)
        table.add("median", inputs, median, "1", "200000 draws", digits=3, printed=6)
        table.add("high", inputs, high, "1", "200000 draws", digits=3, printed=6)
    return table


def some_tables():
    """Rows that take little time."""
    return [table_of(CASES[-1:], with_draws=False)]


def tables():
    return [table_of(CASES, with_draws=True)]


if __name__ == "__main__":
    publish(*tables())
