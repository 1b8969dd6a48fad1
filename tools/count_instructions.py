#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Holds the instructions of twelve kernels to the committed table, benchmarks/instructions.csv.

    tools/count_instructions.py KERNELS          compare; a change of more than 5 % fails
    tools/count_instructions.py KERNELS --renew  write the table

KERNELS is the program benchmarks/kernels.cpp of an optimised build.  A count is that of callgrind
(Debian's valgrind) for one call: the difference of two runs, so that the start of the program does
not count.  Unlike time, it does not depend on what else the machine does.  The mathematical library
is held to its oldest code, and the compiler stands in the table; another compiler is not compared.
"""
import csv
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
TABLE = ROOT / "benchmarks" / "instructions.csv"
MOST = 0.05
# Calls in the shorter run; the longer one has twice as many.
CALLS = {"torsion_curve": 2, "curve_of_200_points": 1, "all_elasticities": 20, "corrected_result": 20,
         "read_file": 20, "draw_by_tables": 1000}
USUAL = 50
PLAIN = ",".join(f"-{name}" for name in ("AVX_Usable", "AVX2_Usable", "AVX512F_Usable", "FMA_Usable",
                                         "FMA4_Usable"))


def instructions(kernels, name, count):
    run = subprocess.run(
        ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", kernels, name, str(count)],
        capture_output=True, text=True, check=False,
        env=dict(os.environ, GLIBC_TUNABLES=f"glibc.cpu.hwcaps={PLAIN}", OMP_NUM_THREADS="1"))
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not found:
        sys.exit(f"count_instructions: {name} failed: {run.stderr[-500:]}")
    return int(found[1])


def of_one_call(kernels, name):
    calls = CALLS.get(name, USUAL)
    return (instructions(kernels, name, 2 * calls) - instructions(kernels, name, calls)) / calls


def compiler_of(kernels):
    """The first compiler that the program names in its section .comment."""
    text = subprocess.run(["readelf", "-p", ".comment", kernels], capture_output=True, text=True,
                          check=True).stdout
    found = re.search(r"GCC: \(.*\) (\d+)\.|clang version (\d+)", text)
    return f"gcc {found[1]}" if found and found[1] else f"clang {found[2]}" if found else "unknown"


def main(arguments):
    if not arguments or len(arguments) > 2 or arguments[1:] not in ([], ["--renew"]):
        sys.exit(__doc__)
    kernels = arguments[0]
    names = subprocess.run([kernels, "--list"], capture_output=True, text=True,
                           check=True).stdout.split()
    compiler = compiler_of(kernels)
    if arguments[1:]:
        rows = [f"{name},{of_one_call(kernels, name):.0f}\n" for name in names]
        TABLE.write_text(f"kernel,instructions of one call by {compiler}\n" + "".join(rows))
        return
    with TABLE.open() as lines:
        head, *rows = csv.reader(lines)
    if not head[1].endswith(f"by {compiler}"):
        print(f"count_instructions: the table is for {head[1].split(' by ')[1]}; this program was "
              f"compiled by {compiler} and is not compared")
        return
    known = {name: float(count) for name, count in rows}
    if sorted(known) != sorted(names):
        sys.exit("count_instructions: the table has other kernels than the program; renew it with "
                 "--renew")
    faults = []
    for name in names:
        count = of_one_call(kernels, name)
        change = count / known[name] - 1
        print(f"{name:20} {count:12.0f} {100 * change:+6.1f} %")
        if abs(change) > MOST:
            faults.append(f"{name} takes {100 * change:+.1f} % instructions")
    if faults:
        sys.exit("count_instructions: " + "; ".join(faults) + ". If the change is meant, renew the "
                 "table with --renew, and say why in the commit")


if __name__ == "__main__":
    main(sys.argv[1:])
