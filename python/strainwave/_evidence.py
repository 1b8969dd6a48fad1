# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The evidence that each result has."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from . import parts as _to
from .parts import Converter, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Verdict(Part):
    """The field `verdict`."""

    judgement: Literal["good", "with care", "critical", "cannot be told"]
    """good, with care, critical or cannot be told"""
    reason: str
    """reason in one sentence"""
    next_step: str
    """next step; empty if no action is needed"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "judgement": ("judgement", _to.plain),
        "reason": ("reason", _to.plain),
        "next_step": ("next_step", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Note(Part):
    """The field `note`."""

    code: str
    """machine-readable code"""
    severity: Literal["information", "care", "cannot tell", "critical"]
    """weight of the note"""
    text: str
    """the remark, for a person"""
    next_step: str
    """action for the reader; empty: none"""
    path: str
    """field concerned; empty: the whole drive"""
    equation: str
    """tag of the theory manual; empty: none"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "code": ("code", _to.plain),
        "severity": ("severity", _to.plain),
        "text": ("text", _to.plain),
        "next_step": ("next_step", _to.plain),
        "path": ("path", _to.plain),
        "equation": ("equation", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Accuracy(Part):
    """The field `accuracy`."""

    path: str
    """member or crack"""
    relative_uncertainty: Quantity
    """one standard uncertainty, as it enters the compliance"""
    source: str
    """basis of the uncertainty"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.plain),
        "relative_uncertainty": ("relative_uncertainty", _to.quantity),
        "source": ("source", _to.plain),
    }
