# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command backbone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import answers as _to
from ..answers import AnyArray, Converter, FloatArray, Part, Quantity, Result


@dataclass(frozen=True, eq=False, repr=False)
class Table(Part):
    """The table of the computed curve and its error."""

    most_torque: Quantity
    """largest torque of the table, at the output [N*m]"""
    torques: int
    """points of the torque"""
    cage_angles: int
    """points of the angle of the cage"""
    flexspline_angles: Optional[int]
    """points of the angle of the flexspline against the wave; absent: no crack or deviation
    moves with it; None if absent"""
    spline_angles: Optional[int]
    """points of the angle of the circular spline against the wave; absent: no crack or
    deviation in it; None if absent"""
    triples: int
    """random angles of flexspline, spline and cage of the check"""
    worst_difference: Quantity
    """largest difference of the twist against the coupled drive at these angles [rad]"""
    rms_difference: Quantity
    """root mean square of this difference [rad]"""
    cracks_twist: Optional[Quantity]
    """root mean square of the twist that the cracks in the contacts add at these angles [rad];
    None if absent"""
    worst_share: Optional[Quantity]
    """largest error of the twist that the cracks add, over the largest such twist; None if
    absent"""
    rms_share: Optional[Quantity]
    """the same as root mean squares; None if absent"""
    teeth_range: Optional[Quantity]
    """kinematic error of the teeth from peak to valley over a turn of the output, sound, at the
    rated torque, or at the largest torque of the table if this is smaller; absent: no tooth
    deviates [rad]; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "most_torque": ("most_torque", _to.quantity),
        "torques": ("torques", _to.plain),
        "cage_angles": ("cage_angles", _to.plain),
        "flexspline_angles": ("flexspline_angles", _to.plain),
        "spline_angles": ("spline_angles", _to.plain),
        "triples": ("triples", _to.plain),
        "worst_difference": ("worst_difference", _to.quantity),
        "rms_difference": ("rms_difference", _to.quantity),
        "cracks_twist": ("cracks_twist", _to.quantity),
        "worst_share": ("worst_share", _to.quantity),
        "rms_share": ("rms_share", _to.quantity),
        "teeth_range": ("teeth_range", _to.quantity),
    }
    _units: ClassVar[dict[str, str]] = {}


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
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class Backbone(Part):
    """Backbone."""

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
    _units: ClassVar[dict[str, str]] = {}


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
    """Responses."""

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
    _units: ClassVar[dict[str, str]] = {}


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
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot",)
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
    _units: ClassVar[dict[str, str]] = {}
