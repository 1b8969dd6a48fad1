# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command sif plot."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from .. import parts as _to
from ..answers import Result
from ..parts import Converter


@dataclass(frozen=True, eq=False, repr=False)
class SifPlotResult(Result):
    """What `sif plot` answers."""

    svg_: str
    """the picture"""

    command: ClassVar[str] = "sif plot"
    documents: ClassVar[tuple[str, ...]] = ("json", "svg")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "svg": ("svg_", _to.plain),
    }
