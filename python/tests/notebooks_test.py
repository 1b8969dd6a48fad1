# SPDX-License-Identifier: Apache-2.0
"""Runs the code of the notebooks in examples/notebooks, each in an interpreter of its own.  They are
stored without output, and each asserts a number."""

import json
import unittest

from support import EXAMPLES, main, missing, python

NOTEBOOKS = sorted((EXAMPLES / "notebooks").glob("*.ipynb"))


@unittest.skipIf(missing("pandas"), missing("pandas"))
class Notebooks(unittest.TestCase):
    def test_behaviour_each_notebook_runs_and_keeps_its_assertion(self):
        self.assertEqual(len(NOTEBOOKS), 8)
        for notebook in NOTEBOOKS:
            with self.subTest(notebook.name):
                cells = json.loads(notebook.read_text())["cells"]
                code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
                for cell in cells:
                    self.assertFalse(cell.get("outputs"), "is stored with output")
                self.assertTrue(any("assert " in one for one in code))
                ended = python("\n".join(code), cwd=notebook.parent)
                self.assertEqual(ended.returncode, 0, ended.stderr)


if __name__ == "__main__":
    main()
