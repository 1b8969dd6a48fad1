# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command transmission."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Lines(Part):
    """Lines of the error over the angle of the input, largest first."""

    family: AnyArray
    """the part whose teeth or cracks make the line"""
    periods: AnyArray
    """periods in a turn of the wave against the part"""
    order: FloatArray
    """periods in a turn of the input"""
    amplitude: FloatArray
    """amplitude of the output's angle, sound [rad]"""
    phase: FloatArray
    """phase of the sine at the angle 0 of the input, sound [rad]"""
    cracked_amplitude: FloatArray
    """amplitude with the cracks [rad]"""
    cracked_phase: FloatArray
    """phase with the cracks [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "family": ("family", _to.entries),
        "periods": ("periods", _to.entries),
        "order": ("order", _to.floats),
        "amplitude": ("amplitude", _to.floats),
        "phase": ("phase", _to.floats),
        "cracked_amplitude": ("cracked_amplitude", _to.floats),
        "cracked_phase": ("cracked_phase", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "order": "1",
        "amplitude": "rad",
        "phase": "rad",
        "cracked_amplitude": "rad",
        "cracked_phase": "rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Drawn(Part):
    """Range over the drives that were drawn; the rest shows the drive with the median."""

    draws: int
    """drawn drives that gave an error"""
    failed: int
    """drawn drives without an equilibrium"""
    seed: int
    """seed of the draws"""
    low: Quantity
    """range from peak to valley, 5 % of the drawn drives [rad]"""
    median: Quantity
    """range from peak to valley, 50 % of the drawn drives [rad]"""
    high: Quantity
    """range from peak to valley, 95 % of the drawn drives [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "draws": ("draws", _to.plain),
        "failed": ("failed", _to.plain),
        "seed": ("seed", _to.plain),
        "low": ("low", _to.quantity),
        "median": ("median", _to.quantity),
        "high": ("high", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Rows(Part):
    """Error over one turn of the wave against each part."""

    family: AnyArray
    """the part whose teeth or cracks make the error"""
    angle: FloatArray
    """angle of the input [rad]"""
    error: FloatArray
    """error of the output, sound, less its mean [rad]"""
    cracked: FloatArray
    """error of the output with the cracks, less its mean [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "family": ("family", _to.entries),
        "angle": ("angle", _to.floats),
        "error": ("error", _to.floats),
        "cracked": ("cracked", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "angle": "rad",
        "error": "rad",
        "cracked": "rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class TransmissionResult(Result):
    """What `transmission` answers."""

    range: Quantity
    """kinematic error from peak to valley over a turn of the output, sound [rad]"""
    cracked_range: Optional[Quantity]
    """the same with the cracks [rad]; None if absent"""
    torque: Quantity
    """torque at the output [N*m]"""
    source: Literal["none", "measured", "drawn"]
    """where the deviations of the teeth come from"""
    lines: Lines
    """lines of the error over the angle of the input, largest first"""
    drawn: Optional[Drawn]
    """range over the drives that were drawn; the rest shows the drive with the median; None if
    absent"""
    checks: int
    """random positions at which the sum of both parts was compared with the complete drive"""
    adding_error: Quantity
    """largest difference at these positions [rad]"""
    rows: Rows
    """error over one turn of the wave against each part"""

    command: ClassVar[str] = "transmission"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "range": ("range", _to.quantity),
        "cracked_range": ("cracked_range", _to.quantity),
        "torque": ("torque", _to.quantity),
        "source": ("source", _to.plain),
        "lines": ("lines", Lines._of),
        "drawn": ("drawn", Drawn._of),
        "checks": ("checks", _to.plain),
        "adding_error": ("adding_error", _to.quantity),
        "rows": ("rows", Rows._of),
    }
