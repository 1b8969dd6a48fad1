# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command calibrate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Factors(Part):
    """Each factor, and how well the targets determine it."""

    name: AnyArray
    """name of the factor"""
    meaning: AnyArray
    """meaning of the factor"""
    before: FloatArray
    """value in the file"""
    value: FloatArray
    """calibrated value"""
    uncertainty: FloatArray
    """one standard uncertainty of the value"""
    at_limit: AnyArray
    """whether the fit stopped at a limit of the factor"""
    plausible: AnyArray
    """whether the value lies in the plausible range"""
    identified: AnyArray
    """whether the targets determine the factor"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.entries),
        "meaning": ("meaning", _to.entries),
        "before": ("before", _to.floats),
        "value": ("value", _to.floats),
        "uncertainty": ("uncertainty", _to.floats),
        "at_limit": ("at_limit", _to.entries),
        "plausible": ("plausible", _to.entries),
        "identified": ("identified", _to.entries),
    }
    _units: ClassVar[dict[str, str]] = {
        "before": "1",
        "value": "1",
        "uncertainty": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Combinations(Part):
    """Directions in the space of factors."""

    weights: FloatArray
    """components along ln(factor), or along factor/range"""
    singular_value: FloatArray
    """change of the vector of ln K per unit step along the direction"""
    uncertainty: FloatArray
    """one standard uncertainty along the direction"""
    identified: AnyArray
    """whether the targets determine the combination"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "weights": ("weights", _to.floats),
        "singular_value": ("singular_value", _to.floats),
        "uncertainty": ("uncertainty", _to.floats),
        "identified": ("identified", _to.entries),
    }
    _units: ClassVar[dict[str, str]] = {
        "weights": "1",
        "singular_value": "1",
        "uncertainty": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Stiffness(Part):
    """Each stiffness before and after the fit."""

    name: AnyArray
    """name of the stiffness"""
    from_torque: FloatArray
    """torque at which the interval begins [N*m]"""
    to_torque: FloatArray
    """torque at which the interval ends [N*m]"""
    wanted: FloatArray
    """target stiffness [N*m/rad]"""
    before: FloatArray
    """predicted with the file's values [N*m/rad]"""
    after: FloatArray
    """predicted with the fitted factors [N*m/rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.entries),
        "from_torque": ("from_torque", _to.floats),
        "to_torque": ("to_torque", _to.floats),
        "wanted": ("wanted", _to.floats),
        "before": ("before", _to.floats),
        "after": ("after", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "from_torque": "N*m",
        "to_torque": "N*m",
        "wanted": "N*m/rad",
        "before": "N*m/rad",
        "after": "N*m/rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class TransferErrors(Part):
    """Errors of the same calibration and prediction over the catalogue's sizes of 17 and more,
    without the values of fitted rows."""

    to: AnyArray
    """class of the predicted ratio"""
    sizes: FloatArray
    """number of sizes"""
    values: FloatArray
    """number of values; a row of several ratios counts at each of them"""
    median: FloatArray
    """median of |predicted/stated - 1|"""
    worst: FloatArray
    """largest of |predicted/stated - 1|"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "to": ("to", _to.entries),
        "sizes": ("sizes", _to.floats),
        "values": ("values", _to.floats),
        "median": ("median", _to.floats),
        "worst": ("worst", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "sizes": "1",
        "values": "1",
        "median": "1",
        "worst": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Predictions(Part):
    """Each stiffness at each ratio."""

    ratio: FloatArray
    """reduction ratio"""
    name: AnyArray
    """name of the stiffness"""
    from_torque: FloatArray
    """torque at which the interval begins [N*m]"""
    to_torque: FloatArray
    """torque at which the interval ends [N*m]"""
    predicted: FloatArray
    """predicted with the fitted factors [N*m/rad]"""
    series: AnyArray
    """series whose table states the ratio"""
    stated: FloatArray
    """stiffness that the table states [N*m/rad]"""
    same_row: AnyArray
    """whether the calibration was fitted to the row that states it"""
    error: FloatArray
    """predicted/stated - 1"""
    usual_error: FloatArray
    """median error of such predictions over the catalogue"""
    worst_error: FloatArray
    """largest error of such predictions over the catalogue"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "ratio": ("ratio", _to.floats),
        "name": ("name", _to.entries),
        "from_torque": ("from_torque", _to.floats),
        "to_torque": ("to_torque", _to.floats),
        "predicted": ("predicted", _to.floats),
        "series": ("series", _to.entries),
        "stated": ("stated", _to.floats),
        "same_row": ("same_row", _to.entries),
        "error": ("error", _to.floats),
        "usual_error": ("usual_error", _to.floats),
        "worst_error": ("worst_error", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "ratio": "1",
        "from_torque": "N*m",
        "to_torque": "N*m",
        "predicted": "N*m/rad",
        "stated": "N*m/rad",
        "error": "1",
        "usual_error": "1",
        "worst_error": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class OtherRatios(Part):
    """Predictions at other ratios of the size, and their errors."""

    from_: Quantity
    """calibrated ratio"""
    size: int
    """size of the drive in the catalogue"""
    form: Literal["cup", "hat"]
    """cup, or hat with the diaphragm outward"""
    length: Literal["standard", "short", "flat"]
    """length class of the flexspline"""
    blank: Literal["ratio", "size"]
    """the wave for which the walls of the other drives are made"""
    geometry_difference: Quantity
    """largest difference in K1 to K3 between the typical drive with the fitted factors and the
    calibrated drive, at the calibrated ratio"""
    median: Optional[Quantity]
    """median of |error| over the other ratios, without the values of the fitted row; None if
    absent"""
    worst: Optional[Quantity]
    """largest |error|, likewise; None if absent"""
    left_out: int
    """sizes left out of transfer_errors because a drive cannot be computed"""
    transfer_errors: TransferErrors
    """errors of the same calibration and prediction over the catalogue's sizes of 17 and more,
    without the values of fitted rows"""
    predictions: Predictions
    """each stiffness at each ratio"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "from": ("from_", _to.quantity),
        "size": ("size", _to.plain),
        "form": ("form", _to.plain),
        "length": ("length", _to.plain),
        "blank": ("blank", _to.plain),
        "geometry_difference": ("geometry_difference", _to.quantity),
        "median": ("median", _to.quantity),
        "worst": ("worst", _to.quantity),
        "left_out": ("left_out", _to.plain),
        "transfer_errors": ("transfer_errors", TransferErrors._of),
        "predictions": ("predictions", Predictions._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class FrictionFriction(Part):
    """The fitted friction, as in drivetrain.friction."""

    coulomb: Quantity
    """friction torque while it turns [N*m]"""
    breakaway: Quantity
    """torque that moves it from rest; at least coulomb [N*m]"""
    stribeck_speed: Quantity
    """speed over which breakaway falls to coulomb [rad/s]"""
    bristle_stiffness: Quantity
    """stiffness while it sticks [N*m/rad]"""
    bristle_damping: Quantity
    """damping while it sticks [N*m*s/rad]"""
    viscous: Quantity
    """friction torque over the speed [N*m*s/rad]"""
    load_coulomb: Quantity
    """share of the torque on the load, over the ratio, that adds to coulomb; in
    drivetrain.friction only"""
    thinning: Quantity
    """share of viscous that is lost per kelvin of warming, as the grease thins [1/K]"""
    warming: Quantity
    """temperature of the grease above that at which viscous was measured [K]"""
    load_breakaway: Optional[Quantity]
    """share of the torque on the load, over the ratio, that adds to breakaway; load_coulomb if
    left out; in drivetrain.friction only"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "coulomb": ("coulomb", _to.quantity),
        "breakaway": ("breakaway", _to.quantity),
        "stribeck_speed": ("stribeck_speed", _to.quantity),
        "bristle_stiffness": ("bristle_stiffness", _to.quantity),
        "bristle_damping": ("bristle_damping", _to.quantity),
        "viscous": ("viscous", _to.quantity),
        "load_coulomb": ("load_coulomb", _to.quantity),
        "thinning": ("thinning", _to.quantity),
        "warming": ("warming", _to.quantity),
        "load_breakaway": ("load_breakaway", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Values(Part):
    """The four values: wanted, fitted and simulated."""

    quantity: AnyArray
    """which of the four values"""
    unit: AnyArray
    """unit of the values"""
    wanted: AnyArray
    """the given value"""
    fitted: AnyArray
    """value of the fitted friction by its formula"""
    residual: FloatArray
    """fitted over wanted, less 1"""
    simulated: AnyArray
    """value that a simulated test of the fitted drive measures"""
    error: FloatArray
    """simulated over wanted, less 1"""
    reason: AnyArray
    """why the simulated test has no value"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "quantity": ("quantity", _to.entries),
        "unit": ("unit", _to.entries),
        "wanted": ("wanted", _to.entries),
        "fitted": ("fitted", _to.entries),
        "residual": ("residual", _to.floats),
        "simulated": ("simulated", _to.entries),
        "error": ("error", _to.floats),
        "reason": ("reason", _to.entries),
    }
    _units: ClassVar[dict[str, str]] = {
        "residual": "1",
        "error": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Friction(Part):
    """Friction of the input that is fitted to a maker's four values."""

    friction: FrictionFriction
    """the fitted friction, as in drivetrain.friction"""
    speed: Quantity
    """speed of the input for the no-load torque and the efficiency [rad/s]"""
    torque: Quantity
    """torque on the load for the efficiency [N*m]"""
    ratio: Quantity
    """turns of the input per turn of the output"""
    converged: bool
    """whether the simulated friction returns all four values"""
    values: Values
    """the four values: wanted, fitted and simulated"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "friction": ("friction", FrictionFriction._of),
        "speed": ("speed", _to.quantity),
        "torque": ("torque", _to.quantity),
        "ratio": ("ratio", _to.quantity),
        "converged": ("converged", _to.plain),
        "values": ("values", Values._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class CalibrateResult(Result):
    """What `calibrate` answers."""

    source: str
    """origin of the target values"""
    converged: bool
    """whether the fit converged"""
    iterations: int
    """steps of the fit"""
    residual: Quantity
    """root mean square of ln(after/wanted)"""
    relative_uncertainty_of_a_value: Quantity
    """relative uncertainty of one value, from which the others follow"""
    factors: Factors
    """each factor, and how well the targets determine it"""
    combinations: Combinations
    """directions in the space of factors"""
    stiffness: Stiffness
    """each stiffness before and after the fit"""
    other_ratios: Optional[OtherRatios]
    """predictions at other ratios of the size, and their errors; None if absent"""
    friction: Optional[Friction]
    """friction of the input that is fitted to a maker's four values; None if absent"""

    command: ClassVar[str] = "calibrate"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "toml")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "source": ("source", _to.plain),
        "converged": ("converged", _to.plain),
        "iterations": ("iterations", _to.plain),
        "residual": ("residual", _to.quantity),
        "relative_uncertainty_of_a_value": ("relative_uncertainty_of_a_value", _to.quantity),
        "factors": ("factors", Factors._of),
        "combinations": ("combinations", Combinations._of),
        "stiffness": ("stiffness", Stiffness._of),
        "other_ratios": ("other_ratios", OtherRatios._of),
        "friction": ("friction", Friction._of),
    }
