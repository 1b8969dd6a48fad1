# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""The classes of the results, one module for each command."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from . import (
        accuracy as accuracy,
        audit as audit,
        backbone as backbone,
        calibrate as calibrate,
        catalogue as catalogue,
        diff as diff,
        duty as duty,
        explain as explain,
        fit as fit,
        frf as frf,
        grow as grow,
        inspect as inspect,
        laminate as laminate,
        life as life,
        material_list as material_list,
        material_show as material_show,
        modes as modes,
        new as new,
        oval as oval,
        reliability as reliability,
        report as report,
        require as require,
        schema as schema,
        sensitivity as sensitivity,
        sif_eval as sif_eval,
        sif_list as sif_list,
        sif_plot as sif_plot,
        sif_show as sif_show,
        simulate as simulate,
        solve as solve,
        stiffness as stiffness,
        sweep as sweep,
        torsion as torsion,
        transmission as transmission,
        turn as turn,
        units as units,
        validate as validate,
    )
else:

    def __getattr__(name: str) -> Any:
        """Imports a module when its name is first used, such as by typing.get_type_hints."""
        try:
            return import_module(f"{__name__}.{name}")
        except ModuleNotFoundError:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}") from None
