#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs one test program under mpirun with 1, 2 and 4 ranks and compares what it prints.

    ranks.py TEST_PROGRAM TEST_NAMES

The tests, a filter of gtest, print lines `ranks NAME VALUE`; the tolerance 1e-9 is rounding of a direct solver.
"""

import os
import re
import subprocess
import sys

program, test = sys.argv[1:]
environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                   OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
found = {}
for ranks in (1, 2, 4):
    out = subprocess.run(["mpirun", "--oversubscribe", "-n", str(ranks), program, f"--gtest_filter={test}"],
                         env=environment, stdout=subprocess.PIPE, text=True, check=True).stdout
    values = dict(re.findall(r"ranks (\w+) (\S+)", out))
    if not values:
        sys.exit(f"{ranks} ranks: {test} printed nothing")
    found[ranks] = {name: float(value) for name, value in values.items()}
for ranks in (2, 4):
    for name, value in found[1].items():
        if not abs(found[ranks][name] - value) <= 1e-9 * abs(value):
            sys.exit(f"{name}: {value!r} with 1 rank, {found[ranks][name]!r} with {ranks}")
print(found)
