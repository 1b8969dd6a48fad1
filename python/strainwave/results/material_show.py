# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command material show."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Literal, Optional

from .. import answers as _to
from ..answers import Converter, FloatArray, Part, Quantity, Result


@dataclass(frozen=True, eq=False, repr=False)
class MaterialPart(Part):
    """Young's modulus."""

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

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "value": ("value", _to.quantity),
        "source": ("source", _to.plain),
        "confidence": ("confidence", _to.plain),
        "scatter": ("scatter", _to.quantity),
        "remark": ("remark", _to.plain),
    }
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class MaterialShowMaterialPart(Part):
    """Poisson's ratio."""

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
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class Density(Part):
    """Density."""

    value: Quantity
    """the number [kg/m^3]"""
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
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class FractureToughness(Part):
    """Fracture toughness."""

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

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "value": ("value", _to.quantity),
        "source": ("source", _to.plain),
        "confidence": ("confidence", _to.plain),
        "scatter": ("scatter", _to.quantity),
        "remark": ("remark", _to.plain),
    }
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class FatigueLimit(Part):
    """FatigueLimit."""

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
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class Threshold(Part):
    """Threshold."""

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
    """Material."""

    name: str
    """name as an input file writes it"""
    aliases: tuple[str, ...]
    """other names"""
    use: tuple[Literal["flexspline", "bearing", "shaft", "generic"], ...]
    """parts for which the steel is used"""
    treatment: str
    """heat treatment and product"""
    remark: str
    """remark on the whole record"""
    youngs_modulus: Optional[MaterialPart]
    """Young's modulus; None if absent"""
    shear_modulus: Optional[MaterialPart]
    """shear modulus; None if absent"""
    poissons_ratio: Optional[MaterialShowMaterialPart]
    """Poisson's ratio; None if absent"""
    density: Optional[Density]
    """density; None if absent"""
    yield_strength: Optional[MaterialPart]
    """yield strength; None if absent"""
    ultimate_strength: Optional[MaterialPart]
    """tensile strength; None if absent"""
    fracture_toughness: Optional[FractureToughness]
    """fracture toughness; None if absent"""
    hardness: Optional[MaterialShowMaterialPart]
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
        "poissons_ratio": ("poissons_ratio", MaterialShowMaterialPart._of),
        "density": ("density", Density._of),
        "yield_strength": ("yield_strength", MaterialPart._of),
        "ultimate_strength": ("ultimate_strength", MaterialPart._of),
        "fracture_toughness": ("fracture_toughness", FractureToughness._of),
        "hardness": ("hardness", MaterialShowMaterialPart._of),
        "fatigue_limit": ("fatigue_limit", _to.many(FatigueLimit._of)),
        "threshold": ("threshold", _to.many(Threshold._of)),
        "growth": ("growth", _to.many(_to.plain)),
    }
    _units: ClassVar[dict[str, str]] = {}


@dataclass(frozen=True, eq=False, repr=False)
class MaterialShowResult(Result):
    """What `material show` answers."""

    material: tuple[Material, ...]
    """the records"""
    source: dict[str, Any]
    """publications that the records cite, by key"""

    command: ClassVar[str] = "material show"
    documents: ClassVar[tuple[str, ...]] = ("json", "text",)
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "material": ("material", _to.many(Material._of)),
        "source": ("source", _to.plain),
    }
    _units: ClassVar[dict[str, str]] = {}
