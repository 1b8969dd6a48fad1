"""One table of reference numbers: JSON on stdout and, with --write, tests/data/<noun>.csv.

A row is: case, inputs, value, unit, digits, source.  `digits` counts the significant digits of
`value` that can be trusted as the solution of the stated mathematical problem; it says nothing
about how well a handbook formula describes a real crack.  Numbers are in SI units.
"""
import json
import sys
from pathlib import Path

from mpmath import mp

mp.dps = 40
DATA = Path(__file__).resolve().parents[2] / "tests" / "data"


def number(x, digits=17):
    """Decimal text of x; text (also the empty cell of an input that does not apply) is kept."""
    return x if isinstance(x, str) else mp.nstr(mp.mpf(x), digits)


class Table:
    def __init__(self, noun, *inputs):
        self.noun = noun
        self.header = ["case", *inputs, "value", "unit", "digits", "source"]
        self.rows = []

    def add(self, case, inputs, value, unit, source, digits=17, printed=17):
        row = [case, *map(number, inputs), number(value, printed), unit, str(digits), source]
        assert len(row) == len(self.header) and not any("," in cell for cell in row), row
        self.rows.append(row)

    @property
    def path(self):
        return DATA / f"{self.noun}.csv"

    def csv(self):
        return "".join(",".join(row) + "\n" for row in [self.header, *self.rows])

    def json(self):
        def cell(text):
            try:
                return float(text)
            except ValueError:
                return text
        rows = [dict(zip(self.header, map(cell, row))) for row in self.rows]
        return {"noun": self.noun, "rows": rows}


def publish(*tables):
    print(json.dumps([table.json() for table in tables], indent=1))
    if "--write" in sys.argv[1:]:
        DATA.mkdir(parents=True, exist_ok=True)
        for table in tables:
            table.path.write_text(table.csv(), encoding="ascii", newline="\n")
