#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the sources and tests name the tagged equations of docs/theory.

    tools/check_equations.py [--root DIRECTORY]   check a tree (default: this one)
    tools/check_equations.py --write FILE         write the table equation, source, tests
    tools/check_equations.py --self-test          break every rule once in a scratch tree

An equation is a heading "### (FR-9) Shell correction {#FR-9}" and, below it, "**Status:** implemented" or
"**Status:** context only".  Code names it in a comment, (FR-9) or (FR-8, FR-9).  A string "FR-9" in the
code must name an equation, but does not count as its implementation.  Tests may also name it without
parentheses or in a string.

The table is not committed: it depends on every source and test that names a tag, so a copy in the
tree would conflict in every merge.  tools/render_manual writes it fresh into the manual.
"""

import argparse
import pathlib
import re
import sys
import tempfile

TAG = r"[A-Z]{2}-\d+"
EQUATION = re.compile(rf"^#+ \(({TAG})\) (.*) \{{#\1\}}\n+\*\*Status:\*\* (implemented|context only)\b", re.M)
GROUP = re.compile(rf"\(({TAG}(?:, {TAG})*)\)")  # (FR-8, FR-9)
QUOTED = re.compile(rf'"({TAG})"')
BARE = re.compile(rf"(?<!table )\b({TAG})\b")
TEST = re.compile(r"^TEST\w*\((\w+), (\w+)\)")


def grouped(text):
    return [tag for group in GROUP.findall(text) for tag in group.split(", ")]


def lines(root, *folders):
    for path in sorted(path for folder in folders for path in (root / folder).rglob("*.[ch]pp")):
        for number, line in enumerate(path.read_text(errors="replace").split("\n"), 1):
            yield path.relative_to(root).as_posix(), number, line


def check(root):
    """The faults, and {tag: (title, places in the code, tests)}."""
    faults, equations, implemented = [], {}, set()

    def name(tags, place, kind=0, entry=None):
        for tag in sorted(tags):
            if tag not in equations:
                faults.append(f"{place}: {tag} is no equation of docs/theory (heading, anchor, status)")
            elif kind and entry not in equations[tag][kind]:
                equations[tag][kind].append(entry)

    manual = {path.name: path.read_text() for path in sorted((root / "docs/theory").glob("*.md"))}
    for file, (tag, title, status) in [(file, e) for file, text in manual.items() for e in EQUATION.findall(text)]:
        faults += [f"{file}: {tag} is there twice"] if tag in equations else []
        equations[tag] = title, [], []
        implemented |= {tag} if status == "implemented" else set()
    for file, text in manual.items():
        name(grouped(text), file)
    for path, number, line in lines(root, "src", "include"):
        name(grouped(line.partition("//")[2]), f"{path}:{number}", 1, f"{path}:{number}")
        name(QUOTED.findall(line), f"{path}:{number}")
    test = {}
    for path, number, line in lines(root, "tests"):
        test[path] = ".".join(TEST.match(line).groups()) if TEST.match(line) else test.get(path, path)
        inside = line.startswith((" ", "TEST"))  # else above a test, or for the whole file
        name({*grouped(line), *QUOTED.findall(line), *BARE.findall(line.partition("//")[2])},
             f"{path}:{number}", 2, test[path] if inside else path)
    for tag, (_, *cells) in equations.items():
        faults += [f"{tag} is implemented, but no {what} names it" for cell, what in
                   zip(cells, ("comment of the code", "test")) if tag in implemented and not cell]
    return faults if equations else ["docs/theory: no equation found"], equations


def table(equations):
    def cell(entries):
        return "<br>".join(f"`{re.sub('^(src|include/strainwave|tests)/', '', entry)}`" for entry in entries) or "—"
    return ("# Traceability {#traceability}\n\nWhere each equation stands in the sources, and the tests that name it.\n\n"
            "| equation | source | tests |\n|---|---|---|\n" + "".join(
                f"| ({tag}) {title} | {cell(code)} | {cell(tests)} |\n" for tag, (title, code, tests) in equations.items()))


SOUND = {"docs/theory/FR.md": "### (FR-1) One {#FR-1}\n\n**Status:** implemented. From (FR-2).\n\n"
                              "### (FR-2) Two {#FR-2}\n\n**Status:** context only.\n",
         "src/a.cpp": 'f();  // (FR-1)\nuse("FR-2");\n', "tests/a_test.cpp": "// FR-1; table FR-7\nTEST(A, B) {}\n"}
BROKEN = [  # a file that breaks a rule, its text, and the beginning of the fault
    ("src/b.cpp", "/// (FR-1, FR-3)\n", "src/b.cpp:1: FR-3 is no equation"),
    ("include/b.hpp", 'use("FR-3");\n', "include/b.hpp:1: FR-3 is no equation"),
    ("tests/b_test.cpp", "  // as FR-3 says\n", "tests/b_test.cpp:1: FR-3 is no equation"),
    ("src/a.cpp", 'use("FR-1");\n', "FR-1 is implemented, but no comment"),
    ("tests/a_test.cpp", "// table FR-1\n", "FR-1 is implemented, but no test"),
    ("docs/theory/ST.md", SOUND["docs/theory/FR.md"], "ST.md: FR-1 is there twice"),
    ("docs/theory/ST.md", "### (ST-1) S {#ST-2}\n\n**Status:** context only\n", "ST.md: ST-1 is no equation"),
    ("docs/theory/ST.md", "### (ST-1) S {#ST-1}\n\nNo status.\n", "ST.md: ST-1 is no equation"),
    ("docs/theory/ST.md", "By (ST-9).\n", "ST.md: ST-9 is no equation"),
    ("docs/theory/FR.md", "", "docs/theory: no equation found")]


def self_test():
    for path, text, fault in [("src/a.cpp", SOUND["src/a.cpp"], None), *BROKEN]:
        with tempfile.TemporaryDirectory() as scratch:
            for name, content in {**SOUND, path: text}.items():
                (pathlib.Path(scratch) / name).parent.mkdir(parents=True, exist_ok=True)
                (pathlib.Path(scratch) / name).write_text(content)
            found = check(pathlib.Path(scratch))[0]
        if not any(f.startswith(fault) for f in found) if fault else found:
            yield f"broken by {path}: {text!r}; expected: {fault}; reported: {found}"


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[1])
    parser.add_argument("--write", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    result, found_equations = (list(self_test()), {}) if arguments.self_test else check(arguments.root)
    if arguments.write:
        arguments.write.write_text(table(found_equations))
    else:
        print("\n".join(result) or "equations: no fault")
        sys.exit(1 if result else 0)
