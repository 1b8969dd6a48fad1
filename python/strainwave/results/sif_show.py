# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command sif show."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, Quantity
from .sif_list import Fields, Loads, Points


@dataclass(frozen=True, eq=False, repr=False)
class SifShowResult(Result):
    """What `sif show` answers."""

    name: str
    """name on the command line"""
    family: str
    """plate, tube, bar or gradient"""
    title: str
    """one line"""
    modes: str
    """modes for which the solution gives K"""
    equation: str
    """first tag in the theory manual"""
    source: str
    """keys of the references; - if derived here"""
    basis: Literal["exact", "read", "secondary", "computed"]
    """basis of the formula"""
    relative_uncertainty: Quantity
    """one standard uncertainty of K inside the validity range; of K_I only, if
    shear_uncertainty is given"""
    shear_uncertainty: Optional[Quantity]
    """one standard uncertainty of K_II and K_III, if it differs from that of K_I; None if
    absent"""
    accuracy: str
    """comparisons made and their results"""
    constraint: Literal["plane strain", "plane stress"]
    """plane strain or plane stress"""
    reference_stress: str
    """sigma in Y = K/(sigma sqrt(pi a)), and the place at which it is taken"""
    fields: tuple[Fields, ...]
    """fields of the crack"""
    loads: tuple[Loads, ...]
    """loads that the solution takes"""
    points: tuple[Points, ...]
    """named points of the front"""
    validity: tuple[str, ...]
    """limits of the range in which the accuracy holds"""
    rules: tuple[str, ...]
    """rules between fields; input that breaks a rule is refused"""

    command: ClassVar[str] = "sif show"
    documents: ClassVar[tuple[str, ...]] = ("json", "text")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.plain),
        "family": ("family", _to.plain),
        "title": ("title", _to.plain),
        "modes": ("modes", _to.plain),
        "equation": ("equation", _to.plain),
        "source": ("source", _to.plain),
        "basis": ("basis", _to.plain),
        "relative_uncertainty": ("relative_uncertainty", _to.quantity),
        "shear_uncertainty": ("shear_uncertainty", _to.quantity),
        "accuracy": ("accuracy", _to.plain),
        "constraint": ("constraint", _to.plain),
        "reference_stress": ("reference_stress", _to.plain),
        "fields": ("fields", _to.many(Fields._of)),
        "loads": ("loads", _to.many(Loads._of)),
        "points": ("points", _to.many(Points._of)),
        "validity": ("validity", _to.many(_to.plain)),
        "rules": ("rules", _to.many(_to.plain)),
    }
