#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Renders the site, follows its links, and asks its search.

    STRAINWAVE_LIBRARY=... tests/structure/site.py FOLDER    render the site into FOLDER and check it
    tests/structure/site.py --self-test                      break each rule of a site once

The search is asked only if node is installed.  Environment: STRAINWAVE_LIBRARY, STRAINWAVE_CLI.
"""

import importlib.machinery
import importlib.util
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def tool():
    loader = importlib.machinery.SourceFileLoader("render_site", str(ROOT / "tools" / "render_site"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("render_site", loader))
    loader.exec_module(module)
    return module


def self_test():
    sound = {"index.html": '<p id="a"><a href="b.html#c">b</a></p>', "b.html": '<h1 id="c">c</h1>',
             "search_index.js": 'const searchIndex = [{"n":["c"],"u":"b.html#c"}];\n'}
    broken = [
        ("a page that is not there", {"index.html": '<a href="d.html">d</a>'}, "dead link d.html"),
        ("an address that is not there", {"b.html": "<h1>c</h1>"}, "dead link b.html#c"),
        ("an entry that leads nowhere", {"search_index.js": 'const searchIndex = [{"n":["e"],"u":"e.html"}];\n'},
         "dead entry e"),
        ("an element that stays open", {"b.html": '<div><h1 id="c">c</h1>'}, "<div> stays open"),
        ("an element that closes another", {"b.html": '<div><h1 id="c">c</div></h1>'}, "</div> closes nothing"),
        ("an address twice", {"b.html": '<h1 id="c">c</h1><p id="c"></p>'}, "two elements have the address c"),
        ("a picture without text", {"b.html": '<h1 id="c">c</h1><img src="b.html">'}, "has no text"),
        ("too large a site", {"large.bin": "x" * 25_000_001}, "more than 25 MB"),
    ]
    unseen = 0
    for name, files, part in [("nothing", {}, "")] + broken:
        with tempfile.TemporaryDirectory() as folder:
            for file, text in {**sound, **files}.items():
                pathlib.Path(folder, file).write_text(text)
            faults = tool().faults_of(pathlib.Path(folder))
        if bool(faults) != bool(part) or not any(part in fault for fault in faults + [""]):
            print(f"{name}: reported {faults}")
            unseen += 1
    with tempfile.TemporaryDirectory() as folder:
        theory = pathlib.Path(folder, "docs", "theory")
        theory.mkdir(parents=True)
        (theory / "FR.md").write_text("### (FR-1) One {#FR-1}\n\n### (FR-2) Two {#FR-2}\n")
        (theory / "FR.html").write_text('<h3 id="FR-1">One</h3><h3 id="FR-2">Two</h3>')
        (theory / "manual.html").write_text('<p id="FR-1"></p>')
        faults = tags_without_address(pathlib.Path(folder), theory)
        if faults != ["docs/theory/manual.html: has no address FR-2"]:
            print(f"an equation without an address: reported {faults}")
            unseen += 1
    return unseen


def tags_without_address(folder, theory=ROOT / "docs" / "theory"):
    """Equations of the manual that have no address in the page of their chapter, or in the page of contents."""
    faults = []
    for source in sorted(theory.glob("*.md")):
        tags = re.findall(r"^#+ \([A-Z]{2}-\d+[a-z]?\).*\{#([\w-]+)\}", source.read_text(encoding="utf-8"), re.M)
        for page in (f"{source.stem}.html", "manual.html"):
            known = tool().Page((folder / "docs" / "theory" / page).read_text(encoding="utf-8")).addresses
            faults += [f"docs/theory/{page}: has no address {tag}" for tag in tags if tag not in known]
    return faults


def pages_without_rows(folder):
    """Pages that are made of tables and hold less than they must."""
    least = (("verification.html", 'id="table-', 50), ("notes.html", "docs/theory/", 60), ("libraries.html", 'id="record-', 10),
             ("python_results.html", "<h2", 30), ("commands/fe_run.html", 'id="result-', 50), ("commands/fe_run.html", 'id="option-', 5),
             ("commands/merge.html", 'id="option-', 5), ("commands/man.html", 'id="option-', 3), ("commands/completion.html", 'id="option-', 3))
    counted = [(page, mark, (folder / page).read_text(encoding="utf-8").count(mark), count) for page, mark, count in least]
    return [f"{page}: has {found} times {mark}, less than {count}" for page, mark, found, count in counted if found < count]


def check(folder):
    module = tool()
    module.render(folder)
    faults = module.faults_of(folder) + tags_without_address(folder) + pages_without_rows(folder)
    for fault in faults:
        print(fault)
    node = shutil.which("node") or shutil.which("nodejs")
    if node:
        asked = subprocess.run([node, str(ROOT / "tests" / "structure" / "site_search.js"), str(folder)], check=False)
        return len(faults) + asked.returncode
    print("the search was not asked: node is not installed")
    return len(faults)


sys.dont_write_bytecode = True
if sys.argv[1:] == ["--self-test"]:
    sys.exit(1 if self_test() else 0)
elif len(sys.argv) == 2 and not sys.argv[1].startswith("-"):
    sys.exit(1 if check(pathlib.Path(sys.argv[1])) else 0)
sys.exit(__doc__)
