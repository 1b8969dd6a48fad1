# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command report."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, Part
from .stiffness import Cracked, Cracks, Curve, Life, StiffnessIntact


@dataclass(frozen=True, eq=False, repr=False)
class Stiffness(Part):
    """The reported result."""

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

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "method": ("method", _to.plain),
        "curve": ("curve", Curve._of),
        "life": ("life", Life._of),
        "intact": ("intact", StiffnessIntact._of),
        "cracked": ("cracked", Cracked._of),
        "cracks": ("cracks", _to.many(Cracks._of)),
    }


@dataclass(frozen=True, eq=False, repr=False)
class ReportResult(Result):
    """What `report` answers."""

    title: str
    """name of the drive"""
    stiffness: Stiffness
    """the reported result"""

    command: ClassVar[str] = "report"
    documents: ClassVar[tuple[str, ...]] = ("json", "html")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "title": ("title", _to.plain),
        "stiffness": ("stiffness", Stiffness._of),
    }
