# SPDX-License-Identifier: Apache-2.0
"""The libraries of steels and of stress intensity factors, as mappings."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Iterator, Mapping, Optional

from ._commands import material_list, material_show, sif_eval, sif_list, sif_show
from .parts import Quantity
from .errors import OptionError
from .running import spelled

if TYPE_CHECKING:
    from .results.material_show import MaterialShowResult
    from .results.sif_eval import SifEvalResult
    from .results.sif_show import SifShowResult


class Materials(Mapping[str, "MaterialShowResult"]):
    """The steels by their names.

    >>> materials["17-4PH H900"].material[0].density.value
    <Quantity 7800 kg/m^3>
    >>> "15-5PH H900" in materials
    True
    """

    def __getitem__(self, name: str) -> "MaterialShowResult":
        try:
            return material_show(name)
        except OptionError as error:
            raise KeyError(str(error)) from None

    def __iter__(self) -> Iterator[str]:
        return iter([steel.name for steel in material_list().material])

    def __len__(self) -> int:
        return len(material_list().material)


class Solution:
    """One solution of the library of stress intensity factors.

    Called with its fields and loads, it gives the stress intensity factors:

    >>> solution = sif["tube-through-inclined"]
    >>> [field.name for field in solution.show().fields][:2]
    ['half_length', 'angle']
    >>> solution(half_length="4 mm", torque="100 N*m").largest.K_I
    <Quantity 1.41689e+06 Pa*m^0.5>
    """

    def __init__(self, name: str) -> None:
        self._name = name

    @property
    def name(self) -> str:
        """Name of the solution."""
        return self._name

    def show(self) -> "SifShowResult":
        """Fields, loads, equation, source and accuracy of the solution."""
        return sif_show(self._name)

    def __call__(self, *, material: Optional[str] = None, **fields: Any) -> "SifEvalResult":
        """Evaluates the solution.

        Args:
            material: steel of the library; if left out, E = 210 GPa and nu = 0.3
            fields: fields and loads; text with a unit, a quantity, or a number in the SI unit

        Raises:
            InputError: if a field is missing, unknown or breaks a rule
        """
        shown = self.show()
        units = {field.name: field.unit for field in shown.fields}
        units.update({load.name: load.unit for load in shown.loads})
        given = []
        for name, value in fields.items():
            if isinstance(value, (int, float)) and not isinstance(value, bool):
                value = Quantity(value, units.get(name, "1"))
            given.append(f"{name}={spelled(value) if isinstance(value, Quantity) else value}")
        return sif_eval(self._name, set=given, material=material)

    def __repr__(self) -> str:
        return f"<Solution {self._name}>"


class Solutions(Mapping[str, Solution]):
    """The solutions by their names.

    >>> sif["tube-through-inclined"]
    <Solution tube-through-inclined>
    """

    def __getitem__(self, name: str) -> Solution:
        try:
            sif_show(name)
        except OptionError as error:
            raise KeyError(str(error)) from None
        return Solution(name)

    def __iter__(self) -> Iterator[str]:
        return iter([solution.name for solution in sif_list().solutions])

    def __len__(self) -> int:
        return len(sif_list().solutions)


materials = Materials()
sif = Solutions()
