# SPDX-License-Identifier: Apache-2.0
"""Many evaluations of one drive with different numbers."""

from __future__ import annotations

import html
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence

import numpy as np
from numpy.typing import NDArray

from . import _library
from ._units import unit_of
from .errors import InputError
from .parts import AnyArray, FloatArray, pandas_module
from .running import ShownProgress, shown_progress

if TYPE_CHECKING:
    import pandas

    from .drive import Drive

#: Outcomes of a row, in the order of their numbers.
ROW_CODES = ("ok", "refused", "no-answer", "not-usable", "output-absent")


@dataclass(frozen=True)
class TableEvidence:
    """How far the numbers of a batch that read tables of cracks are from single evaluations."""

    cracks: int
    """cracks whose compliance was read from tables"""
    points: int
    """random rows at which tables and engine were compared"""
    largest_error: float
    """largest difference between tables and engine at these rows, over the output [-]"""


@dataclass(frozen=True, eq=False)
class BatchResult:
    """The outputs of many evaluations.

    >>> import strainwave as sw
    >>> drive = sw.read("cracked_size25.toml")
    >>> answer = drive.batch({"output_shaft.crack[0].depth": [0.001, 1.0]},
    ...                      ["cracked.positive.stiffness"])
    >>> answer.ok.tolist()
    [True, False]
    >>> ROW_CODES[answer.codes[1]]
    'refused'
    """

    outputs: tuple[str, ...]
    """names of the q outputs"""
    numbers: FloatArray
    """shape (q,) + shape of the rows [SI unit of the output]; NaN where a row has no number that may
    be used"""
    codes: NDArray[np.int32]
    """outcome of each row, an index into ROW_CODES"""
    faults: dict[str, str]
    """the message of the first row with each outcome but "ok" """
    inputs: dict[str, FloatArray]
    """the values of the fields as they were broadcast [SI unit of the field]"""
    tables: Optional[TableEvidence] = None
    """error of the tables that the rows read; None if the engine computed all rows, or if none of the
    compared rows has numbers"""

    @property
    def ok(self) -> NDArray[np.bool_]:
        """Whether the numbers of a row may be used."""
        return np.equal(self.codes, 0)

    def __getitem__(self, output: str) -> FloatArray:
        """The numbers of an output, in the shape of the rows."""
        try:
            row: FloatArray = self.numbers[self.outputs.index(output)]
        except ValueError:
            raise KeyError(f"{output} was not asked for; outputs are "
                           f"{', '.join(self.outputs)}") from None
        return row

    @property
    def units(self) -> dict[str, str]:
        """SI units of the fields and the outputs by their names; "1" for pure numbers."""
        return {name: unit_of(name) for name in (*self.inputs, *self.outputs)}

    @property
    def outcomes(self) -> AnyArray:
        """Outcome of each row as one of ROW_CODES."""
        return np.array(ROW_CODES)[self.codes]

    def to_frame(self) -> "pandas.DataFrame":
        """One row for each evaluation: the fields, the outputs, and the outcome; `attrs["units"]`
        names the units, `attrs["faults"]` has the faults, and `attrs["tables"]` the error of
        tables of cracks."""
        columns: dict[str, Any] = {path: values.ravel() for path, values in self.inputs.items()}
        columns.update({name: self[name].ravel() for name in self.outputs})
        columns["outcome"] = self.outcomes.ravel()
        frame = pandas_module().DataFrame(columns)
        frame.attrs["units"] = self.units
        frame.attrs["faults"] = dict(self.faults)
        frame.attrs["tables"] = asdict(self.tables) if self.tables else None
        return frame

    def to_dict(self) -> dict[str, Any]:
        """Fields, outputs, outcomes, units, faults and the error of tables in dicts and lists, which
        JSON can write; None where a row has no number."""
        return {"inputs": {path: _listed(values) for path, values in self.inputs.items()},
                "outputs": {name: _listed(self[name]) for name in self.outputs},
                "outcomes": self.outcomes.tolist(), "units": self.units, "faults": dict(self.faults),
                "tables": asdict(self.tables) if self.tables else None}

    def _counts(self) -> dict[str, int]:
        """Number of rows of each outcome that occurs."""
        counts = np.bincount(self.codes.ravel(), minlength=len(ROW_CODES))
        return {name: int(count) for name, count in zip(ROW_CODES, counts) if count}

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {name}" for name, count in self._counts().items())
        return f"<BatchResult of {self.codes.size} rows: {counts or 'none'}>"

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><td>{name}</td><td>{count}</td>"
                       f"<td>{html.escape(self.faults.get(name, ''))}</td></tr>"
                       for name, count in self._counts().items())
        asked = ", ".join(f"{name} [{self.units[name]}]" for name in self.outputs)
        error = ("<p>tables of cracks differ from the engine by "
                 f"{self.tables.largest_error:.1g} of an output at most, at {self.tables.points} random "
                 "rows</p>" if self.tables else "")
        return (f"<p><strong>{self.codes.size} rows</strong> of {html.escape(asked)}</p>"
                "<table><tr><th>outcome</th><th>rows</th><th>first fault</th></tr>"
                f"{rows}</table>{error}")


def _listed(numbers: FloatArray) -> Any:
    """Numbers in lists, with None for what JSON cannot write; a single row has no list."""
    listed = np.asarray(numbers).astype(object)
    listed[~np.isfinite(numbers)] = None
    return listed.tolist()


def _column(path: str, values: Any) -> FloatArray:
    """Values of a field as doubles; words, dates, complex numbers, truth values and masked values
    are refused."""
    if not isinstance(path, str):
        raise TypeError("the path of a field is text, such as \"load.torque\", not "
                        f"{type(path).__name__}")
    masked = np.count_nonzero(values.mask) if isinstance(values, np.ma.MaskedArray) else 0
    if masked:
        raise InputError(f"{path}: {masked} of its values are masked; leave them out, or fill them "
                         "with numbers", path=path)
    try:
        given = np.asarray(values)
    except ValueError as error:
        raise InputError(f"{path}: its values are not one array: {error}", path=path) from None
    if given.dtype.kind not in "fiu":
        raise InputError(f"{path}: its values must be numbers in the SI unit of the field, not "
                         f"{given.dtype}", path=path)
    return given.astype(np.float64)


def batch(drive: "Drive", values: Mapping[str, Any], outputs: Sequence[str], *,
          method: str = "corrected", threads: int = 0, out: Any = None,
          progress: ShownProgress = None) -> BatchResult:
    """See Drive.batch."""
    if not isinstance(values, Mapping):
        raise TypeError("values must be arrays by the paths of fields, such as "
                        f"{{\"load.torque\": [1.0, 2.0]}}, not {type(values).__name__}")
    outputs = _names(outputs)
    paths = list(values)
    columns = [_column(path, values[path]) for path in paths]
    try:
        rows = np.broadcast_arrays(*columns) if columns else []
    except ValueError:
        shapes = ", ".join(f"{path} {column.shape}" for path, column in zip(paths, columns))
        raise InputError(f"the shapes of the values do not fit together: {shapes}") from None
    shape = rows[0].shape if rows else ()
    n_rows = int(np.prod(shape, dtype=np.int64))
    table = np.empty((n_rows, len(paths)))
    for place, row in enumerate(rows):
        table[:, place] = row.ravel()
    numbers = _out(out, (len(outputs),) + shape)
    found = np.empty((n_rows, len(outputs)))
    codes = np.empty(n_rows, dtype=np.intc)
    faults, tables = _library.batch(drive._handle, paths, table.ctypes.data, n_rows, outputs, method,
                                    _whole("threads", threads), found.ctypes.data,
                                    codes.ctypes.data, shown_progress(progress))
    found[codes != 0] = np.nan
    numbers[...] = found.T.reshape(numbers.shape)
    return BatchResult(outputs, numbers, codes.astype(np.int32).reshape(shape),
                       {ROW_CODES[code]: fault for code, fault in enumerate(faults) if fault},
                       {path: np.array(row) for path, row in zip(paths, rows)},
                       TableEvidence(tables.cracks, tables.points, tables.largest_error)
                       if tables.points else None)


def _names(outputs: Any) -> tuple[str, ...]:
    names = (outputs,) if isinstance(outputs, str) else outputs
    try:
        names = tuple(names)
    except TypeError:
        pass
    if not isinstance(names, tuple) or not all(isinstance(name, str) for name in names):
        raise TypeError("outputs must be names of outputs, such as [\"intact.stiffness\"], not "
                        f"{outputs!r}")
    return names


def _whole(name: str, value: Any) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)):
        raise TypeError(f"{name} must be a whole number, not {type(value).__name__}")
    if not -(1 << 31) <= value < 1 << 31:
        raise InputError(f"{name} must be from 0 to 256, not {value}", path=name)
    return int(value)


def _out(out: Any, shape: tuple[int, ...]) -> FloatArray:
    if out is None:
        return np.empty(shape)
    if not isinstance(out, np.ndarray) or out.dtype != np.float64 or not out.dtype.isnative:
        raise InputError("out must be an array of native float64", path="out")
    if out.shape != shape:
        raise InputError(f"out must have the shape {shape}, not {out.shape}", path="out")
    if not out.flags.writeable:
        raise InputError("out must be writeable", path="out")
    return out
