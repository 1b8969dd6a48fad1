# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command sweep."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part


@dataclass(frozen=True, eq=False, repr=False)
class Columns(Part):
    """The field `columns`."""

    name: str
    """path of the field or the output"""
    unit: str
    """SI unit of the values"""
    varied: bool
    """true for a varied field, false for an output"""
    values: AnyArray
    """a value for each point; null if absent"""
    relative_uncertainties: FloatArray
    """one standard uncertainty of each value, over the value"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.plain),
        "unit": ("unit", _to.plain),
        "varied": ("varied", _to.plain),
        "values": ("values", _to.entries),
        "relative_uncertainties": ("relative_uncertainties", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "relative_uncertainties": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Rows(Part):
    """The points; the first varied field varies slowest."""

    usable: AnyArray
    """whether the outputs may be used"""
    reason: AnyArray
    """why the point was refused, or must not be used"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "usable": ("usable", _to.entries),
        "reason": ("reason", _to.entries),
    }


@dataclass(frozen=True, eq=False, repr=False)
class NoteRows(Part):
    """The points that have each note."""

    code: AnyArray
    """code of the note"""
    path: AnyArray
    """field that the note concerns"""
    first_row: AnyArray
    """first point that has the note"""
    rows: AnyArray
    """number of points that have the note"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "code": ("code", _to.entries),
        "path": ("path", _to.entries),
        "first_row": ("first_row", _to.entries),
        "rows": ("rows", _to.entries),
    }


@dataclass(frozen=True, eq=False, repr=False)
class SweepResult(Result):
    """What `sweep` answers."""

    method: Literal["as-printed", "repaired", "corrected"]
    """as-printed, repaired or corrected"""
    columns: tuple[Columns, ...]
    """varied fields, then outputs; one value for each point"""
    rows: Rows
    """the points; the first varied field varies slowest"""
    note_rows: NoteRows
    """the points that have each note"""
    crack_paths: tuple[str, ...]
    """fields of the cracks"""

    command: ClassVar[str] = "sweep"
    documents: ClassVar[tuple[str, ...]] = ("json", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "method": ("method", _to.plain),
        "columns": ("columns", _to.many(Columns._of)),
        "rows": ("rows", Rows._of),
        "note_rows": ("note_rows", NoteRows._of),
        "crack_paths": ("crack_paths", _to.many(_to.plain)),
    }
