# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command accuracy."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Budget(Part):
    """Parts of the error and their sums."""

    item: AnyArray
    """part of the error, or a sum of the parts"""
    intact_least: FloatArray
    """least error of the output's angle, sound [rad]"""
    intact_largest: FloatArray
    """largest error of the output's angle, sound [rad]"""
    cracked_least: FloatArray
    """least error, cracked [rad]"""
    cracked_largest: FloatArray
    """largest error, cracked [rad]"""
    tool_least: FloatArray
    """least error of the tool point, with the cracks [m]"""
    tool_largest: FloatArray
    """largest error of the tool point, with the cracks [m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "item": ("item", _to.entries),
        "intact_least": ("intact_least", _to.floats),
        "intact_largest": ("intact_largest", _to.floats),
        "cracked_least": ("cracked_least", _to.floats),
        "cracked_largest": ("cracked_largest", _to.floats),
        "tool_least": ("tool_least", _to.floats),
        "tool_largest": ("tool_largest", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "intact_least": "rad",
        "intact_largest": "rad",
        "cracked_least": "rad",
        "cracked_largest": "rad",
        "tool_least": "m",
        "tool_largest": "m",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Orders(Part):
    """Orders of the kinematic error at the speed."""

    order: FloatArray
    """periods in a turn of the input"""
    amplitude: FloatArray
    """amplitude of the kinematic error [rad]"""
    frequency: FloatArray
    """frequency at the speed [Hz]"""
    intact_gain: FloatArray
    """load's angle over the kinematic error, sound; the largest over a turn of the output"""
    cracked_gain: FloatArray
    """load's angle over the kinematic error, cracked"""
    at_load: FloatArray
    """amplitude of the load's angle, with the cracks [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "order": ("order", _to.floats),
        "amplitude": ("amplitude", _to.floats),
        "frequency": ("frequency", _to.floats),
        "intact_gain": ("intact_gain", _to.floats),
        "cracked_gain": ("cracked_gain", _to.floats),
        "at_load": ("at_load", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "order": "1",
        "amplitude": "rad",
        "frequency": "Hz",
        "intact_gain": "1",
        "cracked_gain": "1",
        "at_load": "rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Cracks(Part):
    """What each crack adds."""

    path: AnyArray
    """the crack"""
    wind_up: FloatArray
    """change of the largest wind-up [rad]"""
    kinematic_error: FloatArray
    """change of the kinematic error at the speed, peak to valley [rad]"""
    hysteresis: FloatArray
    """change of the loss at zero torque [rad]"""
    lost_motion: FloatArray
    """change of the lost motion [rad]"""
    worst_case: FloatArray
    """change of the largest worst case [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.entries),
        "wind_up": ("wind_up", _to.floats),
        "kinematic_error": ("kinematic_error", _to.floats),
        "hysteresis": ("hysteresis", _to.floats),
        "lost_motion": ("lost_motion", _to.floats),
        "worst_case": ("worst_case", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "wind_up": "rad",
        "kinematic_error": "rad",
        "hysteresis": "rad",
        "lost_motion": "rad",
        "worst_case": "rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class BandsPart(Part):
    """Largest magnitude of the worst case."""

    least: Quantity
    """least draw [rad]"""
    low: Quantity
    """5 % of the draws are lower [rad]"""
    median: Quantity
    """half of the draws are lower [rad]"""
    high: Quantity
    """95 % of the draws are lower [rad]"""
    largest: Quantity
    """largest draw [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "least": ("least", _to.quantity),
        "low": ("low", _to.quantity),
        "median": ("median", _to.quantity),
        "high": ("high", _to.quantity),
        "largest": ("largest", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Bands(Part):
    """The sums under the ranges and scatters of the file."""

    worst_case: BandsPart
    """largest magnitude of the worst case"""
    root_of_squares: BandsPart
    """largest magnitude of the root of squares"""
    ranges: int
    """ranges that were drawn"""
    scatters: int
    """scatters that were drawn"""
    correlations: int
    """rank correlations between the scatters"""
    draws: int
    """drawn drives with a budget"""
    rejected: int
    """drawn drives that break a rule or have no equilibrium"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "worst_case": ("worst_case", BandsPart._of),
        "root_of_squares": ("root_of_squares", BandsPart._of),
        "ranges": ("ranges", _to.plain),
        "scatters": ("scatters", _to.plain),
        "correlations": ("correlations", _to.plain),
        "draws": ("draws", _to.plain),
        "rejected": ("rejected", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class AccuracyResult(Result):
    """What `accuracy` answers."""

    worst_case: Quantity
    """largest magnitude of the error of the output's angle: sum of the parts, with the cracks
    [rad]"""
    root_of_squares: Quantity
    """largest magnitude with the half ranges added by their squares, with the cracks [rad]"""
    tool_worst_case: Optional[Quantity]
    """worst_case at the tool point [m]; None if absent"""
    tool_root_of_squares: Optional[Quantity]
    """root_of_squares at the tool point [m]; None if absent"""
    torque: Quantity
    """external torque on the output about +z [N*m]"""
    least_torque: Quantity
    """least torque over a turn of the output, with gravity [N*m]"""
    largest_torque: Quantity
    """largest torque over a turn of the output, with gravity [N*m]"""
    worst_angle: Optional[Quantity]
    """angle of the output at which the torque is largest in magnitude [rad]; None if absent"""
    speed: Quantity
    """speed of the input [rad/s]"""
    tool_radius: Optional[Quantity]
    """distance of the tool point from the output's axis [m]; None if absent"""
    springs: Literal["coupled_drive", "members", "computed_curve"]
    """origin of the twist: coupled_drive or members"""
    kinematic_range: Quantity
    """kinematic error without dynamics, peak to valley [rad]"""
    kinematic_sum: Quantity
    """twice the sum of the amplitudes of the kinematic error [rad]"""
    contains_lost_motion: bool
    """whether the torques of the turn reach the torque of the lost motion on both sides"""
    intact_lost_motion: Quantity
    """lost motion, sound [rad]"""
    cracked_lost_motion: Optional[Quantity]
    """lost motion, cracked [rad]; None if absent"""
    intact_hysteresis: Optional[Quantity]
    """hysteresis loss at zero torque, sound [rad]; None if absent"""
    cracked_hysteresis: Optional[Quantity]
    """hysteresis loss at zero torque, cracked [rad]; None if absent"""
    budget: Budget
    """parts of the error and their sums"""
    orders: Orders
    """orders of the kinematic error at the speed"""
    cracks: Cracks
    """what each crack adds"""
    bands: Optional[Bands]
    """the sums under the ranges and scatters of the file; None if absent"""

    command: ClassVar[str] = "accuracy"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "worst_case": ("worst_case", _to.quantity),
        "root_of_squares": ("root_of_squares", _to.quantity),
        "tool_worst_case": ("tool_worst_case", _to.quantity),
        "tool_root_of_squares": ("tool_root_of_squares", _to.quantity),
        "torque": ("torque", _to.quantity),
        "least_torque": ("least_torque", _to.quantity),
        "largest_torque": ("largest_torque", _to.quantity),
        "worst_angle": ("worst_angle", _to.quantity),
        "speed": ("speed", _to.quantity),
        "tool_radius": ("tool_radius", _to.quantity),
        "springs": ("springs", _to.plain),
        "kinematic_range": ("kinematic_range", _to.quantity),
        "kinematic_sum": ("kinematic_sum", _to.quantity),
        "contains_lost_motion": ("contains_lost_motion", _to.plain),
        "intact_lost_motion": ("intact_lost_motion", _to.quantity),
        "cracked_lost_motion": ("cracked_lost_motion", _to.quantity),
        "intact_hysteresis": ("intact_hysteresis", _to.quantity),
        "cracked_hysteresis": ("cracked_hysteresis", _to.quantity),
        "budget": ("budget", Budget._of),
        "orders": ("orders", Orders._of),
        "cracks": ("cracks", Cracks._of),
        "bands": ("bands", Bands._of),
    }
