# SPDX-License-Identifier: Apache-2.0
"""Executes the notebooks in examples/notebooks as Jupyter does.  They are stored without output, and the
last cell of code of each asserts a number.  The environment variable STRAINWAVE_NOTEBOOKS names a folder that keeps
them with their outputs, for tools/render_site."""

import ast
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from support import NOTEBOOKS, code_cells, main, missing


def outputs(notebook):
    """The outputs of each cell of code."""
    return [cell.get("outputs", []) for cell in code_cells(notebook)]


def asserted_numbers(source):
    """The numbers with which an `assert` compares at its top level; a comparison with 0 tells only a sign."""
    found = []
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Assert) and isinstance(node.test, ast.Compare):
            for side in (node.test.left, *node.test.comparators):
                try:
                    value = ast.literal_eval(side)
                except ValueError:
                    continue
                if isinstance(value, (int, float)) and not isinstance(value, bool) and value != 0:
                    found.append(value)
    return found


@unittest.skipIf(missing("pandas"), missing("pandas"))
@unittest.skipIf(missing("nbconvert"), missing("nbconvert"))
@unittest.skipIf(missing("ipykernel"), missing("ipykernel"))
class Notebooks(unittest.TestCase):
    def test_input_stored_without_output_and_ending_with_an_asserted_number(self):
        self.assertEqual(len(NOTEBOOKS), 8)
        for notebook in NOTEBOOKS:
            with self.subTest(notebook.name):
                self.assertFalse(any(outputs(notebook)), "is stored with output")
                last = "".join(code_cells(notebook)[-1]["source"])
                self.assertTrue(asserted_numbers(last), "its last cell of code asserts no number")

    def test_input_what_counts_as_an_asserted_number(self):
        self.assertEqual(asserted_numbers("assert -0.05 < change < -0.02"), [-0.05, -0.02])
        for source in ("x = 5", "assert x > 0", "assert x is not None", "assert all(x > 5 for x in y)"):
            self.assertEqual(asserted_numbers(source), [], source)

    def test_behaviour_each_notebook_runs_and_shows_pictures_that_are_pictures(self):
        with tempfile.TemporaryDirectory() as temporary:
            folder = os.environ.get("STRAINWAVE_NOTEBOOKS", temporary)
            ended = subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute",
                                    "--output-dir", folder, *map(str, NOTEBOOKS)],
                                   capture_output=True, text=True, check=False)
            self.assertEqual(ended.returncode, 0, ended.stderr)
            pictures = 0
            for notebook in NOTEBOOKS:
                made = outputs(pathlib.Path(folder, notebook.name))
                self.assertTrue(any(made), f"{notebook.name} shows nothing")
                for output in sum(made, []):
                    self.assertNotEqual(output["output_type"], "error")
                    picture = "".join(output.get("data", {}).get("image/svg+xml", ""))
                    if picture:
                        self.assertTrue(xml.etree.ElementTree.fromstring(picture).tag.endswith("svg"))
                        pictures += 1
            self.assertGreaterEqual(pictures, 7)


if __name__ == "__main__":
    main()
