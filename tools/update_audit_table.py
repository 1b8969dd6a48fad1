#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Puts the table of `strainwave audit --format markdown` into docs/theory/90_audit.md.

    tools/update_audit_table.py [--program FILE]           write it between the two markers
    tools/update_audit_table.py [--program FILE] --check   fail if the manual has another table

The program is build/release/apps/cli/strainwave unless given.  Exit status 0 equal or written,
1 different, 2 no program or no markers.
"""

import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
CHAPTER = ROOT / "docs/theory/90_audit.md"
BEGIN, END = "<!-- audit table: begin -->", "<!-- audit table: end -->"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/apps/cli/strainwave")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()

    text = CHAPTER.read_text()
    if text.count(BEGIN) != 1 or text.count(END) != 1 or text.index(BEGIN) > text.index(END):
        print(f"{CHAPTER}: the markers {BEGIN} and {END} must be there once each, in this order")
        return 2
    try:
        audit = subprocess.run([arguments.program, "audit", "--format", "markdown"], check=True,
                               stdout=subprocess.PIPE, text=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        print(f"{arguments.program}: {error}; build strainwave_cli first, or give --program")
        return 2

    updated = f"{text.partition(BEGIN)[0]}{BEGIN}\n\n{audit.strip()}\n\n{END}{text.partition(END)[2]}"
    if updated == text:
        print("audit table: up to date")
        return 0
    if arguments.check:
        print(f"{CHAPTER}: the audit table is not that of {arguments.program}; run tools/update_audit_table.py")
        return 1
    CHAPTER.write_text(updated)
    print(f"audit table: written to {CHAPTER}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
