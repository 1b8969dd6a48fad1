# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command audit."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class ReproducedBy(Part):
    """Value of one input that gives the printed number."""

    input: str
    """name of the input, by its symbol"""
    unit: str
    """unit used in the article: mm, N, MPa, rad, or "1" """
    value: float
    """value of the input, in the unit beside it"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "input": ("input", _to.plain),
        "unit": ("unit", _to.plain),
        "value": ("value", _to.plain_number),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Rows(Part):
    """The field `rows`."""

    id: str
    """chapter and number"""
    quantity: str
    """description of the quantity, with its symbol"""
    unit: str
    """unit of the numbers of this row, as in the article, or "1" """
    printed: Optional[float]
    """the printed number, in the unit of the row; None if absent"""
    own_equation: Optional[float]
    """result of the article's equation for its printed inputs, in the unit of the row; None if
    absent"""
    corrected: Optional[float]
    """result of the corrected theory, in the unit of the row; None if absent"""
    ratio: Optional[Quantity]
    """printed/own, or own/corrected if nothing is printed; None if absent"""
    verdict: Literal["reproduced", "misprint", "dimension", "physics", "not reproducible", "ambiguous", "input"]
    """verdict on the number or equation"""
    sentence: str
    """why"""
    reproduced_by: Optional[ReproducedBy]
    """value of one input that gives the printed number; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "id": ("id", _to.plain),
        "quantity": ("quantity", _to.plain),
        "unit": ("unit", _to.plain),
        "printed": ("printed", _to.plain_number),
        "own_equation": ("own_equation", _to.plain_number),
        "corrected": ("corrected", _to.plain_number),
        "ratio": ("ratio", _to.quantity),
        "verdict": ("verdict", _to.plain),
        "sentence": ("sentence", _to.plain),
        "reproduced_by": ("reproduced_by", ReproducedBy._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class AuditResult(Result):
    """What `audit` answers."""

    rows: tuple[Rows, ...]
    """the numbers and equations of the article"""

    command: ClassVar[str] = "audit"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "markdown")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "rows": ("rows", _to.many(Rows._of)),
    }
