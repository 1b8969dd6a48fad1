"""Rerun the fast generators and require the tables in tests/data to be byte-equal.

The scripts of IN_DOUBLE compute in double precision: some of their rows are rerun and must agree with
the file to the digits it states.  The tables of annular_hollow.py (minutes, floating point) and reliability.py
(OpenTURNS, which ./check does not install) are not rerun.  Exit status 0 equal, 1 different, 77 mpmath, numpy or scipy not installed (a skipped test).
"""
import importlib
import sys

GENERATORS = ("annular_shaft", "article_example", "body_cracks", "collinear_cracks", "edge_crack",
              "failure_assessment", "hertz_contact", "inclined_edge_crack", "library_curves", "newman_raju",
              "surface_crack", "through_crack", "tube_and_diaphragm")
IN_DOUBLE = ("annular_cracks", "annular_modes", "circumferential_crack", "coupled_drive", "crack_growth", "crack_rows", "cracked_block", "cracked_ring",
             "cracked_strip", "detection_fit", "drive_life", "flexspline_shell", "friction_loop", "gradient", "growth_scatter", "laminate", "laminate_wall", "scattered_paths", "shell_crack",
             "tooth_gap",
             "weight_function")


def difference(table):
    """None, or the first line that differs."""
    if not table.path.exists():
        return "no such file"
    ours, file = table.csv().encode(), table.path.read_bytes()
    if ours == file:
        return None
    pairs = zip(ours.splitlines(), file.splitlines())
    line = next((n for n, (a, b) in enumerate(pairs, 1) if a != b), "last")
    return f"differs from line {line}"


def difference_in_digits(table):
    """None, or the first row that is not in the file or has another value there."""
    def keyed(lines):
        rows = [line.rsplit(",", 4) for line in lines]
        return {row[0]: row[1:] for row in rows}

    if not table.path.exists():
        return "no such file"
    file = keyed(table.path.read_text(encoding="ascii").splitlines())
    for key, (value, *rest) in keyed(table.csv().splitlines()[1:]).items():
        if key not in file or file[key][1:] != rest:
            return f"has no such row: {key}"
        theirs = float(file[key][0])
        if abs(float(value) - theirs) > abs(theirs) * 0.5 * 10 ** (1 - int(rest[1])):
            return f"differs in {key}: {value} and {theirs}"
    return None


def main():
    for package in ("mpmath", "numpy", "scipy"):
        try:
            importlib.import_module(package)
        except ImportError:
            print(f"{package} is not installed: nothing checked")
            return 77
    different = 0
    for name in GENERATORS:
        for table in importlib.import_module(name).tables():
            problem = difference(table)
            different += problem is not None
            print(f"{table.path.name}: {problem or 'equal'}", flush=True)
    in_double = []
    for name in IN_DOUBLE:
        generator = importlib.import_module(name)
        in_double += getattr(generator, "some_tables", generator.tables)()
    for table in in_double:
        problem = difference_in_digits(table)
        different += problem is not None
        print(f"{table.path.name}: {problem or 'equal to its digits'}", flush=True)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
