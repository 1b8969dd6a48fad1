# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command require."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, Part, Quantity


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
    """the output"""
    low: Optional[Quantity]
    """the output less its uncertainty; None if absent"""
    high: Optional[Quantity]
    """the output plus its uncertainty; None if absent"""
    outcome: Literal["met", "cannot be told", "not met"]
    """met, not met, or cannot be told"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "output": ("output", _to.plain),
        "comparison": ("comparison", _to.plain),
        "bound": ("bound", _to.quantity),
        "value": ("value", _to.quantity),
        "low": ("low", _to.quantity),
        "high": ("high", _to.quantity),
        "outcome": ("outcome", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class RequireResult(Result):
    """What `require` answers."""

    method: Literal["as-printed", "repaired", "corrected"]
    """as-printed, repaired or corrected"""
    coverage: Quantity
    """number of standard uncertainties taken into account"""
    requirements: tuple[Requirements, ...]
    """each requirement and its answer"""
    outcome: Literal["met", "cannot be told", "not met"]
    """combined answer to all requirements"""

    command: ClassVar[str] = "require"
    documents: ClassVar[tuple[str, ...]] = ("json", "text")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "method": ("method", _to.plain),
        "coverage": ("coverage", _to.quantity),
        "requirements": ("requirements", _to.many(Requirements._of)),
        "outcome": ("outcome", _to.plain),
    }
