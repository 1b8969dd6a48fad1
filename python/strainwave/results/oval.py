# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command oval."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class StationsPart(Part):
    """Stress round the axis."""

    largest: FloatArray
    """largest value over a turn [Pa]"""
    at_largest: FloatArray
    """angle from a lobe to the place at the largest value [rad]"""
    least: FloatArray
    """least value over a turn [Pa]"""
    at_least: FloatArray
    """angle from a lobe to the place at the least value [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "largest": ("largest", _to.floats),
        "at_largest": ("at_largest", _to.floats),
        "least": ("least", _to.floats),
        "at_least": ("at_least", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "largest": "Pa",
        "at_largest": "rad",
        "least": "Pa",
        "at_least": "rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Stations(Part):
    """Places along the wall from the bore of the diaphragm."""

    part: AnyArray
    """diaphragm, barrel or rim"""
    at: FloatArray
    """barrel and rim: z from the barrel's end toward the diaphragm; diaphragm: radius [m]"""
    face: AnyArray
    """inner or outer face of the wall"""
    hoop: StationsPart
    """stress round the axis"""
    meridional: StationsPart
    """stress along the axis, in the diaphragm along the radius"""
    shear: StationsPart
    """shear stress; T > 0 makes it positive"""
    equivalent: StationsPart
    """von Mises stress"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "part": ("part", _to.entries),
        "at": ("at", _to.floats),
        "face": ("face", _to.entries),
        "hoop": ("hoop", StationsPart._of),
        "meridional": ("meridional", StationsPart._of),
        "shear": ("shear", StationsPart._of),
        "equivalent": ("equivalent", StationsPart._of),
    }
    _units: ClassVar[dict[str, str]] = {
        "at": "m",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Torques(Part):
    """The field `torques`."""

    torque: Quantity
    """torque at the output [N*m]"""
    stations: Stations
    """places along the wall from the bore of the diaphragm"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.quantity),
        "stations": ("stations", Stations._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class WaveGenerator(Part):
    """Contact of the wave generator with the bore."""

    lobe_force: Quantity
    """force of one lobe of the wave generator on the bore [N]"""
    half_arc: Quantity
    """half of the arc on which a lobe presses [rad]"""
    largest_pressure: Quantity
    """largest pressure on the bore, even over the band [Pa]"""
    iterations: int
    """iterations of the large rotations"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "lobe_force": ("lobe_force", _to.quantity),
        "half_arc": ("half_arc", _to.quantity),
        "largest_pressure": ("largest_pressure", _to.quantity),
        "iterations": ("iterations", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Pressure(Part):
    """Of the wave generator on the bore."""

    angle: FloatArray
    """from a lobe [rad]"""
    pressure: FloatArray
    """on the bore of the rim, even over the width of the band [Pa]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "angle": ("angle", _to.floats),
        "pressure": ("pressure", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "angle": "rad",
        "pressure": "Pa",
    }


@dataclass(frozen=True, eq=False, repr=False)
class OvalResult(Result):
    """What `oval` answers."""

    largest: Quantity
    """largest von Mises stress of the wall over a turn [Pa]"""
    coning_angle: Quantity
    """turn of the rim's meridian outward at a lobe [rad]"""
    large_rotations: bool
    """whether large rotations of the oval were computed"""
    rotation_stress: Quantity
    """largest change of a stress by large rotations; 0 without them [Pa]"""
    torques: tuple[Torques, ...]
    """the stress under each torque"""
    wave_generator: WaveGenerator
    """contact of the wave generator with the bore"""
    pressure: Pressure
    """of the wave generator on the bore"""

    command: ClassVar[str] = "oval"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "largest": ("largest", _to.quantity),
        "coning_angle": ("coning_angle", _to.quantity),
        "large_rotations": ("large_rotations", _to.plain),
        "rotation_stress": ("rotation_stress", _to.quantity),
        "torques": ("torques", _to.many(Torques._of)),
        "wave_generator": ("wave_generator", WaveGenerator._of),
        "pressure": ("pressure", Pressure._of),
    }
