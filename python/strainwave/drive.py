# SPDX-License-Identifier: Apache-2.0
"""A drive: the text of its file, which can be read, changed and evaluated."""

from __future__ import annotations

import html
import json
import re
from pathlib import Path
from typing import Any, Literal, Mapping, Optional, Sequence, Union

import numpy as np

from . import _library
from ._commands import DriveCommands
from ._commands import new as _new
from ._units import unit_of
from .batch import BatchResult, batch
from .errors import InputError
from .parts import Quantity
from .running import ShownProgress, run, spelled

#: A value of a field: text with a unit ("3 mm"), a quantity, or a bare number, which is in the SI
#: unit of the field; whole numbers, truth values, lists and tables; None removes the field.
FieldValue = Union[str, float, int, bool, Quantity, Sequence[Any], Mapping[str, Any], None]

_NUMBER = re.compile(r"^([-+]?(?:[0-9.]+(?:[eE][-+]?[0-9]+)?|inf|nan)) (\S.*)$")


def _toml(value: Any, path: str) -> str:
    """A value as TOML."""
    if isinstance(value, Quantity):
        return _toml(spelled(value), path) if value.unit not in ("1", "") else spelled(value)
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (int, float)):
        unit = unit_of(path)
        return repr(value) if unit == "1" else json.dumps(f"{value!r} {unit}", ensure_ascii=False)
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, Mapping):
        # An empty list in `fields` is a list that the drive leaves out.
        inner = (f"{_key(name)} = {_toml(one, f'{path}.{name}')}" for name, one in value.items()
                 if not (isinstance(one, (list, tuple)) and len(one) == 0))
        return "{" + ", ".join(inner) + "}"
    if isinstance(value, (list, tuple, np.ndarray)):
        return "[" + ", ".join(_toml(one, path) for one in value) + "]"
    raise TypeError(f"{path}: a field takes text, a number, a quantity, a list or a table, not "
                    f"{type(value).__name__}")


def _text(value: str) -> str:
    """A text as TOML, which wants one more character escaped than JSON."""
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _key(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name) else _text(name)


def _value(given: Any, path: str) -> Any:
    """A value of the library's JSON: text in the SI unit of the field becomes a Quantity."""
    if isinstance(given, str):
        match = _NUMBER.match(given)
        if match and match.group(2) == unit_of(path):
            return Quantity(float(match.group(1)), match.group(2))
        return given
    if isinstance(given, list):
        return [_value(one, path) for one in given]
    if isinstance(given, dict):
        return {name: _value(one, f"{path}.{_key(name)}" if path else name)
                for name, one in given.items()}
    return given


def _steps(path: str) -> list[Union[str, int]]:
    """A path in its steps: names and indices."""
    steps: list[Union[str, int]] = []
    for quoted, name, index in re.findall(r'"([^"]*)"|([^.\[\]"]+)|\[(\d+)\]', path):
        steps.append(int(index) if index else quoted or name)
    return steps


class Drive(DriveCommands):
    """A strain wave gear, as its file describes it.

    A drive is a value: drives with the same text and the same attached tables are equal, whatever
    their names, and a copy is independent.  A field is read and set by its path:

    >>> drive = read("cracked_size25.toml")
    >>> drive["output_shaft.crack[0].depth"]
    <Quantity 0.002 m>
    >>> drive["output_shaft.crack[0].depth"] = "3 mm"
    >>> drive["output_shaft.crack[0].depth"] = 3e-3  # a bare number is in the SI unit
    >>> del drive["output_shaft.crack[0]"]
    >>> drive == read("cracked_size25.toml")
    False

    Each change is checked at once.  If it breaks a rule, the drive stays as it was.

    Args:
        text: TOML
        name: name of the text in messages
        tables: texts that the drive names, such as compliance tables, by their names

    Raises:
        InputError: if the text breaks a rule
    """

    def __init__(self, text: str, name: str = "drive.toml",
                 tables: Optional[Mapping[str, str]] = None) -> None:
        self._folder: Optional[Path] = None  # where tables are found that the text newly names
        self._read_text(text, name, dict(tables or {}))

    @classmethod
    def _read(cls, path: Path) -> "Drive":
        with path.open("rb") as file:
            content = file.read(_MOST + 1)  # the library refuses what is longer
        made = cls.__new__(cls)
        made._folder = path.parent
        made._read_text(content.decode("utf-8", "surrogateescape"), str(path), {})
        return made

    def _read_text(self, text: str, name: str, tables: Mapping[str, str]) -> None:
        """Takes a text, if it is a drive."""
        def find(wanted: str) -> Optional[bytes]:
            if wanted in tables:
                return tables[wanted].encode("utf-8", "surrogateescape")
            file = self._folder / wanted if self._folder is not None else None
            return file.read_bytes() if file is not None and file.is_file() else None

        self._handle, self._tables = _library.read_drive(text, name, find)
        self._text, self._name = text, name

    @property
    def text(self) -> str:
        """The text of the file, with its comments."""
        return self._text

    @property
    def name(self) -> str:
        """Name of the text in messages."""
        return self._name

    @property
    def tables(self) -> dict[str, str]:
        """The texts that the drive names, by their names."""
        return dict(self._tables)

    def fields(self) -> dict[str, Any]:
        """All fields as nested dicts, with those at a fixed default; numbers with a unit are
        quantities.

        >>> read("cracked_size25.toml").fields()["drive"]["ratio"]
        100
        """
        given: dict[str, Any] = _value(_library.drive_fields(self._handle), "")
        return given

    def __getitem__(self, path: str) -> Any:
        """A field, a crack or a section by its path.

        Raises:
            KeyError: if the drive has no such field
        """
        if not isinstance(path, str):
            raise TypeError("the path of a field is text, such as \"load.torque\", not "
                            f"{type(path).__name__}")
        at: Any = _library.drive_fields(self._handle)
        for step in _steps(path) or [path]:
            try:
                at = at[step]
            except (KeyError, IndexError, TypeError):
                raise KeyError(f"{path}: {self._name} does not give this field; explain({path!r}) "
                               "says what it is") from None
        return _value(at, path)

    def __contains__(self, path: str) -> bool:
        try:
            self[path]
        except KeyError:
            return False
        return True

    def __setitem__(self, path: str, value: FieldValue) -> None:
        """Sets a field, a crack or a section; a bare number is in the SI unit of the field.

        Raises:
            InputError: if the path does not exist, or the drive would break a rule; the drive stays
                as it was
        """
        self.edit({path: value})

    def __delitem__(self, path: str) -> None:
        self.edit({path: None})

    def edit(self, changes: Mapping[str, FieldValue]) -> None:
        """Makes several changes at once, checked together.

        >>> drive = read("cracked_size25.toml")
        >>> drive.edit({"load.torque": "60 N*m", "drive.ratio": 80, "output_shaft.crack[0]": None})
        >>> drive["load.torque"], drive["output_shaft.crack"]
        (<Quantity 60 N*m>, [])

        Args:
            changes: values by paths; None removes what is there; "[+]" in a path adds an element

        Raises:
            InputError: if a path does not exist, or the drive would break a rule; the drive stays
                as it was
        """
        text = self._text
        for path, value in changes.items():
            text = _library.edit(text, path, None if value is None else _toml(value, path))
        self._read_text(text, self._name, self._tables)

    @property
    def cracks(self) -> "Cracks":
        """The cracks of all members."""
        return Cracks(self)

    def batch(self, values: Mapping[str, Any], outputs: Sequence[str], *, method: str = "corrected",
              threads: int = 0, out: Any = None, progress: ShownProgress = None) -> BatchResult:
        """Evaluates the stiffness for many values of some fields.

        >>> drive = read("cracked_size25.toml")
        >>> answer = drive.batch({"output_shaft.crack[0].depth": [0.001, 0.002]},
        ...                      ["cracked.positive.stiffness"])
        >>> bool(answer["cracked.positive.stiffness"][1] < answer["cracked.positive.stiffness"][0])
        True

        Args:
            values: arrays by the paths of fields [SI unit of the field]; they are broadcast together
            outputs: names of q outputs, such as "cracked.positive.stiffness"
            method: "as-printed", "repaired" or "corrected"
            threads: 1 to 256; 0: as many as the machine has
            out: array for the numbers, shape (q,) + broadcast shape, float64; None: a new one
            progress: True for a line of progress, or a function that receives the completed fraction

        Raises:
            InputError: if a field or an output does not exist, or if a value is masked or is not a number
        """
        return batch(self, values, outputs, method=method, threads=threads, out=out,
                     progress=progress)

    def save(self, path: _library.PathLike) -> None:
        """Writes the text into a file; the tables that it names are not written.

        >>> import os, tempfile
        >>> drive = read("cracked_size25.toml")
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     drive.save(os.path.join(folder, "drive.toml"))
        ...     read(os.path.join(folder, "drive.toml")).text == drive.text
        True
        """
        Path(path).write_bytes(self._text.encode("utf-8", "surrogateescape"))

    def _run(self, command: str, options: Mapping[str, Any], texts: Optional[Mapping[str, str]],
             progress: ShownProgress) -> Any:
        return run(self, command, options, texts, progress)

    def _key(self) -> tuple[Any, ...]:
        return (self._text, tuple(sorted(self._tables.items())))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Drive) and self._key() == other._key()

    def __hash__(self) -> int:
        """Follows the present text: do not change a drive while it is a key of a dict."""
        return hash(self._key())

    def copy(self) -> "Drive":
        """An independent copy.

        >>> drive = new(size=25, ratio=100)
        >>> other = drive.copy()
        >>> other["load.torque"] = "60 N*m"
        >>> other == drive
        False
        """
        return self.__copy__()

    def __copy__(self) -> "Drive":
        made = Drive.__new__(Drive)
        made.__dict__.update(self.__dict__)  # text and handle never change, they are replaced
        return made

    def __deepcopy__(self, _memo: dict[int, Any]) -> "Drive":
        return self.__copy__()

    def __reduce__(self) -> tuple[Any, ...]:
        return (Drive, (self._text, self._name, self._tables))

    def __repr__(self) -> str:
        return f"<Drive {self._name}>"

    def _repr_html_(self) -> str:
        """The name, the cracks, and the text, which a notebook unfolds."""
        cracks = ", ".join(f"{crack.path} ({crack['kind']})" for crack in self.cracks) or "none"
        return (f"<p><strong>Drive {html.escape(self._name)}</strong>; cracks: {html.escape(cracks)}"
                f"</p><details><summary>text</summary><pre>{html.escape(self._text)}</pre></details>")


class Cracks(Sequence["Crack"]):
    """The cracks of a drive, member after member.

    >>> cracks = read("growing_shaft.toml").cracks
    >>> cracks
    <Cracks output_shaft.crack[0]>
    >>> [crack["kind"] for crack in cracks]
    ['annular']
    """

    def __init__(self, drive: Drive) -> None:
        self._drive = drive

    def _counts(self) -> dict[str, int]:
        """Number of cracks of each member that can have cracks."""
        fields = _library.drive_fields(self._drive._handle)
        return {name: len(member["crack"]) for name, member in fields.items()
                if isinstance(member, dict) and "crack" in member}

    def _tables(self, member: str) -> int:
        """Number of tables of a member's cracks in the text, in which no entry names a crack behind
        the tables; one table may give several cracks."""
        count = 0
        while True:
            try:
                _library.edit(self._drive.text, f"{member}.crack[{count}]", None)
            except InputError:
                return count
            count += 1

    def _paths(self) -> list[str]:
        return [f"{member}.crack[{index}]" for member, count in self._counts().items()
                for index in range(count)]

    def __len__(self) -> int:
        return len(self._paths())

    def __getitem__(self, index: Any) -> Any:
        paths = self._paths()[index]
        if isinstance(index, slice):
            return [Crack(self._drive, path) for path in paths]
        return Crack(self._drive, str(paths))

    def append(self, member: str, **fields: FieldValue) -> "Crack":
        """Adds a crack.

        >>> drive = read("cracked_size25.toml")
        >>> crack = drive.cracks.append("output_shaft", kind="annular", depth="1 mm")
        >>> crack
        <Crack output_shaft.crack[1]>
        >>> crack["depth"]
        <Quantity 0.001 m>

        Args:
            member: a member of the drive, such as "flexspline"
            fields: the fields of the crack

        Raises:
            InputError: if the drive has no such member, the member can have no crack, or the drive
                would break a rule; the drive stays as it was
        """
        if member not in self._counts():
            can = f"one of the members of this drive that can have cracks: {', '.join(self._counts())}"
            if member in _library.drive_fields(self._drive._handle):
                raise InputError(f"{member} can have no crack; name {can}", path=member)
            raise InputError(f"this drive has no [{member}]; give its fields first, by "
                             f'edit({{"{member}.FIELD": value, ...}}), or name {can}', path=member)
        self._drive.edit({f"{member}.crack[+]": fields})
        # The cracks of groups come behind all tables.
        return Crack(self._drive, f"{member}.crack[{self._tables(member) - 1}]")

    def clear(self) -> None:
        """Removes all cracks.

        >>> drive = read("cracked_size25.toml")
        >>> drive.cracks.clear()
        >>> len(drive.cracks)
        0
        """
        self._drive.edit({f"{member}.crack": None
                          for member, count in self._counts().items() if count > 0})

    def __repr__(self) -> str:
        return f"<Cracks {', '.join(self._paths()) or 'none'}>"


class Crack:
    """One crack of a drive, by its path.

    >>> crack = read("cracked_size25.toml").cracks[6]
    >>> crack.path
    'output_shaft.crack[0]'
    >>> crack["depth"] = "3 mm"
    >>> crack.fields()["depth"]
    <Quantity 0.003 m>
    """

    def __init__(self, drive: Drive, path: str) -> None:
        self._drive = drive
        self._path = path

    @property
    def path(self) -> str:
        """Path of the crack, such as "output_shaft.crack[0]"."""
        return self._path

    def fields(self) -> dict[str, Any]:
        """The fields of the crack."""
        given: dict[str, Any] = self._drive[self._path]
        return given

    def __getitem__(self, name: str) -> Any:
        return self._drive[f"{self._path}.{name}"]

    def __setitem__(self, name: str, value: FieldValue) -> None:
        self._drive[f"{self._path}.{name}"] = value

    def __repr__(self) -> str:
        return f"<Crack {self._path}>"


def read(path: _library.PathLike) -> Drive:
    """Reads a drive from its file, with the tables beside the file that it names.

    >>> read("cracked_size25.toml").name
    'cracked_size25.toml'

    Raises:
        OSError: if the file cannot be read
        InputError: if the file breaks a rule
    """
    return Drive._read(Path(path))


def parse(text: str, name: str = "drive.toml",
          tables: Optional[Mapping[str, str]] = None) -> Drive:
    """Reads a drive from TOML text; arguments as of Drive.

    >>> parse(new(size=25, ratio=100).text)["drive.ratio"]
    100
    """
    return Drive(text, name, tables)


def new(*, size: Optional[int] = None, ratio: Optional[float] = None,
        form: Optional[Literal["cup", "hat"]] = None,
        length: Optional[Literal["standard", "short", "flat"]] = None,
        blank: Optional[Literal["ratio", "size"]] = None) -> Drive:
    """A drive to start from: the commented example, or typical proportions of a size.

    >>> new(size=17, ratio=80)["drive.ratio"]
    80

    Args:
        size: size in the catalogue; None: the commented example
        ratio: ratio of the typical drive, 30 to 320
        form: flexspline of the typical drive: cup, or silk hat with the diaphragm outward
        length: length class of its flexspline
        blank: walls made for the wave of this ratio, or of ratio 100 for all ratios of a size

    Raises:
        OptionError: if no catalogue has the size
    """
    return Drive(_new(size=size, ratio=ratio, form=form, length=length, blank=blank).text)


_MOST = 1 << 20  # bytes of a drive
