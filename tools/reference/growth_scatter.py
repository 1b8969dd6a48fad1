#!/usr/bin/env python3
"""Likelihood of measured crack growth, with the covariance of each record as a full matrix.

Equations (GS-1), (GS-4), (GS-5), (GS-7) for the specimens of examples/growth_specimens.csv: at given
parameters, and at the most likely ones.  Independent of the C++: the product filters along a
record and uses Newton's method; this program factors the full covariance and uses the simplex of
Nelder and Mead.  `--specimens` prints that example, which is drawn from the model.
`--forms FILE STRESS_RANGE WIDTH` (MPa, mm) compares forms of the scatter on measured specimens with
six knots: memory in ln a or in a, with and without a slope of each specimen; and the deviation of
ln N that each gives at some sizes with that of the specimens.
"""
import csv
import pathlib
import sys

import numpy as np
from scipy.optimize import minimize

ROOT = pathlib.Path(__file__).resolve().parents[2]
STRESS_RANGE = 60.0  # MPa
WIDTH = 100.0  # mm
WHITE_STEP = 1.0  # mm
TRUE = dict(level=0.08, tilt=0.1, slope=0.15, wander=0.15, log_length=-2.5, white=0.08)
NAMES = list(TRUE)


def delta_k(a):
    """(GS-1) in MPa*sqrt(m); a in mm."""
    return STRESS_RANGE * np.sqrt(np.pi * a / np.cos(np.pi * a / WIDTH) / 1000)


def covariance(p, size, length, x):
    """(GS-4): steps at mean sizes and of lengths in mm, x = ln(Delta K) - pivot."""
    b0 = np.full(len(x), p["level"]) + p["tilt"] * x
    b1 = p["slope"] * x
    change = np.abs(np.log(size)[:, None] - np.log(size)[None, :])
    wander = p["wander"] ** 2 * np.exp(-change / np.exp(p["log_length"]))
    white = np.diag(p["white"] ** 2 * WHITE_STEP / length)
    return np.outer(b0, b0) + np.outer(b1, b1) + wander + white


def weights(x, knots):
    return np.array([np.interp(x, knots, unit) for unit in np.eye(len(knots))]).T


def specimens():
    rng = np.random.default_rng(20261128)
    a = np.array([8 + 0.4 * k for k in range(21)] + [16 + 0.8 * k for k in range(1, 21)])
    middle, length = (a[1:] + a[:-1]) / 2, np.diff(a)
    lk = np.log(delta_k(middle))
    pivot = (lk[0] + lk[-1]) / 2
    root = np.linalg.cholesky(covariance(TRUE, middle, length, lk - pivot))
    median = np.log(8e-11) + 3.1 * lk
    print("# Drawn by tools/reference/growth_scatter.py from the model (GS-4); no test was made.")
    print("# Plate 100 mm wide, crack in its middle, range of the stress 60 MPa.")
    columns = []
    for _ in range(16):
        y = median + root @ rng.standard_normal(len(lk))
        columns.append(np.r_[0, np.cumsum(length / 1000 / np.exp(y))])
    print("crack_length [mm]," + ",".join(f"drawn_{k + 1:02d} [cycle]" for k in range(16)))
    for i, size in enumerate(a):
        print(f"{size:.1f}," + ",".join(f"{column[i]:.0f}" for column in columns))


def records():
    lines = [line for line in open(ROOT / "examples/growth_specimens.csv") if line[0] != "#"]
    table = np.array(list(csv.reader(lines))[1:], float)
    a, n = table[:, 0], table[:, 1:]
    middle, length = (a[1:] + a[:-1]) / 2, np.diff(a)
    return middle, length, np.log(delta_k(middle)), np.log(length[:, None] / 1000 / np.diff(n, axis=0))


def log_likelihood(p, knots_number):
    middle, length, lk, y = records()
    knots = np.linspace(lk[0], lk[-1], knots_number)
    B = weights(lk, knots)
    C = covariance(p, middle, length, lk - (lk[0] + lk[-1]) / 2)
    inverse = np.linalg.inv(C)
    m = y.shape[1]
    rates = np.linalg.solve(B.T @ inverse @ B, B.T @ inverse @ y.mean(1))
    r = y - (B @ rates)[:, None]
    value = -0.5 * (m * (np.linalg.slogdet(C)[1] + len(lk) * np.log(2 * np.pi))
                    + np.einsum("is,ij,js->", r, inverse, r))
    return value, rates, np.linalg.inv(B.T @ inverse @ B) / m


SOURCE = "full covariance matrices"
CASES = ((2, TRUE), (5, TRUE), (3, dict(TRUE, tilt=-0.2, log_length=-0.5, wander=0.3)),
         (2, dict(TRUE, level=0, tilt=0, slope=0, wander=0)))


def add(table, what, knots, p):
    value, rates, variances = log_likelihood(p, knots)
    inputs = [knots, *(p[name] for name in NAMES)]
    best = what == "best"
    table.add(f"{what}_likelihood", inputs, value, "1", SOURCE, digits=9)
    table.add(f"{what}_first_rate", inputs, rates[0], "1", SOURCE, digits=6 if best else 9)
    table.add(f"{what}_first_variance", inputs, variances[0, 0], "1", SOURCE,
              digits=4 if best else 8)


def some_tables():
    """The rows of given parameters; the searches take 20 s."""
    from reference_csv import Table

    table = Table("growth_scatter", "knots [1]", *(f"{name} [1]" for name in NAMES))
    for knots, p in CASES:
        add(table, "at", knots, p)
    return [table]


def found(knots, free):
    """The most likely parameters; those that are not free are 0."""
    start = [TRUE[name] for name in free]
    zero = {**dict.fromkeys(NAMES, 0.0), "log_length": -2.0}

    def of(values):
        return {**zero, **dict(zip(free, values))}

    best = minimize(lambda v: -log_likelihood(of(v), knots)[0], start, method="Nelder-Mead",
                    options=dict(xatol=1e-7, fatol=1e-9, maxiter=20000, maxfev=20000,
                                 adaptive=True))
    p = of(best.x)
    if p["level"] < 0:
        p["tilt"] = -p["tilt"]
    return {name: p[name] if name in ("tilt", "log_length") else abs(p[name]) for name in NAMES}


def tables():
    table = some_tables()[0]
    for knots, free in ((2, NAMES), (2, ["level", "white"]),
                        (3, ["level", "wander", "log_length", "white"])):
        add(table, "best", knots, found(knots, free))
    return [table]


def forms(path, stress_range, width):
    table = np.array(list(csv.reader(line for line in open(path) if line[0] != "#"))[1:], float)
    a, n = table[:, 0], table[:, 1:]
    middle, length = (a[1:] + a[:-1]) / 2, np.diff(a)
    lk = np.log(stress_range * np.sqrt(np.pi * middle / np.cos(np.pi * middle / width) / 1000))
    y = np.log(length[:, None] / 1000 / np.diff(n, axis=0))
    x = lk - (lk[0] + lk[-1]) / 2
    B = weights(lk, np.linspace(lk[0], lk[-1], 6))
    normals = np.random.default_rng(1).standard_normal((len(lk), 4000))
    for memory, place, log_length in (("ln a", np.log(middle), -2.5), ("a", middle, 0.5)):
        change = np.abs(place[:, None] - place[None, :])

        def matrix(v):
            b0, b1 = v[0] + v[1] * x, v[2] * x
            return (np.outer(b0, b0) + np.outer(b1, b1) + v[3] ** 2 * np.exp(-change / np.exp(v[4]))
                    + np.diag(v[5] ** 2 * WHITE_STEP / length))

        def likelihood(v):
            C = matrix(v)
            inverse = np.linalg.inv(C)
            rates = np.linalg.solve(B.T @ inverse @ B, B.T @ inverse @ y.mean(1))
            r = y - (B @ rates)[:, None]
            value = -0.5 * (y.shape[1] * (np.linalg.slogdet(C)[1] + len(lk) * np.log(2 * np.pi))
                            + np.sum(r * (inverse @ r)))
            return value, rates

        for slope in (True, False):
            free = [0, 1, 2, 3, 4, 5] if slope else [0, 3, 4, 5]

            def of(values):
                v = np.zeros(6)
                v[free] = values
                return v

            start = np.array([0.08, 0.1, 0.05, 0.15, log_length, 0.07])[free]
            for _ in range(2):
                start = minimize(lambda v: -likelihood(of(v))[0], start, method="Nelder-Mead",
                                 options=dict(xatol=1e-4, fatol=1e-3, maxiter=3000)).x
            value, rates = likelihood(of(start))
            drawn = (B @ rates)[:, None] + np.linalg.cholesky(matrix(of(start))) @ normals
            cycles = np.cumsum(length[:, None] / 1000 * np.exp(-drawn), axis=0)
            ratios = [np.std(np.log(cycles[i - 1])) / np.std(np.log(n[i] - n[0]), ddof=1)
                      for i in np.searchsorted(a, np.linspace(a[0], a[-1], 6)[1:] - 1e-9)]
            print(f"memory in {memory}, slope {slope}: log likelihood {value:.1f}; deviation of ln N "
                  "over measured " + ", ".join(f"{ratio:.2f}" for ratio in ratios), flush=True)


def main():
    if "--specimens" in sys.argv[1:]:
        specimens()
        return
    if "--forms" in sys.argv[1:]:
        forms(sys.argv[2], float(sys.argv[3]), float(sys.argv[4]))
        return
    from reference_csv import publish

    publish(*tables())


if __name__ == "__main__":
    main()
