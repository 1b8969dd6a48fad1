# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command material show."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from .. import parts as _to
from ..answers import Result
from ..parts import Converter
from .material_list import Material


@dataclass(frozen=True, eq=False, repr=False)
class MaterialShowResult(Result):
    """What `material show` answers."""

    material: tuple[Material, ...]
    """the records"""
    source: dict[str, Any]
    """publications that the records cite, by key"""

    command: ClassVar[str] = "material show"
    documents: ClassVar[tuple[str, ...]] = ("json", "text")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "material": ("material", _to.many(Material._of)),
        "source": ("source", _to.plain),
    }
