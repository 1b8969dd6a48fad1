# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command explain."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, Part


@dataclass(frozen=True, eq=False, repr=False)
class Meanings(Part):
    """The field `meanings`."""

    kind: str
    """the kind of thing that the word names"""
    name: str
    """the full name"""
    text: str
    """the meaning of the word"""
    more: str
    """the command that prints more; empty if there is none"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "kind": ("kind", _to.plain),
        "name": ("name", _to.plain),
        "text": ("text", _to.plain),
        "more": ("more", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class ExplainResult(Result):
    """What `explain` answers."""

    word: str
    """the word as it was given"""
    meanings: tuple[Meanings, ...]
    """each thing of this name"""

    command: ClassVar[str] = "explain"
    documents: ClassVar[tuple[str, ...]] = ("json", "text")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "word": ("word", _to.plain),
        "meanings": ("meanings", _to.many(Meanings._of)),
    }
