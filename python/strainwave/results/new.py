# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command new."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .. import parts as _to
from ..answers import Result
from ..parts import Converter


@dataclass(frozen=True, eq=False, repr=False)
class NewResult(Result):
    """What `new` answers."""

    text: str
    """the input file"""

    command: ClassVar[str] = "new"
    documents: ClassVar[tuple[str, ...]] = ("json", "toml")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "text": ("text", _to.plain),
    }
