#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the symbols that libstrainwave.so exports with tests/data/public_symbols.txt.

    tests/c_api/symbols.py LIBRARY             compare
    tests/c_api/symbols.py LIBRARY --renew     write the listing anew
"""

import pathlib
import subprocess
import sys

LISTING = pathlib.Path(__file__).resolve().parents[1] / "data" / "public_symbols.txt"


def exported(library):
    lines = subprocess.run(["nm", "-D", "--defined-only", library], check=True, text=True,
                           capture_output=True).stdout.splitlines()
    return "".join(sorted(line.split()[2] + "\n" for line in lines if line.split()[1] != "A"))


symbols = exported(sys.argv[1])
if "--renew" in sys.argv:
    LISTING.write_text(symbols)
elif symbols != LISTING.read_text():
    sys.exit("The library exports other symbols than tests/data/public_symbols.txt lists:\n" + symbols +
             "If this is meant, run tests/c_api/symbols.py LIBRARY --renew and name the change in CHANGELOG.md.")
