# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command sif eval."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class SifEvalPart(Part):
    """The field `fields`."""

    name: str
    """name of the field or load"""
    unit: str
    """SI unit"""
    value: float
    """its value"""
    given: bool
    """value from the caller; if left out, the example of a field, or 0 for a load"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.plain),
        "unit": ("unit", _to.plain),
        "value": ("value", _to.plain_number),
        "given": ("given", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Material(Part):
    """Elastic constants and toughness."""

    youngs_modulus: Quantity
    """E [Pa]"""
    poissons_ratio: Quantity
    """nu"""
    fracture_toughness: Optional[Quantity]
    """K_Ic [Pa*m^0.5]; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "youngs_modulus": ("youngs_modulus", _to.quantity),
        "poissons_ratio": ("poissons_ratio", _to.quantity),
        "fracture_toughness": ("fracture_toughness", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class GeometryFactors(Part):
    """Geometry factors for each load and point."""

    load: AnyArray
    """of the factors"""
    point: AnyArray
    """of the front"""
    Y_I: FloatArray
    """K_I/(sigma sqrt(pi a))"""
    Y_II: FloatArray
    """K_II/(sigma sqrt(pi a))"""
    Y_III: FloatArray
    """K_III/(sigma sqrt(pi a))"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "load": ("load", _to.entries),
        "point": ("point", _to.entries),
        "Y_I": ("Y_I", _to.floats),
        "Y_II": ("Y_II", _to.floats),
        "Y_III": ("Y_III", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "Y_I": "1",
        "Y_II": "1",
        "Y_III": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class SifEvalPart2(Part):
    """The field `points`."""

    name: str
    """name of the point; empty for a point found by scanning the front"""
    s: Quantity
    """front parameter"""
    K_I: Quantity
    """opening [Pa*m^0.5]"""
    K_II: Quantity
    """sliding [Pa*m^0.5]"""
    K_III: Quantity
    """tearing [Pa*m^0.5]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.plain),
        "s": ("s", _to.quantity),
        "K_I": ("K_I", _to.quantity),
        "K_II": ("K_II", _to.quantity),
        "K_III": ("K_III", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class AddedCompliance(Part):
    """The field `added_compliance`."""

    load_i: str
    """whose displacement"""
    load_j: str
    """factors per unit of this load"""
    unit: str
    """SI unit"""
    value: float
    """added compliance"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "load_i": ("load_i", _to.plain),
        "load_j": ("load_j", _to.plain),
        "unit": ("unit", _to.plain),
        "value": ("value", _to.plain_number),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Validity(Part):
    """The field `validity`."""

    limit: str
    """the limit in words"""
    inside: bool
    """whether the crack keeps this limit"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "limit": ("limit", _to.plain),
        "inside": ("inside", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class SifEvalResult(Result):
    """What `sif eval` answers."""

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
    fields: tuple[SifEvalPart, ...]
    """of the crack"""
    loads: tuple[SifEvalPart, ...]
    """that act"""
    material: Material
    """elastic constants and toughness"""
    crack_size: Quantity
    """crack size a in the geometry factors [m]"""
    geometry_factors: GeometryFactors
    """geometry factors for each load and point"""
    points: tuple[SifEvalPart2, ...]
    """stress intensities under all loads, at the named points"""
    largest: Optional[SifEvalPart2]
    """along the front; None if absent"""
    faces_pressed: bool
    """whether the faces press on each other somewhere on the front"""
    equivalent: Optional[Quantity]
    """sqrt(G E') at the worst point [Pa*m^0.5]; None if absent"""
    utilisation: Optional[Quantity]
    """equivalent over K_Ic; None if absent"""
    added_compliance: tuple[AddedCompliance, ...]
    """upper triangle"""
    quadrature_error: Quantity
    """relative error of the compliance"""
    validity: tuple[Validity, ...]
    """each limit of the range"""
    in_range: bool
    """whether the crack keeps every limit of the range"""

    command: ClassVar[str] = "sif eval"
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
        "fields": ("fields", _to.many(SifEvalPart._of)),
        "loads": ("loads", _to.many(SifEvalPart._of)),
        "material": ("material", Material._of),
        "crack_size": ("crack_size", _to.quantity),
        "geometry_factors": ("geometry_factors", GeometryFactors._of),
        "points": ("points", _to.many(SifEvalPart2._of)),
        "largest": ("largest", SifEvalPart2._of),
        "faces_pressed": ("faces_pressed", _to.plain),
        "equivalent": ("equivalent", _to.quantity),
        "utilisation": ("utilisation", _to.quantity),
        "added_compliance": ("added_compliance", _to.many(AddedCompliance._of)),
        "quadrature_error": ("quadrature_error", _to.quantity),
        "validity": ("validity", _to.many(Validity._of)),
        "in_range": ("in_range", _to.plain),
    }
