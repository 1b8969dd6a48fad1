# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command torsion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity
from .stiffness import Torques


@dataclass(frozen=True, eq=False, repr=False)
class AtLoad(Part):
    """Twist at the torque of the load."""

    torque: Quantity
    """load.torque, in size [N*m]"""
    positive: Optional[Quantity]
    """twist under torque about +z; null if it is not reached [rad]; None if absent"""
    negative: Optional[Quantity]
    """twist under torque about -z [rad]; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.quantity),
        "positive": ("positive", _to.quantity),
        "negative": ("negative", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class TorsionPart(Part):
    """The maker's lines under torque about +z."""

    K1: Quantity
    """T1/phi(T1) [N*m/rad]"""
    K2: Quantity
    """slope from T1 to T2 [N*m/rad]"""
    K3: Quantity
    """slope from T2 to T3 [N*m/rad]"""
    phi1: Quantity
    """twist at T1 [rad]"""
    phi2: Quantity
    """twist at T2 [rad]"""
    phi3: Quantity
    """twist at T3 [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K1": ("K1", _to.quantity),
        "K2": ("K2", _to.quantity),
        "K3": ("K3", _to.quantity),
        "phi1": ("phi1", _to.quantity),
        "phi2": ("phi2", _to.quantity),
        "phi3": ("phi3", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class OverCagePart(Part):
    """Mean over the phases."""

    K1: Quantity
    """T1/phi(T1) [N*m/rad]"""
    K2: Quantity
    """slope from T1 to T2 [N*m/rad]"""
    K3: Quantity
    """slope from T2 to T3 [N*m/rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K1": ("K1", _to.quantity),
        "K2": ("K2", _to.quantity),
        "K3": ("K3", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class AtPhase(Part):
    """Values at each phase."""

    K1: FloatArray
    """T1/phi(T1) [N*m/rad]"""
    K2: FloatArray
    """slope from T1 to T2 [N*m/rad]"""
    K3: FloatArray
    """slope from T2 to T3 [N*m/rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K1": ("K1", _to.floats),
        "K2": ("K2", _to.floats),
        "K3": ("K3", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "K1": "N*m/rad",
        "K2": "N*m/rad",
        "K3": "N*m/rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class OverCage(Part):
    """K1, K2, K3 under torque about +z over the phases of the cage."""

    phases: FloatArray
    """angles of the first ball from the major axis [rad]"""
    mean: OverCagePart
    """mean over the phases"""
    softest: OverCagePart
    """lowest value of each"""
    stiffest: OverCagePart
    """highest value of each"""
    at_phase: AtPhase
    """values at each phase"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "phases": ("phases", _to.floats),
        "mean": ("mean", OverCagePart._of),
        "softest": ("softest", OverCagePart._of),
        "stiffest": ("stiffest", OverCagePart._of),
        "at_phase": ("at_phase", AtPhase._of),
    }
    _units: ClassVar[dict[str, str]] = {
        "phases": "rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Hysteresis(Part):
    """Hysteresis loop at rated torque."""

    amplitude: Quantity
    """T, amplitude of the torque [N*m]"""
    width_at_zero: Quantity
    """width without torque, maker's hysteresis loss [rad]"""
    largest_width: Quantity
    """largest width of the loop [rad]"""
    torque_of_largest_width: Quantity
    """magnitude of the torque at the largest width [N*m]"""
    lost_energy: Quantity
    """area of the loop [J]"""
    torque: FloatArray
    """torques down from +T to -T and up again [N*m]"""
    twist: FloatArray
    """twist at each torque [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "amplitude": ("amplitude", _to.quantity),
        "width_at_zero": ("width_at_zero", _to.quantity),
        "largest_width": ("largest_width", _to.quantity),
        "torque_of_largest_width": ("torque_of_largest_width", _to.quantity),
        "lost_energy": ("lost_energy", _to.quantity),
        "torque": ("torque", _to.floats),
        "twist": ("twist", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "torque": "N*m",
        "twist": "rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class LossAtZero(Part):
    """Width of the hysteresis loop at zero torque, by its causes."""

    total: Quantity
    """maker's hysteresis loss [rad]"""
    flanks: Quantity
    """by flanks that press on each other without torque [rad]"""
    outer_ring: Quantity
    """by the outer ring in the bore of the rim [rad]"""
    output: Quantity
    """by rating.friction_torque [rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "total": ("total", _to.quantity),
        "flanks": ("flanks", _to.quantity),
        "outer_ring": ("outer_ring", _to.quantity),
        "output": ("output", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class NoLoad(Part):
    """Torque that turns the input without load, without the grease, by its causes."""

    total: Quantity
    """torque that turns the input slowly [N*m]"""
    balls: Quantity
    """rolling friction of the balls [N*m]"""
    outer_ring: Quantity
    """slip of the outer ring in the bore of the rim [N*m]"""
    flanks: Quantity
    """slip of the flanks [N*m]"""
    output: Quantity
    """rating.friction_torque over the ratio [N*m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "total": ("total", _to.quantity),
        "balls": ("balls", _to.quantity),
        "outer_ring": ("outer_ring", _to.quantity),
        "flanks": ("flanks", _to.quantity),
        "output": ("output", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Friction(Part):
    """Losses without load."""

    loss_at_zero: LossAtZero
    """width of the hysteresis loop at zero torque, by its causes"""
    no_load: NoLoad
    """torque that turns the input without load, without the grease, by its causes"""
    back_driving_torque: Optional[Quantity]
    """torque at the output that turns a free input; absent if above the rated torque [N*m];
    None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "loss_at_zero": ("loss_at_zero", LossAtZero._of),
        "no_load": ("no_load", NoLoad._of),
        "back_driving_torque": ("back_driving_torque", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Share(Part):
    """Shares of the members in the tangent compliance."""

    balls: FloatArray
    """share in the tangent compliance"""
    rim_bending: FloatArray
    """share in the tangent compliance"""
    outer_ring_bending: FloatArray
    """share in the tangent compliance"""
    barrel_warping: FloatArray
    """share in the tangent compliance"""
    diaphragm_warping: FloatArray
    """share in the tangent compliance"""
    rim_extension: FloatArray
    """share in the tangent compliance"""
    teeth: FloatArray
    """share in the tangent compliance"""
    circular_spline: FloatArray
    """share in the tangent compliance"""
    barrel: FloatArray
    """share in the tangent compliance"""
    diaphragm: FloatArray
    """share in the tangent compliance"""
    rim_shear: FloatArray
    """share in the tangent compliance"""
    boss_and_flange: FloatArray
    """share in the tangent compliance"""
    series_cracks: FloatArray
    """share in the tangent compliance"""
    output_shaft: FloatArray
    """share in the tangent compliance"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "balls": ("balls", _to.floats),
        "rim_bending": ("rim_bending", _to.floats),
        "outer_ring_bending": ("outer_ring_bending", _to.floats),
        "barrel_warping": ("barrel_warping", _to.floats),
        "diaphragm_warping": ("diaphragm_warping", _to.floats),
        "rim_extension": ("rim_extension", _to.floats),
        "teeth": ("teeth", _to.floats),
        "circular_spline": ("circular_spline", _to.floats),
        "barrel": ("barrel", _to.floats),
        "diaphragm": ("diaphragm", _to.floats),
        "rim_shear": ("rim_shear", _to.floats),
        "boss_and_flange": ("boss_and_flange", _to.floats),
        "series_cracks": ("series_cracks", _to.floats),
        "output_shaft": ("output_shaft", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "balls": "1",
        "rim_bending": "1",
        "outer_ring_bending": "1",
        "barrel_warping": "1",
        "diaphragm_warping": "1",
        "rim_extension": "1",
        "teeth": "1",
        "circular_spline": "1",
        "barrel": "1",
        "diaphragm": "1",
        "rim_shear": "1",
        "boss_and_flange": "1",
        "series_cracks": "1",
        "output_shaft": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class PointsPart(Part):
    """All balls."""

    position: FloatArray
    """angle from the major axis, toward +theta [rad]"""
    force: FloatArray
    """force of the contact [N]"""
    tangent: FloatArray
    """change of the force with the torque [1/m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "position": ("position", _to.floats),
        "force": ("force", _to.floats),
        "tangent": ("tangent", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "position": "rad",
        "force": "N",
        "tangent": "1/m",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Points(Part):
    """The drive in equilibrium at each torque."""

    torque: FloatArray
    """T, torque at the output [N*m]"""
    twist: FloatArray
    """twist phi of the output with locked input [rad]"""
    tangent_stiffness: FloatArray
    """dT/d phi [N*m/rad]"""
    secant_stiffness: FloatArray
    """T/phi [N*m/rad]"""
    teeth_in_contact: FloatArray
    """teeth that touch on either flank"""
    balls_in_contact: FloatArray
    """balls that carry load"""
    share: Share
    """shares of the members in the tangent compliance"""
    balls: PointsPart
    """all balls"""
    drive_flanks: PointsPart
    """drive flanks in contact"""
    coast_flanks: PointsPart
    """coast flanks in contact"""
    residual: FloatArray
    """residual of the contact forces, relative to the largest"""
    iterations: AnyArray
    """steps of the solver"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.floats),
        "twist": ("twist", _to.floats),
        "tangent_stiffness": ("tangent_stiffness", _to.floats),
        "secant_stiffness": ("secant_stiffness", _to.floats),
        "teeth_in_contact": ("teeth_in_contact", _to.floats),
        "balls_in_contact": ("balls_in_contact", _to.floats),
        "share": ("share", Share._of),
        "balls": ("balls", PointsPart._of),
        "drive_flanks": ("drive_flanks", PointsPart._of),
        "coast_flanks": ("coast_flanks", PointsPart._of),
        "residual": ("residual", _to.floats),
        "iterations": ("iterations", _to.entries),
    }
    _units: ClassVar[dict[str, str]] = {
        "torque": "N*m",
        "twist": "rad",
        "tangent_stiffness": "N*m/rad",
        "secant_stiffness": "N*m/rad",
        "teeth_in_contact": "1",
        "balls_in_contact": "1",
        "residual": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class TorsionPart2(Part):
    """Curve under torque about +z."""

    teeth: int
    """z, teeth of the flexspline"""
    cam_amplitude: Quantity
    """cam amplitude A that lifts the lobe to w_0 [m]"""
    assembly_ball_force: Quantity
    """largest ball force without torque [N]"""
    assembly_flank_force: Quantity
    """largest flank force without torque [N]"""
    series_compliance: Quantity
    """compliance of the members outside the ring [rad/(N*m)]"""
    points: Points
    """the drive in equilibrium at each torque"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "teeth": ("teeth", _to.plain),
        "cam_amplitude": ("cam_amplitude", _to.quantity),
        "assembly_ball_force": ("assembly_ball_force", _to.quantity),
        "assembly_flank_force": ("assembly_flank_force", _to.quantity),
        "series_compliance": ("series_compliance", _to.quantity),
        "points": ("points", Points._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Rim(Part):
    """Rim and barrel over a turn of the wave generator, at rated torque."""

    position: FloatArray
    """angle from the major axis [rad]"""
    radial: FloatArray
    """w, outward [m]"""
    tangential: FloatArray
    """v, toward +theta [m]"""
    rim_outside_stress: FloatArray
    """hoop stress at the tooth roots [Pa]"""
    rim_inside_stress: FloatArray
    """hoop stress at the bore [Pa]"""
    barrel_bending_stress: FloatArray
    """hoop stress at the outer surface of the barrel's end; absent for a laminate [Pa]"""
    barrel_shear_stress: FloatArray
    """shear stress from the torque in the barrel [Pa]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "position": ("position", _to.floats),
        "radial": ("radial", _to.floats),
        "tangential": ("tangential", _to.floats),
        "rim_outside_stress": ("rim_outside_stress", _to.floats),
        "rim_inside_stress": ("rim_inside_stress", _to.floats),
        "barrel_bending_stress": ("barrel_bending_stress", _to.floats),
        "barrel_shear_stress": ("barrel_shear_stress", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "position": "rad",
        "radial": "m",
        "tangential": "m",
        "rim_outside_stress": "Pa",
        "rim_inside_stress": "Pa",
        "barrel_bending_stress": "Pa",
        "barrel_shear_stress": "Pa",
    }


@dataclass(frozen=True, eq=False, repr=False)
class BandsPart(Part):
    """Band of K1."""

    low: Quantity
    """5 % [N*m/rad]"""
    median: Quantity
    """50 % [N*m/rad]"""
    high: Quantity
    """95 % [N*m/rad]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "low": ("low", _to.quantity),
        "median": ("median", _to.quantity),
        "high": ("high", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Bands(Part):
    """Bands of the lines under the ranges of the file."""

    K1: BandsPart
    """band of K1"""
    K2: BandsPart
    """band of K2"""
    K3: BandsPart
    """band of K3"""
    ranges: int
    """ranges of numbers that enter the curve"""
    draws: int
    """drawn drives that gave a curve"""
    rejected: int
    """drawn drives that broke a rule or did not assemble"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K1": ("K1", BandsPart._of),
        "K2": ("K2", BandsPart._of),
        "K3": ("K3", BandsPart._of),
        "ranges": ("ranges", _to.plain),
        "draws": ("draws", _to.plain),
        "rejected": ("rejected", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class PositivePart(Part):
    """Changes at the positions of the file."""

    K1: Quantity
    """cracked/sound - 1 of K1"""
    K2: Quantity
    """cracked/sound - 1 of K2"""
    K3: Quantity
    """cracked/sound - 1 of K3"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K1": ("K1", _to.quantity),
        "K2": ("K2", _to.quantity),
        "K3": ("K3", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class AtAngle(Part):
    """Changes at each position of the wave generator."""

    K1: FloatArray
    """cracked/sound - 1 of K1"""
    K2: FloatArray
    """cracked/sound - 1 of K2"""
    K3: FloatArray
    """cracked/sound - 1 of K3"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "K1": ("K1", _to.floats),
        "K2": ("K2", _to.floats),
        "K3": ("K3", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "K1": "1",
        "K2": "1",
        "K3": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class ComparisonPart(Part):
    """Changes under torque about +z."""

    as_given: PositivePart
    """changes at the positions of the file"""
    mean: PositivePart
    """mean over a turn"""
    worst: PositivePart
    """most negative change of each"""
    best: PositivePart
    """least negative change of each"""
    ripple: PositivePart
    """best minus worst"""
    ripple_order: int
    """periods of K1 per turn of the wave generator against the cracked part; 0: no ripple"""
    at_angle: AtAngle
    """changes at each position of the wave generator"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "as_given": ("as_given", PositivePart._of),
        "mean": ("mean", PositivePart._of),
        "worst": ("worst", PositivePart._of),
        "best": ("best", PositivePart._of),
        "ripple": ("ripple", PositivePart._of),
        "ripple_order": ("ripple_order", _to.plain),
        "at_angle": ("at_angle", AtAngle._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Comparison(Part):
    """Drive with cracks compared with the drive without."""

    torques: Torques
    """the maker's torques"""
    sound: TorsionPart
    """the maker's lines without cracks"""
    angles: FloatArray
    """angles by which the wave generator has turned [rad]"""
    positive: ComparisonPart
    """changes under torque about +z"""
    negative: ComparisonPart
    """changes under torque about -z"""
    lost_motion_sound: Quantity
    """lost motion without cracks [rad]"""
    lost_motion_cracked: Quantity
    """lost motion with cracks, at the positions of the file [rad]"""
    hysteresis_sound: Quantity
    """largest width of the loop without cracks [rad]"""
    hysteresis_cracked: Quantity
    """largest width of the loop with cracks [rad]"""
    crack_class: Literal["none", "series", "contact_path", "undecided"]
    """kind of member that contains the cracks"""
    class_ratio: Quantity
    """mean change of K1 over that of K3"""
    evidence: str
    """reason of the class"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torques": ("torques", Torques._of),
        "sound": ("sound", TorsionPart._of),
        "angles": ("angles", _to.floats),
        "positive": ("positive", ComparisonPart._of),
        "negative": ("negative", ComparisonPart._of),
        "lost_motion_sound": ("lost_motion_sound", _to.quantity),
        "lost_motion_cracked": ("lost_motion_cracked", _to.quantity),
        "hysteresis_sound": ("hysteresis_sound", _to.quantity),
        "hysteresis_cracked": ("hysteresis_cracked", _to.quantity),
        "crack_class": ("crack_class", _to.plain),
        "class_ratio": ("class_ratio", _to.quantity),
        "evidence": ("evidence", _to.plain),
    }
    _units: ClassVar[dict[str, str]] = {
        "angles": "rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Limits(Part):
    """Deviations that the tolerances allow."""

    single_pitch: Quantity
    """f_pT, limit of the single pitch deviation of ISO 1328-1 [m]"""
    position: Quantity
    """standard deviation of the middle of a tooth along the pitch circle [m]"""
    thickness: Quantity
    """standard deviation of the thickness of a tooth [m]"""
    diameter_of_ball: Quantity
    """standard deviation of the diameters of the balls [m]"""
    eccentricity: Quantity
    """eccentricity of the cam in the bearing, in a drawn direction [m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "single_pitch": ("single_pitch", _to.quantity),
        "position": ("position", _to.quantity),
        "thickness": ("thickness", _to.quantity),
        "diameter_of_ball": ("diameter_of_ball", _to.quantity),
        "eccentricity": ("eccentricity", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class TolerancesPart(Part):
    """K1 over half of the twist between both senses of torque."""

    nominal: Quantity
    """without deviations"""
    low: Quantity
    """5 % of the drawn drives"""
    median: Quantity
    """50 % of the drawn drives"""
    high: Quantity
    """95 % of the drawn drives"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "nominal": ("nominal", _to.quantity),
        "low": ("low", _to.quantity),
        "median": ("median", _to.quantity),
        "high": ("high", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class ContactsPart(Part):
    """Flanks in contact."""

    nominal: FloatArray
    """without deviations"""
    low: FloatArray
    """5 % of the drawn drives"""
    median: FloatArray
    """50 % of the drawn drives"""
    high: FloatArray
    """95 % of the drawn drives"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "nominal": ("nominal", _to.floats),
        "low": ("low", _to.floats),
        "median": ("median", _to.floats),
        "high": ("high", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "nominal": "1",
        "low": "1",
        "median": "1",
        "high": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Contacts(Part):
    """Contacts at T1, T2 and T3."""

    torque: FloatArray
    """torque at the output [N*m]"""
    flanks: ContactsPart
    """flanks in contact"""
    teeth: ContactsPart
    """teeth in contact"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torque": ("torque", _to.floats),
        "flanks": ("flanks", ContactsPart._of),
        "teeth": ("teeth", ContactsPart._of),
    }
    _units: ClassVar[dict[str, str]] = {
        "torque": "N*m",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Tolerances(Part):
    """Drives whose parts are drawn from their tolerances."""

    limits: Limits
    """deviations that the tolerances allow"""
    K1: TolerancesPart
    """K1 over half of the twist between both senses of torque"""
    K2: TolerancesPart
    """K2, likewise"""
    K3: TolerancesPart
    """K3, likewise"""
    lost_motion: TolerancesPart
    """lost motion"""
    ripple: TolerancesPart
    """largest less least K1 over its mean, over a turn of the wave generator"""
    contacts: Contacts
    """contacts at T1, T2 and T3"""
    positions: int
    """positions of the wave generator for the ripple"""
    draws: int
    """drawn drives that gave a curve"""
    failed: int
    """drawn drives without an equilibrium"""
    seed: int
    """seed of the draws"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "limits": ("limits", Limits._of),
        "K1": ("K1", TolerancesPart._of),
        "K2": ("K2", TolerancesPart._of),
        "K3": ("K3", TolerancesPart._of),
        "lost_motion": ("lost_motion", TolerancesPart._of),
        "ripple": ("ripple", TolerancesPart._of),
        "contacts": ("contacts", Contacts._of),
        "positions": ("positions", _to.plain),
        "draws": ("draws", _to.plain),
        "failed": ("failed", _to.plain),
        "seed": ("seed", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class TorsionResult(Result):
    """What `torsion` answers."""

    torques: Torques
    """the maker's torques"""
    at_load: AtLoad
    """twist at the torque of the load"""
    positive: TorsionPart
    """the maker's lines under torque about +z"""
    negative: TorsionPart
    """the maker's lines under torque about -z"""
    over_cage: OverCage
    """K1, K2, K3 under torque about +z over the phases of the cage"""
    lost_motion: Quantity
    """lost motion between both senses of torque [rad]"""
    hysteresis: Hysteresis
    """hysteresis loop at rated torque"""
    friction: Friction
    """losses without load"""
    curve: TorsionPart2
    """curve under torque about +z"""
    curve_negative: TorsionPart2
    """curve under torque about -z"""
    rim: Rim
    """rim and barrel over a turn of the wave generator, at rated torque"""
    bands: Optional[Bands]
    """bands of the lines under the ranges of the file; None if absent"""
    comparison: Optional[Comparison]
    """drive with cracks compared with the drive without; None if absent"""
    tolerances: Optional[Tolerances]
    """drives whose parts are drawn from their tolerances; None if absent"""

    command: ClassVar[str] = "torsion"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "torques": ("torques", Torques._of),
        "at_load": ("at_load", AtLoad._of),
        "positive": ("positive", TorsionPart._of),
        "negative": ("negative", TorsionPart._of),
        "over_cage": ("over_cage", OverCage._of),
        "lost_motion": ("lost_motion", _to.quantity),
        "hysteresis": ("hysteresis", Hysteresis._of),
        "friction": ("friction", Friction._of),
        "curve": ("curve", TorsionPart2._of),
        "curve_negative": ("curve_negative", TorsionPart2._of),
        "rim": ("rim", Rim._of),
        "bands": ("bands", Bands._of),
        "comparison": ("comparison", Comparison._of),
        "tolerances": ("tolerances", Tolerances._of),
    }
