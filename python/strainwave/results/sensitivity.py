# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The result of the command sensitivity."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Literal, Optional

from .. import parts as _to
from ..answers import Result
from ..parts import AnyArray, Converter, FloatArray, Part, Quantity


@dataclass(frozen=True, eq=False, repr=False)
class Outputs(Part):
    """The field `outputs`."""

    name: str
    """the output"""
    value: Quantity
    """its value"""
    length_residual: Quantity
    """residual of the power of length after the elasticities"""
    force_residual: Quantity
    """residual of the power of force after the elasticities"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.plain),
        "value": ("value", _to.quantity),
        "length_residual": ("length_residual", _to.quantity),
        "force_residual": ("force_residual", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Influence(Part):
    """Influence on each output, in the order of the outputs."""

    derivative: AnyArray
    """dy/dx, unit of the output over that of the input"""
    elasticity: FloatArray
    """d ln y/d ln x"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "derivative": ("derivative", _to.entries),
        "elasticity": ("elasticity", _to.floats),
    }
    _units: ClassVar[dict[str, str]] = {
        "elasticity": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Inputs(Part):
    """Fields with an influence, the largest elasticity first."""

    path: AnyArray
    """field of the input"""
    unit: AnyArray
    """SI unit of the field"""
    value: AnyArray
    """value in the file"""
    influence: Influence
    """influence on each output, in the order of the outputs"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.entries),
        "unit": ("unit", _to.entries),
        "value": ("value", _to.entries),
        "influence": ("influence", Influence._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class NotDifferentiated(Part):
    """Fields with respect to which K1, K2, K3 have no derivative."""

    path: AnyArray
    """field of the input"""
    reason: AnyArray
    """the reason why there is no derivative"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.entries),
        "reason": ("reason", _to.entries),
    }


@dataclass(frozen=True, eq=False, repr=False)
class ScatterInputs(Part):
    """The field `inputs`."""

    path: str
    """path of the number"""
    relative_standard_deviation: Quantity
    """standard deviation over the value in the file"""
    distribution: Literal["lognormal", "normal", "uniform", "weibull", "table"]
    """distribution about the value in the file"""
    source: str
    """one line"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.plain),
        "relative_standard_deviation": ("relative_standard_deviation", _to.quantity),
        "distribution": ("distribution", _to.plain),
        "source": ("source", _to.plain),
    }


@dataclass(frozen=True, eq=False, repr=False)
class ScatterOutputs(Part):
    """The field `outputs`."""

    name: str
    """the output"""
    unit: str
    """SI unit of the output"""
    value: float
    """value at the inputs of the file"""
    first_order: Quantity
    """relative standard deviation, first order"""
    share: FloatArray
    """share of each scattering input in the square of first_order; with its part of the
    covariances"""
    mean: float
    """mean of the draws"""
    relative_deviation: Quantity
    """standard deviation over mean of the draws"""
    relative_deviation_error: Quantity
    """standard error of the relative deviation"""
    mean_error: Quantity
    """standard error of the mean, over the mean"""
    low: float
    """5 % of the draws are lower"""
    median: float
    """half of the draws are lower"""
    high: float
    """95 % of the draws are lower"""
    model_uncertainty: Optional[Quantity]
    """relative uncertainty of the model's form, without the scatter; None if absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.plain),
        "unit": ("unit", _to.plain),
        "value": ("value", _to.plain_number),
        "first_order": ("first_order", _to.quantity),
        "share": ("share", _to.floats),
        "mean": ("mean", _to.plain_number),
        "relative_deviation": ("relative_deviation", _to.quantity),
        "relative_deviation_error": ("relative_deviation_error", _to.quantity),
        "mean_error": ("mean_error", _to.quantity),
        "low": ("low", _to.plain_number),
        "median": ("median", _to.plain_number),
        "high": ("high", _to.plain_number),
        "model_uncertainty": ("model_uncertainty", _to.quantity),
    }
    _units: ClassVar[dict[str, str]] = {
        "share": "1",
    }


@dataclass(frozen=True, eq=False, repr=False)
class Tables(Part):
    """Error of the tables that the draws read; absent: the engine computed all."""

    cracks: int
    """cracks whose compliance was read from tables"""
    points: int
    """random drives of the study at which tables and engine were compared"""
    largest_error: Quantity
    """largest difference between tables and engine at these drives, over the output"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "cracks": ("cracks", _to.plain),
        "points": ("points", _to.plain),
        "largest_error": ("largest_error", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Scatter(Part):
    """Combined uncertainty from the scatter of the inputs."""

    inputs: tuple[ScatterInputs, ...]
    """scatter that the file gives"""
    outputs: tuple[ScatterOutputs, ...]
    """combined uncertainty of each output"""
    samples: int
    """requested draws"""
    evaluated: int
    """draws with a result"""
    refused: int
    """draws that broke a rule of the input"""
    unusable: int
    """draws beyond the validity of the model"""
    seed: int
    """seed of the draws"""
    tables: Optional[Tables]
    """error of the tables that the draws read; absent: the engine computed all; None if
    absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "inputs": ("inputs", _to.many(ScatterInputs._of)),
        "outputs": ("outputs", _to.many(ScatterOutputs._of)),
        "samples": ("samples", _to.plain),
        "evaluated": ("evaluated", _to.plain),
        "refused": ("refused", _to.plain),
        "unusable": ("unusable", _to.plain),
        "seed": ("seed", _to.plain),
        "tables": ("tables", Tables._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class InputsPart(Part):
    """Share by the input alone."""

    value: Quantity
    """the share"""
    low: Quantity
    """lower end of its 95 % interval"""
    high: Quantity
    """upper end of its 95 % interval"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "value": ("value", _to.quantity),
        "low": ("low", _to.quantity),
        "high": ("high", _to.quantity),
    }


@dataclass(frozen=True, eq=False, repr=False)
class OutputsInputs(Part):
    """The field `inputs`."""

    path: str
    """field of the input; of inputs that depend on each other, their fields"""
    first: InputsPart
    """share by the input alone"""
    total: InputsPart
    """share by the input alone and together with others"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "path": ("path", _to.plain),
        "first": ("first", InputsPart._of),
        "total": ("total", InputsPart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class SobolOutputs(Part):
    """The field `outputs`."""

    name: str
    """the output"""
    unit: str
    """SI unit of the output"""
    value: float
    """value at the inputs of the file"""
    mean: float
    """mean over the points"""
    deviation: float
    """standard deviation over the points"""
    inputs: tuple[OutputsInputs, ...]
    """shares of the inputs, the largest total share first"""
    first_sum: InputsPart
    """sum of the shares by single inputs"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "name": ("name", _to.plain),
        "unit": ("unit", _to.plain),
        "value": ("value", _to.plain_number),
        "mean": ("mean", _to.plain_number),
        "deviation": ("deviation", _to.plain_number),
        "inputs": ("inputs", _to.many(OutputsInputs._of)),
        "first_sum": ("first_sum", InputsPart._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class Sobol(Part):
    """Shares of the scattering inputs in the variance of outputs."""

    outputs: tuple[SobolOutputs, ...]
    """shares for each output"""
    points: int
    """base points"""
    replicates: int
    """independent scramblings of the points"""
    evaluations: int
    """evaluated drives"""
    left_out: int
    """base points without a usable drive"""
    seed: int
    """seed of the scramblings"""
    tables: Optional[Tables]
    """error of the tables that the drives read; absent: the engine computed all; None if
    absent"""

    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "outputs": ("outputs", _to.many(SobolOutputs._of)),
        "points": ("points", _to.plain),
        "replicates": ("replicates", _to.plain),
        "evaluations": ("evaluations", _to.plain),
        "left_out": ("left_out", _to.plain),
        "seed": ("seed", _to.plain),
        "tables": ("tables", Tables._of),
    }


@dataclass(frozen=True, eq=False, repr=False)
class SensitivityResult(Result):
    """What `sensitivity` answers."""

    outputs: tuple[Outputs, ...]
    """what is differentiated"""
    inputs: Inputs
    """fields with an influence, the largest elasticity first"""
    no_influence: tuple[str, ...]
    """all other numbers of the file"""
    not_differentiated: NotDifferentiated
    """fields with respect to which K1, K2, K3 have no derivative"""
    homogeneity_residual: Quantity
    """largest residual of the dimensions"""
    scatter: Optional[Scatter]
    """combined uncertainty from the scatter of the inputs; None if absent"""
    sobol: Optional[Sobol]
    """shares of the scattering inputs in the variance of outputs; None if absent"""

    command: ClassVar[str] = "sensitivity"
    documents: ClassVar[tuple[str, ...]] = ("json", "text", "csv", "plot")
    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {
        "outputs": ("outputs", _to.many(Outputs._of)),
        "inputs": ("inputs", Inputs._of),
        "no_influence": ("no_influence", _to.many(_to.plain)),
        "not_differentiated": ("not_differentiated", NotDifferentiated._of),
        "homogeneity_residual": ("homogeneity_residual", _to.quantity),
        "scatter": ("scatter", Scatter._of),
        "sobol": ("sobol", Sobol._of),
    }
