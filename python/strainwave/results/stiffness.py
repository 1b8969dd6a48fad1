# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command stiffness."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Torques(Part):
    """The maker's torques."""

    T1: Quantity
    """torque up to which K1 holds [N*m]"""
    T2: Quantity
    """torque up to which K2 holds [N*m]"""
    T3: Quantity
    """torque up to which K3 is taken [N*m]"""
    rated: Quantity
    """T_N [N*m]"""
    lost_motion: Quantity
    """torque at which lost motion is measured [N*m]"""
    by_convention: bool
    """whether T1 and T2 were not given"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "T1": ("T1", _to.quantity),
        "T2": ("T2", _to.quantity),
        "T3": ("T3", _to.quantity),
        "rated": ("rated", _to.quantity),
        "lost_motion": ("lost_motion", _to.quantity),
        "by_convention": ("by_convention", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Intact(Part):
    """Without the cracks."""

    K1: Quantity
    """stiffness up to T1 [N*m/rad]"""
    K2: Quantity
    """stiffness from T1 to T2 [N*m/rad]"""
    K3: Quantity
    """stiffness from T2 [N*m/rad]"""
    wind_up: Optional[Quantity]
    """twist at the given torque [rad]; None if absent"""
    wind_up_at_T1: Quantity
    """twist at T1 [rad]"""
    wind_up_at_T2: Quantity
    """twist at T2 [rad]"""
    wind_up_at_T3: Quantity
    """twist at T3 [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K1": ("K1", _to.quantity),
        "K2": ("K2", _to.quantity),
        "K3": ("K3", _to.quantity),
        "wind_up": ("wind_up", _to.quantity),
        "wind_up_at_T1": ("wind_up_at_T1", _to.quantity),
        "wind_up_at_T2": ("wind_up_at_T2", _to.quantity),
        "wind_up_at_T3": ("wind_up_at_T3", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Change(Part):
    """Changes by the cracks."""

    K1: Quantity
    """K1 of the cracked over K1 of the sound drive, minus 1; negative means softer"""
    K2: Quantity
    """cracked/sound - 1 of K2"""
    K3: Quantity
    """cracked/sound - 1 of K3"""
    wind_up: Optional[Quantity]
    """wind-up of the cracked over that of the sound drive at the given torque, minus 1; None if
    absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K1": ("K1", _to.quantity),
        "K2": ("K2", _to.quantity),
        "K3": ("K3", _to.quantity),
        "wind_up": ("wind_up", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class OverTurnPart(Part):
    """Mean values over the angles."""

    K1: Quantity
    """stiffness up to T1 [N*m/rad]"""
    K2: Quantity
    """stiffness from T1 to T2 [N*m/rad]"""
    K3: Quantity
    """stiffness from T2 [N*m/rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K1": ("K1", _to.quantity),
        "K2": ("K2", _to.quantity),
        "K3": ("K3", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class OverTurn(Part):
    """Stiffnesses over a turn, if cracks turn relative to the lobes."""

    mean: OverTurnPart
    """mean values over the angles"""
    softest: OverTurnPart
    """each stiffness at the angle where it is lowest"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "mean": ("mean", OverTurnPart._of),
        "softest": ("softest", OverTurnPart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class CurvePart(Part):
    """Cracked, torque about +z."""

    K1: Quantity
    """stiffness up to T1 [N*m/rad]"""
    K2: Quantity
    """stiffness from T1 to T2 [N*m/rad]"""
    K3: Quantity
    """stiffness from T2 [N*m/rad]"""
    wind_up: Optional[Quantity]
    """twist at the given torque [rad]; None if absent"""
    wind_up_at_T1: Quantity
    """twist at T1 [rad]"""
    wind_up_at_T2: Quantity
    """twist at T2 [rad]"""
    wind_up_at_T3: Quantity
    """twist at T3 [rad]"""
    change: Change
    """changes by the cracks"""
    over_turn: Optional[OverTurn]
    """stiffnesses over a turn, if cracks turn relative to the lobes; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K1": ("K1", _to.quantity),
        "K2": ("K2", _to.quantity),
        "K3": ("K3", _to.quantity),
        "wind_up": ("wind_up", _to.quantity),
        "wind_up_at_T1": ("wind_up_at_T1", _to.quantity),
        "wind_up_at_T2": ("wind_up_at_T2", _to.quantity),
        "wind_up_at_T3": ("wind_up_at_T3", _to.quantity),
        "change": ("change", Change._of),
        "over_turn": ("over_turn", OverTurn._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Curve(Part):
    """The coupled drive: the maker's stiffnesses and the wind-up."""

    torques: Torques
    """the maker's torques"""
    intact: Intact
    """without the cracks"""
    positive: CurvePart
    """cracked, torque about +z"""
    negative: CurvePart
    """cracked, torque about -z"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torques": ("torques", Torques._of),
        "intact": ("intact", Intact._of),
        "positive": ("positive", CurvePart._of),
        "negative": ("negative", CurvePart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Life(Part):
    """Life over the duty, without cracks."""

    hours: Optional[Quantity]
    """life that 90 % of the drives reach; absent if a crack that cannot be told may end the
    drive before [s]; None if absent"""
    cracks: Optional[Quantity]
    """time of duty until a crack that can be computed ends the life [s]; None if absent"""
    bearing_L10: Optional[Quantity]
    """L10 of the wave generator's bearing by the maker's rule [s]; None if absent"""
    bearing_L50: Optional[Quantity]
    """L50 of the wave generator's bearing by the maker's rule [s]; None if absent"""
    bearing_ratio: Optional[Quantity]
    """L10 of the wave generator's bearing by its ball forces over that at rated torque and 2000
    rpm; None if absent"""
    output_bearing_L10: Optional[Quantity]
    """L10 of the output bearing [s]; None if absent"""
    average_torque: Optional[Quantity]
    """average torque of the duty [N*m]; None if absent"""
    average_input_speed: Optional[Quantity]
    """average speed of the input over the duty [rad/s]; None if absent"""
    wall_reserve: Optional[Quantity]
    """reserve of the wall against endurance; None if absent"""
    rim_reserve: Optional[Quantity]
    """reserve of the rim's bore against endurance; None if absent"""
    tooth_root_reserve: Optional[Quantity]
    """reserve of the tooth root against endurance; None if absent"""
    makers_reserve: Optional[Quantity]
    """least allowed over present of the maker's rules; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "hours": ("hours", _to.quantity),
        "cracks": ("cracks", _to.quantity),
        "bearing_L10": ("bearing_L10", _to.quantity),
        "bearing_L50": ("bearing_L50", _to.quantity),
        "bearing_ratio": ("bearing_ratio", _to.quantity),
        "output_bearing_L10": ("output_bearing_L10", _to.quantity),
        "average_torque": ("average_torque", _to.quantity),
        "average_input_speed": ("average_input_speed", _to.quantity),
        "wall_reserve": ("wall_reserve", _to.quantity),
        "rim_reserve": ("rim_reserve", _to.quantity),
        "tooth_root_reserve": ("tooth_root_reserve", _to.quantity),
        "makers_reserve": ("makers_reserve", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Compliance(Part):
    """Compliances at the output."""

    wave_generator: Quantity
    """compliance of the wave generator [rad/(N*m)]"""
    flexspline: Quantity
    """compliance of the flexspline [rad/(N*m)]"""
    output_shaft: Quantity
    """compliance of the output shaft [rad/(N*m)]"""
    total: Quantity
    """sum of the members [rad/(N*m)]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "wave_generator": ("wave_generator", _to.quantity),
        "flexspline": ("flexspline", _to.quantity),
        "output_shaft": ("output_shaft", _to.quantity),
        "total": ("total", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class StiffnessIntact(Part):
    """Sum of the members without contacts, sound."""

    compliance: Compliance
    """compliances at the output"""
    stiffness: Quantity
    """K_HD of the sum at the output with locked input [N*m/rad]"""
    wind_up: Quantity
    """twist at the given torque [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "compliance": ("compliance", Compliance._of),
        "stiffness": ("stiffness", _to.quantity),
        "wind_up": ("wind_up", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class CrackedPart(Part):
    """Torque about +z."""

    compliance: Compliance
    """compliances at the output"""
    stiffness: Quantity
    """K_HD of the sum at the output with locked input [N*m/rad]"""
    stiffness_change: Quantity
    """K/K_intact - 1; negative means softer"""
    wind_up: Quantity
    """twist at the given torque [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "compliance": ("compliance", Compliance._of),
        "stiffness": ("stiffness", _to.quantity),
        "stiffness_change": ("stiffness_change", _to.quantity),
        "wind_up": ("wind_up", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Cracked(Part):
    """Sum of the members without contacts, with cracks."""

    positive: CrackedPart
    """torque about +z"""
    negative: CrackedPart
    """torque about -z"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "positive": ("positive", CrackedPart._of),
        "negative": ("negative", CrackedPart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class AddedCompliancePart(Part):
    """Torque about +z."""

    at_output: Quantity
    """contribution to the drive's compliance [rad/(N*m)]"""
    axial_axial: Optional[Quantity]
    """extension per axial force [m/N]; None if absent"""
    axial_torsion: Optional[Quantity]
    """twist per axial force, or extension per torque [1/N]; None if absent"""
    torsion_torsion: Optional[Quantity]
    """twist per torque [rad/(N*m)]; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "at_output": ("at_output", _to.quantity),
        "axial_axial": ("axial_axial", _to.quantity),
        "axial_torsion": ("axial_torsion", _to.quantity),
        "torsion_torsion": ("torsion_torsion", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class AddedCompliance(Part):
    """Compliance that the crack adds."""

    positive: AddedCompliancePart
    """torque about +z"""
    negative: AddedCompliancePart
    """torque about -z"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "positive": ("positive", AddedCompliancePart._of),
        "negative": ("negative", AddedCompliancePart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class StressIntensityPart(Part):
    """Values at the deepest point, or at the tip."""

    K_I: Quantity
    """opening [Pa*m^0.5]"""
    K_II: Quantity
    """sliding [Pa*m^0.5]"""
    K_III: Quantity
    """tearing [Pa*m^0.5]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K_I": ("K_I", _to.quantity),
        "K_II": ("K_II", _to.quantity),
        "K_III": ("K_III", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class StressIntensity(Part):
    """Stress intensities at the given load."""

    deepest: Optional[StressIntensityPart]
    """values at the deepest point, or at the tip; None if absent"""
    largest: Optional[StressIntensityPart]
    """largest magnitude of each mode along the front; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "deepest": ("deepest", StressIntensityPart._of),
        "largest": ("largest", StressIntensityPart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class AtWork(Part):
    """K_I over a turn of the wave generator at the given torque, where its range is largest."""

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


@dataclass(frozen=True, eq=False, repr=False)
class StatesPart(Part):
    """Size at which K reaches K_Ic."""

    size: Optional[Quantity]
    """depth or half length; absent: not reached in the range [m]; None if absent"""
    none_up_to: Optional[Quantity]
    """end of the range, if the criterion is not reached in the range [m]; None if absent"""
    text: str
    """reason why there is no size; else empty"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "size": ("size", _to.quantity),
        "none_up_to": ("none_up_to", _to.quantity),
        "text": ("text", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class States(Part):
    """The field `states`."""

    torque: Literal["positive", "negative"]
    """sense of the torque"""
    with_assembly: bool
    """whether bending of the wall by the wave generator is included"""
    verdict: Literal["acceptable", "fractures", "collapses", "cannot_tell"]
    """verdict of the failure assessment"""
    unknown: str
    """missing input if the verdict is cannot_tell"""
    K_load: Quantity
    """equivalent K of the load alone at the worst point [Pa*m^0.5]"""
    K_assembly: Quantity
    """equivalent K of the assembly alone at the worst point [Pa*m^0.5]"""
    K: Quantity
    """equivalent K of load and assembly together at the worst point [Pa*m^0.5]"""
    utilisation: Optional[Quantity]
    """K/K_Ic; None if absent"""
    L_r: Optional[Quantity]
    """reference stress over yield strength; None if absent"""
    interaction: Optional[Quantity]
    """factor V on the K of the assembly; None if absent"""
    K_r: Optional[Quantity]
    """K with V on the assembly's part, over K_Ic; None if absent"""
    line: Optional[Quantity]
    """f(L_r), the largest accepted K_r; None if absent"""
    reserve: Optional[Quantity]
    """factor on the given load at which the line is reached; None if absent"""
    plastic_zone: Optional[Quantity]
    """radius of the plastic zone [m]; None if absent"""
    brittle_size: Optional[StatesPart]
    """size at which K reaches K_Ic; None if absent"""
    critical_size: Optional[StatesPart]
    """size at which the line is reached; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.plain),
        "with_assembly": ("with_assembly", _to.plain),
        "verdict": ("verdict", _to.plain),
        "unknown": ("unknown", _to.plain),
        "K_load": ("K_load", _to.quantity),
        "K_assembly": ("K_assembly", _to.quantity),
        "K": ("K", _to.quantity),
        "utilisation": ("utilisation", _to.quantity),
        "L_r": ("L_r", _to.quantity),
        "interaction": ("interaction", _to.quantity),
        "K_r": ("K_r", _to.quantity),
        "line": ("line", _to.quantity),
        "reserve": ("reserve", _to.quantity),
        "plastic_zone": ("plastic_zone", _to.quantity),
        "brittle_size": ("brittle_size", StatesPart._of),
        "critical_size": ("critical_size", StatesPart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Notes(Part):
    """The field `notes`."""

    text: str
    """effect that the verdict leaves out"""
    equation: str
    """tag of the theory manual"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "text": ("text", _to.plain),
        "equation": ("equation", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Strength(Part):
    """Strength at the given load."""

    K: Optional[Quantity]
    """equivalent K at the worst point in the worst state [Pa*m^0.5]; None if absent"""
    utilisation: Optional[Quantity]
    """K/K_Ic; None if absent"""
    L_r: Optional[Quantity]
    """reference stress over yield strength; None if absent"""
    K_r: Optional[Quantity]
    """K over K_Ic, with the interaction of the assembly; None if absent"""
    line: Optional[Quantity]
    """largest accepted K_r; None if absent"""
    reserve: Optional[Quantity]
    """least factor on the load at which the line is reached; None if absent"""
    brittle_size: Optional[Quantity]
    """size at which K reaches K_Ic [m]; None if absent"""
    critical_size: Optional[Quantity]
    """size at which the line is reached [m]; None if absent"""
    plastic_zone: Optional[Quantity]
    """radius of the plastic zone [m]; None if absent"""
    ligament: Optional[Quantity]
    """remaining thickness of the section [m]; None if absent"""
    verdict: Literal["acceptable", "fractures", "collapses", "cannot_tell"]
    """verdict of the failure assessment"""
    sentence: str
    """the verdict in words"""
    size_name: str
    """depth or half_length"""
    size: Quantity
    """present size [m]"""
    material: str
    """name of the material"""
    toughness: Optional[Quantity]
    """K_Ic [Pa*m^0.5]; None if absent"""
    governing: int
    """index of the worst state"""
    states: tuple[States, ...]
    """each sense of torque, load alone and with the assembly"""
    notes: tuple[Notes, ...]
    """effects that the verdict leaves out"""
    equations: tuple[str, ...]
    """tags of the theory manual"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K": ("K", _to.quantity),
        "utilisation": ("utilisation", _to.quantity),
        "L_r": ("L_r", _to.quantity),
        "K_r": ("K_r", _to.quantity),
        "line": ("line", _to.quantity),
        "reserve": ("reserve", _to.quantity),
        "brittle_size": ("brittle_size", _to.quantity),
        "critical_size": ("critical_size", _to.quantity),
        "plastic_zone": ("plastic_zone", _to.quantity),
        "ligament": ("ligament", _to.quantity),
        "verdict": ("verdict", _to.plain),
        "sentence": ("sentence", _to.plain),
        "size_name": ("size_name", _to.plain),
        "size": ("size", _to.quantity),
        "material": ("material", _to.plain),
        "toughness": ("toughness", _to.quantity),
        "governing": ("governing", _to.plain),
        "states": ("states", _to.many(States._of)),
        "notes": ("notes", _to.many(Notes._of)),
        "equations": ("equations", _to.many(_to.plain)),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Cracks(Part):
    """The field `cracks`."""

    path: str
    """field of the input"""
    kind: str
    """kind of the crack"""
    opens_under: Optional[Literal["neither", "positive", "negative", "both"]]
    """sense of torque that opens the faces; None if absent"""
    added_compliance: Optional[AddedCompliance]
    """compliance that the crack adds; None if absent"""
    stress_intensity: Optional[StressIntensity]
    """stress intensities at the given load; None if absent"""
    at_work: Optional[AtWork]
    """K_I over a turn of the wave generator at the given torque, where its range is largest;
    None if absent"""
    strength: Optional[Strength]
    """strength at the given load; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.plain),
        "kind": ("kind", _to.plain),
        "opens_under": ("opens_under", _to.plain),
        "added_compliance": ("added_compliance", AddedCompliance._of),
        "stress_intensity": ("stress_intensity", StressIntensity._of),
        "at_work": ("at_work", AtWork._of),
        "strength": ("strength", Strength._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class StiffnessResult(Result):
    """What `stiffness` answers."""

    method: Literal["as-printed", "repaired", "corrected"]
    """as-printed, repaired or corrected"""
    curve: Optional[Curve]
    """the coupled drive: the maker's stiffnesses and the wind-up; None if absent"""
    life: Optional[Life]
    """life over the duty, without cracks; None if absent"""
    intact: StiffnessIntact
    """sum of the members without contacts, sound"""
    cracked: Cracked
    """sum of the members without contacts, with cracks"""
    cracks: tuple[Cracks, ...]
    """outputs of each crack"""

    command: ClassVar[str] = "stiffness"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot", "fad")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "method": ("method", _to.plain),
        "curve": ("curve", Curve._of),
        "life": ("life", Life._of),
        "intact": ("intact", StiffnessIntact._of),
        "cracked": ("cracked", Cracked._of),
        "cracks": ("cracks", _to.many(Cracks._of)),
    }
