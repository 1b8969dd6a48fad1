# SPDX-License-Identifier: Apache-2.0
"""Running commands: options, the texts that they name, and progress."""

from __future__ import annotations

import importlib
import json
import os
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Mapping, Optional, Union

import numpy as np

from . import _library
from .errors import OptionError
from .parts import Quantity

if TYPE_CHECKING:
    import strainwave

    from .drive import Drive

#: An option that is text; a path is read, a drive is handed over, a quantity is spelled.
Named = Union[str, os.PathLike[str], Quantity, "strainwave.Drive"]
#: True for a line of progress on standard error, or a function that receives the completed
#: fraction, 0 to 1.
ShownProgress = Union[bool, _library.Progress, None]

BAR_WIDTH = 40  # characters


def spelled(value: Union[Quantity, float]) -> str:
    """A quantity as the files of drives spell it, with all digits: "0.002 m"."""
    if not isinstance(value, Quantity):
        return repr(float(value))
    digits = repr(value.value)
    return digits if value.unit in ("1", "") else f"{digits} {value.unit}"


def shown_progress(progress: ShownProgress) -> Optional[_library.Progress]:
    """The function that receives the completed fraction."""
    if progress is None or progress is False:
        return None
    if progress is True:
        return _Bar()
    return progress


class _Bar:
    """A line of progress, written only if its text changes: a long batch reports many thousand
    times."""

    def __init__(self) -> None:
        self._shown = ""

    def __call__(self, fraction: float) -> None:
        done = round(BAR_WIDTH * fraction)
        line = f"\r[{'#' * done}{'.' * (BAR_WIDTH - done)}] {100 * fraction:5.1f} %"
        if fraction >= 1:
            line += "\n"
        if line != self._shown:
            self._shown = line
            sys.stderr.write(line)
            sys.stderr.flush()


def _option(value: Any, texts: dict[str, str]) -> Any:
    """An option as JSON takes it.  A file or a drive that it names is added to the texts."""
    from .drive import Drive

    if isinstance(value, Drive):
        name = value.name
        while texts.setdefault(name, value.text) != value.text:
            name += "'"
        return name
    if isinstance(value, Quantity):
        return spelled(value)
    if isinstance(value, os.PathLike):
        name = os.fspath(value)
        texts[name] = Path(name).read_bytes().decode("utf-8", "surrogateescape")
        return name
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, (list, tuple)):
        return [_option(one, texts) for one in value]
    return value


def run(drive: Optional["Drive"], command: str, options: Mapping[str, Any],
        texts: Optional[Mapping[str, str]], progress: ShownProgress) -> Any:
    """Runs a command.

    Args:
        drive: None for a command without a drive
        command: name of the command, such as "sif eval"
        options: by their names; None leaves an option at its default

    Returns:
        the result, an object of the class in `strainwave.results`
    """
    attached = dict(texts or {})
    given = {name: _option(value, attached) for name, value in options.items() if value is not None}
    try:
        document = json.dumps(given, allow_nan=False)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{command}: an option must be text, a finite number, a truth value or a "
                        f"list of texts: {error}") from None
    call = Call(None if drive is None else drive.copy(), command, document, attached, tuple(options))
    word = command.replace(" ", "_")
    module = importlib.import_module(f"{__package__}.results.{word}")
    kind = getattr(module, "".join(part.capitalize() for part in command.split()) + "Result")
    try:
        answer = call(shown_progress(progress))
    except OptionError as error:
        raise _with_a_way_out(error) from None
    return kind._from(answer, call)


def _with_a_way_out(error: OptionError) -> OptionError:
    """The error; of a text that was not given, with what Python's caller can do."""
    said = str(error)
    if not said.endswith(("names a text that is not attached", "the text of this file is missing")):
        return error
    return OptionError(f"{said}; give a pathlib.Path, whose file is read, or the text itself in "
                       "texts={NAME: TEXT}", path=error.path, value=error.value, rule=error.rule)


@dataclass(frozen=True)
class Call:
    """A command with its input, which can be run again: a result that was pickled or copied makes
    its documents so."""

    drive: Optional["Drive"]
    command: str
    options: str  #: JSON
    texts: Mapping[str, str]
    names: tuple[str, ...] = ()  #: of all options of the command

    def __call__(self, progress: Optional[_library.Progress] = None) -> _library.Handle:
        handle = None if self.drive is None else self.drive._handle
        return _library.run(handle, self.command, self.options, self.texts, progress, self.names)
