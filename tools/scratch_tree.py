# SPDX-License-Identifier: Apache-2.0
"""Common part of the self-tests of the tree checks: they break each rule once in a scratch tree."""

import pathlib
import tempfile


def unseen_breaks(sound, broken, check):
    """Broken rules that a check does not report.

    sound: {path: text} of a tree without a fault; broken: (name, changes of it, what is reported);
    check: function that lists the faults of a tree.  The text None leaves the file out.
    """
    failures = []
    for name, changes, sentence in [("nothing", {}, None), *broken]:
        with tempfile.TemporaryDirectory() as scratch:
            root = pathlib.Path(scratch)
            for path, text in {**sound, **changes}.items():
                if text is not None:
                    (root / path).parent.mkdir(parents=True, exist_ok=True)
                    (root / path).write_text(text)
            faults = check(root)
        if not (any(sentence in fault for fault in faults) if sentence else not faults):
            failures.append(f"broken: {name}; expected: {sentence}; reported: {faults}")
    return failures
