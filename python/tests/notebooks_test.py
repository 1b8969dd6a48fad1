# SPDX-License-Identifier: Apache-2.0
"""Executes the notebooks in examples/notebooks as Jupyter does.  They are stored without output, and each
asserts a number."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

from support import EXAMPLES, main, missing

NOTEBOOKS = sorted((EXAMPLES / "notebooks").glob("*.ipynb"))


def outputs(notebook):
    """The outputs of each cell of code."""
    return [cell.get("outputs", []) for cell in json.loads(notebook.read_text())["cells"]
            if cell["cell_type"] == "code"]


@unittest.skipIf(missing("pandas"), missing("pandas"))
@unittest.skipIf(missing("nbconvert"), missing("nbconvert"))
@unittest.skipIf(missing("ipykernel"), missing("ipykernel"))
class Notebooks(unittest.TestCase):
    def test_input_stored_without_output_and_with_an_assertion(self):
        self.assertEqual(len(NOTEBOOKS), 8)
        for notebook in NOTEBOOKS:
            with self.subTest(notebook.name):
                self.assertFalse(any(outputs(notebook)), "is stored with output")
                self.assertIn("assert ", notebook.read_text())

    def test_behaviour_each_notebook_runs_and_shows_pictures_that_are_pictures(self):
        with tempfile.TemporaryDirectory() as folder:
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
