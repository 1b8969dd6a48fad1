# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command schema."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .. import parts as _to
from ..answers import Result
from ..parts import Converter


@dataclass(frozen=True, eq=False, repr=False)
class SchemaResult(Result):
    """What `schema` answers."""

    schema: str
    """the JSON Schema, as text"""

    command: ClassVar[str] = "schema"
    documents: ClassVar[tuple[str, ...]] = ("json", "schema", "markdown")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "schema": ("schema", _to.plain),
    }
