#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the sources keep to the module graph of CMakeLists.txt.

    tools/check_layers.py [--root DIRECTORY]   check a tree (default: this one)
    tools/check_layers.py --self-test          break every rule once in a scratch tree

The linker alone would not notice a forbidden include of a header-only part.
"""

import argparse
import pathlib
import re
import sys

from scratch_tree import unseen_breaks

MODULE = re.compile(r"^ *strainwave_module\(\s*(\w+)\s+SOURCES\s+([^)]*?)"
                    r"(?:\sDEPENDS\s+([^)]*?))?(?:\s+NOT_INSTALLED)?\s*\)", re.M)
TEST = re.compile(r"^\s*strainwave_test\(\s*(\w+)\s+SOURCES\s+([^)]*?)\sDEPENDS\s+([^)]*)\)", re.M)
INCLUDE = re.compile(r"^\s*#\s*(?:include|import|include_next)\b\s*(.*)", re.M)
FOLDERS = ("include", "src", "apps", "tests", "benchmarks")


def read_graph(root):
    """{module: modules it may include}, {module: its sources} and the faults of the lists."""
    depends, sources, faults = {}, {}, []
    for name, source_list, depend_list in MODULE.findall((root / "CMakeLists.txt").read_text()):
        if name in depends:
            faults.append(f"CMakeLists.txt: module {name} is declared twice")
        for other in depend_list.split():
            if other not in depends:
                faults.append(f"CMakeLists.txt: {name} depends on {other}, which is not declared above it")
        depends[name] = set(depend_list.split())
        sources[name] = source_list.split()
    if not depends:
        faults.append("CMakeLists.txt: no strainwave_module(...) found")
    return depends, sources, faults


def files(root, *folders):
    return sorted(path for folder in folders for path in (root / folder).rglob("*") if path.is_file())


def list_faults(what, listed, present):
    """Checks the lists, which people write by hand: each file must stand there exactly once."""
    return ([f"{what} {name} is listed {listed.count(name)} times" for name in sorted(set(listed))
             if listed.count(name) > 1] +
            [f"{what} {name} is listed but does not exist" for name in sorted(set(listed) - present)] +
            [f"{what} {name} exists but is not listed" for name in sorted(present - set(listed))])


def owner_of(parts):
    """(module, whether it is private) of a path in the tree; no module for programs, tests and the
    header of the C interface, which lies above all modules."""
    if parts[0] == "include" and len(parts) > 3:
        return parts[2], False
    return (parts[1], True) if parts[0] == "src" else (None, False)


def meant(target, path, tree):
    """The files of the tree that an include can mean, for any search folders of the compiler.

    A file beside the including file, or under include/ or tests/, comes first.  Otherwise the include
    means every file whose path ends with it: "series_model.hpp" and "stiffness/series_model.hpp" mean
    the same file.
    """
    for first in (path.parent / target, pathlib.PurePath("include", target), pathlib.PurePath("tests", target)):
        if first in tree:
            return [first]
    parts = pathlib.PurePath(target).parts
    return [other for other in tree if other.parts[-len(parts):] == parts]


def include_faults(root, depends, inside):
    faults = []
    tree = {path.relative_to(root) for path in files(root, *FOLDERS)}
    for path in sorted(tree):
        if not path.name.endswith((".hpp", ".h", ".cpp", ".in")):
            continue
        owner, private = owner_of(path.parts)
        if owner and owner not in depends:
            faults.append(f"{path}: {owner} is not a declared module")
            continue
        looks_into = {owner} if private else inside.get(path.parts[1]) if path.parts[0] == "tests" else None
        for operand in INCLUDE.findall((root / path).read_text(errors="replace")):
            where = f"{path}: #include {operand.strip()}: "
            spelled = re.match(r'[<"]([^>"]+)[>"]', operand)
            if not spelled:
                faults.append(where + "is computed, which hides what it includes")
                continue
            target = spelled[1]
            if target.startswith("/") or ".." in target.split("/"):
                faults.append(where + "leaves the folder, and with it the graph")
                continue
            if re.match("strainwave/.+/", target) and target.split("/")[1] not in depends:
                faults.append(where + f"{target.split('/')[1]} is not a declared module")
            for module, hidden in map(owner_of, (file.parts for file in meant(target, path, tree))):
                if owner and module and module != owner and module not in depends[owner]:
                    faults.append(where + f"{owner} may include only {sorted(depends[owner]) or 'itself'}")
                elif hidden and module not in (looks_into or ()):
                    faults.append(where + f"is private to {module}")
    return faults


def check(root):
    depends, sources, faults = read_graph(root)
    faults += list_faults("source", [f"{m}/{s}" for m in sources for s in sources[m]],
                          {"/".join(p.relative_to(root / "src").parts)
                           for p in files(root, "src") if p.suffix == ".cpp"})
    tests = TEST.findall((root / "tests" / "CMakeLists.txt").read_text())
    faults += list_faults("test", [f"{folder}/{name}" for folder, names, _ in tests for name in names.split()],
                          {p.relative_to(root / "tests").as_posix()[:-len("_test.cpp")]
                           for p in files(root, "tests") if p.name.endswith("_test.cpp")})
    inside = {folder: set(re.findall(r"\bINSIDE\s+(\w+)", rest)) for folder, _, rest in tests}
    return faults + include_faults(root, depends, inside)


SOUND = {
    "CMakeLists.txt": "strainwave_module(low  SOURCES a.cpp)\n"
                      "strainwave_module(left SOURCES b.cpp DEPENDS low)\n"
                      "strainwave_module(right\n  SOURCES c.cpp\n  DEPENDS low)\n",
    "tests/CMakeLists.txt": "strainwave_test(low SOURCES a DEPENDS low INSIDE low)\n",
    "include/strainwave/low/a.hpp": "#include <string>\n",
    "src/low/a.cpp": '#include "strainwave/low/a.hpp"\n',
    "src/low/low_private.hpp": "",
    "src/left/b.cpp": '#include "strainwave/low/a.hpp"\n#include "private.hpp"\n#include "fmt/format.h"\n',
    "src/left/private.hpp": "",
    "src/right/c.cpp": "",
    "src/right/secret.hpp": "",
    "tests/low/a_test.cpp": '#include "strainwave/low/a.hpp"\n#include "low_private.hpp"\n#include "low/aid.hpp"\n',
    "tests/low/aid.hpp": "",
}
# The fault, the files that cause it, and a part of the sentence that must report it.
BROKEN = [
    ("an edge not in the graph", {"src/left/b.cpp": '#include "strainwave/right/c.hpp"\n',
                                  "include/strainwave/right/c.hpp": ""},
     "left may include only ['low']"),
    ("an edge upwards, from a header", {"include/strainwave/low/a.hpp": "#  include <strainwave/left/b.hpp>\n",
                                                "include/strainwave/left/b.hpp": ""},
     "low may include only itself"),
    ("a cycle", {"CMakeLists.txt": SOUND["CMakeLists.txt"].replace("a.cpp", "a.cpp DEPENDS right")},
     "low depends on right, which is not declared above it"),
    ("a module declared twice", {"CMakeLists.txt": SOUND["CMakeLists.txt"] * 2}, "is declared twice"),
    ("an undeclared module included", {"apps/cli/main.cpp": '#include "strainwave/nowhere/a.hpp"\n'},
     "nowhere is not a declared module"),
    ("a file of an undeclared module", {"include/strainwave/new/a.hpp": ""}, "new is not a declared module"),
    ("a way round the graph", {"src/left/b.cpp": '#include "../right/secret.hpp"\n'}, "leaves the folder"),
    ("an absolute way", {"src/left/b.cpp": '#include "/src/right/secret.hpp"\n'}, "leaves the folder"),
    ("a computed include", {"src/left/b.cpp": '#define H "right/secret.hpp"\n#include H\n'}, "is computed"),
    *((f"a private header across the graph, as {spelled}", {"src/left/b.cpp": f"#include {spelled}\n"},
       "left may include only ['low']")
      for spelled in ('"right/secret.hpp"', '<right/secret.hpp>', '"./right/secret.hpp"', '"secret.hpp"',
                      '"src/right/secret.hpp"')),
    ("a private header of a module that may be used", {"src/left/b.cpp": '#include "low/low_private.hpp"\n'},
     "is private to low"),
    ("a private header in a public one", {"include/strainwave/low/a.hpp": '#include "low_private.hpp"\n'},
     "is private to low"),
    ("a private header in a program", {"apps/cli/main.cpp": '#include "low/low_private.hpp"\n'},
     "is private to low"),
    ("a private header in a test that does not look inside",
     {"tests/CMakeLists.txt": SOUND["tests/CMakeLists.txt"].replace(" INSIDE low", "")}, "is private to low"),
    ("an include of a file made at build time",
     {"src/left/made.cpp.in": '#include "right/secret.hpp"\n'}, "left may include only ['low']"),
    ("a source forgotten", {"src/low/forgotten.cpp": ""}, "low/forgotten.cpp exists but is not listed"),
    ("a source that is not there", {"src/right/c.cpp": None}, "right/c.cpp is listed but does not exist"),
    ("a source listed twice", {"CMakeLists.txt": SOUND["CMakeLists.txt"].replace("a.cpp", "a.cpp a.cpp")},
     "low/a.cpp is listed 2 times"),
    ("an edge not in the graph, of a part built on request",
     {"CMakeLists.txt": SOUND["CMakeLists.txt"] +
      "if(MORE)\n  strainwave_module(extra SOURCES d.cpp DEPENDS low NOT_INSTALLED)\nendif()\n",
      "src/extra/d.cpp": '#include "strainwave/left/b.hpp"\n',
      "include/strainwave/left/b.hpp": ""}, "extra may include only ['low']"),
    ("a test forgotten", {"tests/left/b_test.cpp": ""}, "left/b exists but is not listed"),
    ("a test that is not there", {"tests/low/a_test.cpp": None}, "low/a is listed but does not exist"),
    ("a test listed twice", {"tests/CMakeLists.txt": SOUND["tests/CMakeLists.txt"].replace(" a ", " a a ")},
     "low/a is listed 2 times"),
    ("a graph that cannot be read", {"CMakeLists.txt": ""}, "no strainwave_module(...) found"),
]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--root", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[1])
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    faults = unseen_breaks(SOUND, BROKEN, check) if arguments.self_test else check(arguments.root)
    print("\n".join(faults) or "layers: no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
