# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command reliability."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity
from .sensitivity import Tables


@dataclass(frozen=True, eq=False, repr=False)
class Inputs(Part):
    """The design point, the most important input first."""

    path: AnyArray
    """field of the input"""
    unit: AnyArray
    """SI unit of the field"""
    value: AnyArray
    """value in the file"""
    at_design: AnyArray
    """value at the design point"""
    deviations: FloatArray
    """standard normal deviate at the design point"""
    importance: FloatArray
    """share in the variance of the margin at the design point"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.entries),
        "unit": ("unit", _to.entries),
        "value": ("value", _to.entries),
        "at_design": ("at_design", _to.entries),
        "deviations": ("deviations", _to.floats),
        "importance": ("importance", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "deviations": "1",
        "importance": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class FirstOrder(Part):
    """By the nearest failure."""

    converged: bool
    """whether the design point was found"""
    reliability_index: Quantity
    """distance of the design point from the inputs of the file"""
    probability: Quantity
    """probability, first order"""
    iterations: int
    """steps of the search"""
    reason: str
    """why no design point was found; empty if it was"""
    inputs: Inputs
    """the design point, the most important input first"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "converged": ("converged", _to.plain),
        "reliability_index": ("reliability_index", _to.quantity),
        "probability": ("probability", _to.quantity),
        "iterations": ("iterations", _to.plain),
        "reason": ("reason", _to.plain),
        "inputs": ("inputs", Inputs._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class SecondOrder(Part):
    """With the curvature of the limit."""

    probability: Optional[Quantity]
    """probability, second order; None if absent"""
    curvatures: FloatArray
    """principal curvatures of the limit at the design point"""
    reason: str
    """reason for an absent probability; empty if the probability is given"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "probability": ("probability", _to.quantity),
        "curvatures": ("curvatures", _to.floats),
        "reason": ("reason", _to.plain),
    }
    _units: ClassVar[dict[str, str]] = {
        "curvatures": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class RequirementsPart(Part):
    """By draws about the nearest failure, or about each cause of failures."""

    draws: int
    """evaluated drives"""
    failures: int
    """drives that do not meet the requirement"""
    without_value: int
    """draws that lead to no usable drive"""
    probability: Quantity
    """estimate"""
    standard_error: Quantity
    """standard error of the estimate"""
    low: Quantity
    """lower end of the 95 % interval"""
    high: Quantity
    """upper end of it; draws without a usable drive count as failures"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "draws": ("draws", _to.plain),
        "failures": ("failures", _to.plain),
        "without_value": ("without_value", _to.plain),
        "probability": ("probability", _to.quantity),
        "standard_error": ("standard_error", _to.quantity),
        "low": ("low", _to.quantity),
        "high": ("high", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Requirements(Part):
    """The field `requirements`."""

    output: str
    """name of the output"""
    comparison: Literal[">=", ">", "<=", "<"]
    """how the output must compare with the bound"""
    bound: Quantity
    """the bound"""
    value: Quantity
    """the output at the inputs of the file"""
    probability: Optional[Quantity]
    """probability that the requirement is not met; None if absent"""
    low: Quantity
    """lower end of its 95 % interval"""
    high: Quantity
    """upper end of its 95 % interval"""
    trusted: Literal["monte-carlo", "importance-sampling", "none"]
    """where the probability comes from"""
    first_order: FirstOrder
    """by the nearest failure"""
    second_order: Optional[SecondOrder]
    """with the curvature of the limit; None if absent"""
    importance_sampling: Optional[RequirementsPart]
    """by draws about the nearest failure, or about each cause of failures; None if absent"""
    monte_carlo: RequirementsPart
    """by plain draws"""
    tables: Optional[Tables]
    """error of the tables that the draws read; absent: the engine computed all; None if
    absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "output": ("output", _to.plain),
        "comparison": ("comparison", _to.plain),
        "bound": ("bound", _to.quantity),
        "value": ("value", _to.quantity),
        "probability": ("probability", _to.quantity),
        "low": ("low", _to.quantity),
        "high": ("high", _to.quantity),
        "trusted": ("trusted", _to.plain),
        "first_order": ("first_order", FirstOrder._of),
        "second_order": ("second_order", SecondOrder._of),
        "importance_sampling": ("importance_sampling", RequirementsPart._of),
        "monte_carlo": ("monte_carlo", RequirementsPart._of),
        "tables": ("tables", Tables._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class ReliabilityResult(Result):
    """What `reliability` answers."""

    requirements: tuple[Requirements, ...]
    """each requirement and its probability"""
    seed: int
    """seed of the draws"""

    command: ClassVar[str] = "reliability"
    documents: ClassVar[tuple[str, ...]] = ("json", "text")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "requirements": ("requirements", _to.many(Requirements._of)),
        "seed": ("seed", _to.plain),
    }
