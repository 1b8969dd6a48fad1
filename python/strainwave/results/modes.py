# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command modes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Shape(Part):
    """Angle of each inertia."""

    inertia: AnyArray
    """motor, wave generator, rim, hub, circular spline or load"""
    angle: FloatArray
    """angle over that of the inertia with the largest kinetic energy"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "inertia": ("inertia", _to.entries),
        "angle": ("angle", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "angle": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Energy(Part):
    """Shares of the members in the elastic energy."""

    member: AnyArray
    """a member of the stiffness model, or the coupling"""
    share: FloatArray
    """share of the elastic energy"""
    derivative: FloatArray
    """derivative of ln f by the logarithm of the member's compliance, minus half of the
    share"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "member": ("member", _to.entries),
        "share": ("share", _to.floats),
        "derivative": ("derivative", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "share": "1",
        "derivative": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class ModesPart(Part):
    """The sound drive."""

    frequency: Quantity
    """natural frequency f [Hz]"""
    damping_ratio: Quantity
    """zeta, of first order in the damping"""
    shape: Shape
    """angle of each inertia"""
    energy: Energy
    """shares of the members in the elastic energy"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "frequency": ("frequency", _to.quantity),
        "damping_ratio": ("damping_ratio", _to.quantity),
        "shape": ("shape", Shape._of),
        "energy": ("energy", Energy._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Cracks(Part):
    """What each crack changes."""

    path: AnyArray
    """the crack"""
    change: FloatArray
    """f with all cracks over f without this one, minus 1"""
    share: FloatArray
    """share of the elastic energy in the crack; absent if it is closed or acts inside the
    contacts"""
    derivative: FloatArray
    """derivative of ln f by the logarithm of the crack's compliance, minus half of the share"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.entries),
        "change": ("change", _to.floats),
        "share": ("share", _to.floats),
        "derivative": ("derivative", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "change": "1",
        "share": "1",
        "derivative": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class CriticalSpeeds(Part):
    """Speeds of the input at which an order meets the frequency."""

    excitation: AnyArray
    """what passes"""
    order: FloatArray
    """periods in one turn of the input"""
    intact: FloatArray
    """speed of the input at which the order meets the frequency, sound [rad/s]"""
    cracked: FloatArray
    """the same, cracked [rad/s]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "excitation": ("excitation", _to.entries),
        "order": ("order", _to.floats),
        "intact": ("intact", _to.floats),
        "cracked": ("cracked", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "order": "1",
        "intact": "rad/s",
        "cracked": "rad/s",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Modes(Part):
    """The field `modes`."""

    number: int
    """number of the mode, from 1"""
    intact: ModesPart
    """the sound drive"""
    cracked: Optional[ModesPart]
    """the drive with its cracks; None if absent"""
    change: Optional[Quantity]
    """f cracked/sound - 1; None if absent"""
    likeness: Optional[Quantity]
    """modal assurance criterion (MAC) of the two shapes; 1 if the shapes are the same; None if
    absent"""
    cracks: Cracks
    """what each crack changes"""
    critical_speeds: CriticalSpeeds
    """speeds of the input at which an order meets the frequency"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "number": ("number", _to.plain),
        "intact": ("intact", ModesPart._of),
        "cracked": ("cracked", ModesPart._of),
        "change": ("change", _to.quantity),
        "likeness": ("likeness", _to.quantity),
        "cracks": ("cracks", Cracks._of),
        "critical_speeds": ("critical_speeds", CriticalSpeeds._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Conditions(Part):
    """The field `conditions`."""

    motor: Literal["torque", "speed"]
    """what the motor gives"""
    modes: tuple[Modes, ...]
    """the modes by rising frequency"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "motor": ("motor", _to.plain),
        "modes": ("modes", _to.many(Modes._of)),
    }


@dataclass(frozen=True, eq=False, repr=False)
class OverTorque(Part):
    """The same modes over the torque at the output."""

    torque: FloatArray
    """torque at the output [N*m]"""
    motor: AnyArray
    """what the motor gives"""
    number: AnyArray
    """number of the mode at the torque of the springs"""
    intact: FloatArray
    """natural frequency of the sound drive [Hz]"""
    cracked: FloatArray
    """natural frequency with the cracks [Hz]"""
    change: FloatArray
    """f cracked/sound - 1"""
    likeness: FloatArray
    """modal assurance criterion (MAC) with the shape one torque nearer to that of the springs;
    absent for the nearest torque"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.floats),
        "motor": ("motor", _to.entries),
        "number": ("number", _to.entries),
        "intact": ("intact", _to.floats),
        "cracked": ("cracked", _to.floats),
        "change": ("change", _to.floats),
        "likeness": ("likeness", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "torque": "N*m",
        "intact": "Hz",
        "cracked": "Hz",
        "change": "1",
        "likeness": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Rows(Part):
    """The first mode over the time of duty."""

    time: FloatArray
    """time of duty [s]"""
    free: FloatArray
    """f of the first mode while the motor gives its torque [Hz]"""
    locked: FloatArray
    """f of the first mode while the motor keeps its speed [Hz]"""
    free_change: FloatArray
    """change of free since the first row"""
    locked_change: FloatArray
    """change of locked since the first row"""
    likeness: FloatArray
    """modal assurance criterion (MAC) of the free mode with that one row before"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "time": ("time", _to.floats),
        "free": ("free", _to.floats),
        "locked": ("locked", _to.floats),
        "free_change": ("free_change", _to.floats),
        "locked_change": ("locked_change", _to.floats),
        "likeness": ("likeness", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "time": "s",
        "free": "Hz",
        "locked": "Hz",
        "free_change": "1",
        "locked_change": "1",
        "likeness": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class OverGrowth(Part):
    """The first mode while the cracks grow over the duty."""

    sentence: str
    """the end of the growth, in words"""
    life: Optional[Quantity]
    """time of duty until a crack ends the life; absent: no end is known [s]; None if absent"""
    rows: Rows
    """the first mode over the time of duty"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "sentence": ("sentence", _to.plain),
        "life": ("life", _to.quantity),
        "rows": ("rows", Rows._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class ModesResult(Result):
    """What `modes` answers."""

    free_frequency: Optional[Quantity]
    """f of the first mode while the motor gives its torque, with the cracks [Hz]; None if
    absent"""
    locked_frequency: Optional[Quantity]
    """f of the first mode while the motor keeps its speed, with the cracks [Hz]; None if
    absent"""
    free_change: Optional[Quantity]
    """change of free_frequency by the cracks; None if absent"""
    torque: Quantity
    """torque at the output at which the springs are taken [N*m]"""
    springs: Literal["coupled_drive", "members", "computed_curve"]
    """origin of the springs: coupled_drive or members"""
    signed_ratio: Quantity
    """turns of the input per turn of the output"""
    intact_stiffness: Quantity
    """tangent at the output with locked input, sound [N*m/rad]"""
    cracked_stiffness: Optional[Quantity]
    """tangent at the output with locked input, cracked [N*m/rad]; None if absent"""
    largest_speed: Optional[Quantity]
    """largest speed that the maker allows the input [rad/s]; None if absent"""
    conditions: tuple[Conditions, ...]
    """modes for each condition of the motor"""
    over_torque: OverTorque
    """the same modes over the torque at the output"""
    over_growth: Optional[OverGrowth]
    """the first mode while the cracks grow over the duty; None if absent"""

    command: ClassVar[str] = "modes"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "free_frequency": ("free_frequency", _to.quantity),
        "locked_frequency": ("locked_frequency", _to.quantity),
        "free_change": ("free_change", _to.quantity),
        "torque": ("torque", _to.quantity),
        "springs": ("springs", _to.plain),
        "signed_ratio": ("signed_ratio", _to.quantity),
        "intact_stiffness": ("intact_stiffness", _to.quantity),
        "cracked_stiffness": ("cracked_stiffness", _to.quantity),
        "largest_speed": ("largest_speed", _to.quantity),
        "conditions": ("conditions", _to.many(Conditions._of)),
        "over_torque": ("over_torque", OverTorque._of),
        "over_growth": ("over_growth", OverGrowth._of),
    }
