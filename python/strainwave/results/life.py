# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command life."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Average(Part):
    """The constant load that stands for the duty."""

    torque: Quantity
    """average torque T_av [N*m]"""
    output_speed: Quantity
    """average speed of the output, with pauses [rad/s]"""
    input_speed: Quantity
    """average speed of the input, with pauses [rad/s]"""
    duration: Quantity
    """time of a repetition of the duty [s]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.quantity),
        "output_speed": ("output_speed", _to.quantity),
        "input_speed": ("input_speed", _to.quantity),
        "duration": ("duration", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Rules(Part):
    """The field `rules`."""

    rule: Literal["average_torque", "repeated_peak", "momentary_peak", "momentary_peaks", "average_speed", "largest_speed", "ratcheting", "buckling"]
    """rule of the makers"""
    outcome: Literal["kept", "broken", "not known", "not needed"]
    """kept, broken, not known or not needed"""
    allowed: Optional[Quantity]
    """what the maker allows; None if absent"""
    present: Optional[Quantity]
    """what the duty has; None if absent"""
    margin: Optional[Quantity]
    """allowed over present, minus 1; None if absent"""
    origin: str
    """origin of the limit, or what to give for it"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "rule": ("rule", _to.plain),
        "outcome": ("outcome", _to.plain),
        "allowed": ("allowed", _to.quantity),
        "present": ("present", _to.quantity),
        "margin": ("margin", _to.quantity),
        "origin": ("origin", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Bearing(Part):
    """The wave generator's bearing by the maker's rule."""

    L10: Quantity
    """life that 90 % of the bearings reach [s]"""
    L50: Quantity
    """life that half of the bearings reach [s]"""
    origin: str
    """origin of the rated life"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "L10": ("L10", _to.quantity),
        "L50": ("L50", _to.quantity),
        "origin": ("origin", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Ratings(Part):
    """Forces for a life of a million turns."""

    inner: Quantity
    """ball force of the inner ring for a million turns [N]"""
    outer: Quantity
    """ball force of the outer ring for a million turns [N]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "inner": ("inner", _to.quantity),
        "outer": ("outer", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class BearingByForcesPart(Part):
    """Life over the duty, not comparable with the maker's hours."""

    L10: Quantity
    """life that 90 % of the bearings reach, from the ball forces [s]"""
    inner_ring: Quantity
    """L10 of the inner ring, which stands against the load [s]"""
    outer_ring: Quantity
    """L10 of the outer ring, which turns against the load [s]"""
    equivalent_inner: Quantity
    """constant force of all balls with the inner ring's life [N]"""
    equivalent_outer: Quantity
    """constant force of all balls with the outer ring's life [N]"""
    largest_force: Quantity
    """largest force of a ball [N]"""
    ratings: Ratings
    """forces for a life of a million turns"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "L10": ("L10", _to.quantity),
        "inner_ring": ("inner_ring", _to.quantity),
        "outer_ring": ("outer_ring", _to.quantity),
        "equivalent_inner": ("equivalent_inner", _to.quantity),
        "equivalent_outer": ("equivalent_outer", _to.quantity),
        "largest_force": ("largest_force", _to.quantity),
        "ratings": ("ratings", Ratings._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class BearingByForces(Part):
    """The wave generator's bearing by the forces of its balls."""

    duty: BearingByForcesPart
    """life over the duty, not comparable with the maker's hours"""
    rated: Optional[BearingByForcesPart]
    """life at rated torque and 2000 rpm; None if absent"""
    ratio: Optional[Quantity]
    """L10 over the duty over L10 at the rating; None if absent"""
    by_ratio: Optional[Quantity]
    """the maker's rated life times this ratio [s]; None if absent"""
    cage_phases: int
    """positions of the balls that were solved"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "duty": ("duty", BearingByForcesPart._of),
        "rated": ("rated", BearingByForcesPart._of),
        "ratio": ("ratio", _to.quantity),
        "by_ratio": ("by_ratio", _to.quantity),
        "cage_phases": ("cage_phases", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class OutputBearing(Part):
    """The output bearing."""

    L10: Quantity
    """life that 90 % of the output bearings reach [s]"""
    load: Quantity
    """constant load with the same life [N]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "L10": ("L10", _to.quantity),
        "load": ("load", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Plane(Part):
    """The most used plane."""

    angle: Quantity
    """normal of the plane against the hoop direction [rad]"""
    normal_amplitude: Quantity
    """amplitude of the normal stress [Pa]"""
    normal_mean: Quantity
    """mean normal stress [Pa]"""
    shear_amplitude: Quantity
    """amplitude of the shear stress [Pa]"""
    shear_mean: Quantity
    """mean shear stress [Pa]"""
    utilisation: Quantity
    """1 at the endurance limit"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "angle": ("angle", _to.quantity),
        "normal_amplitude": ("normal_amplitude", _to.quantity),
        "normal_mean": ("normal_mean", _to.quantity),
        "shear_amplitude": ("shear_amplitude", _to.quantity),
        "shear_mean": ("shear_mean", _to.quantity),
        "utilisation": ("utilisation", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Miner(Part):
    """The field `miner`."""

    rule: Literal["original", "elementary", "haibach"]
    """line of the endurance below its knee"""
    damage_rate: Quantity
    """damage per time [1/s]"""
    life: Optional[Quantity]
    """time to a damage of 1; absent without damage [s]; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "rule": ("rule", _to.plain),
        "damage_rate": ("damage_rate", _to.quantity),
        "life": ("life", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Fatigue(Part):
    """The field `fatigue`."""

    place: Literal["wall", "rim", "tooth_root"]
    """wall, rim at its bore, or tooth root"""
    unknown_because: str
    """what to give; empty if the reserve is known"""
    hoop_amplitude: Quantity
    """amplitude of the hoop stress over the duty [Pa]"""
    hoop_mean: Quantity
    """mean hoop stress over the duty [Pa]"""
    shear_least: Quantity
    """least shear stress over the duty [Pa]"""
    shear_most: Quantity
    """largest shear stress over the duty [Pa]"""
    concentration: Quantity
    """concentration of the hoop stress of the rim"""
    surface: Quantity
    """surface factor K_R"""
    size: Quantity
    """size factor"""
    support: Quantity
    """support factor of the notch"""
    sensitivity: Quantity
    """sensitivity M to the mean stress"""
    endurance: Quantity
    """amplitude that the place endures at R = -1 [Pa]"""
    plane: Optional[Plane]
    """the most used plane; None if absent"""
    reserve: Optional[Quantity]
    """reserve against endurance by the most used plane; None if absent"""
    reserve_with_peaks: Optional[Quantity]
    """reserve with the momentary peaks, each as if it came for ever; None if absent"""
    handbook: Optional[Quantity]
    """reserve by the handbooks; 1.5 is usual; None if absent"""
    miner: tuple[Miner, ...]
    """damage by Miner"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "place": ("place", _to.plain),
        "unknown_because": ("unknown_because", _to.plain),
        "hoop_amplitude": ("hoop_amplitude", _to.quantity),
        "hoop_mean": ("hoop_mean", _to.quantity),
        "shear_least": ("shear_least", _to.quantity),
        "shear_most": ("shear_most", _to.quantity),
        "concentration": ("concentration", _to.quantity),
        "surface": ("surface", _to.quantity),
        "size": ("size", _to.quantity),
        "support": ("support", _to.quantity),
        "sensitivity": ("sensitivity", _to.quantity),
        "endurance": ("endurance", _to.quantity),
        "plane": ("plane", Plane._of),
        "reserve": ("reserve", _to.quantity),
        "reserve_with_peaks": ("reserve_with_peaks", _to.quantity),
        "handbook": ("handbook", _to.quantity),
        "miner": ("miner", _to.many(Miner._of)),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Elastic(Part):
    """The barrel as an elastic tube."""

    Z: Quantity
    """Batdorf's parameter of length"""
    coefficient: Quantity
    """k of the buckling stress"""
    waves: int
    """whole waves around the tube"""
    elastic_stress: Quantity
    """shear stress at which an elastic wall buckles [Pa]"""
    elastic_torque: Quantity
    """torque at which an elastic wall buckles [N*m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "Z": ("Z", _to.quantity),
        "coefficient": ("coefficient", _to.quantity),
        "waves": ("waves", _to.plain),
        "elastic_stress": ("elastic_stress", _to.quantity),
        "elastic_torque": ("elastic_torque", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Buckling(Part):
    """Buckling of the barrel from its geometry."""

    elastic: Elastic
    """the barrel as an elastic tube"""
    plastic_torque: Optional[Quantity]
    """buckling torque of a wall that yields [N*m]; None if absent"""
    reserve: Optional[Quantity]
    """buckling torque over the largest torque of the duty; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "elastic": ("elastic", Elastic._of),
        "plastic_torque": ("plastic_torque", _to.quantity),
        "reserve": ("reserve", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class States(Part):
    """The drive with worn flanks."""

    time: FloatArray
    """time of duty [s]"""
    depth: FloatArray
    """depth of wear of a pair of flanks, mean of both senses [m]"""
    lost_motion: FloatArray
    """lost motion of the worn drive [rad]"""
    K1: FloatArray
    """stiffness up to T1 of the worn drive [N*m/rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "time": ("time", _to.floats),
        "depth": ("depth", _to.floats),
        "lost_motion": ("lost_motion", _to.floats),
        "K1": ("K1", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "time": "s",
        "depth": "m",
        "lost_motion": "rad",
        "K1": "N*m/rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Wear(Part):
    """Wear of the flanks."""

    drive_rate: Quantity
    """depth per time of the flanks under torque about +z [m/s]"""
    coast_rate: Quantity
    """depth per time of the flanks under torque about -z [m/s]"""
    states: States
    """the drive with worn flanks"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "drive_rate": ("drive_rate", _to.quantity),
        "coast_rate": ("coast_rate", _to.quantity),
        "states": ("states", States._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Parts(Part):
    """The field `parts`."""

    name: str
    """the part"""
    L10: Optional[Quantity]
    """life that 90 % reach; absent without a distribution [s]; None if absent"""
    slope: Optional[Quantity]
    """Weibull's slope; None if absent"""
    end: Optional[Quantity]
    """end of a part without a distribution [s]; None if absent"""
    origin: str
    """origin of the life, or why it is not known"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.plain),
        "L10": ("L10", _to.quantity),
        "slope": ("slope", _to.quantity),
        "end": ("end", _to.quantity),
        "origin": ("origin", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Survival(Part):
    """Share of the drives over time."""

    time: FloatArray
    """time of duty [s]"""
    share: FloatArray
    """share of the drives that reach it"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "time": ("time", _to.floats),
        "share": ("share", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "time": "s",
        "share": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class LifeResult(Result):
    """What `life` answers."""

    answer: str
    """what ends the drive, and when"""
    hours: Optional[Quantity]
    """life that 90 % of the drives reach, of the parts whose life is known [s]; None if
    absent"""
    governing: str
    """part that ends first"""
    average: Average
    """the constant load that stands for the duty"""
    rules: tuple[Rules, ...]
    """the maker's rules"""
    bearing: Optional[Bearing]
    """the wave generator's bearing by the maker's rule; None if absent"""
    bearing_by_forces: Optional[BearingByForces]
    """the wave generator's bearing by the forces of its balls; None if absent"""
    output_bearing: Optional[OutputBearing]
    """the output bearing; None if absent"""
    fatigue: tuple[Fatigue, ...]
    """fatigue of the flexspline"""
    buckling: Optional[Buckling]
    """buckling of the barrel from its geometry; None if absent"""
    wear: Optional[Wear]
    """wear of the flanks; None if absent"""
    parts: tuple[Parts, ...]
    """parts and their ends"""
    survival: Survival
    """share of the drives over time"""

    command: ClassVar[str] = "life"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "answer": ("answer", _to.plain),
        "hours": ("hours", _to.quantity),
        "governing": ("governing", _to.plain),
        "average": ("average", Average._of),
        "rules": ("rules", _to.many(Rules._of)),
        "bearing": ("bearing", Bearing._of),
        "bearing_by_forces": ("bearing_by_forces", BearingByForces._of),
        "output_bearing": ("output_bearing", OutputBearing._of),
        "fatigue": ("fatigue", _to.many(Fatigue._of)),
        "buckling": ("buckling", Buckling._of),
        "wear": ("wear", Wear._of),
        "parts": ("parts", _to.many(Parts._of)),
        "survival": ("survival", Survival._of),
    }
