#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What the C++ headers document, read by Doxygen.

    tools/site/cpp_reference.py [MODULE ...]    what is public and not documented, and functions that describe
                                                some of their parameters only; all modules if none is named
    tools/site/cpp_reference.py --self-test     break each rule once

The site takes `declarations` for its pages.

Doxygen reads copies of the public headers, in which comments are added from what the header says in
another way: a field of a described struct gets the text and the unit of its description, the enumerators of
a named enumeration get their names in files, and members that mean the same in each struct get that meaning.
A comment in the header always wins.  The lines keep their numbers.
Exit status 0 all is documented, 1 something is not.
"""

import dataclasses
import functools
import html
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

INCLUDE = pathlib.Path(__file__).resolve().parents[2] / "include"

# Modules that serve the programs; their headers are not public.
INTERNAL = {"chart", "crack_tables", "fe_study", "fem", "gear_fem", "layouts", "present"}

# Members that a concept or a convention of the library asks for: the same meaning in each struct.
CONVENTIONS = {
    "describe": "Calls a visitor with each described field, see core/described.hpp.",
    "kTableRow": "Whether a list of this struct is shown as a table, a row for each entry.",
    "kKind": "The value of `kind` in a file.",
    "kMeaning": "What this kind is, in words.",
    "kInfo": "Title, source, accuracy and tag of the equation.",
    "names": "The names of the enumerators in files and results, in their order.",
    "kLoadInfo": "Name, unit and meaning of each load.",
    "kPoints": "Named points along the front.",
    "kSummary": "What the command answers, in words.",
    "operator==": "Whether all fields are equal.",
}
# What the concepts SweptCrack and Solution ask of a solution of the library (sif/solution.hpp).
SOLUTION = {
    "kLoads": "The number of loads.",
    "size": "The size a of the crack [m].",
    "front": "The range of the front parameter.",
    "swept_area": "Area that the front sweeps per growth of the size, at a size and a front parameter [m].",
    "stress_intensity": "K I, II and III per unit of each load, at a size and a front parameter [m^0.5].",
    "gross_stress": "Nominal stress of the uncracked section per unit of a load.",
    "check": "Calls rule(ok, field, value, unit, text) for each rule between fields.",
    "validity": "Calls limit(inside, text) for each limit of the range of the stated accuracy.",
}


LITERAL = re.compile(r'R"\(.*?\)"|"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'|//[^\n]*', re.S)


def marks(text, start):
    """(place, mark) of each bracket and comma from a place on, outside of literals and comments."""
    place = start
    while place < len(text):
        literal = LITERAL.match(text, place)
        if literal:
            place = literal.end()
            continue
        if text[place] in "(){}[],":
            yield place, text[place]
        place += 1


def closing(text, start):
    """The place after the bracket that closes the one at `start`."""
    depth = 0
    for place, mark in marks(text, start):
        depth += (mark in "({[") - (mark in ")}]")
        if depth == 0:
            return place + 1
    raise ValueError("no closing bracket")


def arguments(text):
    """The parts of a text in brackets, cut at its commas."""
    parts, start, depth = [], 1, 0
    for place, mark in marks(text, 0):
        depth += (mark in "({[") - (mark in ")}]")
        if mark == "," and depth == 1 or depth == 0:
            parts.append(text[start:place].strip())
            start = place + 1
    return parts


def string(text):
    """The text of adjacent literals."""
    return "".join(re.findall(r'"((?:\\.|[^"\\])*)"', text)).replace('\\"', '"')


def described(record):
    """(unit, text) of a record Field{…}."""
    parts = arguments(record[record.index("{"):])
    named = {}
    for part in parts:
        match = re.match(r"\.(\w+)\s*=\s*(.*)", part, re.S)
        if match:
            named[match.group(1)] = match.group(2)
    if named:
        return string(named.get("unit", '""')), string(named.get("doc", ""))
    return (string(parts[1]) if len(parts) > 1 else ""), (string(parts[2]) if len(parts) > 2 else "")


@functools.cache
def shared_records():
    """The records of fields that several structs share, by the names of their constants."""
    found = {}
    for header in sorted(INCLUDE.rglob("*.hpp")):
        text = header.read_text(encoding="utf-8")
        for match in re.finditer(r"constexpr Field (\w+)\s*(?==|\{)", text):
            start = text.index("{", match.end() - 1)
            found[match.group(1)] = text[start:closing(text, start)]
    return found


def bodies(text):
    """(start, end, name) of the body of each struct, the inner ones last."""
    found = []
    for match in re.finditer(r"^[^\S\n]*(?:struct|class) (\w+)[^;{}()]*\{", text, re.M):
        found.append((match.end() - 1, closing(text, match.end() - 1), match.group(1)))
    return found


def owner(spans, place):
    """The start of the body of the innermost struct at a place, or -1."""
    return max((start for start, end, _ in spans if start < place < end), default=-1)


def fields(text, spans):
    """{(start of the struct, member): "text [unit]"} of the calls of the visitor in a header."""
    found = {}
    for match in re.finditer(r"\bfield\(", text):
        parts = arguments(text[match.end() - 1:closing(text, match.end() - 1)])
        pointers = [one.group(1) for part in parts for one in [re.fullmatch(r"&[\w:<>]+::(\w+)", part)] if one]
        record = parts[0] if "{" in parts[0] else shared_records().get(re.sub(r"\W.*", "", parts[0]), "")
        if not pointers or "{" not in record:
            continue
        unit, words = described(record)
        if words:
            found[owner(spans, match.start()), pointers[0]] = f"{words}{f' [{unit}]' if unit else ''}"
    return found


# A member in one line: what stands before its name, and the name.
FIELD = re.compile(r"^[^\S\n]+(?!return\b|using\b|friend\b|else\b|throw\b|case\b|///)[\w:<>,*&()\t ]*?[\w>&*] +(\w+)"
                   r'(?: = (?:[^;"\n]|"(?:\\.|[^"\\\n])*")*'
                   r"| ?\{[^;\n]*\})?;(?P<unit> *///< \[[^\]\n]*\])?[^\S\n]*$", re.M)
# A field whose value begins in the next line, or whose value has several lines.
LONG_FIELD = re.compile(r"^[^\S\n]+(?:static )?(?:inline )?constexpr [\w:<>,&\t ]+? (\w+) ?[={][^\n;]*$", re.M)
FUNCTION = re.compile(r"^[^\S\n]+(?:template <[^\n]*>\n[^\S\n]+)?"
                      r"(?:friend |static |constexpr |\[\[nodiscard\]\] ?|\n[^\S\n]+)*"
                      r"[\w:<>,*& ]+?[ &*](\w+|operator==)\(", re.M)
NAMES = re.compile(r"^template <>\nstruct EnumNames<([\w:]+)>", re.M)
ENUMERATION = re.compile(r"enum class (\w+)[^;{]*\{")


def commented(text, start, end, only_above=False):
    """Whether a declaration has a comment: above, or behind."""
    above = text[:start].rstrip(" ").removesuffix("\n").rpartition("\n")[2].strip()
    behind = "" if only_above else text[end:text.find("\n", end)]
    return "///<" in text[start:end] or "///<" in behind or above.endswith("*/") \
        or above.startswith("///") and not above.startswith(("///<", "/// @}"))


def documented(text):
    """The header with the comments of the members that have none, or only a unit."""
    spans = bodies(text)
    meanings = fields(text, spans)
    solutions = {start for start, end, _ in spans if re.search(r"\bkLoads\b", text[start:end])}
    inserted = []

    def insert(place, meaning):
        inserted.append((place, place, f"/** {meaning} */ "))

    def convention(here, word):
        return (SOLUTION.get(word) if here in solutions else None) or CONVENTIONS.get(word)

    for pattern in (FIELD, LONG_FIELD):
        for match in pattern.finditer(text):
            here, word = owner(spans, match.start()), match.group(1)
            unit = match.groupdict().get("unit")
            if here < 0 or commented(text, match.start(), match.start("unit") if unit else match.end(), bool(unit)):
                continue
            meaning = meanings.get((here, word)) or ("" if unit else convention(here, word))
            if meaning:
                insert(match.start(), meaning)
                if unit:
                    inserted.append((match.start("unit"), match.end("unit"), ""))
    for match in FUNCTION.finditer(text):
        here, meaning = owner(spans, match.start()), convention(owner(spans, match.start()), match.group(1))
        if meaning and here >= 0 and not commented(text, match.start(), match.end()):
            insert(match.start(), meaning)
    for match in NAMES.finditer(text):
        if not commented(text, match.start(), match.end()):
            insert(match.start(), f"The names of {match.group(1)} in files and results.")
    for match in ENUMERATION.finditer(text):
        names = re.search(r"struct EnumNames<(?:\w+::)*" + match.group(1) + r">\s*\{.*?names\s*=\s*(\{.*?\})", text, re.S)
        end = closing(text, match.end() - 1)
        if not names:
            continue
        words = iter(re.findall(r'"([^"]*)"', names.group(1)))
        for line in re.finditer(r"[^\n]+", text[match.end():end - 1]):
            code = line.group(0).partition("//")[0]
            for one in re.finditer(r"[A-Za-z_]\w*(?=\s*(?:,|$|=))", code):
                name = next(words, "")
                if "//" not in line.group(0) and name:
                    insert(match.end() + line.start() + one.start(), f"Written `{name}`.")
    for start, end, comment in sorted(inserted, reverse=True):
        text = text[:start] + comment + text[end:]
    return text


def public_headers(include):
    """The public headers of a folder, by their paths as a program includes them."""
    for header in sorted((include / "strainwave").rglob("*.h*")):
        name = header.relative_to(include).as_posix()
        if name.split("/")[1] not in INTERNAL and not name.startswith("strainwave/core/toml_"):
            yield name


def read(folder, include=INCLUDE):
    """Writes the XML of Doxygen to a folder; returns its warnings."""
    if not shutil.which("doxygen"):
        sys.exit("cpp_reference: doxygen is not installed; run tools/install_dependencies check")
    copies = folder / "copies"
    for name in public_headers(include):
        copy = copies / name
        copy.parent.mkdir(parents=True, exist_ok=True)
        text = (include / name).read_text(encoding="utf-8")
        copy.write_text(documented(text) if name.endswith(".hpp") else text, encoding="utf-8")
    settings = {"INPUT": copies, "STRIP_FROM_PATH": copies, "RECURSIVE": "YES", "FILE_PATTERNS": "*.h *.hpp",
                "OUTPUT_DIRECTORY": folder, "GENERATE_XML": "YES", "XML_PROGRAMLISTING": "NO", "GENERATE_HTML": "NO",
                "CLASS_GRAPH": "NO", "COLLABORATION_GRAPH": "NO", "INCLUDE_GRAPH": "NO", "INCLUDED_BY_GRAPH": "NO",
                "GENERATE_LATEX": "NO", "QUIET": "YES", "DISTRIBUTE_GROUP_DOC": "YES",
                "EXCLUDE_SYMBOLS": "strainwave::detail strainwave::*::detail",
                "MACRO_EXPANSION": "YES", "EXPAND_ONLY_PREDEF": "YES", "PREDEFINED": "SW_API=",
                "WARN_LOGFILE": folder / "warnings"}
    lines = "".join(f'{name} = "{value}"\n' if name in ("INPUT", "STRIP_FROM_PATH", "OUTPUT_DIRECTORY", "WARN_LOGFILE")
                    else f"{name} = {value}\n" for name, value in settings.items())
    subprocess.run(["doxygen", "-"], input=lines, text=True, check=True, stdout=subprocess.DEVNULL)
    return [line.replace(f"{copies}/", "include/")
            for line in (folder / "warnings").read_text(encoding="utf-8").splitlines()]


@dataclasses.dataclass
class Declaration:
    """A class, a function, a constant or a type, or the text of a header."""

    header: str
    line: int
    kind: str
    scope: str  # name of the class or the namespace that contains it
    name: str
    text: str  # as C++ has it
    meaning: str  # HTML


def described_as(node):
    """The HTML of a description of Doxygen."""
    if node is None:
        return ""
    inside = html.escape(node.text or "", quote=False)
    for child in node:
        inside += described_as(child) + html.escape(child.tail or "", quote=False)
    tag = node.tag
    if tag == "para":
        return f"<p>{inside}</p>" if inside.strip() else ""
    if tag == "computeroutput":
        return f"<code>{inside}</code>"
    if tag in ("verbatim", "preformatted"):
        return f"</p><pre>{inside}</pre><p>"
    if tag in ("itemizedlist", "orderedlist"):
        return f"</p><ul>{inside}</ul><p>"
    if tag == "listitem":
        return f"<li>{inside}</li>"
    if tag == "emphasis":
        return f"<em>{inside}</em>"
    if tag == "parametername":
        return f"<code>{inside}</code> "
    if tag == "parameteritem":
        return f"<li>{inside.replace('<p>', '').replace('</p>', '')}</li>"
    if tag == "parameterlist":
        word = {"exception": "Throws: ", "templateparam": "Template: "}.get(node.get("kind"), "")
        return f"</p>{f'<p>{word}</p>' if word else ''}<ul class='parameters'>{inside}</ul><p>"
    if tag == "simplesect":
        word = {"return": "Returns: ", "note": "Note: ", "see": "See: "}.get(node.get("kind"), "")
        return f"</p><p>{word}{inside.replace('<p>', '').replace('</p>', '')}</p><p>"
    return inside


def meaning_of(node):
    whole = described_as(node.find("briefdescription")) + described_as(node.find("detaileddescription"))
    return re.sub(r"<p>\s*</p>", "", whole)


def plain_text(node):
    return " ".join("".join(node.itertext()).split()) if node is not None else ""


def spelled(member):
    """A member as C++ declares it, without its body."""
    kind, name = member.get("kind"), plain_text(member.find("name"))
    before = ""
    if member.find("templateparamlist") is not None:
        parts = []
        for one in member.find("templateparamlist"):
            parts.append(f"{plain_text(one.find('type'))} {plain_text(one.find('declname'))}".strip())
        before = f"template <{', '.join(parts)}> "
    if kind == "enum":
        return f"enum {'class ' if member.get('strong') == 'yes' else ''}{name}"
    if kind == "define":
        return f"#define {name}"
    value = plain_text(member.find("initializer"))
    value = f" {value}" if value and len(value) < 60 else ""
    words = plain_text(member.find("type"))
    if kind == "typedef" and plain_text(member.find("definition")).startswith("using"):
        return before + re.sub(r"(using )strainwave::|(= )typedef ", r"\1\2", plain_text(member.find("definition")))
    return f"{before}{words + ' ' if words else ''}{name}{plain_text(member.find('argsstring'))}{value}"


def declarations(folder):
    """What the XML of a folder declares, in the order of the headers."""
    found, seen = [], set()
    for file in sorted((folder / "xml").glob("*.xml")):
        compound = xml.etree.ElementTree.parse(file).getroot().find("compounddef")
        if compound is None or compound.get("kind") not in ("struct", "class", "union", "concept", "namespace", "file"):
            continue
        if compound.get("prot", "public") != "public":
            continue
        kind, scope = compound.get("kind"), plain_text(compound.find("compoundname"))
        place = compound.find("location")
        header = place.get("file") if place is not None else ""
        if scope.startswith("std") or scope.startswith("strainwave::EnumNames<"):
            continue
        if kind == "file":
            found.append(Declaration(header, 0, kind, "", header, header, meaning_of(compound)))
            scope = ""
        elif kind != "namespace":
            outer, _, name = scope.rpartition("::") if "<" not in scope else ("", "", scope)
            text = f"{kind} {name or scope}"
            if kind == "concept":
                text = f"concept {name or scope}"
            found.append(Declaration(header, int(place.get("line")), kind, outer, name or scope, text, meaning_of(compound)))
        for member in compound.iter("memberdef"):
            if member.get("prot") != "public" or member.get("id") in seen:
                continue
            seen.add(member.get("id"))
            at = member.find("location")
            name = plain_text(member.find("name"))
            found.append(Declaration(at.get("file"), int(at.get("line")), member.get("kind"), scope, name, spelled(member),
                                     meaning_of(member)))
            for one in member.iter("enumvalue"):
                found.append(Declaration(at.get("file"), int(at.get("line")), "enumvalue", f"{scope}::{name}".lstrip(":"),
                                         plain_text(one.find("name")), plain_text(one.find("name")), meaning_of(one)))
    return sorted(found, key=lambda one: (one.header, one.line))


TRIAL = """#pragma once
/// @file
/// A header.
namespace strainwave {
/// What a thing may be.
enum class Form { round, flat };
template <>
struct EnumNames<Form> {
  static constexpr std::array<std::string_view, 2> names = {"round", "flat"};
};
/// A thing.
struct Thing {
  double length = 0.0;
  double width = 0.0;  ///< [m]
  double depth = 0.0;  ///< from the top [m]
  int count = 0;  ///< [-]

  template <class Visitor>
  static void describe(Visitor&& field) {
    field({"length", "m", "from end to end, (a) and \\"b\\""}, &Thing::length);
    field(Field{.name = "width", .unit = "m", .doc = "across, "
                "at the middle"}, &Thing::width);
    field({"depth", "m", "not used"}, &Thing::depth);
  }
};
namespace detail {
struct Hidden {};
}
}
"""
DOCUMENTED = ("from end to end, (a) and &quot;b&quot; [m]", "across, at the middle [m]", "from the top [m]", "[-]",
              "Written <code>round</code>.", "Written <code>flat</code>.")


def self_test():
    """The comments that are added to a header, and members that nothing documents."""
    unseen = []
    for line, wanted in (("", 0), ("  double bare = 0.0;", 1), ("  double of(double x) const;", 1),
                         ("  double bare = 0.0;  ///< of no use", 0),
                         ("  /// Twice.\n  /// @param x  of two\n  double of(double x, double y) const;", 2)):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            header = folder / "include" / "strainwave" / "trial" / "trial.hpp"
            header.parent.mkdir(parents=True)
            header.write_text(TRIAL.replace("  int count", line + "\n  int count"), encoding="utf-8")
            warnings = read(folder, folder / "include")
            meanings = [re.sub("</?p>", "", one.meaning).strip() for one in declarations(folder)]
        if len(warnings) != wanted:
            unseen.append(f"{line.strip() or 'nothing'}: {warnings}")
        unseen += [f"{text}: is missing" for text in DOCUMENTED if html.unescape(text) not in map(html.unescape, meanings)]
        if any("Hidden" in one for one in meanings):
            unseen.append("the namespace detail is shown")
    print("\n".join(unseen) if unseen else "cpp_reference: each rule was broken and noticed")
    return len(unseen)


def main():
    if sys.argv[1:] == ["--self-test"]:
        sys.exit(1 if self_test() else 0)
    with tempfile.TemporaryDirectory() as folder:
        warnings = read(pathlib.Path(folder))
    wanted = sys.argv[1:]
    shown = [line for line in warnings if not wanted or not line.startswith("include/")
             or re.match(rf"include/strainwave/({'|'.join(wanted)})[/.]", line)]
    print("\n".join(shown) if shown else "cpp_reference: no fault")
    sys.exit(1 if shown else 0)


if __name__ == "__main__":
    main()
