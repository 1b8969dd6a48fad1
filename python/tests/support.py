# SPDX-License-Identifier: Apache-2.0
"""Paths and helpers of the tests.  ctest sets PYTHONPATH, STRAINWAVE_LIBRARY and STRAINWAVE_CLI."""

import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
NOTEBOOKS = sorted((EXAMPLES / "notebooks").glob("*.ipynb"))
DATA = ROOT / "tests" / "data"
CLI = os.environ.get("STRAINWAVE_CLI", str(ROOT / "build" / "release" / "apps" / "cli" / "strainwave"))


def trials():
    """Options of each command that show its result at little cost: pairs of command and JSON."""
    lines = (DATA / "command_trials.txt").read_text().splitlines()
    return [re.match(r"([a-z ]+) (\{.*)", line).groups() for line in lines
            if line and not line.startswith("#")]


def code_cells(notebook):
    return [cell for cell in json.loads(notebook.read_text())["cells"] if cell["cell_type"] == "code"]


def python(code, *arguments, timeout=120, **options):
    """Runs a program in another interpreter, for at most a time in seconds."""
    return subprocess.run([sys.executable, "-c", code, *arguments], capture_output=True, text=True,
                          timeout=timeout, check=False, **options)


def missing(module):
    """Reason to skip a test that needs an optional module; empty if the module is there."""
    try:
        __import__(module)
    except ImportError:
        return f"{module} is not installed"
    return ""


main = unittest.main
