#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that pages quote the example programs word for word.

    tools/check_snippets.py              check docs/ and examples/NN_topic/
    tools/check_snippets.py --write      quote the present text of the examples again
    tools/check_snippets.py --self-test  break every rule once in a scratch tree

A program marks a part by `// snippet: name` and `// end`.  A page quotes it below a line
`<!-- examples/NN_topic/main.cpp: name -->`.  README.md of an example starts with the examples that it
builds on.  It states, word for word, the output that examples/CMakeLists.txt expects of the program.
"""

import pathlib
import re
import sys
import textwrap

from scratch_tree import unseen_breaks

ROOT = pathlib.Path(__file__).resolve().parents[1]
MARKED = re.compile(r"^ *// snippet: (\w+)\n(.*?)^ *// end\n", re.M | re.S)
QUOTE = re.compile(r"(<!-- (examples/[\w./]+): (\w+) -->\n```cpp\n)(.*?)(^```\n)", re.M | re.S)
EXPECTED = re.compile(r'^strainwave_example\((\w+)\s[^)]*PRINTS\s+"([^"]*)"', re.M)
BUILDS_ON = re.compile(r"builds-on: (\d\d|nothing)\n")


def snippets(root):
    """{(file, name): text} of all marked parts."""
    return {(path.relative_to(root).as_posix(), name): textwrap.dedent(text)
            for path in sorted(root.glob("examples/*/main.cpp")) for name, text in MARKED.findall(path.read_text())}


def quote_faults(root, write=False):
    marked, quoted, faults = snippets(root), set(), []
    for page in sorted(root.glob("docs/**/*.md")):
        def renewed(match, page=page):
            key = (match[2], match[3])
            if key not in marked:
                faults.append(f"{page.name}: {key[0]} has no snippet {key[1]}")
                return match[0]
            quoted.add(key)
            if match[4] != marked[key] and not write:
                faults.append(f"{page.name}: {key[0]} says something else at {key[1]}: run tools/check_snippets.py --write")
            return match[1] + marked[key] + match[5]

        text = page.read_text()
        renewed_text = QUOTE.sub(renewed, text)
        if write and renewed_text != text:
            page.write_text(renewed_text)
    return faults + [f"{file}: snippet {name} is quoted nowhere" for file, name in sorted(set(marked) - quoted)]


def example_faults(root):
    expected = dict(EXPECTED.findall((root / "examples" / "CMakeLists.txt").read_text()))
    folders = sorted(path.parent for path in root.glob("examples/*/main.cpp"))
    faults = [f"{folder.name} is not in examples/CMakeLists.txt" for folder in folders if folder.name not in expected]
    for folder in folders:
        readme = folder / "README.md"
        text = readme.read_text() if readme.exists() else ""
        start = BUILDS_ON.match(text)
        if not start:
            faults.append(f"{folder.name}/README.md does not start with builds-on: NN")
        elif start[1] != "nothing" and not any(other.name[:2] == start[1] < folder.name[:2] for other in folders):
            faults.append(f"{folder.name}/README.md builds on {start[1]}, which is no example before it")
        if folder.name in expected and expected[folder.name] not in text:
            faults.append(f"{folder.name}/README.md does not state {expected[folder.name]!r}")
    return faults


SOUND = {
    "examples/CMakeLists.txt": 'strainwave_example(01_a DEPENDS low PRINTS "K = 2.5")\n',
    "examples/01_a/main.cpp": "int main() {\n  // snippet: part\n  run();\n  // end\n}\n",
    "examples/01_a/README.md": "builds-on: nothing\n\nIt prints K = 2.5.\n",
    "docs/guide/a.md": "<!-- examples/01_a/main.cpp: part -->\n```cpp\nrun();\n```\n",
}
# The fault, the files that cause it, and a part of the sentence that must report it.
BROKEN = [
    ("a page of yesterday", {"docs/guide/a.md": SOUND["docs/guide/a.md"].replace("run", "walk")}, "says something else at part"),
    ("a snippet that is not there", {"docs/guide/a.md": SOUND["docs/guide/a.md"] * 2 +
                                     SOUND["docs/guide/a.md"].replace("part", "other")}, "has no snippet other"),
    ("a snippet without a page", {"docs/guide/a.md": ""}, "snippet part is quoted nowhere"),
    ("an example that is not run", {"examples/CMakeLists.txt": ""}, "01_a is not in examples/CMakeLists.txt"),
    ("no word on what comes before", {"examples/01_a/README.md": "It prints K = 2.5.\n"}, "does not start with builds-on"),
    ("no page of an example", {"examples/01_a/README.md": None}, "does not start with builds-on"),
    ("an example on itself", {"examples/01_a/README.md": "builds-on: 01\n\nIt prints K = 2.5.\n"}, "builds on 01, which is no"),
    ("another number", {"examples/01_a/README.md": "builds-on: nothing\n\nIt prints K = 3.\n"}, "does not state 'K = 2.5'"),
]


def self_test():
    def check(root):
        faults = quote_faults(root) + example_faults(root)
        if any("says something else" in fault for fault in faults):
            faults += quote_faults(root, write=True) + quote_faults(root)  # --write mends it
            faults = faults[:1] if len(faults) == 1 else ["--write does not mend a page of yesterday"]
        return faults
    return unseen_breaks(SOUND, BROKEN, check)


def main():
    option = sys.argv[1] if len(sys.argv) > 1 else ""
    faults = self_test() if option == "--self-test" else quote_faults(ROOT, option == "--write") + example_faults(ROOT)
    print("\n".join(faults) or "snippets: no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
