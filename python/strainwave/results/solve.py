# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command solve."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, Part, Quantity
from .report import Stiffness


@dataclass(frozen=True, eq=False, repr=False)
class Target(Part):
    """Wanted value of the output."""

    output: str
    """name of the output"""
    unit: str
    """SI unit of the output"""
    value: float
    """the wanted value"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "output": ("output", _to.plain),
        "unit": ("unit", _to.plain),
        "value": ("value", _to.plain_number),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Searched(Part):
    """Range that was searched."""

    from_: float
    """lower end, in the SI unit of the field"""
    to: float
    """upper end, in the SI unit of the field"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "from": ("from_", _to.plain_number),
        "to": ("to", _to.plain_number),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Excluded(Part):
    """The field `excluded`."""

    from_: float
    """lower end, in the SI unit of the field"""
    to: float
    """upper end, in the SI unit of the field"""
    refused: bool
    """true: refused by the method; false: result must not be used"""
    reason: str
    """reason at the first point"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "from": ("from_", _to.plain_number),
        "to": ("to", _to.plain_number),
        "refused": ("refused", _to.plain),
        "reason": ("reason", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Solutions(Part):
    """The field `solutions`."""

    value: Quantity
    """the value of the field"""
    output: Quantity
    """the output at this value"""
    result: Stiffness
    """the complete result at this value"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "value": ("value", _to.quantity),
        "output": ("output", _to.quantity),
        "result": ("result", Stiffness._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class SolveResult(Result):
    """What `solve` answers."""

    method: Literal["as-printed", "repaired", "corrected"]
    """as-printed, repaired or corrected"""
    path: str
    """the sought field"""
    unit: str
    """SI unit of the sought field"""
    present: float
    """value of the field in the file"""
    target: Target
    """wanted value of the output"""
    searched: Searched
    """range that was searched"""
    least: Optional[Quantity]
    """least output over the range; None if absent"""
    greatest: Optional[Quantity]
    """greatest output over the range; None if absent"""
    excluded: tuple[Excluded, ...]
    """parts of the range without a usable result"""
    reason: str
    """remarks; empty for a single solution without remarks"""
    solutions: tuple[Solutions, ...]
    """ascending"""

    command: ClassVar[str] = "solve"
    documents: ClassVar[tuple[str, ...]] = ("json", "text")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "method": ("method", _to.plain),
        "path": ("path", _to.plain),
        "unit": ("unit", _to.plain),
        "present": ("present", _to.plain_number),
        "target": ("target", Target._of),
        "searched": ("searched", Searched._of),
        "least": ("least", _to.quantity),
        "greatest": ("greatest", _to.quantity),
        "excluded": ("excluded", _to.many(Excluded._of)),
        "reason": ("reason", _to.plain),
        "solutions": ("solutions", _to.many(Solutions._of)),
    }
