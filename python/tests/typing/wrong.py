# SPDX-License-Identifier: Apache-2.0
"""Uses of the package that `mypy --strict` must refuse, each line that ends in `# wrong`."""

import strainwave as sw

drive = sw.read(3)  # wrong
drive = sw.read("drive.toml")
drive.stiffnes()  # wrong
drive.stiffness(method="best")  # wrong
drive.stiffness(methode="corrected")  # wrong
drive.stiffness("corrected")  # wrong
drive["load.torque"] = object()  # wrong
drive[3] = "3 mm"  # wrong
drive.grow(points="many")  # wrong
answer = drive.stiffness()
answer.cracked.positive.stifness  # wrong
answer.method = "repaired"  # wrong
text: str = answer.intact.stiffness  # wrong
number: int = answer.intact.stiffness.value  # wrong
drive.batch(["load.torque"], ["intact.stiffness"])  # wrong
sw.new(size="25")  # wrong
sw.sif_eval()  # wrong
sw.new(form="bell")  # wrong
