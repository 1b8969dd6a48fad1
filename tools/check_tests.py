#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the names of the tests state one of the kinds in CONTRIBUTING.md.

    tools/check_tests.py [--root DIRECTORY]   check a tree (default: this one)
    tools/check_tests.py --self-test          break every rule once in a scratch tree
"""

import argparse
import pathlib
import re
import sys

from scratch_tree import unseen_breaks

TABLE = re.compile(r"^\| kind \|.*\n\|[-|]+\|\n((?:\|.*\n)+)", re.M)
TEST = re.compile(r"^[ \t]*(?:TYPED_)?TEST(?:_[FP])?\s*\(\s*(\w+)\s*,\s*(\w+)\s*\)", re.M)
MACRO = re.compile(r"^[ \t]*(?:TYPED_)?TEST(?:_[FP])?\s*\(", re.M)


def check(root):
    table = TABLE.search((root / "CONTRIBUTING.md").read_text())
    kinds = re.findall(r"^\| `(\w+)` \|", table[1], re.M) if table else []
    if not kinds:
        return ["CONTRIBUTING.md: the table of kinds is not found"]
    faults, used = [], set()
    for path in sorted((root / "tests").rglob("*_test.cpp")):
        text, where = path.read_text(), path.relative_to(root)
        tests = TEST.findall(text)
        if len(tests) != len(MACRO.findall(text)):
            faults.append(f"{where}: a test has no name that can be read")
        if not tests:
            faults.append(f"{where}: holds no test")
        for suite, name in tests:
            kind = re.match(rf"({'|'.join(kinds)})(?=[A-Z0-9])", name)
            if kind:
                used.add(kind[1])
            else:
                faults.append(f"{where}: {suite}.{name} begins with none of the kinds {', '.join(kinds)}")
    return faults + [f"CONTRIBUTING.md: no test is of the kind {kind}" for kind in kinds if kind not in used]


SOUND = {
    "CONTRIBUTING.md": "| kind | compares with |\n|---|---|\n| `Limit` | a |\n| `Input` | b |\n\n| `Other` | c |\n",
    "tests/low/a_test.cpp": "TEST(A, LimitOfB) {}\nTYPED_TEST(A,\n           InputBroken) {}\n",
}
# The fault, the files that cause it, and a part of the sentence that must report it.
BROKEN = [
    ("no kind", {"tests/low/b_test.cpp": "TEST(A, ItWorks) {}\n"}, "A.ItWorks begins with none of the kinds Limit, Input"),
    ("a kind of another table", {"tests/low/b_test.cpp": "TEST_F(A, OtherThing) {}\n"}, "A.OtherThing begins"),
    ("a kind as a part of a word", {"tests/low/b_test.cpp": "TEST_P(A, Limitless) {}\n"}, "A.Limitless begins"),
    ("a kind alone", {"tests/low/b_test.cpp": "TEST(A, Limit) {}\n"}, "A.Limit begins"),
    ("a name made by a macro", {"tests/low/b_test.cpp": "TEST(A, LimitA) {}\nTEST(A, NAME(B)) {}\n"},
     "a test has no name that can be read"),
    ("a file without a test", {"tests/low/b_test.cpp": "// TEST(A, LimitB)\n"}, "holds no test"),
    ("a kind that no test is of", {"tests/low/a_test.cpp": "TEST(A, LimitOfB) {}\n"}, "no test is of the kind Input"),
    ("a table that cannot be read", {"CONTRIBUTING.md": ""}, "the table of kinds is not found"),
]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[1])
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    faults = unseen_breaks(SOUND, BROKEN, check) if arguments.self_test else check(arguments.root)
    print("\n".join(faults) or "tests: no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
