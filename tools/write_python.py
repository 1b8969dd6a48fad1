#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the modules of the Python package that follow from the table of commands: the functions
and methods (python/strainwave/_commands.py) and the classes of the results
(python/strainwave/results/).

    STRAINWAVE_LIBRARY=build/release/libstrainwave.so tools/write_python.py           write
    STRAINWAVE_LIBRARY=build/release/libstrainwave.so tools/write_python.py --check   compare only

Names, units and descriptions come from the library, so that the package cannot drift from it.
"""

import ast
import difflib
import json
import keyword
import pathlib
import re
import sys
import textwrap
import types

ROOT = pathlib.Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "python" / "strainwave"
sys.dont_write_bytecode = True
# The package without its __init__, which imports what this program writes.
sys.modules["strainwave"] = types.ModuleType("strainwave")
sys.modules["strainwave"].__path__ = [str(PACKAGE)]

from strainwave import _library  # noqa: E402
from strainwave.parts import Part  # noqa: E402



def members_of(name):
    """The names in a class of answers.py, which cannot be imported before its evidence is written."""
    tree = ast.parse((PACKAGE / "answers.py").read_text())
    body = next(node.body for node in tree.body if isinstance(node, ast.ClassDef) and node.name == name)
    return {node.target.id if isinstance(node, ast.AnnAssign) else node.name for node in body
            if isinstance(node, (ast.AnnAssign, ast.FunctionDef))}


HEAD = '''# SPDX-License-Identifier: Apache-2.0
# Written by tools/write_python.py; change the descriptions in the C++ sources instead.
"""{doc}"""
'''
ENVELOPE = ("format", "command", "usable", "unusable_because", "verdict", "notes", "equations",
            "accuracies", "result", "provenance")
# A field with the name of a member of its class, and a reserved word, get an underscore at the end.
TAKEN_OF_PART = {name for name in dir(Part) if not name.startswith("_")}
TAKEN = TAKEN_OF_PART | set(ENVELOPE) | members_of("Result")


def schema(of, command):
    answer = _library.run(None, "schema", json.dumps({"of": of, "command": command}), {})
    return json.loads(json.loads(_library.document(answer, "json"))["result"]["schema"])


def identifier(name):
    spelled = re.sub(r"\W", "_", name)
    return spelled + "_" if keyword.iskeyword(spelled) else spelled


def camel(name):
    return "".join(word[:1].upper() + word[1:] for word in re.split(r"[\W_]+", name))


def sentence(text):
    """A description as a sentence of a docstring."""
    spelled = text.replace("\\", "\\\\").replace('"""', "'''")
    return spelled + " " if spelled.endswith('"') else spelled


def in_python(text, options):
    """A description that names options as the command line spells them, with the names of Python's arguments."""
    def argument(match):
        about = options.get(match.group(1).replace("-", "_"))
        if about is None:
            return match.group(0)
        chosen = match.group(3) in about.get("enum", ())
        return f"`{identifier(match.group(1))}" + (f'="{match.group(3)}"`' if chosen else "`" + (match.group(2) or ""))

    return re.sub(r"--([a-z][\w-]*)( ([\w-]+))?", argument, text)


def wrapped(text, indent, first=""):
    return "\n".join(textwrap.wrap(text, 100 - len(indent) if not first else 100,
                                   initial_indent=first or indent, subsequent_indent=indent,
                                   break_on_hyphens=False, break_long_words=False))


def listed(before, parts, after, indent):
    """Code with a list that is wrapped between its parts only."""
    text = before + ", ".join(part.replace(" ", "\0") for part in parts) + after.replace(" ", "\0")
    inner = " " * len(before)
    first, *rest = text.split("\n")
    return wrapped(first.replace(before, before.replace(" ", "\0"), 1), inner,
                   indent or "\0").replace("\0", " ")[0 if indent else 1:]


def is_quantity(node):
    parts = node.get("properties", {})
    return "value" in parts and set(parts) <= {"value", "unit", "relative_uncertainty"}


def structure(node):
    """What two objects of the same class have in common: all but the units of their quantities, which
    each quantity carries."""
    def without_units(part):
        if isinstance(part, list):
            return [without_units(one) for one in part]
        if not isinstance(part, dict):
            return part
        if is_quantity(part):
            part = {**part, "properties": {**part["properties"], "unit": {}}}
        return {name: without_units(one) for name, one in part.items()}

    return json.dumps(without_units(node["properties"]), sort_keys=True)


def unit_of(node):
    return node.get("properties", {}).get("unit", {}).get("const", "")


class Structures:
    """The structures of all results: each is written once, in the module of the first result that has
    it as a part."""

    def __init__(self):
        self.owners = {}  # structure -> (module, name of the class)
        self.units = {}  # structure -> {field: units that it has}

    def collect_units(self, node):
        for part in node.get("properties", {}).values():
            self.collect_units(part)
        if "items" in node:
            self.collect_units(node["items"])
        if "properties" in node and not is_quantity(node):
            units = self.units.setdefault(structure(node), {})
            for field, part in node["properties"].items():
                units.setdefault(field, set()).add(unit_of(part))


class ResultModule:
    """The classes of one result, or of the evidence that all results have."""

    def __init__(self, name, root, node, structures, command=None):
        self.name = name  # of the module
        self.root = root  # name of the class of the whole
        self.command = command  # None: the evidence
        self.structures = structures
        self.names = {}  # structure of an object -> name of its class in this module
        self.keys = {}  # structure of an object -> names of the fields that have it
        self.written = []  # classes, parts before wholes
        self.imported = {}  # module -> names
        self.used = set()
        self.collect(node, root)
        if command:
            self.object(node, (root,))
        else:
            for field, part in node["properties"].items():
                self.object(part.get("items", part), (root, field))

    def collect(self, node, key):
        """Notes which fields have the same structure."""
        if "properties" in node and not is_quantity(node):
            self.keys.setdefault(structure(node), []).append(key)
            for field, part in node["properties"].items():
                self.collect(part, field)
        elif "items" in node:
            self.collect(node["items"], key)

    def class_name(self, node, path):
        """Named after the field; a structure of several fields is named after what contains them."""
        path = (self.name,) + path[1:]
        if len(set(self.keys[structure(node)])) > 1:
            path = path[:-2] + (path[-2] + "_part",)
        for depth in range(1, len(path) + 1):
            name = "".join(camel(key) for key in path[-depth:])
            if name not in self.names.values() and name != self.root and name not in RESERVED:
                return name
        return next(numbered for numbered in (f"{name}{n}" for n in range(2, 100))
                    if numbered not in self.names.values())

    def owned_elsewhere(self, key):
        """The name of a class that another module has, imported; None if no module has it."""
        if key not in self.structures.owners:
            return None
        module, name = self.structures.owners[key]
        spelled = name if name not in self.names.values() and name != self.root else camel(module) + name
        self.imported.setdefault(module, []).append(name if spelled == name else f"{name} as {spelled}")
        self.names[key] = spelled
        return spelled

    def value(self, node, path):
        """Type and converter of a value."""
        kind = node.get("type")
        if "oneOf" in node:
            return "Any", "_to.plain"
        if "enum" in node:
            words = ", ".join(json.dumps(word) for word in node["enum"])
            return f"Literal[{words}]", "_to.plain"
        if kind == "object":
            parts = node.get("properties", {})
            if not parts:
                return "dict[str, Any]", "_to.plain"
            if is_quantity(node):
                return "Quantity", "_to.quantity"
            if set(parts) == {"values", "unit"}:
                return "FloatArray", "_to.floats"
            if set(parts) == {"values"}:
                return "AnyArray", "_to.entries"
            name = self.object(node, path)
            return name, f"{name}._of"
        if kind == "array":
            inner, convert = self.value(node["items"], path)
            return f"tuple[{inner}, ...]", f"_to.many({convert})"
        if kind == ["number", "null"]:
            return "float", "_to.plain_number"
        return {"string": "str", "integer": "int", "boolean": "bool",
                "number": "float"}[kind], "_to.plain"

    def object(self, node, path):
        """Writes the class of an object unless one of the same structure exists; returns its name."""
        key = structure(node)
        if key in self.names:
            return self.names[key]
        whole = len(path) == 1
        if not whole and (name := self.owned_elsewhere(key)):
            return name
        name = self.names[key] = self.root if whole else self.class_name(node, path)
        if not whole:
            self.structures.owners[key] = (self.name, name)
        required = set(node.get("required", ()))
        fields, table, units = [], [], []
        for field, part in node["properties"].items():
            attribute = identifier(field)
            if attribute in (TAKEN if whole else TAKEN_OF_PART):
                attribute += "_"
            kind, convert = self.value(part, path + (field,))
            unit = unit_of(part)
            if kind == "FloatArray" and unit:
                units.append((attribute, unit))
            if field not in required:
                kind = f"Optional[{kind}]"
            self.used |= set(re.findall(r"\w+", kind))
            shown = sentence(part.get("description", ""))
            if unit not in ("", "1") and len(self.structures.units[key][field]) == 1:
                shown = f"{shown} [{unit}]".strip()
            if kind.startswith("Optional") and "if left out" not in shown:
                shown = f"{shown}; None if absent".lstrip("; ")
            fields.append((attribute, kind, shown))
            table.append((field, attribute, convert))
        doc = sentence(node.get("description", "")) or f"the field `{path[-1]}`"
        doc = RESULT_DOC.format(self.command and self.command["name"]) if whole else doc[:1].upper() + doc[1:] + "."
        text = [f"@dataclass(frozen=True, eq=False, repr=False)\nclass {name}({'Result' if whole else 'Part'}):",
                wrapped(f'"""{doc}"""', "    "), ""]
        for attribute, kind, shown in fields:
            text.append(f"    {attribute}: {kind}")
            if shown:
                text.append(wrapped(f'"""{shown}"""', "    "))
        text.append("")
        if whole:
            documents = ", ".join(json.dumps(one) for one in self.command["documents"])
            comma = "," if len(self.command["documents"]) == 1 else ""
            text.append(f"    command: ClassVar[str] = {json.dumps(self.command['name'])}")
            text.append(wrapped(f"documents: ClassVar[tuple[str, ...]] = ({documents}{comma})", "        ", "    "))
        text.append("    _fields: ClassVar[dict[str, tuple[str, Converter]]] = {")
        text += [f"        {json.dumps(field)}: ({json.dumps(attribute)}, {convert}),"
                 for field, attribute, convert in table]
        text.append("    }")
        if units:
            text.append("    _units: ClassVar[dict[str, str]] = {\n"
                        + "".join(f"        {json.dumps(a)}: {json.dumps(u)},\n" for a, u in units) + "    }")
        self.written.append("\n".join(text))
        return name

    def text(self):
        up = ".." if self.command else "."
        typing = ["ClassVar"] + [name for name in ("Any", "Literal", "Optional") if name in self.used]
        shared = sorted({"Converter"} | {name for name in SHARED if name in self.used}
                        | ({"Part"} if len(self.written) > bool(self.command) else set()))
        doc = f"The result of the command {self.command['name']}." if self.command else "The evidence that each result has."
        imports = [f"from {up} import parts as _to"]
        if self.command:
            imports.append("from ..answers import Result")
        imports.append(f"from {up}parts import {', '.join(shared)}")
        for module, names in sorted(self.imported.items()):
            parent = "." if self.command else ".results."
            one_line = f"from {parent}{module} import {', '.join(sorted(set(names)))}"
            imports.append(one_line if len(one_line) <= 100 else
                           listed(f"from {parent}{module} import (", sorted(set(names)), ")", ""))
        return (HEAD.format(doc=doc) + "\nfrom __future__ import annotations\n\nfrom dataclasses import dataclass\n"
                + f"from typing import {', '.join(sorted(typing))}\n\n" + "\n".join(imports) + "\n\n\n"
                + "\n\n\n".join(self.written) + "\n")


SHARED = ("AnyArray", "FloatArray", "Part", "Quantity")
RESERVED = set(SHARED) | {"Any", "ClassVar", "Literal", "Optional", "Result", "Converter"}
RESULT_DOC = "What `{}` answers."


def option_type(option):
    if "enum" in option:
        return f"Literal[{', '.join(json.dumps(word) for word in option['enum'])}]"
    if option["type"] == "array":
        return "Sequence[Named]"
    return {"boolean": "bool", "integer": "int", "number": "float", "string": "Named"}[option["type"]]


def function(command, method):
    """The function of a command, or its method of Drive."""
    options = schema("options", command["name"])
    required = options["required"]
    name = identifier(command["name"].replace(" ", "_"))
    result = camel(command["name"]) + "Result"
    module = identifier(command["name"].replace(" ", "_"))
    spelt = []
    spelled_by_name = {name.replace("-", "_"): about for name, about in options["properties"].items()}
    for option, about in sorted(options["properties"].items(), key=lambda one: one[0] not in required):
        kind = option_type(about)
        spelt.append((identifier(option), option, kind if option in required else f"Optional[{kind}]",
                       "" if option in required else " = None", in_python(about["description"], spelled_by_name)))
    first = [f"{spelled}: {kind}" for spelled, option, kind, _, _ in spelt if option in required]
    rest = [f"{spelled}: {kind}{fallback}"
            for spelled, option, kind, fallback, _ in spelt if option not in required]
    rest += ["texts: Optional[Mapping[str, str]] = None", "progress: ShownProgress = None"]
    indent = "    " if method else ""
    head = listed(f"{indent}def {name}(", (["self"] if method else []) + first + ["*"] + rest,
                  f") -> results.{module}.{result}:", "")
    doc = [f'{indent}    """{sentence(command["summary"])}.', "", f"{indent}    Args:"]
    for spelled, _, _, _, about in spelt:
        doc.append(wrapped(f"{spelled}: {sentence(about)}", indent + " " * 12, indent + " " * 8))
    doc.append(wrapped("texts: texts that options name, by their names; an option may also be a "
                       "pathlib.Path, whose file is read", indent + " " * 12, indent + " " * 8))
    doc.append(wrapped("progress: True for a line of progress, or a function that receives the "
                       "completed fraction", indent + " " * 12, indent + " " * 8))
    doc.append(f'{indent}    """')
    runner = "self._run(" if method else "run(None, "
    given = listed("given: dict[str, Any] = {", [f"{json.dumps(option)}: {spelled}"
                                                 for spelled, option, _, _, _ in spelt], "}", "")
    body = [textwrap.indent(f'{given}\nanswer: results.{module}.{result} = '
                            f'{runner}"{command["name"]}", given, texts, progress)\nreturn answer',
                            indent + "    ")]
    return "\n".join([head, *doc, *body])


def commands_text(commands):
    text = [HEAD.format(doc="The commands, as functions and as methods of Drive.")
            + '''
from __future__ import annotations

from typing import Any, Literal, Mapping, Optional, Sequence

import strainwave  # noqa: F401  names the drive among the options, for typing.get_type_hints

from . import results
from .running import Named, ShownProgress, run
''']
    functions = [command for command in commands if command["takes"] != "drive"]
    methods = [command for command in commands if command["takes"] != "nothing"]
    names = [identifier(command["name"].replace(" ", "_")) for command in functions
             if command["name"] != "new"]  # drive.new gives a drive
    text.append("__all__ = [\n" + "".join(f'    "{name}",\n' for name in ["DriveCommands"] + names) + "]\n")
    for command in functions:
        text.append("\n" + function(command, False) + "\n")
    text.append('''
class DriveCommands:
    """The commands that take a drive."""

    def _run(self, command: str, options: Mapping[str, Any], texts: Optional[Mapping[str, str]],
             progress: ShownProgress) -> Any:
        raise NotImplementedError
''')
    for command in methods:
        text.append(function(command, True) + "\n")
    return "\n".join(text)


LAZY = '''else:

    def __getattr__(name: str) -> Any:
        """Imports a module when its name is first used, such as by typing.get_type_hints."""
        try:
            return import_module(f"{__name__}.{name}")
        except ModuleNotFoundError:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}") from None
'''


def written():
    """All files by their paths."""
    commands = _library.commands()
    files = {PACKAGE / "_commands.py": commands_text(commands)}
    schemas = [schema("result", command["name"])["properties"] for command in commands]
    structures = Structures()
    evidence = {"properties": {"verdict": schemas[0]["verdict"], "note": schemas[0]["notes"],
                               "accuracy": schemas[0]["accuracies"]}}
    for node in [evidence] + [one["result"] for one in schemas]:
        structures.collect_units(node)
    files[PACKAGE / "_evidence.py"] = ResultModule("evidence", "Evidence", evidence, structures).text()
    for command, one in zip(commands, schemas):
        name = identifier(command["name"].replace(" ", "_"))
        files[PACKAGE / "results" / f"{name}.py"] = ResultModule(
            name, camel(command["name"]) + "Result", one["result"], structures, command).text()
    modules = sorted(path.stem for path in files if path.parent.name == "results")
    files[PACKAGE / "results" / "__init__.py"] = (
        HEAD.format(doc="The classes of the results, one module for each command.")
        + "\nfrom importlib import import_module\nfrom typing import TYPE_CHECKING, Any\n\n"
        + "if TYPE_CHECKING:\n    from . import (\n"
        + "".join(f"        {name} as {name},\n" for name in modules) + "    )\n" + LAZY)
    return files


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    files = written()
    stale = [path for path in (PACKAGE / "results").glob("*.py") if path not in files]
    if sys.argv[1:] == ["--check"]:
        wrong = [path for path, text in files.items() if not path.exists() or path.read_text() != text]
        for path in wrong[:1]:
            old = path.read_text().splitlines() if path.exists() else []
            print("\n".join(list(difflib.unified_diff(old, files[path].splitlines(), "in the tree",
                                                     "from the library", lineterm=""))[:40]))
        if wrong or stale:
            sys.exit("These files differ from what the library describes: "
                     + ", ".join(str(path.relative_to(ROOT)) for path in wrong + stale)
                     + ". Run tools/write_python.py without --check.")
        return
    (PACKAGE / "results").mkdir(exist_ok=True)
    for path, text in files.items():
        path.write_text(text)
    for path in stale:
        path.unlink()


if __name__ == "__main__":
    main()
