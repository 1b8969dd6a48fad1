# SPDX-License-Identifier: Apache-2.0
"""What can go wrong, as exceptions."""

from __future__ import annotations


class Error(Exception):
    """Base of all exceptions of strainwave.

    str() gives one sentence that names the place, the value and the rule.
    """


class InputError(Error, ValueError):
    """A drive breaks a rule, or holds what the command cannot treat.

    >>> import strainwave as sw
    >>> drive = sw.read("cracked_size25.toml")
    >>> try:
    ...     drive["load.torque"] = "3 kg"
    ... except InputError as error:
    ...     print(error.path, error.value, error.line > 0)
    load.torque "3 kg" True

    Attributes:
        file: name of the text with the fault, such as "drive.toml"; empty if unknown
        line: line of the fault, counted from 1; 0 if unknown
        column: column of the fault, counted from 1; 0 if unknown
        path: field, such as "output_shaft.crack[0].depth"; empty if unknown
        value: the value, as it is written in the text, or with its unit
        rule: rule that the value breaks, such as "> 0"
    """

    def __init__(self, message: str, *, file: str = "", line: int = 0, column: int = 0,
                 path: str = "", value: str = "", rule: str = "") -> None:
        super().__init__(message)
        self.file = file
        self.line = line
        self.column = column
        self.path = path
        self.value = value
        self.rule = rule

    def __reduce__(self) -> tuple[object, ...]:
        return (_input_error, (type(self), str(self), self.__dict__))


def _input_error(kind: type[InputError], message: str, parts: dict[str, object]) -> InputError:
    error = kind(message)
    error.__dict__.update(parts)
    return error


class OptionError(InputError):
    """A command or an option cannot be understood; `path` is the name of the option."""


class SolverError(Error, RuntimeError):
    """The numerical method does not deliver an answer."""


class NotUsable(Error, RuntimeError):
    """A number was demanded from a result that must not be used."""


class InternalError(Error, RuntimeError):
    """A mistake of the library.  Please report it."""
