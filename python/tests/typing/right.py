# SPDX-License-Identifier: Apache-2.0
"""Uses of the package that `mypy --strict` accepts."""

from typing import Optional

import numpy as np
import strainwave as sw
from strainwave.results.stiffness import StiffnessResult
from strainwave.results.torsion import TorsionResult

drive: sw.Drive = sw.read("drive.toml")
drive["output_shaft.crack[0].depth"] = "3 mm"
drive["output_shaft.crack[0].depth"] = 3e-3
drive.edit({"load.torque": sw.Quantity(5.0, "N*m"), "output_shaft.crack[0]": None})
answer: StiffnessResult = drive.stiffness(method="corrected", progress=True)
number: float = answer.intact.stiffness.value + 1
text: str = answer.verdict.reason
curve: TorsionResult = drive.torsion(compare=True, progress=lambda fraction: print(fraction))
array: np.ndarray = curve.curve.points.torque if curve.curve is not None else np.zeros(1)  # type: ignore[type-arg]
uncertainty: Optional[float] = answer.intact.stiffness.relative_uncertainty
rows = drive.batch({"load.torque": np.linspace(1, 2, 5)}, ["intact.stiffness"], threads=2)
total: float = float(rows["intact.stiffness"].sum())
started: sw.Drive = sw.new(size=25, ratio=100, form="cup")
steels: list[str] = list(sw.materials)
largest = sw.sif["plate-surface"](tension="100 MPa").largest
