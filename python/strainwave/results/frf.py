# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command frf."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Extrema(Part):
    """Resonances and antiresonances of each response."""

    response: AnyArray
    """from which excitation to which angle"""
    kind: AnyArray
    """resonance or antiresonance"""
    unit: AnyArray
    """SI unit of the amplitudes"""
    intact_frequency: FloatArray
    """frequency, sound [Hz]"""
    intact_amplitude: AnyArray
    """amplitude, sound; absent if infinite"""
    intact_damping: FloatArray
    """damping ratio by the half-power points, sound; absent if the response has none"""
    cracked_frequency: FloatArray
    """frequency, cracked [Hz]"""
    cracked_amplitude: AnyArray
    """amplitude, cracked; absent if infinite"""
    cracked_damping: FloatArray
    """damping ratio by the half-power points, cracked; absent if the response has none"""
    change: FloatArray
    """frequency cracked/sound - 1"""
    amplitude_change: FloatArray
    """amplitude cracked/sound - 1"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "response": ("response", _to.entries),
        "kind": ("kind", _to.entries),
        "unit": ("unit", _to.entries),
        "intact_frequency": ("intact_frequency", _to.floats),
        "intact_amplitude": ("intact_amplitude", _to.entries),
        "intact_damping": ("intact_damping", _to.floats),
        "cracked_frequency": ("cracked_frequency", _to.floats),
        "cracked_amplitude": ("cracked_amplitude", _to.entries),
        "cracked_damping": ("cracked_damping", _to.floats),
        "change": ("change", _to.floats),
        "amplitude_change": ("amplitude_change", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "intact_frequency": "Hz",
        "intact_damping": "1",
        "cracked_frequency": "Hz",
        "cracked_damping": "1",
        "change": "1",
        "amplitude_change": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Curves(Part):
    """The field `curves`."""

    response: Literal["motor_angle", "load_angle", "error_given_torque", "error_given_speed", "load_torque", "load_torque_at_speed"]
    """from which excitation to which angle"""
    unit: str
    """SI unit of the amplitudes"""
    intact_amplitude: AnyArray
    """amplitude at each frequency, sound"""
    intact_phase: FloatArray
    """phase at each frequency, without jumps, sound [rad]"""
    cracked_amplitude: AnyArray
    """amplitude at each frequency, cracked"""
    cracked_phase: FloatArray
    """phase at each frequency, without jumps, cracked [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "response": ("response", _to.plain),
        "unit": ("unit", _to.plain),
        "intact_amplitude": ("intact_amplitude", _to.entries),
        "intact_phase": ("intact_phase", _to.floats),
        "cracked_amplitude": ("cracked_amplitude", _to.entries),
        "cracked_phase": ("cracked_phase", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "intact_phase": "rad",
        "cracked_phase": "rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class FrfResult(Result):
    """What `frf` answers."""

    resonance: Optional[Quantity]
    """first resonance of the motor's angle under its torque, with the cracks [Hz]; None if
    absent"""
    antiresonance: Optional[Quantity]
    """first antiresonance of the motor's angle under its torque, with the cracks [Hz]; None if
    absent"""
    error_gain: Optional[Quantity]
    """load's angle over the kinematic error at its first resonance, motor of given speed, with
    the cracks; absent if infinite; None if absent"""
    torque: Quantity
    """torque at the output at which the springs are taken [N*m]"""
    springs: Literal["coupled_drive", "members", "computed_curve"]
    """origin of the springs: coupled_drive or members"""
    signed_ratio: Quantity
    """turns of the input per turn of the output"""
    damped: bool
    """whether the file gives any damping"""
    extrema: Extrema
    """resonances and antiresonances of each response"""
    frequency: FloatArray
    """frequencies of the curves [Hz]"""
    curves: tuple[Curves, ...]
    """amplitude and phase of each response"""

    command: ClassVar[str] = "frf"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "resonance": ("resonance", _to.quantity),
        "antiresonance": ("antiresonance", _to.quantity),
        "error_gain": ("error_gain", _to.quantity),
        "torque": ("torque", _to.quantity),
        "springs": ("springs", _to.plain),
        "signed_ratio": ("signed_ratio", _to.quantity),
        "damped": ("damped", _to.plain),
        "extrema": ("extrema", Extrema._of),
        "frequency": ("frequency", _to.floats),
        "curves": ("curves", _to.many(Curves._of)),
    }
    _units: ClassVar[dict[str, str]] = {
        "frequency": "Hz",
    }
