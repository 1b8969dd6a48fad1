# SPDX-License-Identifier: Apache-2.0
"""Runs the examples in the docstrings of the package in the folder of the examples."""

import doctest
import importlib
import inspect
import os
import pkgutil
import unittest

import strainwave as sw
from support import EXAMPLES, main, missing

OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
# Methods with an example that needs a package which may be missing.
NEEDS = {"plot": "matplotlib", "to_frame": "pandas"}
# What a reader looks up first has an example.
SHOWN = (sw.Drive, sw.Drive.edit, sw.Drive.batch, sw.Cracks.append, sw.read, sw.parse, sw.new, sw.Quantity,
         sw.Result.plot, sw.Result.to_frame, sw.BatchResult, sw.InputError, type(sw.sif["tube-through-inclined"]))


def modules():
    """The package and its modules that are written by hand."""
    yield sw
    for found in pkgutil.iter_modules(sw.__path__, "strainwave."):
        if not found.name.rpartition(".")[2].startswith("_") and not found.ispkg:
            yield importlib.import_module(found.name)


class Docstrings(unittest.TestCase):
    def test_behaviour_the_examples_print_what_they_say(self):
        before = os.getcwd()
        os.chdir(EXAMPLES)
        try:
            for module in modules():
                for test in doctest.DocTestFinder(exclude_empty=True).find(module):
                    reason = missing(NEEDS.get(test.name.rpartition(".")[2], "os"))
                    if test.examples and not reason:
                        with self.subTest(test.name):
                            said = []
                            runner = doctest.DocTestRunner(optionflags=OPTIONS)
                            self.assertEqual(runner.run(test, out=said.append).failed, 0, "".join(said))
        finally:
            os.chdir(before)

    def test_behaviour_what_is_looked_up_first_has_an_example(self):
        for value in SHOWN:
            self.assertIn(">>> ", inspect.getdoc(value), value.__qualname__)


if __name__ == "__main__":
    main()
