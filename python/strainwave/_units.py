# SPDX-License-Identifier: Apache-2.0
"""SI units of the fields and of the outputs of a drive, as the command explain states them."""

from __future__ import annotations

import re

from ._commands import explain
from .errors import OptionError

_known: dict[str, str] = {}  # unit of a field or an output by its path without indices


def unit_of(path: str) -> str:
    """SI unit of the field or the output with this path; "1" for a number without a unit."""
    bare = re.sub(r"\[[^]]*\]", "", re.sub(r'^material\.("[^"]*"|[^.]*)', "material.NAME", path))
    if bare not in _known:
        # An output of a crack, such as output_shaft.crack[0].strength.K, is explained with those of
        # all cracks.
        texts = _explained(bare) or _explained(re.sub(r"^\w+\.crack\.", "cracks.", bare))
        found = [match.group(1) for match in (re.search(r"; in ([^;]+)(;|$)", one) for one in texts)
                 if match]
        _known[bare] = found[0] if found else "1"
    return _known[bare]


def _explained(path: str) -> list[str]:
    """What the command explain says about a path; empty if it does not know the path."""
    try:
        return [meaning.text for meaning in explain(path).meanings]
    except OptionError:
        return []
