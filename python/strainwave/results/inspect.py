# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command inspect."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Outcomes(Part):
    """How the drawn drives end."""

    failed: int
    """a crack ends the life before the end of service"""
    later: int
    """a crack ends the life after the end of service"""
    arrested: int
    """no crack grows any more: the life has no end"""
    unfinished: int
    """no end within the longest duty that is computed"""
    out_of_range: int
    """a crack leaves the range of its solution, which counts as a failure at that time"""
    refused: int
    """the drawn numbers break a rule of the input, or have no answer; left out"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "failed": ("failed", _to.plain),
        "later": ("later", _to.plain),
        "arrested": ("arrested", _to.plain),
        "unfinished": ("unfinished", _to.plain),
        "out_of_range": ("out_of_range", _to.plain),
        "refused": ("refused", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Percentiles(Part):
    """Percentiles of the life."""

    share: FloatArray
    """share of the drives with a shorter life"""
    life: FloatArray
    """the life; absent: endless [s]"""
    lower: FloatArray
    """lower limit with 95 % confidence; absent: endless [s]"""
    upper: FloatArray
    """upper limit with 95 % confidence; absent: endless, or not known [s]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "share": ("share", _to.floats),
        "life": ("life", _to.floats),
        "lower": ("lower", _to.floats),
        "upper": ("upper", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "share": "1",
        "life": "s",
        "lower": "s",
        "upper": "s",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Shares(Part):
    """What the scatter of the life comes from."""

    path: AnyArray
    """the number that scatters"""
    share: FloatArray
    """share in the variance of the logarithm of the life, linear part"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.entries),
        "share": ("share", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "share": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class AtEnd(Part):
    """Probabilities of failure up to the end of service."""

    time: Quantity
    """time of duty [s]"""
    without: Quantity
    """probability of failure without inspections"""
    without_low: Quantity
    """lower limit with 95 % confidence"""
    without_high: Quantity
    """upper limit with 95 % confidence"""
    inspected: Optional[Quantity]
    """probability of failure with the inspections; None if absent"""
    inspected_low: Optional[Quantity]
    """lower limit with 95 % confidence; None if absent"""
    inspected_high: Optional[Quantity]
    """upper limit with 95 % confidence; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "time": ("time", _to.quantity),
        "without": ("without", _to.quantity),
        "without_low": ("without_low", _to.quantity),
        "without_high": ("without_high", _to.quantity),
        "inspected": ("inspected", _to.quantity),
        "inspected_low": ("inspected_low", _to.quantity),
        "inspected_high": ("inspected_high", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Risk(Part):
    """Probabilities of failure over time."""

    time: FloatArray
    """time of duty [s]"""
    without: FloatArray
    """probability of failure without inspections"""
    without_low: FloatArray
    """lower limit with 95 % confidence"""
    without_high: FloatArray
    """upper limit with 95 % confidence"""
    inspected: FloatArray
    """probability of failure with the inspections"""
    inspected_low: FloatArray
    """lower limit with 95 % confidence"""
    inspected_high: FloatArray
    """upper limit with 95 % confidence"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "time": ("time", _to.floats),
        "without": ("without", _to.floats),
        "without_low": ("without_low", _to.floats),
        "without_high": ("without_high", _to.floats),
        "inspected": ("inspected", _to.floats),
        "inspected_low": ("inspected_low", _to.floats),
        "inspected_high": ("inspected_high", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "time": "s",
        "without": "1",
        "without_low": "1",
        "without_high": "1",
        "inspected": "1",
        "inspected_low": "1",
        "inspected_high": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Inputs(Part):
    """The inputs there, the most deviating first."""

    path: AnyArray
    """the number that scatters"""
    unit: AnyArray
    """SI unit of the number"""
    value: AnyArray
    """value in the file"""
    at_centre: AnyArray
    """value at the centre of the failures"""
    deviations: FloatArray
    """standard normal deviate there"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.entries),
        "unit": ("unit", _to.entries),
        "value": ("value", _to.entries),
        "at_centre": ("at_centre", _to.entries),
        "deviations": ("deviations", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "deviations": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Centres(Part):
    """The field `centres`."""

    distance: Quantity
    """distance of the centre from the inputs of the file"""
    inputs: Inputs
    """the inputs there, the most deviating first"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "distance": ("distance", _to.quantity),
        "inputs": ("inputs", Inputs._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class ImportanceSampling(Part):
    """The draws about the failures, and what the others say."""

    centres: tuple[Centres, ...]
    """places about which equal numbers of draws scatter"""
    rounds: int
    """rounds of draws that found the centres"""
    plain_draws: int
    """accepted draws about the inputs of the file"""
    plain: Quantity
    """probability of failure without inspections by these alone"""
    plain_low: Quantity
    """lower limit with 95 % confidence"""
    plain_high: Quantity
    """upper limit with 95 % confidence"""
    elsewhere: Quantity
    """probability of failures far from the centres that the plain draws do not exclude with
    97.5 % confidence"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "centres": ("centres", _to.many(Centres._of)),
        "rounds": ("rounds", _to.plain),
        "plain_draws": ("plain_draws", _to.plain),
        "plain": ("plain", _to.quantity),
        "plain_low": ("plain_low", _to.quantity),
        "plain_high": ("plain_high", _to.quantity),
        "elsewhere": ("elsewhere", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Points(Part):
    """Probability of detection over the size."""

    size: FloatArray
    """depth, or half length of a through crack [m]"""
    probability: FloatArray
    """probability that one inspection finds the crack"""
    change: FloatArray
    """of a measurement: share by which the crack changes the measured value"""
    bound: FloatArray
    """of a curve from trials: size with this probability on the lower bound with 95 %
    confidence [m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "size": ("size", _to.floats),
        "probability": ("probability", _to.floats),
        "change": ("change", _to.floats),
        "bound": ("bound", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "size": "m",
        "probability": "1",
        "change": "1",
        "bound": "m",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Method(Part):
    """How inspections find cracks, and what a find leads to."""

    method: Literal["curve", "stiffness", "one_sided_stiffness", "resonance"]
    """what an inspection looks at"""
    find: Literal["out", "repair"]
    """what a find leads to"""
    repaired_to: Optional[Quantity]
    """size of a crack after its repair [m]; None if absent"""
    false_calls: Quantity
    """probability that an inspection finds what is not there"""
    a50: Optional[Quantity]
    """size that is found in half of the cases; absent: no size up to the end [m]; None if
    absent"""
    a90: Optional[Quantity]
    """size that is found in nine of ten; absent: no size up to the end [m]; None if absent"""
    a50_bound: Optional[Quantity]
    """a50 on the lower bound of the trials with 95 % confidence; absent: not bounded [m]; None
    if absent"""
    a90_bound: Optional[Quantity]
    """a90 on the lower bound of the trials with 95 % confidence; absent: not bounded [m]; None
    if absent"""
    trials: Optional[int]
    """number of trials behind the curve; None if absent"""
    bound_equation: str
    """equation of the bound of the trials"""
    below_floor: Optional[int]
    """of these trials, signals at the floor or below; None if absent"""
    above_ceiling: Optional[int]
    """of these trials, signals at the ceiling or above; None if absent"""
    crack: str
    """of a measurement: the crack that ends the life of the file"""
    noise: Optional[Quantity]
    """standard deviation of a measured change over the measured value; None if absent"""
    threshold: Optional[Quantity]
    """change from which on a measurement counts as a find; None if absent"""
    change_ninety: Optional[Quantity]
    """smallest change that nine of ten measurements find; None if absent"""
    size_at_end: Optional[Quantity]
    """size of the crack when it ends the life [m]; None if absent"""
    change_at_end: Optional[Quantity]
    """change of the measured value by the crack of this size; None if absent"""
    found_at_end: Optional[Quantity]
    """probability that one measurement finds the crack of this size; None if absent"""
    points: Points
    """probability of detection over the size"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "method": ("method", _to.plain),
        "find": ("find", _to.plain),
        "repaired_to": ("repaired_to", _to.quantity),
        "false_calls": ("false_calls", _to.quantity),
        "a50": ("a50", _to.quantity),
        "a90": ("a90", _to.quantity),
        "a50_bound": ("a50_bound", _to.quantity),
        "a90_bound": ("a90_bound", _to.quantity),
        "trials": ("trials", _to.plain),
        "bound_equation": ("bound_equation", _to.plain),
        "below_floor": ("below_floor", _to.plain),
        "above_ceiling": ("above_ceiling", _to.plain),
        "crack": ("crack", _to.plain),
        "noise": ("noise", _to.quantity),
        "threshold": ("threshold", _to.quantity),
        "change_ninety": ("change_ninety", _to.quantity),
        "size_at_end": ("size_at_end", _to.quantity),
        "change_at_end": ("change_at_end", _to.quantity),
        "found_at_end": ("found_at_end", _to.quantity),
        "points": ("points", Points._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Inspections(Part):
    """Each inspection."""

    time: FloatArray
    """time of duty [s]"""
    in_service: FloatArray
    """share of the drives in service before it"""
    found: FloatArray
    """probability that it finds a crack"""
    false_call: FloatArray
    """probability of a false call"""
    remaining: FloatArray
    """probability of failure up to the end of service if it is the last inspection"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "time": ("time", _to.floats),
        "in_service": ("in_service", _to.floats),
        "found": ("found", _to.floats),
        "false_call": ("false_call", _to.floats),
        "remaining": ("remaining", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "time": "s",
        "in_service": "1",
        "found": "1",
        "false_call": "1",
        "remaining": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Cost(Part):
    """Expected cost of one drive, in the currency of the file."""

    without: Quantity
    """of failures, without inspections"""
    inspected: Optional[Quantity]
    """with the inspections: the sum of the three below; None if absent"""
    inspections: Optional[Quantity]
    """of the inspections; None if absent"""
    calls: Optional[Quantity]
    """of finds and false calls; None if absent"""
    failures: Optional[Quantity]
    """of failures, with the inspections; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "without": ("without", _to.quantity),
        "inspected": ("inspected", _to.quantity),
        "inspections": ("inspections", _to.quantity),
        "calls": ("calls", _to.quantity),
        "failures": ("failures", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Plans(Part):
    """The field `plans`."""

    kind: str
    """equal intervals, or times of least risk"""
    reached: bool
    """whether the wanted risk is reached"""
    inspections: int
    """number of inspections"""
    times: FloatArray
    """times of duty [s]"""
    risk: Quantity
    """probability of failure up to the end of service"""
    risk_low: Quantity
    """lower limit with 95 % confidence"""
    risk_high: Quantity
    """upper limit with 95 % confidence"""
    cost: Optional[Quantity]
    """expected cost of one drive; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "kind": ("kind", _to.plain),
        "reached": ("reached", _to.plain),
        "inspections": ("inspections", _to.plain),
        "times": ("times", _to.floats),
        "risk": ("risk", _to.quantity),
        "risk_low": ("risk_low", _to.quantity),
        "risk_high": ("risk_high", _to.quantity),
        "cost": ("cost", _to.quantity),
    }
    _units: ClassVar[dict[str, str]] = {
        "times": "s",
    }


@dataclass(frozen=True, eq=False, repr=False)
class InspectResult(Result):
    """What `inspect` answers."""

    sentence: str
    """the answer in words"""
    until: Quantity
    """end of service [s]"""
    nominal_life: Optional[Quantity]
    """life at the values of the file; absent: endless [s]; None if absent"""
    draws: int
    """number of drawn drives"""
    seed: int
    """seed of the draws"""
    outcomes: Outcomes
    """how the drawn drives end"""
    percentiles: Percentiles
    """percentiles of the life"""
    shares: Shares
    """what the scatter of the life comes from"""
    at_end: AtEnd
    """probabilities of failure up to the end of service"""
    risk: Risk
    """probabilities of failure over time"""
    importance_sampling: Optional[ImportanceSampling]
    """the draws about the failures, and what the others say; None if absent"""
    method: Optional[Method]
    """how inspections find cracks, and what a find leads to; None if absent"""
    inspections: Inspections
    """each inspection"""
    bound_risk: Optional[Quantity]
    """probability of failure with the inspections, by the lower bound of detection with 95 %
    confidence from the trials; None if absent"""
    cost: Optional[Cost]
    """expected cost of one drive, in the currency of the file; None if absent"""
    plans: tuple[Plans, ...]
    """inspections that keep the wanted risk"""
    half_interval: Optional[Quantity]
    """half of the time from the size a90 of the crack that ends the life to this end, at the
    values of the file [s]; None if absent"""

    command: ClassVar[str] = "inspect"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "sentence": ("sentence", _to.plain),
        "until": ("until", _to.quantity),
        "nominal_life": ("nominal_life", _to.quantity),
        "draws": ("draws", _to.plain),
        "seed": ("seed", _to.plain),
        "outcomes": ("outcomes", Outcomes._of),
        "percentiles": ("percentiles", Percentiles._of),
        "shares": ("shares", Shares._of),
        "at_end": ("at_end", AtEnd._of),
        "risk": ("risk", Risk._of),
        "importance_sampling": ("importance_sampling", ImportanceSampling._of),
        "method": ("method", Method._of),
        "inspections": ("inspections", Inspections._of),
        "bound_risk": ("bound_risk", _to.quantity),
        "cost": ("cost", Cost._of),
        "plans": ("plans", _to.many(Plans._of)),
        "half_interval": ("half_interval", _to.quantity),
    }
