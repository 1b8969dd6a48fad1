# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command units."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part


@dataclass(frozen=True, eq=False, repr=False)
class Units(Part):
    """Units of which a quantity can be made."""

    unit: AnyArray
    """name of the unit in a text"""
    dimension: AnyArray
    """dimension of the unit"""
    takes_prefix: AnyArray
    """whether a prefix may stand before the unit"""
    factor: FloatArray
    """factor to the SI unit"""
    si: AnyArray
    """the SI unit"""
    written_in: AnyArray
    """a field of the input that takes the unit"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "unit": ("unit", _to.entries),
        "dimension": ("dimension", _to.entries),
        "takes_prefix": ("takes_prefix", _to.entries),
        "factor": ("factor", _to.floats),
        "si": ("si", _to.entries),
        "written_in": ("written_in", _to.entries),
    }
    _units: ClassVar[dict[str, str]] = {
        "factor": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Prefixes(Part):
    """Prefixes of the units that take one."""

    prefix: AnyArray
    """before a unit"""
    power: AnyArray
    """of ten"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "prefix": ("prefix", _to.entries),
        "power": ("power", _to.entries),
    }


@dataclass(frozen=True, eq=False, repr=False)
class UnitsResult(Result):
    """What `units` answers."""

    units: Units
    """units of which a quantity can be made"""
    prefixes: Prefixes
    """prefixes of the units that take one"""

    command: ClassVar[str] = "units"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "markdown")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "units": ("units", Units._of),
        "prefixes": ("prefixes", Prefixes._of),
    }
