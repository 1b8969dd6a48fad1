# SPDX-License-Identifier: Apache-2.0
"""Holds tests/data/note_codes.txt to the sources and the tests.

Every code of a note in the sources is listed with its severities, and every listed code is in the
sources.  A code that no example reaches must be named by a test, or the listing says why not.

usage: note_codes.py [--self-test]
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LISTING = ROOT / "tests/data/note_codes.txt"
CODE = r'"([a-z_]+\.[a-z_]+)"'
MADE = [
    re.compile(r"\.code =\s*(?:\w+ \?\s*)?" + CODE + r"(?:\s*:\s*" + CODE + ")?"),
    re.compile(r"(?:push_back|emplace_back)\(\s*\{\s*" + CODE + r"\s*,"),
    re.compile(r"upper_bound\(\s*" + CODE),
]
SEVERITY = re.compile(r"Severity::(\w+)")
MOST_UNREACHED = 5


def made_in(text):
    """Codes of the notes that a source makes, with the severities that stand behind each."""
    made = {}
    for pattern in MADE:
        for match in pattern.finditer(text):
            statement = re.split(r";\s*\n", text[match.end():], maxsplit=1)[0]
            found = {s.replace("_", " ") for s in SEVERITY.findall(statement)}
            for code in filter(None, match.groups()):
                made.setdefault(code, set()).update(found)
    return made


def read_listing(text):
    rows = {}
    for line in text.splitlines():
        if line and not line.startswith("#"):
            code, severities, reached = line.split(" | ")
            rows[code] = (set(severities.split(", ")), reached)
    return rows


def faults(made, listed, tests):
    for code in sorted(made.keys() - listed.keys()):
        yield f"{code} is made in the sources and not listed"
    for code in sorted(listed.keys() - made.keys()):
        yield f"{code} is listed and not made in the sources"
    for code in sorted(made.keys() & listed.keys()):
        severities, reached = listed[code]
        if made[code] and made[code] != severities:
            yield f"{code} has {sorted(made[code])} in the sources, {sorted(severities)} listed"
        if reached == "test" and f'"{code}"' not in tests:
            yield f"{code} is named by no test"
    unreached = [code for code, (_, reached) in listed.items() if reached not in ("test", "example")]
    if len(unreached) > MOST_UNREACHED:
        yield f"{len(unreached)} codes are not reached; {MOST_UNREACHED} at most"


def self_test():
    made = made_in('a.push_back({"x.one", t,\n Severity::care});\n'
                   'b = {.code = bad ? "x.two" : "x.three", .severity = Severity::cannot_tell};\n')
    assert made == {"x.one": {"care"}, "x.two": {"cannot tell"}, "x.three": {"cannot tell"}}, made
    listed = read_listing("# head\nx.one | information | test\nx.two | cannot tell | example\n"
                          "x.gone | care | test\n")
    found = list(faults(made, listed, ""))
    assert found == ["x.three is made in the sources and not listed",
                     "x.gone is listed and not made in the sources",
                     "x.one has ['care'] in the sources, ['information'] listed",
                     "x.one is named by no test"], found


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    made = {}
    for source in sorted((ROOT / "src").rglob("*.[ch]pp")):
        for code, severities in made_in(source.read_text()).items():
            made.setdefault(code, set()).update(severities)
    tests = "".join(p.read_text() for p in sorted((ROOT / "tests").rglob("*_test.cpp")))
    found = list(faults(made, read_listing(LISTING.read_text()), tests))
    sys.exit("\n".join(found) if found else 0)


if __name__ == "__main__":
    main()
