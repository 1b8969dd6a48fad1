# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command fit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Knots(Part):
    """Median rate of growth."""

    delta_K: FloatArray
    """range of the stress intensity factor [Pa*m^0.5]"""
    rate: FloatArray
    """median growth in a cycle [m]"""
    relative_error: FloatArray
    """standard error of the logarithm of the rate"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "delta_K": ("delta_K", _to.floats),
        "rate": ("rate", _to.floats),
        "relative_error": ("relative_error", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "delta_K": "Pa*m^0.5",
        "rate": "m",
        "relative_error": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Scatter(Part):
    """Parameters of the scatter."""

    name: AnyArray
    """what varies"""
    value: FloatArray
    """its value"""
    error: FloatArray
    """standard error; absent if the records do not determine the value"""
    identified: AnyArray
    """whether the value exceeds two standard errors"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.entries),
        "value": ("value", _to.floats),
        "error": ("error", _to.floats),
        "identified": ("identified", _to.entries),
    }
    _units: ClassVar[dict[str, str]] = {
        "value": "1",
        "error": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Basis(Part):
    """What law and scatter are stated for."""

    test: str
    """how the ranges of the stress intensity factor were found"""
    stress_ratio: Optional[Quantity]
    """R of the test, as stated; absent: not stated; None if absent"""
    from_: Quantity
    """least range of a step of the records [Pa*m^0.5]"""
    to: Quantity
    """greatest range of a step of the records [Pa*m^0.5]"""
    step: Quantity
    """geometric mean of the lengths of the steps [m]"""
    pivot: Quantity
    """range at which the level of a specimen holds [Pa*m^0.5]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "test": ("test", _to.plain),
        "stress_ratio": ("stress_ratio", _to.quantity),
        "from": ("from_", _to.quantity),
        "to": ("to", _to.quantity),
        "step": ("step", _to.quantity),
        "pivot": ("pivot", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Tried(Part):
    """Numbers of knots that were tried."""

    knots: AnyArray
    """number of knots of the median rate"""
    log_likelihood: FloatArray
    """logarithm of the likelihood"""
    criterion: FloatArray
    """Bayesian information criterion; the least is taken"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "knots": ("knots", _to.entries),
        "log_likelihood": ("log_likelihood", _to.floats),
        "criterion": ("criterion", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "log_likelihood": "1",
        "criterion": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Checks(Part):
    """Bands of unseen specimens against their records."""

    known: FloatArray
    """size up to which the specimen's own record was known; absent: nothing [m]"""
    size: FloatArray
    """size whose cycles were predicted [m]"""
    specimens: AnyArray
    """specimens that reached the size"""
    inside: AnyArray
    """specimens inside of their band"""
    fewest: AnyArray
    """lower end of the numbers inside that a right model has with 99 %"""
    most: AnyArray
    """upper end of them"""
    mean_width: FloatArray
    """mean width of the bands in cycles"""
    width_over_lognormal: FloatArray
    """mean width over that of a log-normal distribution fitted to the same specimens"""
    width_over_unknown: FloatArray
    """mean width over that without the specimen's own record"""
    distance: FloatArray
    """largest distance of the probability transforms from uniform"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "known": ("known", _to.floats),
        "size": ("size", _to.floats),
        "specimens": ("specimens", _to.entries),
        "inside": ("inside", _to.entries),
        "fewest": ("fewest", _to.entries),
        "most": ("most", _to.entries),
        "mean_width": ("mean_width", _to.floats),
        "width_over_lognormal": ("width_over_lognormal", _to.floats),
        "width_over_unknown": ("width_over_unknown", _to.floats),
        "distance": ("distance", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "known": "m",
        "size": "m",
        "mean_width": "1",
        "width_over_lognormal": "1",
        "width_over_unknown": "1",
        "distance": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Bands(Part):
    """Band of each specimen."""

    specimen: AnyArray
    """name of the specimen"""
    known: FloatArray
    """size up to which its own record was known; absent: nothing [m]"""
    size: FloatArray
    """size whose cycles are predicted [m]"""
    cycles: FloatArray
    """measured cycles from the first size, or from the known one"""
    low: FloatArray
    """lower end of the band"""
    median: FloatArray
    """median"""
    high: FloatArray
    """upper end of the band"""
    transform: FloatArray
    """probability that the model gives to fewer cycles than measured"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "specimen": ("specimen", _to.entries),
        "known": ("known", _to.floats),
        "size": ("size", _to.floats),
        "cycles": ("cycles", _to.floats),
        "low": ("low", _to.floats),
        "median": ("median", _to.floats),
        "high": ("high", _to.floats),
        "transform": ("transform", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "known": "m",
        "size": "m",
        "cycles": "1",
        "low": "1",
        "median": "1",
        "high": "1",
        "transform": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class FitResult(Result):
    """What `fit` answers."""

    specimens: int
    """specimens of the fit"""
    steps: int
    """their steps of growth"""
    pooled_exponent: Quantity
    """exponent m of one straight line through all steps"""
    pooled_log_coefficient: Quantity
    """ln C of this line, in metres per cycle at 1 MPa*sqrt(m)"""
    pooled_deviation: Quantity
    """standard deviation of a step from this line"""
    knots: Knots
    """median rate of growth"""
    scatter: Scatter
    """parameters of the scatter"""
    basis: Basis
    """what law and scatter are stated for"""
    tried: Tried
    """numbers of knots that were tried"""
    log_likelihood: Quantity
    """logarithm of the likelihood"""
    converged: bool
    """whether the search found a maximum"""
    reason: str
    """how the search ended"""
    judged_by: Literal["leave_one_out", "other_specimens"]
    """specimens of which the bands were judged"""
    confidence: Quantity
    """probability of a band"""
    checks: Checks
    """bands of unseen specimens against their records"""
    coverage: Optional[Quantity]
    """mean share of specimens inside, over the bands without own record; None if absent"""
    bands: Bands
    """band of each specimen"""

    command: ClassVar[str] = "fit"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "toml", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "specimens": ("specimens", _to.plain),
        "steps": ("steps", _to.plain),
        "pooled_exponent": ("pooled_exponent", _to.quantity),
        "pooled_log_coefficient": ("pooled_log_coefficient", _to.quantity),
        "pooled_deviation": ("pooled_deviation", _to.quantity),
        "knots": ("knots", Knots._of),
        "scatter": ("scatter", Scatter._of),
        "basis": ("basis", Basis._of),
        "tried": ("tried", Tried._of),
        "log_likelihood": ("log_likelihood", _to.quantity),
        "converged": ("converged", _to.plain),
        "reason": ("reason", _to.plain),
        "judged_by": ("judged_by", _to.plain),
        "confidence": ("confidence", _to.quantity),
        "checks": ("checks", Checks._of),
        "coverage": ("coverage", _to.quantity),
        "bands": ("bands", Bands._of),
    }
