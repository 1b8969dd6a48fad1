# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command turn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Optional

from .. import answers as _to
from ..answers import Converter, FloatArray, Part, Quantity, Result


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
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class ModeI(Part):
    """K_I over a turn."""

    largest: Quantity
    """largest K_I over a turn [Pa*m^0.5]"""
    least: Quantity
    """least K_I over a turn; 0 if the crack closes there [Pa*m^0.5]"""
    range: Quantity
    """Delta K of mode I [Pa*m^0.5]"""
    ratio: Quantity
    """R = least/largest; 0 if the station never opens"""
    open_share: Quantity
    """share of the turn during which the station is open"""
    at_largest: Quantity
    """angle from a lobe to the crack at the largest K_I [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "largest": ("largest", _to.quantity),
        "least": ("least", _to.quantity),
        "range": ("range", _to.quantity),
        "ratio": ("ratio", _to.quantity),
        "open_share": ("open_share", _to.quantity),
        "at_largest": ("at_largest", _to.quantity),
    }
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class Factors(Part):
    """K over one wave; the last angle is the first one again."""

    angle: FloatArray
    """from a lobe of the wave generator to the crack, toward +theta [rad]"""
    K_I: FloatArray
    """opening mode; 0 if the faces touch [Pa*m^0.5]"""
    K_II: FloatArray
    """sliding mode [Pa*m^0.5]"""
    K_III: FloatArray
    """tearing [Pa*m^0.5]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "angle": ("angle", _to.floats),
        "K_I": ("K_I", _to.floats),
        "K_II": ("K_II", _to.floats),
        "K_III": ("K_III", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "angle": "rad",
        "K_I": "Pa*m^0.5",
        "K_II": "Pa*m^0.5",
        "K_III": "Pa*m^0.5",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Stations(Part):
    """Stations."""

    tip: str
    """upper: toward +z, at 90 degrees toward -theta; lower: the other tip"""
    station: Quantity
    """through crack: from -1 at the inner face of the wall to 1 at the outer face; surface
    crack: from 0 at the surface to 1 at the deepest point"""
    mode_I: ModeI
    """K_I over a turn"""
    factors: Factors
    """K over one wave; the last angle is the first one again"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "tip": ("tip", _to.plain),
        "station": ("station", _to.quantity),
        "mode_I": ("mode_I", ModeI._of),
        "factors": ("factors", Factors._of),
    }
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class Torques(Part):
    """Torques."""

    torque: Quantity
    """torque at the output [N*m]"""
    stations: tuple[Stations, ...]
    """places of the fronts"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.quantity),
        "stations": ("stations", _to.many(Stations._of)),
    }
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class Sizes(Part):
    """Sizes."""

    depth: Optional[Quantity]
    """depth of a surface crack [m]; None if absent"""
    half_length: Quantity
    """half length of the crack [m]"""
    torques: tuple[Torques, ...]
    """the turn under each torque"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "depth": ("depth", _to.quantity),
        "half_length": ("half_length", _to.quantity),
        "torques": ("torques", _to.many(Torques._of)),
    }
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class TurnResult(Result):
    """What `turn` answers."""

    largest: Quantity
    """K_max of mode I where its range over a turn is largest [Pa*m^0.5]"""
    range: Quantity
    """Delta K of mode I there [Pa*m^0.5]"""
    ratio: Quantity
    """R = K_min/K_max there"""
    governing_tip: str
    """the tip with the largest range"""
    path: str
    """path of the crack in the input file"""
    distance: Quantity
    """of the crack's middle from its section's end toward the diaphragm [m]"""
    wave_generator: WaveGenerator
    """contact of the wave generator with the bore"""
    large_rotations: bool
    """whether large rotations of the oval were computed"""
    largest_stress: Quantity
    """largest stress of the sound wall normal to the crack [Pa]"""
    sizes: tuple[Sizes, ...]
    """the turn at each size of the crack"""

    command: ClassVar[str] = "turn"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot",)
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "largest": ("largest", _to.quantity),
        "range": ("range", _to.quantity),
        "ratio": ("ratio", _to.quantity),
        "governing_tip": ("governing_tip", _to.plain),
        "path": ("path", _to.plain),
        "distance": ("distance", _to.quantity),
        "wave_generator": ("wave_generator", WaveGenerator._of),
        "large_rotations": ("large_rotations", _to.plain),
        "largest_stress": ("largest_stress", _to.quantity),
        "sizes": ("sizes", _to.many(Sizes._of)),
    }
    _units: ClassVar[dict[str, str]] = {}
