# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command grow."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Events(Part):
    """The field `events`."""

    event: Literal["arrested", "through_wall", "breaks", "assessment", "severed", "range", "wanted_size", "merges"]
    """what happens"""
    time: Quantity
    """time of duty [s]"""
    cycles: Quantity
    """cycles of this crack"""
    size: Quantity
    """depth, or half length of a through crack [m]"""
    half_length: Quantity
    """half length on the surface [m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "event": ("event", _to.plain),
        "time": ("time", _to.quantity),
        "cycles": ("cycles", _to.quantity),
        "size": ("size", _to.quantity),
        "half_length": ("half_length", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Series(Part):
    """Growth over time."""

    time: FloatArray
    """time of duty [s]"""
    cycles: FloatArray
    """cycles of this crack"""
    size: FloatArray
    """depth, or half length of a through crack [m]"""
    half_length: FloatArray
    """half length on the surface [m]"""
    K_max: FloatArray
    """largest K of a repetition of the duty, at any point of the tip [Pa*m^0.5]"""
    delta_K: FloatArray
    """widest range of K, with its pressed part [Pa*m^0.5]"""
    ratio: FloatArray
    """R of the widest cycle"""
    rate: FloatArray
    """growth of the size per cycle, mean over a repetition [m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "time": ("time", _to.floats),
        "cycles": ("cycles", _to.floats),
        "size": ("size", _to.floats),
        "half_length": ("half_length", _to.floats),
        "K_max": ("K_max", _to.floats),
        "delta_K": ("delta_K", _to.floats),
        "ratio": ("ratio", _to.floats),
        "rate": ("rate", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "time": "s",
        "cycles": "1",
        "size": "m",
        "half_length": "m",
        "K_max": "Pa*m^0.5",
        "delta_K": "Pa*m^0.5",
        "ratio": "1",
        "rate": "m",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Cracks(Part):
    """The field `cracks`."""

    path: str
    """the crack"""
    kind: str
    """kind of the crack in the file"""
    law: str
    """law of growth"""
    constants: str
    """origin of the constants"""
    cycles_per_hour: Quantity
    """cycles in an hour of duty"""
    grows: bool
    """whether the crack grows from its size in the file"""
    margin: Optional[Quantity]
    """of a crack at rest: threshold over the range of K; None if absent"""
    factor_to_grow: Optional[Quantity]
    """factor on the duty's loads from which a crack at rest grows; None if absent"""
    kink_angle: Optional[Quantity]
    """angle by which the crack would turn, at its size in the file [rad]; None if absent"""
    events: tuple[Events, ...]
    """what happens to the crack"""
    series: Series
    """growth over time"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.plain),
        "kind": ("kind", _to.plain),
        "law": ("law", _to.plain),
        "constants": ("constants", _to.plain),
        "cycles_per_hour": ("cycles_per_hour", _to.quantity),
        "grows": ("grows", _to.plain),
        "margin": ("margin", _to.quantity),
        "factor_to_grow": ("factor_to_grow", _to.quantity),
        "kink_angle": ("kink_angle", _to.quantity),
        "events": ("events", _to.many(Events._of)),
        "series": ("series", Series._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Stiffness(Part):
    """Stiffness of the drive over time."""

    time: FloatArray
    """time of duty [s]"""
    positive: FloatArray
    """K_HD under T > 0 [N*m/rad]"""
    negative: FloatArray
    """K_HD under T < 0 [N*m/rad]"""
    change: FloatArray
    """of the softer sense, against the drive of the file"""
    resonance: FloatArray
    """natural frequency over that of the file"""
    reserve: FloatArray
    """least factor on the duty's largest load at which a crack fails"""
    K1_positive: FloatArray
    """K1 of the coupled drive, T > 0 [N*m/rad]"""
    K2_positive: FloatArray
    """K2 of the coupled drive, T > 0 [N*m/rad]"""
    K3_positive: FloatArray
    """K3 of the coupled drive, T > 0 [N*m/rad]"""
    K1_negative: FloatArray
    """K1 of the coupled drive, T < 0 [N*m/rad]"""
    K2_negative: FloatArray
    """K2 of the coupled drive, T < 0 [N*m/rad]"""
    K3_negative: FloatArray
    """K3 of the coupled drive, T < 0 [N*m/rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "time": ("time", _to.floats),
        "positive": ("positive", _to.floats),
        "negative": ("negative", _to.floats),
        "change": ("change", _to.floats),
        "resonance": ("resonance", _to.floats),
        "reserve": ("reserve", _to.floats),
        "K1_positive": ("K1_positive", _to.floats),
        "K2_positive": ("K2_positive", _to.floats),
        "K3_positive": ("K3_positive", _to.floats),
        "K1_negative": ("K1_negative", _to.floats),
        "K2_negative": ("K2_negative", _to.floats),
        "K3_negative": ("K3_negative", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "time": "s",
        "positive": "N*m/rad",
        "negative": "N*m/rad",
        "change": "1",
        "resonance": "1",
        "reserve": "1",
        "K1_positive": "N*m/rad",
        "K2_positive": "N*m/rad",
        "K3_positive": "N*m/rad",
        "K1_negative": "N*m/rad",
        "K2_negative": "N*m/rad",
        "K3_negative": "N*m/rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class GrowResult(Result):
    """What `grow` answers."""

    sentence: str
    """the answer in words"""
    end: Literal["until", "arrested", "breaks", "assessment", "severed", "range", "too_slow", "not_known"]
    """what ended the growth"""
    governing: str
    """crack that ends the growth; empty: none"""
    life: Optional[Quantity]
    """time of duty until a crack ends the life; absent: no end is known [s]; None if absent"""
    time: Quantity
    """time of duty that was computed [s]"""
    repetitions: Quantity
    """repetitions of the duty that were computed"""
    duty_duration: Quantity
    """time of one repetition of the duty [s]"""
    cracks: tuple[Cracks, ...]
    """each crack"""
    stiffness: Stiffness
    """stiffness of the drive over time"""
    rainflow: str
    """rule of the ranges that stay open"""
    mixed_mode: str
    """rule of mixed modes"""
    interaction: str
    """rule of overloads"""
    steps: int
    """steps of the integration"""
    tolerance: Quantity
    """tolerance of each step"""
    step_error: Quantity
    """largest relative change of time and sizes at the end if each step is halved"""

    command: ClassVar[str] = "grow"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "sentence": ("sentence", _to.plain),
        "end": ("end", _to.plain),
        "governing": ("governing", _to.plain),
        "life": ("life", _to.quantity),
        "time": ("time", _to.quantity),
        "repetitions": ("repetitions", _to.quantity),
        "duty_duration": ("duty_duration", _to.quantity),
        "cracks": ("cracks", _to.many(Cracks._of)),
        "stiffness": ("stiffness", Stiffness._of),
        "rainflow": ("rainflow", _to.plain),
        "mixed_mode": ("mixed_mode", _to.plain),
        "interaction": ("interaction", _to.plain),
        "steps": ("steps", _to.plain),
        "tolerance": ("tolerance", _to.quantity),
        "step_error": ("step_error", _to.quantity),
    }
