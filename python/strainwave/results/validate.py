# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command validate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class BandFit(Part):
    """Discrepancy of the model in the bands."""

    classes: int
    """classes of size and ratio to which the bands are fitted"""
    values: int
    """values of the catalogue in these classes"""
    between: Quantity
    """root mean square of the mean errors of the classes, of ln K"""
    within: Quantity
    """standard deviation of the errors within a class, of ln K"""
    draws: Quantity
    """standard deviation by the draws of the proportions, of ln K"""
    discrepancy: Quantity
    """standard deviation of ln K by which the bands are wider than the draws; a fit of the
    bands, never of a prediction"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "classes": ("classes", _to.plain),
        "values": ("values", _to.plain),
        "between": ("between", _to.quantity),
        "within": ("within", _to.quantity),
        "draws": ("draws", _to.quantity),
        "discrepancy": ("discrepancy", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class BandTests(Part):
    """Values within their bands, with each class left out in turn."""

    of: AnyArray
    """class of size or ratio, or all of them in turn"""
    values: FloatArray
    """number of values"""
    in_band: FloatArray
    """values within bands that are fitted to all classes"""
    left_out: FloatArray
    """values within bands that are fitted to the other classes"""
    discrepancy: FloatArray
    """discrepancy of the bands that are fitted to the other classes"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "of": ("of", _to.entries),
        "values": ("values", _to.floats),
        "in_band": ("in_band", _to.floats),
        "left_out": ("left_out", _to.floats),
        "discrepancy": ("discrepancy", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "values": "1",
        "in_band": "1",
        "left_out": "1",
        "discrepancy": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class ValidatePart(Part):
    """Errors over groups of rows, a row as the mean over its ratios."""

    of: AnyArray
    """name of the group of rows"""
    rows: FloatArray
    """number of rows"""
    values: FloatArray
    """number of values"""
    median: FloatArray
    """median of |predicted/catalogue - 1|"""
    worst: FloatArray
    """largest of |predicted/catalogue - 1|"""
    median_K1: FloatArray
    """median for K1 alone"""
    median_K2: FloatArray
    """median for K2 alone"""
    median_K3: FloatArray
    """median for K3 alone"""
    worst_K1: FloatArray
    """largest for K1 alone"""
    worst_K2: FloatArray
    """largest for K2 alone"""
    worst_K3: FloatArray
    """largest for K3 alone"""
    spread_K1: FloatArray
    """median of largest/least - 1 over the ratios of a row, for K1"""
    spread_K2: FloatArray
    """median of largest/least - 1 over the ratios of a row, for K2"""
    spread_K3: FloatArray
    """median of largest/least - 1 over the ratios of a row, for K3"""
    in_band: FloatArray
    """number of values within the band"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "of": ("of", _to.entries),
        "rows": ("rows", _to.floats),
        "values": ("values", _to.floats),
        "median": ("median", _to.floats),
        "worst": ("worst", _to.floats),
        "median_K1": ("median_K1", _to.floats),
        "median_K2": ("median_K2", _to.floats),
        "median_K3": ("median_K3", _to.floats),
        "worst_K1": ("worst_K1", _to.floats),
        "worst_K2": ("worst_K2", _to.floats),
        "worst_K3": ("worst_K3", _to.floats),
        "spread_K1": ("spread_K1", _to.floats),
        "spread_K2": ("spread_K2", _to.floats),
        "spread_K3": ("spread_K3", _to.floats),
        "in_band": ("in_band", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "rows": "1",
        "values": "1",
        "median": "1",
        "worst": "1",
        "median_K1": "1",
        "median_K2": "1",
        "median_K3": "1",
        "worst_K1": "1",
        "worst_K2": "1",
        "worst_K3": "1",
        "spread_K1": "1",
        "spread_K2": "1",
        "spread_K3": "1",
        "in_band": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class ValidatePart2(Part):
    """Each row of the tables and its prediction, the mean over its ratios."""

    size: FloatArray
    """maker's size, in tenths of an inch"""
    ratio_class: AnyArray
    """30, 50, or 80 and more"""
    series: AnyArray
    """maker's series"""
    form: AnyArray
    """cup, or hat with the diaphragm outward"""
    length: AnyArray
    """length class of the flexspline"""
    origin: AnyArray
    """where the row comes from; only rows of the catalogue enter a fit"""
    ratios: FloatArray
    """reduction ratios over which predicted is the mean"""
    T1: FloatArray
    """upper torque of K1 [N*m]"""
    T2: FloatArray
    """upper torque of K2 [N*m]"""
    T3: FloatArray
    """upper torque of the comparison of K3 [N*m]"""
    catalogue_K1: FloatArray
    """stiffness that the table states [N*m/rad]"""
    predicted_K1: FloatArray
    """predicted, mean over the ratios [N*m/rad]"""
    least_K1: FloatArray
    """least prediction over the ratios [N*m/rad]"""
    most_K1: FloatArray
    """largest prediction over the ratios [N*m/rad]"""
    ratio_K1: FloatArray
    """predicted/catalogue"""
    low_K1: FloatArray
    """5 % quantile of the drawn predictions with the discrepancy [N*m/rad]"""
    middle_K1: FloatArray
    """50 % quantile of the drawn predictions with the discrepancy [N*m/rad]"""
    high_K1: FloatArray
    """95 % quantile of the drawn predictions with the discrepancy [N*m/rad]"""
    catalogue_K2: FloatArray
    """stiffness that the table states [N*m/rad]"""
    predicted_K2: FloatArray
    """predicted, mean over the ratios [N*m/rad]"""
    least_K2: FloatArray
    """least prediction over the ratios [N*m/rad]"""
    most_K2: FloatArray
    """largest prediction over the ratios [N*m/rad]"""
    ratio_K2: FloatArray
    """predicted/catalogue"""
    low_K2: FloatArray
    """5 % quantile of the drawn predictions with the discrepancy [N*m/rad]"""
    middle_K2: FloatArray
    """50 % quantile of the drawn predictions with the discrepancy [N*m/rad]"""
    high_K2: FloatArray
    """95 % quantile of the drawn predictions with the discrepancy [N*m/rad]"""
    catalogue_K3: FloatArray
    """stiffness that the table states [N*m/rad]"""
    predicted_K3: FloatArray
    """predicted, mean over the ratios [N*m/rad]"""
    least_K3: FloatArray
    """least prediction over the ratios [N*m/rad]"""
    most_K3: FloatArray
    """largest prediction over the ratios [N*m/rad]"""
    ratio_K3: FloatArray
    """predicted/catalogue"""
    low_K3: FloatArray
    """5 % quantile of the drawn predictions with the discrepancy [N*m/rad]"""
    middle_K3: FloatArray
    """50 % quantile of the drawn predictions with the discrepancy [N*m/rad]"""
    high_K3: FloatArray
    """95 % quantile of the drawn predictions with the discrepancy [N*m/rad]"""
    factors: FloatArray
    """values of the factors in the prediction"""
    at_limit: AnyArray
    """whether each factor is at a limit"""
    outside: AnyArray
    """why the row lies outside of what the bands were made from"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "size": ("size", _to.floats),
        "ratio_class": ("ratio_class", _to.entries),
        "series": ("series", _to.entries),
        "form": ("form", _to.entries),
        "length": ("length", _to.entries),
        "origin": ("origin", _to.entries),
        "ratios": ("ratios", _to.floats),
        "T1": ("T1", _to.floats),
        "T2": ("T2", _to.floats),
        "T3": ("T3", _to.floats),
        "catalogue_K1": ("catalogue_K1", _to.floats),
        "predicted_K1": ("predicted_K1", _to.floats),
        "least_K1": ("least_K1", _to.floats),
        "most_K1": ("most_K1", _to.floats),
        "ratio_K1": ("ratio_K1", _to.floats),
        "low_K1": ("low_K1", _to.floats),
        "middle_K1": ("middle_K1", _to.floats),
        "high_K1": ("high_K1", _to.floats),
        "catalogue_K2": ("catalogue_K2", _to.floats),
        "predicted_K2": ("predicted_K2", _to.floats),
        "least_K2": ("least_K2", _to.floats),
        "most_K2": ("most_K2", _to.floats),
        "ratio_K2": ("ratio_K2", _to.floats),
        "low_K2": ("low_K2", _to.floats),
        "middle_K2": ("middle_K2", _to.floats),
        "high_K2": ("high_K2", _to.floats),
        "catalogue_K3": ("catalogue_K3", _to.floats),
        "predicted_K3": ("predicted_K3", _to.floats),
        "least_K3": ("least_K3", _to.floats),
        "most_K3": ("most_K3", _to.floats),
        "ratio_K3": ("ratio_K3", _to.floats),
        "low_K3": ("low_K3", _to.floats),
        "middle_K3": ("middle_K3", _to.floats),
        "high_K3": ("high_K3", _to.floats),
        "factors": ("factors", _to.floats),
        "at_limit": ("at_limit", _to.entries),
        "outside": ("outside", _to.entries),
    }
    _units: ClassVar[dict[str, str]] = {
        "size": "1",
        "ratios": "1",
        "T1": "N*m",
        "T2": "N*m",
        "T3": "N*m",
        "catalogue_K1": "N*m/rad",
        "predicted_K1": "N*m/rad",
        "least_K1": "N*m/rad",
        "most_K1": "N*m/rad",
        "ratio_K1": "1",
        "low_K1": "N*m/rad",
        "middle_K1": "N*m/rad",
        "high_K1": "N*m/rad",
        "catalogue_K2": "N*m/rad",
        "predicted_K2": "N*m/rad",
        "least_K2": "N*m/rad",
        "most_K2": "N*m/rad",
        "ratio_K2": "1",
        "low_K2": "N*m/rad",
        "middle_K2": "N*m/rad",
        "high_K2": "N*m/rad",
        "catalogue_K3": "N*m/rad",
        "predicted_K3": "N*m/rad",
        "least_K3": "N*m/rad",
        "most_K3": "N*m/rad",
        "ratio_K3": "1",
        "low_K3": "N*m/rad",
        "middle_K3": "N*m/rad",
        "high_K3": "N*m/rad",
        "factors": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class SetsTried(Part):
    """Sets of factors fitted to all sizes at once."""

    factors: AnyArray
    """names of the factors"""
    values: FloatArray
    """fitted values of the factors"""
    at_limit: AnyArray
    """whether each factor is at a limit"""
    fitted: FloatArray
    """number of values to which the factors are fitted"""
    median: FloatArray
    """median of |error| over the fitted rows"""
    worst: FloatArray
    """largest of |error| over the fitted rows"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "factors": ("factors", _to.entries),
        "values": ("values", _to.floats),
        "at_limit": ("at_limit", _to.entries),
        "fitted": ("fitted", _to.floats),
        "median": ("median", _to.floats),
        "worst": ("worst", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "values": "1",
        "fitted": "1",
        "median": "1",
        "worst": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class ValidateResult(Result):
    """What `validate` answers."""

    mode: Literal["geometry", "leave-one-size-out", "leave-one-class-out", "per-row"]
    """which factors are fitted, and to what"""
    factors: tuple[Literal["support", "coning", "gap_factor", "pair_compliance", "structure", "clearance", "cam_flattening"], ...]
    """names of the fitted factors"""
    blank: Literal["ratio", "size"]
    """the wave for which the walls of the drives are made"""
    draws: int
    """drives drawn for the bands"""
    failed_draws: int
    """draws left out because they have no equilibrium"""
    seed: int
    """seed of the draws"""
    band_fit: Optional[BandFit]
    """discrepancy of the model in the bands; None if absent"""
    band_tests: BandTests
    """values within their bands, with each class left out in turn"""
    errors: ValidatePart
    """errors over groups of rows, a row as the mean over its ratios"""
    errors_at_each_ratio: ValidatePart
    """errors over groups of rows, each row at each ratio"""
    rows: ValidatePart2
    """each row of the tables and its prediction, the mean over its ratios"""
    each_ratio: ValidatePart2
    """each row of the tables and its prediction at each of its ratios"""
    sets_tried: SetsTried
    """sets of factors fitted to all sizes at once"""

    command: ClassVar[str] = "validate"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "markdown", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "mode": ("mode", _to.plain),
        "factors": ("factors", _to.many(_to.plain)),
        "blank": ("blank", _to.plain),
        "draws": ("draws", _to.plain),
        "failed_draws": ("failed_draws", _to.plain),
        "seed": ("seed", _to.plain),
        "band_fit": ("band_fit", BandFit._of),
        "band_tests": ("band_tests", BandTests._of),
        "errors": ("errors", ValidatePart._of),
        "errors_at_each_ratio": ("errors_at_each_ratio", ValidatePart._of),
        "rows": ("rows", ValidatePart2._of),
        "each_ratio": ("each_ratio", ValidatePart2._of),
        "sets_tried": ("sets_tried", SetsTried._of),
    }
