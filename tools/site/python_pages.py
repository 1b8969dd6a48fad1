# SPDX-License-Identifier: Apache-2.0
"""The reference of the Python package: what `strainwave.__all__` names, and the classes of the results."""

import ast
import importlib
import inspect
import pathlib
import re

from pages import escape, table


def write(site, sw):
    """The page of the package, and that of the results."""
    body = ['<h1>Python reference</h1><p><a href="docs/guide/python.html">The guide</a> explains the package by examples. '
            '<a href="python_results.html">The classes of the results</a> have a page.</p>']
    named = {f"sw.{name}": getattr(sw, name) for name in sorted(sw.__all__, key=str.lower) if not name.startswith("_")}
    # What the mapping sw.sif gives is public, although the package does not export its class.
    named["Solution"] = importlib.import_module("strainwave.tables").Solution
    for name, value in named.items():
        if isinstance(value, (str, tuple)):
            continue
        bare = name.removeprefix("sw.")
        body.append(member(name, value, 2))
        site.enter("python", name, f"python.html#{name}", inspect.getdoc(value) or "", [bare])
        if inspect.isclass(value):
            fields = fields_of(value)
            if fields:
                body.append(table(("field", "type", "meaning"), [(None, *row) for row in fields]))
            for inner, part in inspect.getmembers(value):
                if not (inspect.isfunction(part) or isinstance(part, property)) \
                        or inner.startswith("_") and not (inner == "__call__" and inner in value.__dict__):
                    continue
                if issubclass(value, Exception) or inner not in value.__dict__ and value is not sw.Drive:
                    continue
                body.append(member(f"{bare}.{inner}", part, 3))
                site.enter("python", f"{bare}.{inner}", f"python.html#{bare}.{inner}", inspect.getdoc(part) or "", [inner])
    site.write("python.html", "Python reference", "\n".join(body))
    results(site, sw)


def member(name, value, level):
    """A function, a class or a property with its docstring."""
    signature = ""
    if callable(value):
        try:
            signature = re.sub(r"['\"]", "", str(inspect.signature(value)))
        except ValueError:
            pass
    spelled = re.sub(r"results\.(\w+?)_?\.(\w+Result)", r'<a href="python_results.html#\2">\2</a>',
                     escape(name.rpartition(".")[2] + signature))
    return (f'<h{level} id="{escape(name)}"><code>{escape(name)}</code></h{level}>'
            f"<pre class='signature'>{spelled}</pre>"
            f"<pre class='docstring'>{escape(inspect.getdoc(value) or '')}</pre>")


def fields_in(node, link=escape):
    """(name, type, meaning) of the fields of a class: each has a text below it."""
    rows = []
    for one, after in zip(node.body, node.body[1:]):
        if isinstance(one, ast.AnnAssign) and isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant):
            rows.append((f"<code>{escape(one.target.id)}</code>", f"<code>{link(ast.unparse(one.annotation))}</code>",
                         escape(" ".join(after.value.value.split()))))
    return rows


def fields_of(value):
    """The fields of one class of the package."""
    source = ast.parse(inspect.getsource(inspect.getmodule(value)))
    return next((fields_in(node) for node in source.body if isinstance(node, ast.ClassDef) and node.name == value.__name__), [])


def results(site, sw):
    """The classes of the results, with their fields; the class of a part links to its own table."""
    folder = pathlib.Path(sw.__file__).parent / "results"
    body = ['<h1>Results in Python</h1><p>A result is an object of the class of its command. Each result also has '
            'the members of <a href="python.html#sw.Result"><code>Result</code></a>, and each part of a result those of '
            '<a href="python.html#sw.Part"><code>Part</code></a>.</p>']
    for file in sorted(folder.glob("*.py")):
        classes = {node.name: node for node in ast.parse(file.read_text(encoding="utf-8")).body if isinstance(node, ast.ClassDef)}
        whole = next((name for name in reversed(classes) if name.endswith("Result")), None)
        if whole is None:  # __init__.py
            continue

        def address(name, whole=whole):
            return name if name == whole else f"{whole}.{name}"

        def link(spelled, classes=classes, address=address):
            return re.sub(r"\w+", lambda word: f'<a href="#{address(word.group(0))}">{word.group(0)}</a>'
                          if word.group(0) in classes else word.group(0), escape(spelled))

        for name in [whole, *(one for one in classes if one != whole)]:
            node = classes[name]
            about = ast.get_docstring(node) or ""
            rows = fields_in(node, link)
            level = 2 if name == whole else 3
            body.append(f'<h{level} id="{address(name)}"><code>{name}</code></h{level}><p>{escape(about)}</p>'
                        + table(("field", "type", "meaning"), [(None, *row) for row in rows]))
            if name == whole:
                names = " ".join(re.sub("<[^>]+>", "", row[0]) for row in rows)
                site.enter("python", name, f"python_results.html#{name}", f"{about} {names}")
    site.write("python_results.html", "Results in Python", "\n".join(body))
