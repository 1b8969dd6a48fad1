# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command turn."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, FloatArray, Part, Quantity
from .oval import WaveGenerator
from .stiffness import AtWork


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
    """The field `stations`."""

    tip: str
    """upper: toward +z, at 90 degrees toward -theta; lower: the other tip"""
    station: Quantity
    """through crack: from -1 at the inner face of the wall to 1 at the outer face; surface
    crack: from 0 at the surface to 1 at the deepest point"""
    mode_I: AtWork
    """K_I over a turn"""
    factors: Factors
    """K over one wave; the last angle is the first one again"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "tip": ("tip", _to.plain),
        "station": ("station", _to.quantity),
        "mode_I": ("mode_I", AtWork._of),
        "factors": ("factors", Factors._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Torques(Part):
    """The field `torques`."""

    torque: Quantity
    """torque at the output [N*m]"""
    stations: tuple[Stations, ...]
    """places of the fronts"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.quantity),
        "stations": ("stations", _to.many(Stations._of)),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Sizes(Part):
    """The field `sizes`."""

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
    """largest stress of the sound wall normal to the crack, at its middle [Pa]"""
    sizes: tuple[Sizes, ...]
    """the turn at each size of the crack"""

    command: ClassVar[str] = "turn"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
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
