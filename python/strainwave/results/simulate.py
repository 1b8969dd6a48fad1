# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command simulate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


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


@dataclass(frozen=True, eq=False, repr=False)
class Contacts(Part):
    """Friction in the contacts, by the coupled drive."""

    width_at_rest: Quantity
    """width of the loops without torque, at the output [rad]"""
    width_at_rated: Quantity
    """width of the loops at the rated torque, mean of both senses [rad]"""
    teeth_in_contact: Quantity
    """teeth in contact at the rated torque, mean of both senses"""
    memory_angle: Quantity
    """angle of the input over which the loops fade to 1/e [rad]"""
    coulomb: Optional[Quantity]
    """friction of the turning input without load; absent: the file gives its own [N*m]; None if
    absent"""
    load_coulomb: Optional[Quantity]
    """share of the torque on the load, over the ratio, that adds to it; None if absent"""
    worst_deviation: Optional[Quantity]
    """largest deviation of this straight line from the computed torques, over them; None if
    absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "width_at_rest": ("width_at_rest", _to.quantity),
        "width_at_rated": ("width_at_rated", _to.quantity),
        "teeth_in_contact": ("teeth_in_contact", _to.quantity),
        "memory_angle": ("memory_angle", _to.quantity),
        "coulomb": ("coulomb", _to.quantity),
        "load_coulomb": ("load_coulomb", _to.quantity),
        "worst_deviation": ("worst_deviation", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class SimulatePart(Part):
    """The sound drive."""

    largest_torque: Quantity
    """largest magnitude of the torque of the drive on the load [N*m]"""
    largest_error: Quantity
    """largest magnitude of the output's error [rad]"""
    largest_input_torque: Quantity
    """largest magnitude of the torque of the input [N*m]"""
    last_error: Quantity
    """error of the output at the end [rad]"""
    largest_lag: Optional[Quantity]
    """largest magnitude of the angle of the input behind the given one, with a controller
    [rad]; None if absent"""
    largest_output_torque: Optional[Quantity]
    """largest magnitude of the external torque that the given speed of the output needs [N*m];
    None if absent"""
    lost_energy: Quantity
    """energy lost, or stored in drivetrain.hysteresis and in the friction [J]"""
    released_energy: Optional[Quantity]
    """part of the lost energy that the growing cracks release; absent if no crack grows [J];
    None if absent"""
    imbalance: Quantity
    """imbalance of the energy over the energy that was exchanged"""
    steps: Quantity
    """accepted steps"""
    events: Quantity
    """events at which a step ended"""
    converged: bool
    """whether the motion reached its end"""
    reason: str
    """why the motion did not reach its end"""
    time_reached: Quantity
    """time that the motion reached [s]"""
    beyond_table: bool
    """whether the motion left the table of the computed curve"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "largest_torque": ("largest_torque", _to.quantity),
        "largest_error": ("largest_error", _to.quantity),
        "largest_input_torque": ("largest_input_torque", _to.quantity),
        "last_error": ("last_error", _to.quantity),
        "largest_lag": ("largest_lag", _to.quantity),
        "largest_output_torque": ("largest_output_torque", _to.quantity),
        "lost_energy": ("lost_energy", _to.quantity),
        "released_energy": ("released_energy", _to.quantity),
        "imbalance": ("imbalance", _to.quantity),
        "steps": ("steps", _to.quantity),
        "events": ("events", _to.quantity),
        "converged": ("converged", _to.plain),
        "reason": ("reason", _to.plain),
        "time_reached": ("time_reached", _to.quantity),
        "beyond_table": ("beyond_table", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Cracks(Part):
    """The cracks whose compliance grows in the motion."""

    path: AnyArray
    """the crack"""
    sense: AnyArray
    """sense of the torque on the load that opens it: positive, negative, both"""
    first_size: FloatArray
    """depth or half length at the start [m]"""
    last_size: FloatArray
    """depth or half length at the end [m]"""
    first_compliance: FloatArray
    """compliance of the open crack at the output, at the start [rad/(N*m)]"""
    last_compliance: FloatArray
    """compliance of the open crack at the output, at the end [rad/(N*m)]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.entries),
        "sense": ("sense", _to.entries),
        "first_size": ("first_size", _to.floats),
        "last_size": ("last_size", _to.floats),
        "first_compliance": ("first_compliance", _to.floats),
        "last_compliance": ("last_compliance", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "first_size": "m",
        "last_size": "m",
        "first_compliance": "rad/(N*m)",
        "last_compliance": "rad/(N*m)",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Growth(Part):
    """Growth of the cracks during the motion."""

    time: Quantity
    """time of duty that was to pass during the motion [s]"""
    pace: Quantity
    """time of duty over the time of the motion"""
    time_at_end: Quantity
    """time of duty at the end of the motion, or of the growth [s]"""
    sentence: str
    """the answer of the growth in words"""
    first_stiffness: Quantity
    """stiffness without load at the start, with the cracks of the softer sense fully open
    [N*m/rad]"""
    last_stiffness: Quantity
    """stiffness without load at the end, with the cracks of the softer sense fully open
    [N*m/rad]"""
    cracks: Cracks
    """the cracks whose compliance grows in the motion"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "time": ("time", _to.quantity),
        "pace": ("pace", _to.quantity),
        "time_at_end": ("time_at_end", _to.quantity),
        "sentence": ("sentence", _to.plain),
        "first_stiffness": ("first_stiffness", _to.quantity),
        "last_stiffness": ("last_stiffness", _to.quantity),
        "cracks": ("cracks", Cracks._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Lines(Part):
    """The lines by rising order."""

    cause: AnyArray
    """what passes"""
    order: FloatArray
    """periods in one turn of the input"""
    turns_needed: FloatArray
    """turns of the input that separate the line from the others"""
    error: FloatArray
    """amplitude of the output's error, sound; absent if the motion does not separate the line
    [rad]"""
    torque: FloatArray
    """amplitude of the torque on the load, sound [N*m]"""
    cracked_error: FloatArray
    """amplitude of the output's error, cracked [rad]"""
    cracked_torque: FloatArray
    """amplitude of the torque on the load, cracked [N*m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "cause": ("cause", _to.entries),
        "order": ("order", _to.floats),
        "turns_needed": ("turns_needed", _to.floats),
        "error": ("error", _to.floats),
        "torque": ("torque", _to.floats),
        "cracked_error": ("cracked_error", _to.floats),
        "cracked_torque": ("cracked_torque", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "order": "1",
        "turns_needed": "1",
        "error": "rad",
        "torque": "N*m",
        "cracked_error": "rad",
        "cracked_torque": "N*m",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Orders(Part):
    """Lines of the motion while the input turns at a constant speed."""

    from_: Quantity
    """begin of the part that is analysed [s]"""
    to: Quantity
    """end of the part that is analysed [s]"""
    speed: Quantity
    """given speed of the input [rad/s]"""
    turns: Quantity
    """turns of the input in this part"""
    error_floor: Quantity
    """median amplitude of the output's error at orders without a name, sound [rad]"""
    torque_floor: Quantity
    """median amplitude of the torque at orders without a name, sound [N*m]"""
    cracked_error_floor: Optional[Quantity]
    """the same of the output's error, cracked [rad]; None if absent"""
    cracked_torque_floor: Optional[Quantity]
    """the same of the torque, cracked [N*m]; None if absent"""
    lines: Lines
    """the lines by rising order"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "from": ("from_", _to.quantity),
        "to": ("to", _to.quantity),
        "speed": ("speed", _to.quantity),
        "turns": ("turns", _to.quantity),
        "error_floor": ("error_floor", _to.quantity),
        "torque_floor": ("torque_floor", _to.quantity),
        "cracked_error_floor": ("cracked_error_floor", _to.quantity),
        "cracked_torque_floor": ("cracked_torque_floor", _to.quantity),
        "lines": ("lines", Lines._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Rows(Part):
    """The motion over time; empty if the rows were recorded."""

    time: FloatArray
    """time since the start [s]"""
    input_angle: FloatArray
    """angle of the input, sound [rad]"""
    input_speed: FloatArray
    """speed of the input, sound [rad/s]"""
    output_angle: FloatArray
    """angle of the output, sound [rad]"""
    output_speed: FloatArray
    """speed of the output, sound [rad/s]"""
    output_error: FloatArray
    """angle of the output beyond that of an ideal stiff gear, sound [rad]"""
    torque: FloatArray
    """torque of the drive on the load, sound [N*m]"""
    input_torque: FloatArray
    """torque that drives the input, sound [N*m]"""
    cracked_output_angle: FloatArray
    """angle of the output, cracked [rad]"""
    cracked_output_error: FloatArray
    """angle of the output beyond that of an ideal stiff gear, cracked [rad]"""
    cracked_torque: FloatArray
    """torque of the drive on the load, cracked [N*m]"""
    cracked_input_torque: FloatArray
    """torque that drives the input, cracked [N*m]"""
    output_torque: FloatArray
    """external torque that the given speed of the output needs, sound [N*m]"""
    cracked_output_torque: FloatArray
    """external torque that the given speed of the output needs, cracked [N*m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "time": ("time", _to.floats),
        "input_angle": ("input_angle", _to.floats),
        "input_speed": ("input_speed", _to.floats),
        "output_angle": ("output_angle", _to.floats),
        "output_speed": ("output_speed", _to.floats),
        "output_error": ("output_error", _to.floats),
        "torque": ("torque", _to.floats),
        "input_torque": ("input_torque", _to.floats),
        "cracked_output_angle": ("cracked_output_angle", _to.floats),
        "cracked_output_error": ("cracked_output_error", _to.floats),
        "cracked_torque": ("cracked_torque", _to.floats),
        "cracked_input_torque": ("cracked_input_torque", _to.floats),
        "output_torque": ("output_torque", _to.floats),
        "cracked_output_torque": ("cracked_output_torque", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "time": "s",
        "input_angle": "rad",
        "input_speed": "rad/s",
        "output_angle": "rad",
        "output_speed": "rad/s",
        "output_error": "rad",
        "torque": "N*m",
        "input_torque": "N*m",
        "cracked_output_angle": "rad",
        "cracked_output_error": "rad",
        "cracked_torque": "N*m",
        "cracked_input_torque": "N*m",
        "output_torque": "N*m",
        "cracked_output_torque": "N*m",
    }


@dataclass(frozen=True, eq=False, repr=False)
class SimulateResult(Result):
    """What `simulate` answers."""

    duration: Quantity
    """time of the motion [s]"""
    signed_ratio: Quantity
    """turns of the input per turn of the output"""
    springs: Literal["coupled_drive", "members", "computed_curve"]
    """origin of the spring: coupled_drive, members or computed_curve"""
    table: Optional[Table]
    """the table of the computed curve and its error; None if absent"""
    contacts: Optional[Contacts]
    """friction in the contacts, by the coupled drive; None if absent"""
    intact: SimulatePart
    """the sound drive"""
    cracked: Optional[SimulatePart]
    """the drive with its cracks; None if absent"""
    largest_difference: Optional[Quantity]
    """largest difference of the output's angle, cracked against sound, among the rows [rad];
    None if absent"""
    growth: Optional[Growth]
    """growth of the cracks during the motion; None if absent"""
    orders: Optional[Orders]
    """lines of the motion while the input turns at a constant speed; None if absent"""
    recorded_rows: Optional[Quantity]
    """number of rows in the record of the motion; absent: the rows are here; None if absent"""
    rows: Rows
    """the motion over time; empty if the rows were recorded"""

    command: ClassVar[str] = "simulate"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "duration": ("duration", _to.quantity),
        "signed_ratio": ("signed_ratio", _to.quantity),
        "springs": ("springs", _to.plain),
        "table": ("table", Table._of),
        "contacts": ("contacts", Contacts._of),
        "intact": ("intact", SimulatePart._of),
        "cracked": ("cracked", SimulatePart._of),
        "largest_difference": ("largest_difference", _to.quantity),
        "growth": ("growth", Growth._of),
        "orders": ("orders", Orders._of),
        "recorded_rows": ("recorded_rows", _to.quantity),
        "rows": ("rows", Rows._of),
    }
