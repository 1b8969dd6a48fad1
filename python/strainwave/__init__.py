# SPDX-License-Identifier: Apache-2.0
"""Stiffness, damage, life and dynamics of strain wave gears with cracks.

>>> import strainwave as sw
>>> drive = sw.read("cracked_size25.toml")
>>> answer = drive.stiffness()
>>> answer.usable
True
>>> print(answer.cracked.positive.stiffness.unit, len(answer.notes) > 0)
N*m/rad True

`Drive` is a drive, its methods are the commands of the program `strainwave`, and the commands that
take no drive are functions of this module.  Numbers are in SI units.
"""

from __future__ import annotations

from . import _commands, _library
from ._commands import *  # noqa: F403
from ._evidence import Accuracy, Note, Verdict
from .answers import Result, Svg
from .batch import ROW_CODES, BatchResult, TableEvidence
from .drive import Crack, Cracks, Drive, new, parse, read
from .errors import Error, InputError, InternalError, NotUsable, OptionError, SolverError
from .parts import Part, Quantity
from .tables import materials, sif

__version__ = _library.version()

__all__ = [
    "Accuracy", "BatchResult", "Crack", "Cracks", "Drive", "Error", "InputError", "InternalError",
    "NotUsable", "Note", "OptionError", "Part", "Quantity", "ROW_CODES", "Result", "SolverError",
    "Svg", "TableEvidence",
    "Verdict", "__version__", "materials", "new", "parse", "read", "sif",
]
__all__ += [name for name in _commands.__all__ if name != "DriveCommands"]
