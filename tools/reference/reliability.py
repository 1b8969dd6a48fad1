"""Reliability of a closed-form limit by OpenTURNS.

Independent of the C++: distributions, search of the design point (Abdo and Rackwitz), curvatures
and probabilities are those of OpenTURNS (Debian's python3-openturns); nothing is shared.

The limit: a drive of two springs in series, k = 1/(1/(a x1) + 1/(b x2 x3^3)), must be at least
k_min.  x1 is lognormal (median 1, relative standard deviation 0.15), x2 Weibull (mean 1, 0.08), x3
uniform (mean 1, 0.05).  Cases: beta, the design point in standard normal space, the probabilities of
first and second order (Hohenbichler and Rackwitz), and the probability by a quadrature over x2 and
x3 with x1 integrated exactly.  The cases "correlated_..." give the inputs the rank correlations 0.6
of x1 with x2 and -0.3 of x2 with x3, in a normal copula.
"""
import math

import openturns as ot
import numpy as np

from reference_csv import Table, publish

SOURCE = "OpenTURNS 1.20"
A, B = 3.0, 2.0


def weibull(mean, deviation):
    ratio = lambda k: math.gamma(1 + 2 / k) / math.gamma(1 + 1 / k) ** 2 - 1 - deviation ** 2
    low, high = 1.0, 200.0
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if ratio(middle) > 0 else (low, middle)
    return ot.WeibullMin(mean / math.gamma(1 + 1 / low), low, 0.0)


def inputs(correlated):
    sigma = math.sqrt(math.log1p(0.15 ** 2))
    half = 0.05 * math.sqrt(3)
    ranks = ot.CorrelationMatrix(3)
    if correlated:
        ranks[0, 1], ranks[1, 2] = 0.6, -0.3
    copula = ot.NormalCopula(ot.NormalCopula.GetCorrelationFromSpearmanCorrelation(ranks))
    return ot.ComposedDistribution(
        [ot.LogNormal(0.0, sigma, 0.0), weibull(1.0, 0.08), ot.Uniform(1 - half, 1 + half)], copula)


def exact(k_min):
    """P(k < k_min): for given x2, x3 the limit is one of x1, whose distribution is known."""
    sigma = math.sqrt(math.log1p(0.15 ** 2))
    nodes, weights = np.polynomial.legendre.leggauss(400)
    u, w = (nodes + 1) / 2, weights / 2
    law = weibull(1.0, 0.08)
    # Map the unit interval so that both tails of x2 are resolved.
    x2 = np.array([law.computeQuantile(float(p))[0] for p in 3 * u ** 2 - 2 * u ** 3])
    w2 = w * (6 * u - 6 * u ** 2)
    x3 = 1 + 0.05 * math.sqrt(3) * (2 * u - 1)
    second = B * np.outer(x2, x3 ** 3)
    rest = 1 / k_min - 1 / second  # must not exceed 1/(A x1)
    with np.errstate(divide="ignore"):
        x1 = np.where(rest > 0, 1 / (A * np.maximum(rest, 1e-300)), np.inf)
    below = np.array([[0.5 * math.erfc(-math.log(x) / sigma / math.sqrt(2)) for x in row]
                      for row in x1])
    return float(w2 @ below @ w)


def tables():
    table = Table("reliability", "k_min [1]")
    function = ot.SymbolicFunction(["x1", "x2", "x3"], [f"1/(1/({A}*x1)+1/({B}*x2*x3^3))"])
    for k_min, correlated in [(k, c) for c in (False, True) for k in (0.95, 0.85, 0.75)]:
        event = ot.ThresholdEvent(
            ot.CompositeRandomVector(function, ot.RandomVector(inputs(correlated))), ot.Less(),
            k_min)
        search = ot.AbdoRackwitz()
        search.setMaximumAbsoluteError(1e-12)
        search.setMaximumRelativeError(1e-12)
        search.setMaximumConstraintError(1e-12)
        search.setMaximumResidualError(1e-12)
        search.setMaximumIterationNumber(1000)
        form = ot.SORM(search, event, inputs(correlated).getMean())
        form.run()
        result = form.getResult()
        prefix = "correlated_" if correlated else ""
        add = lambda case, value: table.add(prefix + case, [k_min], value=value, unit="1", digits=7,
                                            source=SOURCE)
        add("beta", result.getHasoferReliabilityIndex())
        for i, z in enumerate(result.getStandardSpaceDesignPoint()):
            add(f"design_{i + 1}", z)
        first = ot.FORM(search, event, inputs(correlated).getMean())
        first.run()
        add("first_order", first.getResult().getEventProbability())
        add("second_order", result.getEventProbabilityHohenbichler())
        if not correlated:
            table.add("exact", [k_min], value=exact(k_min), unit="1", digits=5, source="quadrature")
    return [table]


if __name__ == "__main__":
    publish(*tables())
