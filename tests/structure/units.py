#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that docstrings of free functions in the public headers of mechanics state units.

A function that returns a number states its unit in brackets, and so does the @param line of each
number that it takes, or the text above these lines if it is unambiguous.  An overload shares the
docstring of the preceding function of the same name.

    tests/structure/units.py               check the tree
    tests/structure/units.py --self-test   break each rule once
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODULES = ["contact", "drive_cracks", "fracture", "sif", "stiffness", "strength", "torsion"]
FUNCTION = re.compile(r"((?:^///.*\n)*)(?:^template <.*>\n)?^\[\[nodiscard\]\] ([^;{]*?)(\w+)\(", re.M)
STRUCT = re.compile(r"\b(?!optional|vector|span|array)\w+<[^<>]*>")  # the fields of a struct state their own units
NUMBER = re.compile(r"\b(?:double|Real|DualReal)\b")
UNIT = re.compile(r"\[[^\]]+\]")


def is_number(declared):
    return NUMBER.search(STRUCT.sub("", declared))


def parameters(text):
    """The parameters of a declaration; `text` begins after the parenthesis."""
    parts, depth = [""], 0
    for c in text:
        depth += (c in "(<{[") - (c in ")>}]")
        if depth < 0:
            return [part.split("=")[0].strip() for part in parts]
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    return []


def faults(text, where):
    found, documented = [], {}
    for match in FUNCTION.finditer(text):
        doc, returned, name = match.groups()
        doc = documented.setdefault(name, doc) if not UNIT.search(doc) else doc
        documented[name] = doc
        head, *lines = re.split(r"^/// @param\s+", doc, flags=re.M)
        stated = {line.split()[0]: line for line in lines}
        if is_number(returned) and not UNIT.search(re.sub(r"(?s)@param.*?(?=@return|\Z)", "", doc)):
            found.append(f"{where}: {name} does not state the unit of what it returns")
        for parameter in parameters(text[match.end():]):
            own = re.search(r"(\w+)$", parameter)
            if own and is_number(parameter[: own.start()]):
                if not UNIT.search(stated.get(own[1], "" if stated and is_number(returned) else head)):
                    found.append(f"{where}: {name} does not state the unit of {own[1]}")
    return found


def self_test():
    good = "/// Force [N].\n/// @param a  depth [m]\n[[nodiscard]] double f(double a, int n = g(1, 2));\n"
    assert not faults(good + "[[nodiscard]] DualReal f(const DualReal& a);\n", "")
    for broken, word in [(good.replace(" [N]", ""), "returns"), (good.replace(" [m]", ""), "of a"),
                         (good.replace("@param a", "@param b"), "of a")]:
        assert len(faults(broken, "")) == 1 and word in faults(broken, "")[0], broken


if "--self-test" in sys.argv:
    self_test()
else:
    headers = [path for module in MODULES for path in sorted((ROOT / "include/strainwave" / module).rglob("*.hpp"))]
    problems = [fault for path in headers for fault in faults(path.read_text(), path.relative_to(ROOT))]
    sys.exit("\n".join(problems) or (0 if headers else "no header is found"))
