# SPDX-License-Identifier: Apache-2.0
"""A page of the site, the entries of its search, and what its pages are made of."""

import html
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANUAL = "docs/theory/manual.html"
MARKDOWN = "markdown+gfm_auto_identifiers+autolink_bare_uris-tex_math_single_backslash"
NAVIGATION = (("index.html", "Start"), ("docs/guide/index.html", "Guides"), ("commands/index.html", "Commands"),
              ("docs/guide/input_file.html", "Input file"), ("python.html", "Python"), ("cpp/index.html", "C and C++"),
              ("libraries.html", "Libraries"),
              (MANUAL, "Theory"), ("verification.html", "Verification"), ("notes.html", "Notes"),
              ("docs/adr/index.html", "Decisions"),
              ("CHANGELOG.html", "Changelog"))


def escape(text):
    return html.escape(str(text), quote=True)


def identifier(text):
    """A word for an address."""
    return re.sub(r"[^\w.+-]+", "-", text).strip("-")


class Site:
    """The pages and the entries of the search."""

    def __init__(self, folder):
        self.folder = folder
        self.entries = []
        self.theory = {}  # the address of each equation by its tag

    def enter(self, kind, name, url, text="", other=()):
        """An entry of the search: its first name is its title."""
        self.entries.append({"k": kind, "n": [name, *other], "u": url, "t": " ".join(text.split())})

    def tag(self, tag, up=""):
        """The tag of an equation as a link to the equation; as text, if the manual has no such equation."""
        url = self.theory.get(tag)
        return f'<a href="{up}{url}">{escape(tag)}</a>' if url else escape(tag)

    def write(self, path, title, body):
        """A page with the head of all pages."""
        up = "../" * path.count("/")
        links = "".join(f'<a href="{up}{url}">{name}</a>' for url, name in NAVIGATION)
        page = (f'<!DOCTYPE html>\n<html lang="en-GB"><head><meta charset="utf-8"><title>{escape(title)}</title>'
                '<meta name="viewport" content="width=device-width, initial-scale=1">'
                f'<link rel="stylesheet" href="{up}style.css"></head>\n'
                f'<body><header class="site"><a class="name" href="{up}index.html">strainwave</a>'
                f'<input id="search" type="search" placeholder="Search" aria-label="Search all pages" data-up="{up}" '
                f'autocomplete="off"><nav class="site" aria-label="Pages">{links}</nav>'
                '<ol id="found" hidden></ol></header>\n'
                f'<main>\n{body}\n</main>\n<script src="{up}search_index.js"></script>'
                f'<script src="{up}search.js"></script></body></html>\n')
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(page, encoding="utf-8")


def pandoc(text):
    """Markdown as HTML; tables scroll inside a narrow page."""
    made = subprocess.run(["pandoc", "--from", MARKDOWN, "--to", "html5", "--mathml", "--columns=10000", "--wrap=none"],
                          input=text, capture_output=True, text=True, check=True).stdout
    return re.sub(r"(<table.*?</table>)", r'<div class="wide">\1</div>', made, flags=re.S)


def headings(body):
    """(level, id, text, following text) of each heading."""
    for match in re.finditer(r'<h([1-4]) id="([^"]*)"[^>]*>(.*?)</h\1>(.*?)(?=<h[1-4]|\Z)', body, re.S):
        yield int(match.group(1)), match.group(2), plain(match.group(3)), plain(match.group(4))


def plain(text):
    """The text of HTML; a formula is one word."""
    text = re.sub(r"<annotation.*?</annotation>", "", text, flags=re.S)
    text = re.sub(r"<math.*?</math>", lambda formula: re.sub(r"<[^>]+>|\s", "", formula.group(0)), text, flags=re.S)
    return " ".join(html.unescape(re.sub(r"<[^>]+>", " ", text)).split())


def anchored_rows(body, prefix_of):
    """Gives each row of a table, whose first cell is a word, the address `prefix + word`.  Returns
    the page, and the address, the section and the cells of each row."""
    seen = []
    section = ""

    def row(match):
        cells = [plain(cell) for cell in re.findall(r"<td[^>]*>(.*?)</td>", match.group(0), re.S)]
        if not cells or not cells[0]:
            return match.group(0)
        address = identifier(prefix_of(section) + cells[0])
        if any(address == one[0] for one in seen):
            return match.group(0)
        seen.append((address, section, cells))
        return match.group(0).replace("<tr", f'<tr id="{escape(address)}"', 1)

    parts = re.split(r"(<h[1-4][^>]*>.*?</h[1-4]>)", body, flags=re.S)
    for place, part in enumerate(parts):
        if re.match(r"<h[1-4]", part):
            section = plain(part)
        else:
            parts[place] = re.sub(r"<tr[^>]*>(?:(?!</tr>).)*</tr>", row, part, flags=re.S)
    return "".join(parts), seen


def table(head, rows, look=""):
    """An HTML table of escaped cells; a row begins with its address, or with None."""
    lines = "".join(f"<tr{f' id={chr(34)}{escape(address)}{chr(34)}' if address else ''}>"
                    + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>\n" for address, *cells in rows)
    return (f'<div class="wide{f" {look}" if look else ""}"><table><thead><tr>' + "".join(f"<th>{escape(one)}</th>" for one in head)
            + f"</tr></thead><tbody>\n{lines}</tbody></table></div>")
