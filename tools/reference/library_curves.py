"""The curves between the entries of the library's tables of fitted numbers.

The entries are in tests/data/library_tables.csv, with the program that prints them as their source:
`annular_fourier.py --library`, `bar_surface.py --library`, `annular_hollow.py --library` (minutes to
half an hour each), `shell_tables.py` and `weight_function.py --fit`.  This script interpolates at the
entries and halfway between them, with 40 digits and by other formulas than the library's: Lagrange's
products instead of barycentric weights, Legendre's functions instead of powers, Floater and Hormann's
blended polynomials instead of their weights.
"""
import csv

from mpmath import (atan, cbrt, cos, exp, fdot, fsum, legendre, log, mp, mpf, pi, sin, sqrt)

from reference_csv import DATA, Table, publish

SOURCE = "library_curves.py"


def entries():
    """{table: {(i, j, k): entry}}"""
    tables = {}
    with open(DATA / "library_tables.csv", encoding="ascii", newline="") as file:
        for row in csv.DictReader(file):
            index = tuple(int(row[f"{name} [1]"]) for name in "ijk" if row[f"{name} [1]"])
            tables.setdefault(row["case"], {})[index] = mpf(row["value"])
    return tables


def lobatto(n, start, end):
    return [start + (end - start) * (1 - cos(pi * i / (n - 1))) / 2 for i in range(n)]


def lagrange(nodes, x):
    """Weights of the polynomial through values at the nodes, each a product."""
    weights = []
    for i, node in enumerate(nodes):
        weight = mpf(1)
        for j, other in enumerate(nodes):
            if j != i:
                weight *= (x - other) / (node - other)
        weights.append(weight)
    return weights


def polynomial_through(nodes, values, x):
    return fdot(lagrange(nodes, x), values)


def blended(nodes, values, x, degree=3):
    """Floater and Hormann's interpolant: a blend of the polynomials through degree + 1 neighbours."""
    if x in nodes:
        return values[nodes.index(x)]
    above = below = mpf(0)
    for i in range(len(nodes) - degree):
        weight = mpf((-1) ** i)
        for node in nodes[i:i + degree + 1]:
            weight /= x - node
        above += weight * polynomial_through(nodes[i:i + degree + 1], values[i:i + degree + 1], x)
        below += weight
    return above / below


def both(nodes):
    """The nodes and the middles between them."""
    return sorted([*nodes, *((a + b) / 2 for a, b in zip(nodes, nodes[1:]))])


def surface(over_rows, over_columns, entry):
    """The polynomial in both variables, by its weights over the rows and over the columns."""
    return fsum(u * v * entry(i, j) for i, u in enumerate(over_rows) if u
                for j, v in enumerate(over_columns) if v)


DEPTH = lobatto(9, 0, mpf("0.8"))
HOLE = {"tension": "1.1215 -0.7088 -0.0012 0.7249 -0.4998",
        "bending": "1.1215 -1.2814 0.456 0.396 -0.2676",
        "torsion": "1.0 -1.3547 1.5196 -1.0883 0.3478"}


def hole(load, alpha, rho):
    xi = alpha * (1 - rho) / (rho + alpha * (1 - rho))
    return sum(mpf(c) * xi ** n for n, c in enumerate(HOLE[load].split()))


def bars(table, data):
    wall = lobatto(8, 0, 1)

    def add(case, entries_of, lowest, divisor):
        def entry(i, j):
            return divisor(DEPTH[j], 1 - (1 - lowest) * wall[i] ** 2) / entries_of[i, j]
        for q in both(wall):
            rho = 1 - (1 - lowest) * q ** 2
            over_wall = lagrange(wall, q)
            for alpha in both(DEPTH):
                value = divisor(alpha, rho) / surface(over_wall, lagrange(DEPTH, alpha), entry)
                table.add(case, (alpha, rho, ""), value, "1", SOURCE)

    add("outer.bending", data["outer.bending"], mpf(0), lambda alpha, rho: mpf(1))
    for load in HOLE:
        add(f"inner.{load}", data[f"inner.{load}"], mpf("0.1"),
            lambda alpha, rho, load=load: hole(load, alpha, rho))
    nodes = lobatto(11, 0, mpf("0.9"))
    for n, load in enumerate(HOLE):
        for x in both(nodes):
            values = [1 / data["penny"][n, j] for j in range(11)]
            table.add(f"penny.{load}", (x, "", ""), 1 / polynomial_through(nodes, values, x), "1", SOURCE)


def front_at(d, k, entry):
    """Below the depth 0.1 the deep polynomial is corrected by a line times (d - 0.1)^2."""
    shallow, depths = [mpf("0.025"), mpf("0.05")], [mpf(n) / 10 for n in range(1, 6)]
    over_aspect = lagrange([mpf(n) / 4 for n in range(5)], k)

    def at(i):
        return fdot(over_aspect, [entry(i, j) for j in range(5)])

    def deep(x):
        return polynomial_through(depths, [at(i) for i in range(2, 7)], x)
    if d >= depths[0]:
        return deep(d)
    ends = [(at(i) - deep(x)) / (x - depths[0]) ** 2 for i, x in enumerate(shallow)]
    slope = (ends[1] - ends[0]) / (shallow[1] - shallow[0])
    return deep(d) + (d - depths[0]) ** 2 * (ends[0] + slope * (d - shallow[0]))


def fronts(table, data):
    aspects = [mpf(n) / 4 for n in range(5)]
    depths = [mpf("0.0125"), *both([mpf("0.025"), mpf("0.05")]), mpf("0.08"),
              *both([mpf(n) / 10 for n in range(1, 6)])]
    for mode in ("tension", "bending", "sliding", "tearing"):
        coefficients = data[f"front.{mode}"]
        for d in depths:
            for k in both(aspects):
                for t in (mpf("0.25"), mpf("0.5"), mpf("0.75"), mpf(1)):
                    def entry(i, j, t=t):
                        return sum(coefficients[i, j, n] * t ** (2 * n) for n in range(4))
                    value = front_at(d, k, entry)
                    table.add(f"front.{mode}", (d, k, t), value * (t if mode == "sliding" else 1),
                              "1", SOURCE)


def mapped(x):
    return x / (x + 3)


def shells(table, data):
    lambdas = [3 * u / (1 - u) for u in lobatto(12, 0, mapped(mpf(8)))]
    cosines = lobatto(7, 1, -1)
    for lam in both(lambdas):
        over_lambda = lagrange([mapped(x) for x in lambdas], mapped(lam))
        for cosine in both(cosines):
            beta = atan(sqrt((1 - cosine) / (1 + cosine))) if cosine > -1 else pi / 2
            over_angle = lagrange(cosines, cosine)
            nn, tn, bn, cn, nt, tt, bt, ct = (
                surface(over_angle, over_lambda, lambda j, i, c=c: data["shell"][c, j, i])
                for c in range(8))
            s, l2 = sin(2 * beta) if -1 < cosine < 1 else mpf(0), lam ** 2
            for case, value in (("opening_by_normal.mean", 1 + l2 * nn),
                                ("opening_by_normal.linear", -bn),
                                ("sliding_by_normal.mean", s * l2 * tn),
                                ("sliding_by_normal.linear", s * l2 * cn),
                                ("opening_by_shear.mean", s * l2 * nt),
                                ("opening_by_shear.linear", -s * bt),
                                ("sliding_by_shear.mean", 1 + l2 * tt),
                                ("sliding_by_shear.linear", l2 * ct)):
                table.add(case, (lam, beta, ""), value, "1", SOURCE)


def circumferential(table, data):
    lambdas = [3 * u / (1 - u) for u in lobatto(16, 0, mapped(mpf(24)))]
    alphas = lobatto(6, pi / 20, pi / 2)
    ratios = lobatto(4, log(5), log(60))
    middle = [(x + y) / 2 for x, y in zip(alphas, alphas[1:])][2], (ratios[1] + ratios[2]) / 2
    points = [(*middle, lam) for lam in both(lambdas)]
    points += [(a, y, mpf(2)) for a in both(alphas) for y in both(ratios)]
    for a, y, lam in points:
        over_lambda = lagrange([mapped(x) for x in lambdas], mapped(lam))
        nn, bn, tt, ct = (fdot(over_lambda, [data["circumferential"][c, i] for i in range(16)])
                          for c in range(4))
        over_alpha, over_ratio = lagrange(alphas, a), lagrange(ratios, y)
        t, tb, b, bb, s, sc = (surface(over_alpha, over_ratio,
                                       lambda i, j, c=c: data["finite_angle"][c, i, j])
                               for c in range(6))
        l2 = lam ** 2
        for case, value in (("axial.mean", 1 + l2 * nn + a ** 2 * t), ("axial.linear", -bn - a * tb),
                            ("bending.mean", 1 + l2 * nn + a ** 2 * b),
                            ("bending.linear", -bn - a * bb),
                            ("torque.mean", 1 + l2 * tt + a ** 2 * s),
                            ("torque.linear", l2 * ct + a * sc)):
            table.add(case, (a, exp(y), lam), value, "1", SOURCE)


def hollow(table, data):
    depths = [mpf(x) for x in "0.02 0.05 0.1 0.2 0.3 0.4 0.5 0.6 0.7 0.8".split()]
    torsion_rows = [mpf(x) for x in "0 0.1 0.2 0.3 0.4 0.5 0.6".split()] + [mpf(9) / 14]
    tension_rows = torsion_rows + [mpf(x) for x in "0.7 0.8 0.85 0.9 0.95".split()]
    torsion_rows += [mpf(x) for x in "0.7 0.8 0.9".split()]

    def shallow(rho):
        return 4 / ((1 + rho) * (1 + rho ** 2))

    def torsion(rho, alpha):
        curve = [mpf(0)]
        for j in range(10):
            radii = [cbrt(shallow(r) / data["hollow.torsion"][i, j])
                     for i, r in enumerate(torsion_rows)]
            curve.append(-3 * log(blended([*torsion_rows, mpf(1)], [*radii, mpf(1)], rho)))
        return shallow(rho) * exp(blended([mpf(0), *depths], curve, alpha))

    def tension(rho, alpha):
        curve = [mpf(1)]
        for j in range(10):
            logs = [log(data["hollow.tension"][i, j]) for i in range(len(tension_rows))]
            curve.append(exp(blended(tension_rows, logs, rho)))
        return blended([mpf(0), *depths], curve, alpha)

    for case, f, rows in (("hollow.torsion", torsion, torsion_rows),
                          ("hollow.tension", tension, tension_rows)):
        middles = [(x + y) / 2 for x, y in zip(rows, rows[1:])]
        for rho, alphas in [(r, depths) for r in rows] + [
                (m, [(x + y) / 2 for x, y in zip(depths, depths[1:])]) for m in middles]:
            for alpha in alphas:
                table.add(case, (alpha, rho, ""), f(rho, alpha), "1", SOURCE)


def edge_weights(table, data):
    for alpha in (mpf(n) / 13 for n in range(13)):
        deep = (1 - alpha) ** mpf("-1.5")
        x = 2 * alpha - 1
        parts = [(4 * j + 1) * pi / (2 * sqrt(2)) * deep *
                 sum(data["edge_weight"][j, k] * mp.chebyt(k, x) for k in range(11))
                 for j in range(6)]
        parts.append((1 - sum(p * legendre(2 * j, 0) for j, p in enumerate(parts))) /
                     legendre(12, 0))
        for v in (mpf(n) / 7 for n in range(8)):
            value = sum(p * legendre(2 * j, v) for j, p in enumerate(parts))
            table.add("edge_weight", (alpha, v, ""), value, "1", SOURCE)


def tables():
    table = Table("library_curves", "x [1]", "y [1]", "z [1]")
    data = entries()
    for part in (bars, fronts, shells, circumferential, hollow, edge_weights):
        part(table, data)
    return [table]


if __name__ == "__main__":
    publish(*tables())
