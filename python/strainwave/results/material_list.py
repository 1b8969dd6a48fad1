# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command material list."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class MaterialPart(Part):
    """Young's modulus."""

    value: Quantity
    """the number"""
    source: str
    """key in [source]"""
    confidence: Literal["measured", "handbook", "standard", "derived", "unverified"]
    """how well the number is known"""
    scatter: Optional[Quantity]
    """one standard deviation over the value; None if absent"""
    remark: str
    """remark that contradicts or limits the number"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "value": ("value", _to.quantity),
        "source": ("source", _to.plain),
        "confidence": ("confidence", _to.plain),
        "scatter": ("scatter", _to.quantity),
        "remark": ("remark", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class FatigueLimit(Part):
    """The field `fatigue_limit`."""

    value: Quantity
    """the number [Pa]"""
    source: str
    """key in [source]"""
    confidence: Literal["measured", "handbook", "standard", "derived", "unverified"]
    """how well the number is known"""
    scatter: Optional[Quantity]
    """one standard deviation over the value; None if absent"""
    remark: str
    """remark that contradicts or limits the number"""
    stress_ratio: Quantity
    """R, smallest over largest stress"""
    cycles: Optional[Quantity]
    """number of cycles for which the limit is stated; None if absent"""
    loading: Literal["axial", "bending", "rotating_bending", "not_stated"]
    """how the specimen was loaded"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "value": ("value", _to.quantity),
        "source": ("source", _to.plain),
        "confidence": ("confidence", _to.plain),
        "scatter": ("scatter", _to.quantity),
        "remark": ("remark", _to.plain),
        "stress_ratio": ("stress_ratio", _to.quantity),
        "cycles": ("cycles", _to.quantity),
        "loading": ("loading", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Threshold(Part):
    """The field `threshold`."""

    value: Quantity
    """the number [Pa*m^0.5]"""
    source: str
    """key in [source]"""
    confidence: Literal["measured", "handbook", "standard", "derived", "unverified"]
    """how well the number is known"""
    scatter: Optional[Quantity]
    """one standard deviation over the value; None if absent"""
    remark: str
    """remark that contradicts or limits the number"""
    stress_ratio: FloatArray
    """range of R for which the law is stated"""
    environment: str
    """environment of the crack"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "value": ("value", _to.quantity),
        "source": ("source", _to.plain),
        "confidence": ("confidence", _to.plain),
        "scatter": ("scatter", _to.quantity),
        "remark": ("remark", _to.plain),
        "stress_ratio": ("stress_ratio", _to.floats),
        "environment": ("environment", _to.plain),
    }
    _units: ClassVar[dict[str, str]] = {
        "stress_ratio": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Material(Part):
    """The field `material`."""

    name: str
    """name as an input file writes it"""
    aliases: tuple[str, ...]
    """other names"""
    use: tuple[Literal["flexspline", "bearing", "shaft", "generic", "ply"], ...]
    """parts for which the steel is used"""
    treatment: str
    """heat treatment and product"""
    remark: str
    """remark on the whole record"""
    youngs_modulus: Optional[MaterialPart]
    """Young's modulus; None if absent"""
    shear_modulus: Optional[MaterialPart]
    """shear modulus; None if absent"""
    poissons_ratio: Optional[MaterialPart]
    """Poisson's ratio; None if absent"""
    transverse_modulus: Optional[MaterialPart]
    """modulus across the fibres; None if absent"""
    fibre_tension: Optional[MaterialPart]
    """tensile strength along the fibres; None if absent"""
    fibre_compression: Optional[MaterialPart]
    """compressive strength along the fibres; None if absent"""
    transverse_tension: Optional[MaterialPart]
    """tensile strength across the fibres; None if absent"""
    transverse_compression: Optional[MaterialPart]
    """compressive strength across the fibres; None if absent"""
    shear_strength: Optional[MaterialPart]
    """shear strength along the fibres; None if absent"""
    density: Optional[MaterialPart]
    """density; None if absent"""
    yield_strength: Optional[MaterialPart]
    """yield strength; None if absent"""
    ultimate_strength: Optional[MaterialPart]
    """tensile strength; None if absent"""
    fracture_toughness: Optional[MaterialPart]
    """fracture toughness; None if absent"""
    hardness: Optional[MaterialPart]
    """hardness HRC; None if absent"""
    fatigue_limit: tuple[FatigueLimit, ...]
    """fatigue limit"""
    threshold: tuple[Threshold, ...]
    """growth threshold"""
    growth: tuple[Any, ...]
    """growth law"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.plain),
        "aliases": ("aliases", _to.many(_to.plain)),
        "use": ("use", _to.many(_to.plain)),
        "treatment": ("treatment", _to.plain),
        "remark": ("remark", _to.plain),
        "youngs_modulus": ("youngs_modulus", MaterialPart._of),
        "shear_modulus": ("shear_modulus", MaterialPart._of),
        "poissons_ratio": ("poissons_ratio", MaterialPart._of),
        "transverse_modulus": ("transverse_modulus", MaterialPart._of),
        "fibre_tension": ("fibre_tension", MaterialPart._of),
        "fibre_compression": ("fibre_compression", MaterialPart._of),
        "transverse_tension": ("transverse_tension", MaterialPart._of),
        "transverse_compression": ("transverse_compression", MaterialPart._of),
        "shear_strength": ("shear_strength", MaterialPart._of),
        "density": ("density", MaterialPart._of),
        "yield_strength": ("yield_strength", MaterialPart._of),
        "ultimate_strength": ("ultimate_strength", MaterialPart._of),
        "fracture_toughness": ("fracture_toughness", MaterialPart._of),
        "hardness": ("hardness", MaterialPart._of),
        "fatigue_limit": ("fatigue_limit", _to.many(FatigueLimit._of)),
        "threshold": ("threshold", _to.many(Threshold._of)),
        "growth": ("growth", _to.many(_to.plain)),
    }


@dataclass(frozen=True, eq=False, repr=False)
class MaterialListResult(Result):
    """What `material list` answers."""

    material: tuple[Material, ...]
    """the records"""
    source: dict[str, Any]
    """publications that the records cite, by key"""

    command: ClassVar[str] = "material list"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "markdown")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "material": ("material", _to.many(Material._of)),
        "source": ("source", _to.plain),
    }
