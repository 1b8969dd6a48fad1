# SPDX-License-Identifier: Apache-2.0
"""Quantities and parts of results, and how they are made of JSON.

The classes of the single results are written by tools/write_python.py from the descriptions of the
results; this module holds what they share.
"""

from __future__ import annotations

import copy
import html
import math
from typing import TYPE_CHECKING, Any, Callable, ClassVar, Iterator, Optional, TypeVar, Union

import numpy as np
from numpy.typing import NDArray

from .errors import NotUsable

if TYPE_CHECKING:
    import pandas

FloatArray = NDArray[np.float64]
AnyArray = NDArray[Any]

MOST_SHOWN = 20  # elements of a list in an HTML table

PartType = TypeVar("PartType", bound="Part")
Converter = Callable[[Any, str], Any]  # JSON, reason why the result must not be used -> value


class Quantity:
    """A number with its unit and, where it is known, its accuracy.

    `value`, `float()` and arithmetic give the number in the unit, which is an SI unit.  str() gives
    as many digits as the accuracy warrants.  Of a result that must not be used, the number is
    refused by NotUsable.

    >>> stiffness = Quantity(72811.46, "N*m/rad", 0.05)
    >>> stiffness
    <Quantity 7.28e+04 N*m/rad>
    >>> float(stiffness), stiffness.unit, round(stiffness.uncertainty, 3)
    (72811.46, 'N*m/rad', 3640.573)
    >>> stiffness / 2
    36405.73
    """

    __slots__ = ("_value", "_unit", "_relative_uncertainty", "_unusable_because")

    def __init__(self, value: float, unit: str, relative_uncertainty: Optional[float] = None,
                 unusable_because: str = "") -> None:
        self._value = float(value)
        self._unit = unit
        self._relative_uncertainty = relative_uncertainty
        self._unusable_because = unusable_because

    @property
    def value(self) -> float:
        """The number [unit]; NaN where the result has none.

        Raises:
            NotUsable: if the result must not be used
        """
        if self._unusable_because:
            raise _refusal(self._unusable_because)
        return self._value

    @property
    def unit(self) -> str:
        """The SI unit; "1" for a pure number."""
        return self._unit

    @property
    def relative_uncertainty(self) -> Optional[float]:
        """One relative standard uncertainty [1]; None if it is not known."""
        return self._relative_uncertainty

    @property
    def uncertainty(self) -> Optional[float]:
        """One standard uncertainty [unit]; None if it is not known."""
        relative = self._relative_uncertainty
        return None if relative is None else abs(self.value) * relative

    def __float__(self) -> float:
        return self.value

    def __array__(self, dtype: Any = None, copy: Any = None) -> AnyArray:
        return np.asarray(self.value, dtype=dtype)

    def __str__(self) -> str:
        if self._unusable_because:
            return f"not usable: {self._unusable_because}"
        unit = "" if self._unit in ("1", "") else f" {self._unit}"
        return _digits(self._value, self._relative_uncertainty) + unit

    def __repr__(self) -> str:
        return f"<Quantity {self}>"

    def _repr_html_(self) -> str:
        """As str(), with one standard uncertainty if it is known."""
        shown = html.escape(str(self))
        if self._unusable_because:
            return f"<strong>{shown}</strong>"
        relative = self._relative_uncertainty
        return f"{shown} (&plusmn; {100 * relative:.2g} %)" if relative else shown

    def __format__(self, spec: str) -> str:
        """The number alone in the format `spec`; without `spec`, as str()."""
        return format(self.value, spec) if spec else str(self)

    def _key(self) -> tuple[str, str, Optional[float], str]:
        return (repr(self._value), self._unit, self._relative_uncertainty, self._unusable_because)

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Quantity):
            return self._key() == other._key()
        if isinstance(other, (int, float)):
            return self.value == other
        return NotImplemented

    def __hash__(self) -> int:
        return hash(self._value)

    def __lt__(self, other: Union[float, Quantity]) -> bool:
        return self.value < float(other)

    def __le__(self, other: Union[float, Quantity]) -> bool:
        return self.value <= float(other)

    def __gt__(self, other: Union[float, Quantity]) -> bool:
        return self.value > float(other)

    def __ge__(self, other: Union[float, Quantity]) -> bool:
        return self.value >= float(other)

    def __neg__(self) -> float:
        return -self.value

    def __abs__(self) -> float:
        return abs(self.value)

    def __add__(self, other: Union[float, Quantity]) -> float:
        return self.value + float(other)

    def __radd__(self, other: float) -> float:
        return other + self.value

    def __sub__(self, other: Union[float, Quantity]) -> float:
        return self.value - float(other)

    def __rsub__(self, other: float) -> float:
        return other - self.value

    def __mul__(self, other: Union[float, Quantity]) -> float:
        return self.value * float(other)

    def __rmul__(self, other: float) -> float:
        return other * self.value

    def __truediv__(self, other: Union[float, Quantity]) -> float:
        return self.value / float(other)

    def __rtruediv__(self, other: float) -> float:
        return other / self.value


def _refusal(unusable_because: str) -> NotUsable:
    return NotUsable(f"the result must not be used: {unusable_because}")


def _digits(value: float, relative_uncertainty: Optional[float]) -> str:
    """The number with one digit more than its uncertainty leaves certain, 2 to 12 digits; with 6
    digits if the uncertainty is not known."""
    digits = 6
    if relative_uncertainty is not None and relative_uncertainty > 0:
        digits = min(max(1 - math.floor(math.log10(relative_uncertainty)), 2), 12)
    return format(value, f".{digits}g")


def number(json_value: Any) -> float:
    """A number of JSON, which writes NaN and infinity as null."""
    return math.nan if json_value is None else float(json_value)


def quantity(value: Any, unusable_because: str) -> Quantity:
    """Converts a number with its unit."""
    return Quantity(number(value["value"]), value["unit"], value.get("relative_uncertainty"),
                    unusable_because)


def floats(value: Any, _unusable_because: str) -> FloatArray:
    """Converts numbers of one unit to a read-only array; rows of unequal length become an array of
    arrays."""
    given = value["values"]
    lengths = {len(row) if isinstance(row, list) else -1 for row in given}
    if len(lengths) > 1:
        made = np.empty(len(given), dtype=object)
        for place, row in enumerate(given):
            made[place] = floats({"values": row}, "")
    else:
        made = np.array(given, dtype=np.float64)  # null becomes NaN
    made.setflags(write=False)
    return made


def entries(value: Any, _unusable_because: str) -> AnyArray:
    """Converts whole numbers, words or truth values to a read-only array."""
    made = np.array(value["values"])
    made.setflags(write=False)
    return made


def plain(value: Any, _unusable_because: str) -> Any:
    """Takes a value as JSON gives it."""
    return value


def plain_number(value: Any, _unusable_because: str) -> float:
    """Takes a number without a unit."""
    return number(value)


def many(convert: Converter) -> Converter:
    """Converts a list, element by element."""
    return lambda value, unusable_because: tuple(convert(one, unusable_because) for one in value)


def _is_bare(value: Any) -> bool:
    """Whether a value is a number that is not a count, an array of such numbers, or a tuple of
    them: unlike a Quantity, such a value cannot say itself that it must not be used."""
    if isinstance(value, tuple) or isinstance(value, np.ndarray) and value.dtype.kind == "O":
        return any(_is_bare(one) for one in value)
    if isinstance(value, np.ndarray):
        return value.dtype.kind == "f" and value.size > 0
    return isinstance(value, float)


class Part:
    """A part of a result: its fields are attributes, documented with their units.

    Two parts are equal if they are of one class and all their numbers are the same.  Of a result
    that must not be used, numbers and arrays of numbers are refused by NotUsable; words, truth
    values and counts are given, and to_dict() gives everything.
    """

    _fields: ClassVar[dict[str, tuple[str, Converter]]]  # JSON name -> attribute, converter
    _units: ClassVar[dict[str, str]] = {}  # units of the fields that are arrays
    _json: dict[str, Any]
    _unusable_because: str
    _refused: frozenset[str]  # attributes that are left out, because they must not be used

    @classmethod
    def _of(cls: type[PartType], value: Any, unusable_because: str) -> PartType:
        made = cls.__new__(cls)
        attributes = made.__dict__
        refused = []
        for name, (attribute, convert) in cls._fields.items():
            given = convert(value[name], unusable_because) if name in value else None
            if unusable_because and _is_bare(given):
                refused.append(attribute)
            else:
                attributes[attribute] = given
        attributes["_json"] = value
        attributes["_unusable_because"] = unusable_because
        attributes["_refused"] = frozenset(refused)
        return made

    if not TYPE_CHECKING:  # with this method, a checker would take every name for an attribute

        def __getattr__(self, name: str) -> Any:
            """Refuses an attribute that is left out."""
            if name in self.__dict__.get("_refused", ()):
                raise _refusal(self._unusable_because)
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")

    def _values(self) -> Iterator[tuple[str, Any]]:
        """The fields with their values; in the place of one that is refused, a quantity that says
        so."""
        refused = Quantity(math.nan, "1", unusable_because=self._unusable_because)
        for attribute, _ in self._fields.values():
            yield attribute, self.__dict__.get(attribute, refused)

    def to_dict(self) -> dict[str, Any]:
        """The part as JSON states it, in dicts and lists."""
        return copy.deepcopy(self._json)

    def unit_of(self, name: str) -> str:
        """Unit of the field with this name; "1" for words and pure numbers.

        >>> import strainwave as sw
        >>> sw.read("cracked_size25.toml").torsion().curve.points.unit_of("twist")
        'rad'
        """
        value = None if name in self._refused else getattr(self, name)
        return value.unit if isinstance(value, Quantity) else self._units.get(name, "1")

    def to_frame(self) -> "pandas.DataFrame":
        """The arrays of equal length as a pandas.DataFrame; `attrs["units"]` names the units, and
        `attrs["unusable_because"]` says why the numbers must not be used; empty if they may be used.

        >>> import strainwave as sw
        >>> frame = sw.read("cracked_size25.toml").torsion().curve.points.to_frame()
        >>> frame.attrs["units"]["twist"]
        'rad'

        Raises:
            ValueError: if the part has no arrays
        """
        given = {attribute: convert(self._json[name], "") if attribute in self._refused
                 else self.__dict__[attribute] for name, (attribute, convert) in self._fields.items()}
        columns = {name: value for name, value in given.items()
                   if isinstance(value, np.ndarray) and value.ndim == 1}
        if not columns:
            raise ValueError(f"{type(self).__name__} has no arrays to put into columns; to_dict() "
                             "gives its values")
        length = max(len(column) for column in columns.values())
        frame = pandas_module().DataFrame({name: column for name, column in columns.items()
                                     if len(column) == length})
        frame.attrs["units"] = {name: self.unit_of(name) for name in frame.columns}
        frame.attrs["unusable_because"] = self._unusable_because
        return frame

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self._json == other.__dict__["_json"]

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        words = ", ".join(f"{name}={value}" for name, value in self._values()
                          if isinstance(value, (Quantity, str, bool, int, float)))
        return f"<{type(self).__name__} {words}>"

    def _repr_html_(self) -> str:
        return html_table(self)


def pandas_module() -> Any:
    try:
        import pandas
    except ImportError as error:
        raise ImportError("to_frame() needs pandas, which is not installed; to_dict() gives the "
                          "same values without pandas") from error
    return pandas


def html_table(part: Part) -> str:
    """The values of a part as an HTML table, with tables of its parts inside."""
    rows = [(name, _html_cell(value, part.unit_of(name))) for name, value in part._values()
            if value is not None]
    cells = "".join(f"<tr><th>{html.escape(name)}</th><td>{cell}</td></tr>" for name, cell in rows)
    return f"<table>{cells}</table>"


def _html_cell(value: Any, unit: str) -> str:
    if isinstance(value, (Quantity, Part)):
        return value._repr_html_()
    if isinstance(value, np.ndarray):
        size = " x ".join(map(str, value.shape))
        return html.escape(f"array of {size}" + (f" [{unit}]" if unit not in ("1", "") else ""))
    if isinstance(value, tuple):
        more = f"... and {len(value) - MOST_SHOWN} more" if len(value) > MOST_SHOWN else ""
        shown = [_html_cell(one, unit) for one in value[:MOST_SHOWN]] + [more] * bool(more)
        return ("" if any(isinstance(one, Part) for one in value) else ", ").join(shown)
    return html.escape(str(value))
