# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command backbone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity
from .simulate import Table


@dataclass(frozen=True, eq=False, repr=False)
class BackbonePart(Part):
    """The sound drive."""

    frequency: Quantity
    """frequency of the free vibration without damping and hysteresis [Hz]"""
    resonance: Quantity
    """frequency at which the twist is a quarter of a period behind the torque, with damping and
    hysteresis [Hz]"""
    damping_ratio: Quantity
    """equivalent damping ratio at the resonance"""
    torque: Quantity
    """half of the range of the torque of spring and hysteresis, at the resonance [N*m]"""
    excitation: Quantity
    """amplitude of the torque that keeps the resonance [N*m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "frequency": ("frequency", _to.quantity),
        "resonance": ("resonance", _to.quantity),
        "damping_ratio": ("damping_ratio", _to.quantity),
        "torque": ("torque", _to.quantity),
        "excitation": ("excitation", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Backbone(Part):
    """The field `backbone`."""

    amplitude: Quantity
    """half of the range of the twist [rad]"""
    intact: BackbonePart
    """the sound drive"""
    cracked: Optional[BackbonePart]
    """the drive with its cracks; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "amplitude": ("amplitude", _to.quantity),
        "intact": ("intact", BackbonePart._of),
        "cracked": ("cracked", BackbonePart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Jumps(Part):
    """Frequencies at which the response jumps."""

    frequency: FloatArray
    """frequency of the fold [Hz]"""
    amplitude: FloatArray
    """half of the range of the twist before the jump [rad]"""
    rising: AnyArray
    """whether the response jumps while the frequency rises; else while it falls"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "frequency": ("frequency", _to.floats),
        "amplitude": ("amplitude", _to.floats),
        "rising": ("rising", _to.entries),
    }
    _units: ClassVar[dict[str, str]] = {
        "frequency": "Hz",
        "amplitude": "rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Points(Part):
    """The curve, in the order of its length."""

    frequency: FloatArray
    """frequency of the excitation [Hz]"""
    amplitude: FloatArray
    """half of the range of the twist [rad]"""
    torque: FloatArray
    """half of the range of the torque of spring and hysteresis [N*m]"""
    output: FloatArray
    """amplitude of the first harmonic of the output's angle [rad]"""
    lag: FloatArray
    """phase of this harmonic behind the torque [rad]"""
    multiplier: FloatArray
    """largest magnitude of the Floquet multipliers"""
    stable: AnyArray
    """whether the drive keeps this response"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "frequency": ("frequency", _to.floats),
        "amplitude": ("amplitude", _to.floats),
        "torque": ("torque", _to.floats),
        "output": ("output", _to.floats),
        "lag": ("lag", _to.floats),
        "multiplier": ("multiplier", _to.floats),
        "stable": ("stable", _to.entries),
    }
    _units: ClassVar[dict[str, str]] = {
        "frequency": "Hz",
        "amplitude": "rad",
        "torque": "N*m",
        "output": "rad",
        "lag": "rad",
        "multiplier": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Responses(Part):
    """The field `responses`."""

    drive: Literal["sound", "cracked"]
    """sound, or with its cracks"""
    excitation: Quantity
    """amplitude of the exciting torque [N*m]"""
    peak: Quantity
    """largest half range of the twist among the stable points [rad]"""
    peak_frequency: Quantity
    """frequency of the peak [Hz]"""
    peak_torque: Quantity
    """half of the range of spring and hysteresis at the peak [N*m]"""
    converged: bool
    """whether the curve reached its end"""
    reason: str
    """why the curve did not reach its end"""
    jumps: Jumps
    """frequencies at which the response jumps"""
    points: Points
    """the curve, in the order of its length"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "drive": ("drive", _to.plain),
        "excitation": ("excitation", _to.quantity),
        "peak": ("peak", _to.quantity),
        "peak_frequency": ("peak_frequency", _to.quantity),
        "peak_torque": ("peak_torque", _to.quantity),
        "converged": ("converged", _to.plain),
        "reason": ("reason", _to.plain),
        "jumps": ("jumps", Jumps._of),
        "points": ("points", Points._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class BackboneResult(Result):
    """What `backbone` answers."""

    load_torque: Quantity
    """constant torque on the output [N*m]"""
    input: Literal["free", "locked"]
    """free: the motor gives its torque; locked: it keeps its speed"""
    at: Literal["motor", "load"]
    """end on which the excitation acts"""
    harmonics: int
    """harmonics of the twist"""
    springs: Literal["coupled_drive", "members", "computed_curve"]
    """origin of the spring: coupled_drive, members or computed_curve"""
    table: Optional[Table]
    """the table of the computed curve and its error; None if absent"""
    input_swing: Optional[Quantity]
    """largest angle by which the free input swings about its start; absent: no computed curve,
    or a locked input [rad]; None if absent"""
    change_over_swing: Optional[Quantity]
    """largest change of the tangent stiffness under the load over this swing, over that at the
    start; None if absent"""
    change_over_turn: Optional[Quantity]
    """the same over a turn of the input; None if absent"""
    small_frequency: Quantity
    """frequency of small vibrations, sound, with the hysteresis as a spring [Hz]"""
    cracked_small_frequency: Optional[Quantity]
    """the same with the cracks [Hz]; None if absent"""
    truncation: Quantity
    """largest share of the last two harmonics in the energy"""
    backbone: tuple[Backbone, ...]
    """frequency and damping over the amplitude"""
    responses: tuple[Responses, ...]
    """responses to each excitation"""

    command: ClassVar[str] = "backbone"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "load_torque": ("load_torque", _to.quantity),
        "input": ("input", _to.plain),
        "at": ("at", _to.plain),
        "harmonics": ("harmonics", _to.plain),
        "springs": ("springs", _to.plain),
        "table": ("table", Table._of),
        "input_swing": ("input_swing", _to.quantity),
        "change_over_swing": ("change_over_swing", _to.quantity),
        "change_over_turn": ("change_over_turn", _to.quantity),
        "small_frequency": ("small_frequency", _to.quantity),
        "cracked_small_frequency": ("cracked_small_frequency", _to.quantity),
        "truncation": ("truncation", _to.quantity),
        "backbone": ("backbone", _to.many(Backbone._of)),
        "responses": ("responses", _to.many(Responses._of)),
    }
