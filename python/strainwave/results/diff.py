# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command diff."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Inputs(Part):
    """The field `inputs`."""

    path: str
    """field of the input"""
    first: str
    """value in the first; empty if absent"""
    second: str
    """value in the second; empty if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.plain),
        "first": ("first", _to.plain),
        "second": ("second", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class DiffPart(Part):
    """The field `stiffness`."""

    output: str
    """name of the output"""
    unit: str
    """of the numbers"""
    first: float
    """of the first"""
    second: float
    """of the second"""
    difference: float
    """second less first"""
    uncertainty: Optional[float]
    """one standard uncertainty of the difference; None if absent"""
    standing: Literal["beyond", "within", "not stated", "same"]
    """whether the difference is beyond its uncertainty"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "output": ("output", _to.plain),
        "unit": ("unit", _to.plain),
        "first": ("first", _to.plain_number),
        "second": ("second", _to.plain_number),
        "difference": ("difference", _to.plain_number),
        "uncertainty": ("uncertainty", _to.plain_number),
        "standing": ("standing", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class DiffResult(Result):
    """What `diff` answers."""

    first: str
    """a drive or a result"""
    second: str
    """a drive or a result that is compared with the first"""
    coverage: Quantity
    """number of standard uncertainties that a difference must exceed"""
    inputs: tuple[Inputs, ...]
    """inputs that differ"""
    stiffness: tuple[DiffPart, ...]
    """K1, K2, K3 and wind-up for both senses of torque, even if they are the same"""
    outputs: tuple[DiffPart, ...]
    """outputs that differ by more than the uncertainty of their difference"""
    within_uncertainty: tuple[DiffPart, ...]
    """outputs that differ by less"""
    uncertainty_not_stated: tuple[DiffPart, ...]
    """outputs that differ without a stated uncertainty"""
    only_first: tuple[str, ...]
    """outputs that exist only in the first"""
    only_second: tuple[str, ...]
    """outputs that exist only in the second"""
    equal: int
    """number of outputs that are the same"""

    command: ClassVar[str] = "diff"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "first": ("first", _to.plain),
        "second": ("second", _to.plain),
        "coverage": ("coverage", _to.quantity),
        "inputs": ("inputs", _to.many(Inputs._of)),
        "stiffness": ("stiffness", _to.many(DiffPart._of)),
        "outputs": ("outputs", _to.many(DiffPart._of)),
        "within_uncertainty": ("within_uncertainty", _to.many(DiffPart._of)),
        "uncertainty_not_stated": ("uncertainty_not_stated", _to.many(DiffPart._of)),
        "only_first": ("only_first", _to.many(_to.plain)),
        "only_second": ("only_second", _to.many(_to.plain)),
        "equal": ("equal", _to.plain),
    }
