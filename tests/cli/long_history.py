# SPDX-License-Identifier: Apache-2.0
"""Limit: `duty --rainflow -` counts a history of any length in the memory of a short one.

One block of random torques follows on itself many times.  So the counts are known: those of the block,
with its open ranges repeated, times the number of blocks.  The environment variable STRAINWAVE_LONG
asks for a hundred million rows in place of two million.

usage: long_history.py PROGRAM
"""

import csv
import io
import os
import random
import resource
import subprocess
import sys

ROWS = 100_000  # of the block
MOST_MEMORY = 64 * 1024  # [KiB]; the program itself takes 9 MiB, and a sanitizer adds to it
HEAD = b"torque [N*m]\n"


def count(program, block, times):
    """(range, mean) -> cycles, and the largest memory of any child so far [KiB]"""
    run = subprocess.Popen(
        [program, "duty", "--rainflow", "-", "--residue", "repeated", "--format", "csv", "--quiet"],
        stdin=subprocess.PIPE, stdout=subprocess.PIPE)
    run.stdin.write(HEAD)
    for _ in range(times):
        run.stdin.write(block)
    run.stdin.close()
    rows = list(csv.reader(io.TextIOWrapper(run.stdout)))[1:]
    if run.wait() != 0:
        sys.exit(f"the program ends with exit code {run.returncode}")
    return {(row[0], row[1]): float(row[2]) for row in rows}, \
        resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss


def main():
    program = sys.argv[1]
    times = 1000 if os.environ.get("STRAINWAVE_LONG") else 20
    numbers = random.Random(15)
    # Few levels, so that the answer has few rows.
    block = b"".join(b"%d\n" % numbers.randint(-40, 40) for _ in range(ROWS))
    once, short = count(program, block, 1)
    many, memory = count(program, block, times)
    # Equal neighbours where two blocks meet are one reversal in both.
    if {key: cycles * times for key, cycles in once.items()} != many:
        wrong = {key for key in once.keys() | many.keys()
                 if once.get(key, 0) * times != many.get(key, 0)}
        sys.exit(f"{len(wrong)} of {len(once)} counts are not {times} times those of one block, "
                 f"such as {sorted(wrong)[:3]}")
    if memory > short + MOST_MEMORY:
        sys.exit(f"{times * ROWS} rows took {memory} KiB, one block {short} KiB")
    print(f"{times * ROWS} rows, {len(once)} ranges and means, {memory} KiB")


if __name__ == "__main__":
    main()
