# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command laminate."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Plies(Part):
    """Each ply."""

    number: AnyArray
    """number of the ply from the inner face of the wall"""
    material: AnyArray
    """material of the ply"""
    angle: FloatArray
    """angle of the fibres from the axis, measured like that of a crack [rad]"""
    thickness: FloatArray
    """thickness in the wall [m]"""
    load_along: FloatArray
    """stress along the fibres by torque and axial force [Pa]"""
    load_across: FloatArray
    """stress across the fibres by torque and axial force [Pa]"""
    load_shear: FloatArray
    """shear stress along the fibres by torque and axial force [Pa]"""
    assembly_along: FloatArray
    """largest stress along the fibres by the assembly over a turn [Pa]"""
    assembly_across: FloatArray
    """largest stress across the fibres by the assembly over a turn [Pa]"""
    assembly_shear: FloatArray
    """largest shear stress along the fibres by the assembly over a turn [Pa]"""
    tsai_wu: FloatArray
    """least factor on the loads at which the ply fails by the criterion of Tsai and Wu"""
    largest_strain: FloatArray
    """least factor on the loads at which the ply fails by the largest strain"""
    proportional: FloatArray
    """least factor on the loads and the assembly together at which the ply fails"""
    worst_face: AnyArray
    """face of the ply that fails first"""
    worst_angle: FloatArray
    """its angle from a lobe [rad]"""
    worst_sense: AnyArray
    """sense of torque under which it fails first; 0: not known"""
    worst_along: FloatArray
    """stress there along the fibres by load and assembly [Pa]"""
    worst_across: FloatArray
    """stress there across the fibres by load and assembly [Pa]"""
    worst_shear: FloatArray
    """stress there in shear by load and assembly [Pa]"""
    haigh: FloatArray
    """share of the Haigh line over a turn; absent: no endurance is given"""
    haigh_factor: FloatArray
    """factor on the loads at which the share is 1"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "number": ("number", _to.entries),
        "material": ("material", _to.entries),
        "angle": ("angle", _to.floats),
        "thickness": ("thickness", _to.floats),
        "load_along": ("load_along", _to.floats),
        "load_across": ("load_across", _to.floats),
        "load_shear": ("load_shear", _to.floats),
        "assembly_along": ("assembly_along", _to.floats),
        "assembly_across": ("assembly_across", _to.floats),
        "assembly_shear": ("assembly_shear", _to.floats),
        "tsai_wu": ("tsai_wu", _to.floats),
        "largest_strain": ("largest_strain", _to.floats),
        "proportional": ("proportional", _to.floats),
        "worst_face": ("worst_face", _to.entries),
        "worst_angle": ("worst_angle", _to.floats),
        "worst_sense": ("worst_sense", _to.entries),
        "worst_along": ("worst_along", _to.floats),
        "worst_across": ("worst_across", _to.floats),
        "worst_shear": ("worst_shear", _to.floats),
        "haigh": ("haigh", _to.floats),
        "haigh_factor": ("haigh_factor", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "angle": "rad",
        "thickness": "m",
        "load_along": "Pa",
        "load_across": "Pa",
        "load_shear": "Pa",
        "assembly_along": "Pa",
        "assembly_across": "Pa",
        "assembly_shear": "Pa",
        "tsai_wu": "1",
        "largest_strain": "1",
        "proportional": "1",
        "worst_angle": "rad",
        "worst_along": "Pa",
        "worst_across": "Pa",
        "worst_shear": "Pa",
        "haigh": "1",
        "haigh_factor": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Walls(Part):
    """The field `walls`."""

    path: str
    """section of the flexspline"""
    material: str
    """its material"""
    thickness: Quantity
    """thickness of the wall [m]"""
    thickness_of_plies: Quantity
    """sum of the plies as given [m]"""
    E_x: Quantity
    """modulus along the axis [Pa]"""
    E_y: Quantity
    """modulus round the axis [Pa]"""
    G_xy: Quantity
    """shear modulus of a wall that may lengthen and widen [Pa]"""
    nu_xy: Quantity
    """contraction round the axis under a stress along it"""
    A: FloatArray
    """stiffness of the wall in its plane: 11, 12, 22, 16, 26, 66 [N/m]"""
    B: FloatArray
    """coupling with bending: 11, 12, 22, 16, 26, 66 [N]"""
    D: FloatArray
    """bending stiffness: 11, 12, 22, 16, 26, 66 [N*m]"""
    hoop_bending: Quantity
    """stiffness against a change of the hoop curvature [N*m]"""
    symmetric: bool
    """whether the plies are the same from both faces"""
    balanced: bool
    """whether torque does not lengthen the wall"""
    torsional_rigidity: Optional[Quantity]
    """torque over twist per length; absent for a bottom [N*m^2]; None if absent"""
    compliance: Optional[Quantity]
    """torsional compliance of the section [rad/(N*m)]; None if absent"""
    axial_strain: Optional[Quantity]
    """strain along the axis by the torque; None if absent"""
    hoop_strain: Optional[Quantity]
    """strain round the axis by the torque; None if absent"""
    reserve: Optional[Quantity]
    """least factor on the loads at which a ply fails; absent: not known; None if absent"""
    first_ply: int
    """number of the ply that fails first; 0: not known"""
    proportional: Optional[Quantity]
    """least factor on the loads and the assembly together; absent: not known; None if absent"""
    haigh: Optional[Quantity]
    """largest share of the Haigh line of the plies; absent: not known; None if absent"""
    plies: Plies
    """each ply"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.plain),
        "material": ("material", _to.plain),
        "thickness": ("thickness", _to.quantity),
        "thickness_of_plies": ("thickness_of_plies", _to.quantity),
        "E_x": ("E_x", _to.quantity),
        "E_y": ("E_y", _to.quantity),
        "G_xy": ("G_xy", _to.quantity),
        "nu_xy": ("nu_xy", _to.quantity),
        "A": ("A", _to.floats),
        "B": ("B", _to.floats),
        "D": ("D", _to.floats),
        "hoop_bending": ("hoop_bending", _to.quantity),
        "symmetric": ("symmetric", _to.plain),
        "balanced": ("balanced", _to.plain),
        "torsional_rigidity": ("torsional_rigidity", _to.quantity),
        "compliance": ("compliance", _to.quantity),
        "axial_strain": ("axial_strain", _to.quantity),
        "hoop_strain": ("hoop_strain", _to.quantity),
        "reserve": ("reserve", _to.quantity),
        "first_ply": ("first_ply", _to.plain),
        "proportional": ("proportional", _to.quantity),
        "haigh": ("haigh", _to.quantity),
        "plies": ("plies", Plies._of),
    }
    _units: ClassVar[dict[str, str]] = {
        "A": "N/m",
        "B": "N",
        "D": "N*m",
    }


@dataclass(frozen=True, eq=False, repr=False)
class LaminateResult(Result):
    """What `laminate` answers."""

    sentence: str
    """the answer in words"""
    reserve: Optional[Quantity]
    """least factor on the loads at which a ply fails; absent: not known; None if absent"""
    haigh: Optional[Quantity]
    """largest share of the Haigh line of the plies; absent: not known; None if absent"""
    walls: tuple[Walls, ...]
    """each section of a laminate"""

    command: ClassVar[str] = "laminate"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "sentence": ("sentence", _to.plain),
        "reserve": ("reserve", _to.quantity),
        "haigh": ("haigh", _to.quantity),
        "walls": ("walls", _to.many(Walls._of)),
    }
