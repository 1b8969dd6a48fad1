# SPDX-License-Identifier: Apache-2.0
"""Runs the examples of docs/guide/python.md in the folder of the examples."""

import doctest
import os
import re
import unittest

from support import EXAMPLES, ROOT, main

OPTIONS = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


class Guide(unittest.TestCase):
    def test_behaviour_the_examples_print_what_the_page_says(self):
        text = (ROOT / "docs" / "guide" / "python.md").read_text()
        text = re.sub(r"^```.*$", "", text, flags=re.M)  # a fence is no output
        examples = doctest.DocTestParser().get_doctest(text, {}, "python.md", "python.md", 0)
        self.assertGreater(len(examples.examples), 30)
        before = os.getcwd()
        os.chdir(EXAMPLES)
        try:
            failed = doctest.DocTestRunner(optionflags=OPTIONS).run(examples).failed
        finally:
            os.chdir(before)
        self.assertEqual(failed, 0)


if __name__ == "__main__":
    main()
