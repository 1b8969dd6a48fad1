# SPDX-License-Identifier: Apache-2.0
"""What the numbers were held against: reference tables, finite elements, makers' tables, the article."""

import csv
import re
import shutil
import statistics
import tempfile

from command_pages import printed, program
from pages import MANUAL, ROOT, escape, headings, pandoc, plain, table

DATA = ROOT / "tests" / "data"
README = ROOT / "tools" / "reference" / "README.md"


def tables_of_numbers():
    """(name, rows) of each table of reference numbers."""
    for file in sorted(DATA.glob("*.csv")):
        with file.open(encoding="utf-8", newline="") as lines:
            yield file.stem, list(csv.DictReader(lines))


def contents():
    """What the tables hold, as the page of their generators says: {table: HTML}."""
    found = {}
    for row in re.findall(r"^\|([^|\n]*)\|([^|\n]*)\|([^|\n]*)\|([^|\n]*)\|$", README.read_text(encoding="utf-8"), re.M):
        for name in re.findall(r"`(\w+)`", row[1]):
            found[name] = pandoc(row[2].strip()).strip().removeprefix("<p>").removesuffix("</p>")
    return found


def tests_of():
    """The tests that read a table, by the name of the table."""
    found = {}
    for file in sorted((ROOT / "tests").rglob("*_test.cpp")):
        for name in set(re.findall(r'"(\w+)(?:\.csv)?"', file.read_text(encoding="utf-8"))):
            found.setdefault(name, []).append(file.relative_to(ROOT / "tests").as_posix())
    return found


def spelled(digits):
    """Half a unit of the last trusted digit, relative, as the tests compute it (tests/support/reference_csv.hpp)."""
    return f"{0.5 * 10 ** (1 - digits):.0e}".replace("e-0", "e-")


def tolerance(rows):
    digits = [int(row["digits"]) for row in rows]
    return " to ".join(spelled(count) for count in sorted({max(digits), min(digits)}, reverse=True))


def markdown_tables(text):
    """(title, head, rows) of each table of a tool's output."""
    title, head, rows = "", None, []
    for line in [*text.splitlines(), ""]:
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if not line.startswith("|"):
            if head:
                yield title, head, rows
            title, head, rows = line.strip() or title, None, []
        elif head is None:
            head = cells
        elif not set(line) <= set("|-: "):
            rows.append(cells)


def number(cell):
    return float(cell) if re.fullmatch(r"[+-]?[\d.]+", cell) else None


def differences(head, rows):
    """(name of the column, number of values, median, largest magnitude) of the columns of differences: they stand behind
    those of the inputs, and the first of them has signs."""
    begun = False
    for place, name in enumerate(head):
        given = [row[place] for row in rows if place < len(row) and row[place]]
        begun = begun or any(number(cell) is not None and cell.startswith(("+", "-")) for cell in given)
        if begun:
            sizes = [abs(number(cell)) for cell in given]
            yield name, len(sizes), statistics.median(sizes), max(sizes)


def judgements():
    """(title, head, rows) of the closed forms over finite elements, and of K over a turn."""
    cli = program()
    yield from markdown_tables(printed(ROOT / "tools" / "judge_closed_forms.py", "table", "--program", cli))
    with tempfile.TemporaryDirectory() as work:
        answer = printed(ROOT / "tools" / "judge_turns.py", "table", "--program", cli, "--work", work)
    for _, head, rows in markdown_tables(answer):
        yield "judgement_turn: K over a turn, closed form over finite elements, - 1 in per cent", head, rows


def write(site, sw):
    """The page, with the tables of numbers beside it."""
    folder = site.folder / "tests" / "data"
    folder.mkdir(parents=True, exist_ok=True)
    about, tests = contents(), tests_of()
    summary, body = [], []

    numbers = dict(tables_of_numbers())
    rows = []
    for name, given in numbers.items():
        shutil.copy(DATA / f"{name}.csv", folder)
        sources = sorted({row["source"].partition(";")[0] for row in given})
        what = about.get(name, "; ".join(map(escape, sources[:3])))
        readers = "<br>".join(one.removesuffix("_test.cpp").replace("/", "/<wbr>") for one in tests.get(name, ()))
        rows.append((f"table-{name}", f'<a href="tests/data/{name}.csv">{name}</a>', what, len(given), tolerance(given), readers))
        site.enter("verification", name, f"verification.html#table-{name}", " ".join([plain(what), *sources]))
    judged = [name for name in numbers if name.startswith("judgement_")]
    independent = [row for name, given in numbers.items() if name not in judged for row in given]
    summary.append(('<a href="#references">Reference numbers</a> of scripts that never call strainwave',
                    f"{len(independent)} in {len(numbers) - len(judged)} tables", f"relative tolerance {tolerance(independent)}, median {spelled(statistics.median(int(row['digits']) for row in independent))}"))
    body.append("<h2 id=\"references\">Reference numbers</h2><p>Scripts of <code>tools/reference</code> write these tables. They share no code "
                "with strainwave, and take another road wherever there is one. Finite elements of <code>strainwave fe</code> write the tables "
                "<code>judgement_…</code>. A number counts as many digits as can be trusted; the relative tolerance of a table is half a unit "
                "of the last of them. The tests in the last column read the table. A test may allow more, where the method that it "
                "tests states a larger uncertainty.</p>"
                + table(("table", "contents", "values", "relative tolerance", "tests"), rows))

    body.append("<h2 id=\"judgement\">Closed forms over finite elements</h2><p>The differences are closed form over finite elements, minus 1, in "
                "per cent; those of K through the wall of a through crack are in per cent of τ√(πa). The comparison includes cracks outside the range that a closed form "
                f'states. <a href="{site.theory["FE-1"].partition("#")[0]}#judgement">The manual</a> says what limits each of them.</p>')
    for title, head, given in judgements():
        name, _, words = title.partition(": ")
        found = [one for one in differences(head, given) if one[0] != "factor"]
        rows = [(None, pandoc(column.replace("_", "\\_") if "$" not in column else column).strip().removeprefix("<p>").removesuffix("</p>"), count, f"{median:.2g}", f"{most:.2g}")
                for column, count, median, most in found]
        body.append(f'<h3 id="{escape(name)}">{escape(name)}</h3><p>{escape(words)}: {len(given)} cracks or members.</p>'
                    + table(("quantity", "values", "median |difference| [%]", "largest |difference| [%]"), rows))
        columns = "; ".join(f"{row[1]} {row[3]} / {row[4]}" for row in rows)
        summary.append((f'<a href="#{escape(name)}">{escape(name)}</a>: finite elements of <code>strainwave fe</code>',
                        sum(one[1] for one in found), f"median / largest difference in per cent: {columns}"))

    errors = sw.validate().errors.to_dict()
    differing = [name for name in errors if name.startswith(("median", "worst"))]
    rows = [(None, escape(of), values, *("-" if one is None else f"{100 * one:.1f}" for one in others)) for of, values, *others in zip(
        *(errors[name]["values"] for name in ("of", "values", *differing)))]
    body.append("<h2 id=\"makers\">Torsion curve over the makers' tables</h2><p><a href=\"commands/validate.html\"><code>strainwave "
                "validate</code></a> compares K1, K2 and K3 of typical drives with the catalogues; no factor is fitted.</p>"
                + table(("rows of", "values", *(name.replace("_", " |error| of ") + ("" if "_" in name else " |error|") + " [%]"
                                                for name in differing)), rows))
    whole = {name: column["values"][0] for name, column in errors.items()}
    summary.append(("<a href=\"#makers\">Stiffness in the makers' tables</a>, no factor fitted", whole["values"],
                    f"median {100 * whole['median']:.1f} %, worst {100 * whole['worst']:.0f} %"))

    verdicts = {}
    audit = sw.audit().rows
    for row in audit:
        verdicts[row.verdict] = verdicts.get(row.verdict, 0) + 1
    counted = "; ".join(f"{count} {escape(word)}" for word, count in sorted(verdicts.items(), key=lambda one: -one[1]))
    manual = MANUAL.rpartition("/")[0] + "/90_audit.html"
    body.append(f"<h2 id=\"article\">The article</h2><p><a href=\"{manual}\">The audit</a> recomputes {len(audit)} numbers and equations of the "
                f"article on which the project is based: {counted}.</p>")
    summary.append(("<a href=\"#article\">Numbers and equations of the article</a>", len(audit), counted))

    accuracies = [(None, f'<a href="libraries.html#sif-{escape(one.name)}"><code>{escape(one.name)}</code></a>',
                   escape(sw.sif_show(one.name).accuracy)) for one in sw.sif_list().solutions]
    body.append("<h2 id=\"solutions\">Stated accuracy of stress intensity factors</h2>" + table(("solution", "accuracy"), accuracies))
    summary.append(('<a href="#solutions">Solutions of the library</a> with a stated accuracy', len(accuracies), "in the table"))

    page = ("<h1>Verification</h1><p>What was held against what, with the numbers. All of this page is computed from the tables "
            "and by the program.</p>" + table(("source", "values", "tolerance or difference"), [(None, *row) for row in summary]) + "".join(body))
    site.write("verification.html", "Verification", page)
    site.enter("page", "Verification", "verification.html", plain(page.partition("<h2")[0]), ["what was held against what", "validation"])
    for _, anchor, title, after in headings(page):
        site.enter("verification", title, f"verification.html#{anchor}", after)

