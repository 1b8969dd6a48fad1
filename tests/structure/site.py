#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Renders the site, follows its links, and asks its search.

    STRAINWAVE_LIBRARY=... tests/structure/site.py FOLDER    render the site into FOLDER and check it
    tests/structure/site.py --self-test                      break each rule of a site once

The search is asked only if node is installed.
"""

import importlib.machinery
import importlib.util
import pathlib
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
    return unseen


def check(folder):
    module = tool()
    module.render(folder)
    faults = module.faults_of(folder)
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
