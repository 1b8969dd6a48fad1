#!/usr/bin/env python3
"""Curves of detection fitted to trials, with their 95 % bound.

Equations (IR-12), (IR-13), (IR-14), (IR-17) for examples/detection_hits.csv and
examples/detection_signals.csv, once also with the ends of a scale.  Independent of the C++: the product uses Newton's method, and a
closed form for signals; this program uses the simplex of Nelder and Mead, and searches the other
parameter of a bound of hits by it too.  For the bound of signals it integrates the probability over
the scatter, and the product uses a function for the non-central t.  `--trials` writes the two examples, which are drawn from a model.
"""
import csv
import pathlib
import sys

import numpy as np
from scipy.integrate import quad
from scipy.optimize import brentq, minimize
from scipy.stats import chi, logistic, nct, norm

ROOT = pathlib.Path(__file__).resolve().parents[2]
HITS = ROOT / "examples" / "detection_hits.csv"
SIGNALS = ROOT / "examples" / "detection_signals.csv"
THRESHOLD = 120.0
FLOOR, CEILING = 60.0, 400.0
FALL = norm.ppf(0.95) ** 2
FORMS = {"log_logistic": logistic, "log_normal": norm}


def write_trials():
    rng = np.random.default_rng(7)
    head = "# Drawn by tools/reference/detection_fit.py from a model; no test was made.\n"
    size = np.round(np.exp(rng.uniform(np.log(0.3), np.log(5), 60)), 2)
    hit = rng.random(60) < logistic.cdf(np.log(size / 1.1) / 0.35)
    HITS.write_text(head + "size [mm],hit\n" + "".join(f"{a:.2f},{int(h)}\n" for a, h in zip(size, hit)))
    size = np.round(np.exp(rng.uniform(np.log(0.3), np.log(5), 30)), 2)
    signal = np.exp(np.log(100) + 1.1 * np.log(size) + 0.3 * rng.standard_normal(30))
    SIGNALS.write_text(head + "size [mm],signal\n"
                       + "".join(f"{a:.2f},{s:.1f}\n" for a, s in zip(size, signal)))


def read(path):
    rows = [row for row in csv.reader(path.read_text().splitlines()) if not row[0].startswith("#")]
    return np.array(rows[1:], float).T


def hits_likelihood(form):
    size, hit = read(HITS)
    x, law = np.log(size), FORMS[form]

    def value(x50, width):
        z = (x - x50) / width
        return float(np.sum(np.where(hit == 1, law.logcdf(z), law.logsf(z)))) if width > 0 else -1e9

    return value, lambda p: law.ppf(p), x


def signal_likelihood(floor=0.0, ceiling=np.inf):
    size, signal = read(SIGNALS)
    x, y = np.log(size), np.log(np.clip(signal, floor, ceiling))
    below, above = signal <= floor, signal >= ceiling

    def value(x50, width, rise):
        if width <= 0 or rise <= 0:
            return -1e9
        law = norm(np.log(THRESHOLD) + rise * (x - x50), width * rise)
        return float(np.sum(np.where(below, law.logcdf(y), np.where(above, law.logsf(y), law.logpdf(y)))))

    return value, norm.ppf, x


def limited_bound(z):
    """The same for signals with a scale (IR-17), by differences of the likelihood of each trial."""
    size, signal = read(SIGNALS)
    x, y = np.log(size), np.log(np.clip(signal, FLOOR, CEILING) / THRESHOLD)
    below, above = signal <= FLOOR, signal >= CEILING
    known = np.sum(~below & ~above)
    value = signal_likelihood(FLOOR, CEILING)[0]
    x50, width, rise = largest(value, [np.mean(x), 0.3, 1.0])[0]
    r = y / (width * rise) - (x - x50) / width

    def part(r):
        return np.where(below, norm.logcdf(r), np.where(above, norm.logsf(r), norm.logpdf(r)))

    weight = -(part(r + 1e-4) - 2 * part(r) + part(r - 1e-4)) / 1e-8
    design = np.stack([np.ones(len(x)), x], axis=1)
    inverse = np.linalg.inv(design.T @ (weight[:, None] * design))

    def left(place):
        at = np.array([1.0, place])
        root = np.sqrt(at @ inverse @ at)
        return nct.cdf((place - x50) / width * np.sqrt((known - 2) / known) / root, known - 2, z / root) - 0.95

    return left


def signal_bound(z):
    """The confidence that the argument z lies below a place, less 0.95 (IR-14)."""
    size, signal = read(SIGNALS)
    x, v = np.log(size), np.log(signal / THRESHOLD)
    n = len(x)
    design = np.stack([np.ones(n), x], axis=1)
    line, rest = np.linalg.lstsq(design, v, rcond=None)[:2]
    scatter = np.sqrt(rest[0] / (n - 2))
    inverse = np.linalg.inv(design.T @ design)

    def left(place):
        at = np.array([1.0, place])
        root = np.sqrt(at @ inverse @ at)
        t = (at @ line) / (scatter * root)
        below = quad(lambda w: norm.cdf(t * w / np.sqrt(n - 2) - z / root) * chi.pdf(w, n - 2),
                     0, 60, points=[np.sqrt(n - 2)], epsabs=1e-13, epsrel=1e-12, limit=400)[0]
        return below - 0.95

    return left


def largest(function, start):
    best = start
    for _ in range(6):
        best = minimize(lambda v: -function(*v), best, method="Nelder-Mead",
                        options=dict(xatol=1e-11, fatol=1e-13, maxiter=20000, maxfev=20000)).x
    return best, function(*best)


def fitted(value, ppf, x, rest, bound):
    best, top = largest(value, [np.mean(x), 0.3, *rest])
    found = {"log_likelihood": (top, "1", 9), "a50": (np.exp(best[0]) / 1e3, "m", 7),
             "a90": (np.exp(best[0] + best[1] * ppf(0.9)) / 1e3, "m", 7)}
    for name, p in (("a50_bound", 0.5), ("a90_bound", 0.9)):
        z = ppf(p)
        if bound:
            place = best[0] + best[1] * z
            found[name] = (np.exp(brentq(bound(z), place, place + 1, xtol=1e-12)) / 1e3, "m", 7)
            continue
        start = [best[1:]]

        def left(place):
            start[0], at = largest(lambda width, *more: value(place - z * width, width, *more), start[0])
            return 2 * (top - at) - FALL

        place = best[0] + best[1] * z
        end = place + 0.05
        while left(end) < 0:
            end += 0.05
        found[name] = (np.exp(brentq(left, end - 0.05, end, xtol=1e-11)) / 1e3, "m", 7)
    return found


def tables():
    from reference_csv import Table

    table = Table("detection_fit")
    for case, parts in (("hits_log_logistic", (*hits_likelihood("log_logistic"), [], None)),
                        ("hits_log_normal", (*hits_likelihood("log_normal"), [], None)),
                        ("signals", (*signal_likelihood(), [1.0], signal_bound)),
                        ("limited", (*signal_likelihood(FLOOR, CEILING), [1.0], limited_bound))):
        for name, (number, unit, digits) in fitted(*parts).items():
            source = "simplex of Nelder and Mead"
            if name.endswith("bound") and case == "signals":
                source = "integral over the scatter"
            elif name.endswith("bound") and case == "limited":
                source, digits = "simplex and differences of the likelihood", 5
            table.add(f"{case}_{name}", [], number, unit, source, digits=digits)
    return [table]


def main():
    if "--trials" in sys.argv[1:]:
        write_trials()
        return
    from reference_csv import publish

    publish(*tables())


if __name__ == "__main__":
    main()
