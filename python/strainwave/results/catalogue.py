# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command catalogue."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part


@dataclass(frozen=True, eq=False, repr=False)
class Stiffness(Part):
    """Torsional stiffness, input locked, also of other series."""

    size: FloatArray
    """maker's size, in tenths of an inch"""
    ratio_class: AnyArray
    """30, 50, or 80 and more"""
    ratios: FloatArray
    """reduction ratios for which the row holds"""
    series: AnyArray
    """maker's series"""
    form: AnyArray
    """cup, or hat with the diaphragm outward"""
    length: AnyArray
    """length class of the flexspline"""
    origin: AnyArray
    """where the row comes from; only rows of the catalogue enter a fit"""
    T1: FloatArray
    """upper torque of K1 [N*m]"""
    T2: FloatArray
    """upper torque of K2 [N*m]"""
    K1: FloatArray
    """stiffness up to T1 [N*m/rad]"""
    K2: FloatArray
    """stiffness from T1 to T2 [N*m/rad]"""
    K3: FloatArray
    """stiffness beyond T2 [N*m/rad]"""
    sources: AnyArray
    """tables that state the row"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "size": ("size", _to.floats),
        "ratio_class": ("ratio_class", _to.entries),
        "ratios": ("ratios", _to.floats),
        "series": ("series", _to.entries),
        "form": ("form", _to.entries),
        "length": ("length", _to.entries),
        "origin": ("origin", _to.entries),
        "T1": ("T1", _to.floats),
        "T2": ("T2", _to.floats),
        "K1": ("K1", _to.floats),
        "K2": ("K2", _to.floats),
        "K3": ("K3", _to.floats),
        "sources": ("sources", _to.entries),
    }
    _units: ClassVar[dict[str, str]] = {
        "size": "1",
        "ratios": "1",
        "T1": "N*m",
        "T2": "N*m",
        "K1": "N*m/rad",
        "K2": "N*m/rad",
        "K3": "N*m/rad",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Ratings(Part):
    """Torques, speeds and inertia."""

    series: AnyArray
    """maker's series"""
    size: FloatArray
    """maker's size, in tenths of an inch"""
    ratio: FloatArray
    """reduction ratio"""
    rated: FloatArray
    """rated torque T_N at an input of 2000 rpm [N*m]"""
    average: FloatArray
    """largest average torque [N*m]"""
    repeated_peak: FloatArray
    """largest repeated torque [N*m]"""
    momentary_peak: FloatArray
    """largest momentary torque [N*m]"""
    max_input_speed: FloatArray
    """largest speed of the input, with grease [rad/s]"""
    average_input_speed: FloatArray
    """largest average speed of the input, with grease [rad/s]"""
    input_inertia: FloatArray
    """moment of inertia of the wave generator [kg*m^2]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "series": ("series", _to.entries),
        "size": ("size", _to.floats),
        "ratio": ("ratio", _to.floats),
        "rated": ("rated", _to.floats),
        "average": ("average", _to.floats),
        "repeated_peak": ("repeated_peak", _to.floats),
        "momentary_peak": ("momentary_peak", _to.floats),
        "max_input_speed": ("max_input_speed", _to.floats),
        "average_input_speed": ("average_input_speed", _to.floats),
        "input_inertia": ("input_inertia", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "size": "1",
        "ratio": "1",
        "rated": "N*m",
        "average": "N*m",
        "repeated_peak": "N*m",
        "momentary_peak": "N*m",
        "max_input_speed": "rad/s",
        "average_input_speed": "rad/s",
        "input_inertia": "kg*m^2",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Limits(Part):
    """Ratcheting and buckling torques."""

    series: AnyArray
    """maker's series"""
    size: FloatArray
    """maker's size, in tenths of an inch"""
    ratio: FloatArray
    """reduction ratio"""
    ratcheting: FloatArray
    """torque at which teeth jump [N*m]"""
    buckling: FloatArray
    """torque at which the flexspline buckles, for all ratios of a size [N*m]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "series": ("series", _to.entries),
        "size": ("size", _to.floats),
        "ratio": ("ratio", _to.floats),
        "ratcheting": ("ratcheting", _to.floats),
        "buckling": ("buckling", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "size": "1",
        "ratio": "1",
        "ratcheting": "N*m",
        "buckling": "N*m",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Lives(Part):
    """Lives of the wave generator bearings of all series."""

    series: AnyArray
    """maker's series"""
    L10: FloatArray
    """life that 90 % of the bearings reach [s]"""
    L50: FloatArray
    """life that half of the bearings reach [s]"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "series": ("series", _to.entries),
        "L10": ("L10", _to.floats),
        "L50": ("L50", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "L10": "s",
        "L50": "s",
    }


@dataclass(frozen=True, eq=False, repr=False)
class CatalogueResult(Result):
    """What `catalogue` answers."""

    stiffness: Stiffness
    """torsional stiffness, input locked, also of other series"""
    ratings: Ratings
    """torques, speeds and inertia"""
    limits: Limits
    """ratcheting and buckling torques"""
    lives: Lives
    """lives of the wave generator bearings of all series"""
    sources: dict[str, Any]
    """publications from which the rows were taken"""

    command: ClassVar[str] = "catalogue"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "stiffness": ("stiffness", Stiffness._of),
        "ratings": ("ratings", Ratings._of),
        "limits": ("limits", Limits._of),
        "lives": ("lives", Lives._of),
        "sources": ("sources", _to.plain),
    }
