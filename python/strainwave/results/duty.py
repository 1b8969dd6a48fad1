# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command duty."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Rows(Part):
    """Cycles by falling range."""

    range: AnyArray
    """range; the middle of its class"""
    mean: AnyArray
    """mean; the middle of its class"""
    count: FloatArray
    """number of cycles"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "range": ("range", _to.entries),
        "mean": ("mean", _to.entries),
        "count": ("count", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "count": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class DrivePart(Part):
    """Counted cycles of the torque in one repetition."""

    unit: str
    """unit of ranges and means"""
    rule: str
    """rule of counting"""
    residue: Literal["half_cycles", "repeated"]
    """what counts of the ranges that stay open at the end"""
    cycles: Quantity
    """sum of all counts"""
    largest_range: float
    """largest range"""
    class_width: Optional[float]
    """width of the classes; absent if rows are exact; None if absent"""
    left_out: Quantity
    """cycles in no row, because there are too many ranges"""
    largest_left_out: Optional[float]
    """largest range of a cycle in no row; None if absent"""
    rows: Rows
    """cycles by falling range"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "unit": ("unit", _to.plain),
        "rule": ("rule", _to.plain),
        "residue": ("residue", _to.plain),
        "cycles": ("cycles", _to.quantity),
        "largest_range": ("largest_range", _to.plain_number),
        "class_width": ("class_width", _to.plain_number),
        "left_out": ("left_out", _to.quantity),
        "largest_left_out": ("largest_left_out", _to.plain_number),
        "rows": ("rows", Rows._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Loads(Part):
    """Loads, and the cycles under each."""

    torque: FloatArray
    """torque; the middle of its class [N*m]"""
    axial_force: FloatArray
    """axial force, tension > 0 [N]"""
    bending_moment: FloatArray
    """bending moment fixed in space [N*m]"""
    cycles: FloatArray
    """waves, ball passes or turns in one repetition"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.floats),
        "axial_force": ("axial_force", _to.floats),
        "bending_moment": ("bending_moment", _to.floats),
        "cycles": ("cycles", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "torque": "N*m",
        "axial_force": "N",
        "bending_moment": "N*m",
        "cycles": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Places(Part):
    """The field `places`."""

    place: Literal["flexspline", "outer_ring", "inner_ring", "circular_spline", "output_shaft"]
    """part of the drive"""
    cycle: str
    """what makes a stress cycle there: a wave, a ball pass or a turn"""
    per_output_turn: Quantity
    """cycles in a turn of the output"""
    per_repetition: Quantity
    """cycles in one repetition of the duty"""
    per_hour: Quantity
    """cycles in an hour of the duty"""
    class_width: Optional[Quantity]
    """width of the classes of torque; absent if torques are exact [N*m]; None if absent"""
    loads: Loads
    """loads, and the cycles under each"""
    between: Optional[DrivePart]
    """cycles whose peak and valley have different torques: difference, mean and count; None if
    absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "place": ("place", _to.plain),
        "cycle": ("cycle", _to.plain),
        "per_output_turn": ("per_output_turn", _to.quantity),
        "per_repetition": ("per_repetition", _to.quantity),
        "per_hour": ("per_hour", _to.quantity),
        "class_width": ("class_width", _to.quantity),
        "loads": ("loads", Loads._of),
        "between": ("between", DrivePart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Peaks(Part):
    """The field `peaks`."""

    torque: Quantity
    """torque at the output [N*m]"""
    duration: Quantity
    """time of one peak [s]"""
    per_repetition: Quantity
    """peaks in one repetition of the duty"""
    waves: Quantity
    """waves of the flexspline during one peak"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.quantity),
        "duration": ("duration", _to.quantity),
        "per_repetition": ("per_repetition", _to.quantity),
        "waves": ("waves", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Drive(Part):
    """What each part of the drive bears in one repetition of its duty."""

    fixed: Literal["circular_spline", "flexspline"]
    """the member that does not turn"""
    steps: int
    """steps of constant load: blocks, or rows of the history"""
    duration: Quantity
    """time of one repetition [s]"""
    output_turns: Quantity
    """turns of the output in one repetition, in both senses"""
    input_turns: Quantity
    """turns of the input in one repetition, in both senses"""
    average_torque: Quantity
    """average torque T_av of the makers' rules [N*m]"""
    average_output_speed: Quantity
    """average speed of the output, with pauses [rad/s]"""
    average_input_speed: Quantity
    """average speed of the input, with pauses [rad/s]"""
    torque: DrivePart
    """counted cycles of the torque in one repetition"""
    places: tuple[Places, ...]
    """what each part of the drive bears"""
    peaks: tuple[Peaks, ...]
    """momentary peaks"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "fixed": ("fixed", _to.plain),
        "steps": ("steps", _to.plain),
        "duration": ("duration", _to.quantity),
        "output_turns": ("output_turns", _to.quantity),
        "input_turns": ("input_turns", _to.quantity),
        "average_torque": ("average_torque", _to.quantity),
        "average_output_speed": ("average_output_speed", _to.quantity),
        "average_input_speed": ("average_input_speed", _to.quantity),
        "torque": ("torque", DrivePart._of),
        "places": ("places", _to.many(Places._of)),
        "peaks": ("peaks", _to.many(Peaks._of)),
    }


@dataclass(frozen=True, eq=False, repr=False)
class History(Part):
    """Counted cycles of a history."""

    file: str
    """name of the history"""
    column: str
    """counted column"""
    unit: str
    """unit of the column; 1 if it states none"""
    points: int
    """number of points"""
    reversals: int
    """number of reversals, with the first and the last point"""
    least: float
    """least value"""
    largest: float
    """largest value"""
    counted: DrivePart
    """counted cycles"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "file": ("file", _to.plain),
        "column": ("column", _to.plain),
        "unit": ("unit", _to.plain),
        "points": ("points", _to.plain),
        "reversals": ("reversals", _to.plain),
        "least": ("least", _to.plain_number),
        "largest": ("largest", _to.plain_number),
        "counted": ("counted", DrivePart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class DutyResult(Result):
    """What `duty` answers."""

    drive: Optional[Drive]
    """what each part of the drive bears in one repetition of its duty; None if absent"""
    history: Optional[History]
    """counted cycles of a history; None if absent"""

    command: ClassVar[str] = "duty"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "drive": ("drive", Drive._of),
        "history": ("history", History._of),
    }
