# SPDX-License-Identifier: Apache-2.0
"""A page for each command: what it does, its options, its documents, the fields of its result."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from pages import ROOT, escape, identifier, table

# Commands of the program alone, which the library does not describe.
OWN = ("merge", "man", "completion")
LISTING = ROOT / "tests" / "data" / "public_surface_fe.txt"


def program():
    """The program strainwave: $STRAINWAVE_CLI, or where the build of the library has it, or an installed one."""
    library = pathlib.Path(os.environ.get("STRAINWAVE_LIBRARY", "")).parent
    for place in (os.environ.get("STRAINWAVE_CLI"), library / "apps" / "cli" / "strainwave", shutil.which("strainwave")):
        if place and os.access(place, os.X_OK):
            return pathlib.Path(place)
    sys.exit("render_site: the program strainwave is not there; build it, or set STRAINWAVE_CLI to its path")


def printed(*words):
    """What a program prints."""
    return subprocess.run(list(map(str, words)), check=True, capture_output=True, text=True).stdout


class Commands:
    """Writes the pages; `rows` is their list."""

    def __init__(self, site):
        self.site = site
        self.rows = []

    def add(self, name, summary, sentences, options, fields):
        """A page.  options: (name, kind, meaning); fields: (path, unit, meaning), None: not described."""
        word = name.replace(" ", "_")
        path = f"commands/{word}.html"
        option_rows = []
        for spelled, kind, meaning in options:
            address = "option-" + identifier(spelled.lstrip("-").replace("-", "_"))
            option_rows.append((address, f"<code>{escape(spelled)}</code>", escape(kind), escape(meaning)))
            self.site.enter("option", f"{name} {spelled}", f"{path}#{address}", meaning, [spelled])
        body = (f"<h1><code>strainwave {escape(name)}</code></h1><p>{escape(summary)}.</p><p>{sentences}</p><h2 id='options'>Options</h2>"
                + (table(("option", "kind", "meaning"), option_rows) if option_rows else "<p>None.</p>"))
        if fields is not None:
            field_rows = []
            for field, unit, meaning in fields:
                address = "result-" + identifier(field)
                field_rows.append((address, f"<code>{escape(field).replace('.', '.<wbr>')}</code>", escape(unit), escape(meaning)))
                self.site.enter("result", f"{name} {field}", f"{path}#{address}", meaning, [field, field.rpartition(".")[2]])
            body += ("<h2 id='result'>Result</h2><p>Numbers of <code>--format json</code> are in these SI units.</p>"
                     + table(("field", "unit", "meaning"), field_rows))
        self.site.write(path, f"strainwave {name}", body)
        self.site.enter("command", name, path, summary, [f"strainwave {name}"])
        self.rows.append((None, f'<a href="{word}.html"><code>{escape(name)}</code></a>', escape(summary)))


def described(schema):
    """(name, kind, meaning) of each option of a schema."""
    for option, about in schema["properties"].items():
        choices = ", ".join(map(str, about.get("enum", about.get("items", {}).get("enum", ()))))
        yield (option if option in schema.get("required", ()) else "--" + option.replace("_", "-"),
               choices or about.get("type", "choice"), about["description"])


def result_fields(node, path=""):
    """(path, unit, meaning) of each field of a result."""
    for name, part in node.get("properties", {}).items():
        inner, where = part, f"{path}{name}"
        while inner.get("type") == "array":
            inner, where = inner["items"], where + "[]"
        parts = inner.get("properties", {})
        meaning = part.get("description", "")
        if "enum" in inner:
            meaning = f"{meaning}: {', '.join(map(str, inner['enum']))}".lstrip(": ")
        if not parts or set(parts) <= {"value", "values", "unit", "relative_uncertainty"}:
            yield where, parts.get("unit", {}).get("const", ""), meaning
        else:
            yield from result_fields(inner, where + ".")


def helped(text):
    """(name, kind, meaning) of each option in the help of a command."""
    parts = re.split(r"^(?=\S.*:$)", text, flags=re.M)
    for part in parts:
        if part.startswith(("Positionals:", "Options:")):
            for spelled, meaning in re.findall(r"^  (\S.*?)  +(\S.*)$", part, re.M):
                names, _, kind = spelled.partition(" ")
                yield names.rpartition(",")[2], kind.lower() or "flag", meaning


def listed():
    """The commands of the finite elements as the listing of the tests has them:
    {name: {"takes": …, "journal": …, "option": [(name, kind, "")], "document": […], "result": [(path, unit, "")]}}."""
    found = {}
    for line in LISTING.read_text(encoding="utf-8").splitlines():
        if not line.startswith(" "):
            name, _, takes = line.partition(" of ")
            found[name] = {"takes": takes or "nothing", "journal": "", "option": [], "document": [], "result": []}
            continue
        if line.startswith("  journal: "):
            found[name]["journal"] = line.partition(": ")[2]
            continue
        word, entry, kind = re.fullmatch(r"  (\w+) ([^:]+): (.*)", line).groups()
        unit = re.search(r"\[(.*)\]$", kind)
        found[name][word].append({"option": ("--" + entry.replace("_", "-"), kind, ""), "document": entry,
                                  "result": (entry.replace("?", ""), unit.group(1) if unit else "", "")}[word])
    return found


def finite_elements(commands, cli):
    """The commands of `strainwave fe`; without its program, which a build may leave out, without their texts."""
    elements = cli.with_name("strainwave-fe")
    summary = re.search(r"^  fe +(.*)$", printed(cli, "--help"), re.M).group(1)
    links = "".join(f'<li><a href="fe_{name}.html"><code>strainwave fe {name}</code></a></li>' for name in listed())
    commands.add("fe", summary, f'<a href="../docs/guide/finite_elements.html">The guide</a> explains the commands:</p><ul>{links}</ul><p>',
                 [], None)
    for name, about in listed().items():
        options, fields, text = about["option"], about["result"], f"Finite elements: {name}"
        note = f" Journal: {about['journal']}." if about["journal"] else ""
        if os.access(elements, os.X_OK):
            options = list(described(json.loads(printed(elements, "schema", "--of", "options", "--command", name))))
            result = json.loads(printed(elements, "schema", "--of", "result", "--command", name))
            fields = list(result_fields(result["properties"]["result"]))
            text = result["title"].partition(": ")[2]
        else:
            note += " This site was written without the program of the finite elements, so meanings are left out."
        documents = ", ".join(f"<code>{escape(one)}</code>" for one in about["document"])
        commands.add(f"fe {name}", text, f"Documents: {documents}. Takes: {escape(about['takes'])}.{escape(note)}", options, fields)


def write(site, sw, library):
    """All pages of commands; returns the rows of their list."""
    commands = Commands(site)
    for command in library.commands():
        name = command["name"]
        word = name.replace(" ", "_")
        call = {"nothing": f"sw.{word}(…)", "drive": f"drive.{word}(…)"}.get(command["takes"], f"drive.{word}(…), sw.{word}(…)")
        documents = ", ".join(f"<code>{escape(one)}</code>" for one in command["documents"])
        commands.add(name, command["summary"],
                     f"In Python: <code>{escape(call)}</code>. Documents: {documents}. Takes: {escape(command['takes'])}.",
                     described(json.loads(sw.schema(of="options", command=name).schema)),
                     result_fields(json.loads(sw.schema(of="result", command=name).schema)["properties"]["result"]))
    cli = program()
    for name in OWN:
        text = printed(cli, name, "--help")
        example = text.partition("Example:\n")[2].strip()
        commands.add(name, text.partition("\n")[0], f"Only the program has this command. Example: <code>{escape(example)}</code>",
                     helped(text), None)
    finite_elements(commands, cli)
    site.write("commands/index.html", "Commands", "<h1>Commands</h1><p>Which command answers which question.</p>"
               + table(("command", "answers"), commands.rows))
    site.enter("page", "Commands", "commands/index.html", "which command answers which question")
    return commands.rows
