#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Holds what is public to what it was: tests/released has a folder for each version or date.

    tests/structure/released.py PROGRAM                compare; PROGRAM is the command line
    tests/structure/released.py --list                 the names of the Python package, as a record keeps them
    tests/structure/released.py --self-test PROGRAM    break each rule once

Every drive of a record must still be read.  A line of a listing that is no longer there must be in a list
"### Removed" of CHANGELOG.md, in backticks.
"""

import inspect
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
RELEASED = ROOT / "tests" / "released"
LISTINGS = ("public_surface.txt", "public_surface_fe.txt", "public_symbols.txt", "note_codes.txt")
READ = (0, 4)  # exit status of a drive that was read: an answer, or one that must not be used


def python_names():
    """`strainwave.__all__` and the public members of its classes."""
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(ROOT / "python"))
    import strainwave as sw

    names = []
    for name in sw.__all__:
        names.append(name)
        value = getattr(sw, name)
        if inspect.isclass(value):
            names += [f"{name}.{member}" for member in dir(value) if not member.startswith("_")]
    return sorted(names)


def entries(text):
    """What a listing lists: a line with the headings above it."""
    found, command = set(), ""
    for line in text.splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        if line.startswith(" "):
            found.add(f"{command}: {line.strip()}")
        else:
            command = line.split(" | ")[0].strip()
            found.add(command)
    return found


def removed(changelog):
    """The words in backticks below the headings `### Removed`."""
    parts = re.findall(r"^### Removed\n(.*?)(?=^##|\Z)", changelog, re.M | re.S)
    return {word for part in parts for word in re.findall(r"`([^`]+)`", part)}


def faults_of(record, current, changelog):
    """Entries of a record that are neither in the present listing nor named as removed."""
    gone = removed(changelog)
    return [f"{entry}: is no longer there, and CHANGELOG.md does not list it as removed"
            for entry in sorted(entries(record) - entries(current)) if entry not in gone]


def unread(program, folder):
    """Drives of a record that are not read any more."""
    for drive in sorted(folder.glob("*.toml")):
        ended = subprocess.run([program, "stiffness", drive], capture_output=True, text=True, check=False)
        if ended.returncode not in READ:
            yield f"{drive}: {ended.stderr.strip()}"


def check(program):
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    faults, drives, lines = [], 0, 0
    for folder in sorted(RELEASED.iterdir()):
        faults += unread(program, folder)
        drives += len(list(folder.glob("*.toml")))
        for name in LISTINGS:
            if (folder / name).exists():
                record = (folder / name).read_text(encoding="utf-8")
                lines += len(entries(record))
                present = (ROOT / "tests" / "data" / name).read_text(encoding="utf-8")
                faults += faults_of(record, present, changelog)
        if (folder / "python_names.txt").exists():
            record = (folder / "python_names.txt").read_text(encoding="utf-8")
            faults += faults_of(record, "\n".join(python_names()), changelog)
    print("\n".join(faults) if faults else
          f"released: {drives} drives are read, {lines} entries are kept or named as removed")
    return len(faults) + (drives == 0) + (lines == 0)


def self_test(program):
    record = ("# comment\nstiffness of a drive\n  option method: a|b\n  result torque: number [N*m]\n"
              "sw_read\ncrack.closed | note | 1\n")
    same = record.replace("sw_read\n", "").replace("number [N*m]", "number [N*m]\n  result new: flag")
    log = "## Unreleased\n\n### Removed\n\n- `sw_read` is gone.\n\n### Fixed\n\n- `stiffness of a drive: option method: a|b`\n"
    trials = [
        ("nothing", record, "", 0),
        ("an added field and a removal that is named", same, log, 0),
        ("a removal that is not named", same, log.replace("sw_read", "sw_other"), 1),
        ("a removal that is named as a fix", record.replace("  option method: a|b\n", ""), log, 1),
        ("a changed unit", record.replace("[N*m]", "[J]"), log, 1),
        ("a code of a note", record.replace("crack.closed", "crack.shut"), log, 1),
    ]
    unseen = [name for name, current, changelog, wanted in trials
              if len(faults_of(record, current, changelog)) != wanted]
    with tempfile.TemporaryDirectory() as folder:
        drive = (RELEASED / "0.1.0" / "article.toml").read_text(encoding="utf-8")
        pathlib.Path(folder, "good.toml").write_text(drive, encoding="utf-8")
        pathlib.Path(folder, "bad.toml").write_text(drive + "\nunknown = 1\n", encoding="utf-8")
        refused = [fault.split(":")[0].rpartition("/")[2] for fault in unread(program, pathlib.Path(folder))]
        if refused != ["bad.toml"]:
            unseen.append("a drive that is refused")
    for name in unseen:
        print(f"{name}: was not noticed, or without reason")
    return len(unseen)


if sys.argv[1:] == ["--list"]:
    print("\n".join(python_names()))
elif len(sys.argv) == 3 and sys.argv[1] == "--self-test":
    sys.exit(1 if self_test(sys.argv[2]) else 0)
elif len(sys.argv) == 2 and not sys.argv[1].startswith("-"):
    sys.exit(1 if check(sys.argv[1]) else 0)
else:
    sys.exit(__doc__)
