#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Holds what is public to what it was: tests/released has a folder for each version or date.

    tests/structure/released.py PROGRAM                compare; PROGRAM is the command line
    tests/structure/released.py --list                 the names of the Python package, as a record keeps them
    tests/structure/released.py --fields PROGRAM       the fields of a drive, as a record keeps them
    tests/structure/released.py --self-test PROGRAM    break each rule once

The program must still read every drive of a record.  A list "### Removed" of CHANGELOG.md must name, in backticks,
each recorded line that the present listing lacks.  Beside a drive, a record may have a result, such as
article.stiffness.json; `strainwave diff` compares it with today's result for this drive.  The list "### Removed" must
also name each output that today's result lacks, and a list "### Numerical results that change" each output whose
number changes.
"""

import inspect
import json
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


def fields_of(schema, path=""):
    """The fields that a JSON Schema describes: paths with kind or unit, choices, and what may be left out."""
    for kind in schema.get("oneOf", []):  # of a crack or of a law of growth
        yield from fields_of(kind, f"{path}[{kind['properties']['kind']['const']}]")
    if isinstance(schema.get("additionalProperties"), dict):
        yield from fields_of(schema["additionalProperties"], f"{path}.NAME")
    for name, about in schema.get("properties", {}).items():
        at = f"{path}.{name}".lstrip(".")
        if name not in schema.get("required", []):
            yield f"{at} may be left out"
        while about.get("type") == "array":
            about, at = {**about["items"], "description": about.get("description", "")}, at + "[]"
        unit = re.search(r" \[([^][]+)\](?:;|$)", about.get("description", ""))
        choices = about.get("enum", [about["const"]] if "const" in about else [])
        yield from (f"{at} = {choice}" for choice in choices)
        if not choices and about.get("type") != "object" and "oneOf" not in about:
            yield f"{at}: {about['type']}" + (f" [{unit.group(1)}]" if unit else "")
        yield from fields_of(about, at)


def input_fields(program):
    """The fields of a drive, by the program's own description."""
    schema = subprocess.run([program, "schema"], capture_output=True, text=True, check=True).stdout
    return sorted(set(fields_of(json.loads(schema))))


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


def named(changelog, heading):
    """The words in backticks below a heading."""
    parts = re.findall(rf"^### {heading}\n(.*?)(?=^##|\Z)", changelog, re.M | re.S)
    return {word for part in parts for word in re.findall(r"`([^`]+)`", part)}


LOST = ("the program lacks this entry of the record; bring the entry back, or name it in a list \"### Removed\" of "
        "CHANGELOG.md")


def faults_of(record, current, changelog):
    """Entries of a record that are neither in the present listing nor named as removed."""
    gone = named(changelog, "Removed")
    return [f"{entry}: {LOST}"
            for entry in sorted(entries(record) - entries(current)) if entry not in gone]


def unread(program, folder):
    """Drives of a record that are not read any more."""
    for drive in sorted(folder.glob("*.toml")):
        ended = subprocess.run([program, "stiffness", drive], capture_output=True, text=True, check=False)
        if ended.returncode not in READ:
            yield f"{drive}: {ended.stderr.strip()}"


def changes_of(difference, changelog):
    """Outputs of a recorded result that are gone or changed, which the changelog does not name."""
    gone, changed = named(changelog, "Removed"), named(changelog, "Numerical results that change")
    for output in difference["only_first"]:
        if output not in gone:
            yield f"{output}: {LOST}"
    for part in ("stiffness", "outputs", "within_uncertainty", "uncertainty_not_stated"):
        for row in difference[part]:
            # The last digits may differ between processors.
            if abs(row["difference"]) > 1e-6 * abs(row["first"]) and row["output"] not in changed:
                yield (f"{row['output']}: is {row['second']} in place of {row['first']} {row['unit']}, and CHANGELOG.md "
                       "does not list it as changed")


def results_of(program, folder, changelog):
    """Faults of the results of a record against the results of today."""
    for record in sorted(folder.glob("*.json")):
        stem, command = record.stem.rsplit(".", 1)
        with tempfile.TemporaryDirectory() as place:
            today = pathlib.Path(place, "today.json")
            words = [[program, *command.split("_"), folder / f"{stem}.toml", "--format", "json", "-o", today],
                     [program, "diff", record, today, "--format", "json"]]
            for call, accepted in zip(words, (READ, (0,))):
                ended = subprocess.run(call, capture_output=True, text=True, check=False)
                if ended.returncode not in accepted:
                    yield f"{record}: {ended.stderr.strip()}"
                    break
            else:
                difference = json.loads(ended.stdout)["result"]
                yield from (f"{record}: {fault}" for fault in changes_of(difference, changelog))


def check(program):
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    faults, drives, lines, results = [], 0, 0, 0
    for folder in sorted(RELEASED.iterdir()):
        faults += unread(program, folder)
        drives += len(list(folder.glob("*.toml")))
        for name in LISTINGS:
            if (folder / name).exists():
                record = (folder / name).read_text(encoding="utf-8")
                lines += len(entries(record))
                present = (ROOT / "tests" / "data" / name).read_text(encoding="utf-8")
                faults += faults_of(record, present, changelog)
        for name, present in (("python_names.txt", python_names), ("input_fields.txt", lambda: input_fields(program))):
            if (folder / name).exists():
                record = (folder / name).read_text(encoding="utf-8")
                lines += len(entries(record))
                faults += faults_of(record, "\n".join(present()), changelog)
        faults += results_of(program, folder, changelog)
        results += len(list(folder.glob("*.json")))
    print("\n".join(faults) if faults else
          f"released: {drives} drives are read, {lines} entries and the outputs of {results} results are kept or named "
          "in the changelog")
    return len(faults) + (drives == 0) + (lines == 0) + (results == 0)


def unseen_changes(program):
    """Changes of fields and of results that are not noticed."""
    schema = {"properties": {"length": {"type": "string", "description": "length [m]; > 0"},
                             "crack": {"type": "array", "items": {"oneOf": [
                                 {"properties": {"kind": {"const": "ring"}, "depth": {"type": "number"}},
                                  "required": ["kind", "depth"]}]}}}, "required": ["length"]}
    wanted = ["crack may be left out", "crack[][ring].depth: number", "crack[][ring].kind = ring", "length: string [m]"]
    unseen = [] if sorted(fields_of(schema)) == wanted else ["the fields of a schema"]
    name = "intact.stiffness"
    number = "### Numerical results that change\n\n- `intact.stiffness`\n"
    drive = (RELEASED / "0.1.0" / "article.toml").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder, "article.toml")
        place.write_text(drive, encoding="utf-8")
        made = json.loads(subprocess.run([program, "stiffness", place, "--format", "json"], capture_output=True,
                                         text=True, check=True).stdout)
        stiffness = made["result"]["intact"]["stiffness"]
        for title, field, value, changelog, count in (
                ("the same result", "value", stiffness["value"], "", 0),
                ("other last digits", "value", stiffness["value"] * (1 + 1e-9), "", 0),
                ("a changed number", "value", 2 * stiffness["value"], "", 1),
                ("a changed number that is named", "value", 2 * stiffness["value"], number, 0),
                ("a changed number that is named as removed", "value", 2 * stiffness["value"],
                 number.replace("Numerical results that change", "Removed"), 1),
                ("another format", "format", "strainwave-result/0", "", 1)):
            changed = json.loads(json.dumps(made))
            target = changed["result"]["intact"]["stiffness"] if field == "value" else changed
            target[field] = value
            pathlib.Path(folder, "article.stiffness.json").write_text(json.dumps(changed), encoding="utf-8")
            faults = [one for one in results_of(program, pathlib.Path(folder), changelog)
                      if field == "format" or name in one]
            if len(faults) != count:
                unseen.append(f"{title} ({faults})")
        changed = json.loads(json.dumps(made))
        changed["result"]["intact"]["softness"] = stiffness
        pathlib.Path(folder, "article.stiffness.json").write_text(json.dumps(changed), encoding="utf-8")
        for changelog, count in (("", 1), ("### Removed\n\n- `intact.softness`\n", 0)):
            if len(list(results_of(program, pathlib.Path(folder), changelog))) != count:
                unseen.append("an output that is gone")
    return unseen


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
    unseen += unseen_changes(program)
    for name in unseen:
        print(f"{name}: was not noticed, or without reason")
    return len(unseen)


if sys.argv[1:] == ["--list"]:
    print("\n".join(python_names()))
elif len(sys.argv) == 3 and sys.argv[1] == "--fields":
    print("\n".join(input_fields(sys.argv[2])))
elif len(sys.argv) == 3 and sys.argv[1] == "--self-test":
    sys.exit(1 if self_test(sys.argv[2]) else 0)
elif len(sys.argv) == 2 and not sys.argv[1].startswith("-"):
    sys.exit(1 if check(sys.argv[1]) else 0)
else:
    sys.exit(__doc__)
