# SPDX-License-Identifier: Apache-2.0
"""The theory manual, a page for each chapter; each tag of an equation is an address."""

import json
import pathlib
import re
import subprocess
import tempfile

from pages import MANUAL, ROOT, escape, headings, plain

THEORY = ROOT / "docs" / "theory"
HEADING = re.compile(r'<h([1-4]) id="([^"]*)"[^>]*>(.*?)</h\1>', re.S)
# The manual once was one page: its addresses lead to the pages of their chapters.
FOLLOW = """<script>
"use strict";
const chapters = {addresses};
function follow() {
  const address = decodeURIComponent(location.hash.slice(1));
  const page = Object.keys(chapters).find((one) => chapters[one].includes(address));
  if (page) location.replace(page + "#" + address);
}
addEventListener("hashchange", follow);
follow();
</script>"""


def stems():
    """Names of the files of the chapters, by the addresses of their titles."""
    found = {}
    for file in THEORY.glob("*.md"):
        title = file.read_text(encoding="utf-8").partition("\n")[0]
        given = re.search(r"\{#([\w-]+)\}", title)
        found[given.group(1) if given else title.lstrip("# ").lower()] = file.stem
    return found


def chapters():
    """(name of the page, HTML) of each chapter, in the order of the manual."""
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder, "manual.html")
        subprocess.run([str(ROOT / "tools" / "render_manual"), str(made)], check=True, capture_output=True)
        text = made.read_text(encoding="utf-8")
    body = text[text.index("</nav>") + len("</nav>"):text.index("</body>")]
    names = stems()
    for part in re.split(r'(?=<h1 id=")', body)[1:]:
        address = re.match(r'<h1 id="([^"]*)"', part).group(1)
        yield names.get(address, address) + ".html", part


LONG = 16  # characters of a formula in a line that may be wider than a narrow page


def scrolled(body):
    """Wide tables and long formulas scroll inside of a narrow page."""
    body = re.sub(r'<math display="inline".*?</math>', lambda formula: f'<span class="formula">{formula.group(0)}</span>'
                  if len(plain(formula.group(0))) > LONG else formula.group(0), body, flags=re.S)
    return re.sub(r'(<div class="(?:wide|audit)">\s*)?(<table.*?</table>)',
                  lambda match: match.group(0) if match.group(1) else f'<div class="scroll">{match.group(2)}</div>', body, flags=re.S)


def nested(found):
    """Headings (level, address, HTML, url) as a list in lists."""
    lines, open_levels = [], []
    for level, address, text, url in found:
        while open_levels and open_levels[-1] > level:
            lines.append("</li></ul>")
            open_levels.pop()
        if open_levels and open_levels[-1] == level:
            lines.append("</li>")
        else:
            lines.append("<ul>")
            open_levels.append(level)
        lines.append(f'<li{f" id={chr(34)}{address}{chr(34)}" if address else ""}><a href="{url}">{text}</a>')
    return "\n".join(lines) + "</li></ul>" * len(open_levels)


def write(site):
    """Writes the chapters, and the page of contents."""
    parts = list(chapters())
    addresses = {name: re.findall(r'\bid="([^"]*)"', part) for name, part in parts}
    page_of = {address: name for name, known in addresses.items() for address in known}
    titles = [plain(HEADING.search(part).group(3)) for _, part in parts]
    folder = MANUAL.rpartition("/")[0]
    contents = []
    for place, (name, part) in enumerate(parts):
        def link(match, name=name):
            page = page_of[match.group(1)]
            return f'href="{"" if page == name else page}#{match.group(1)}"'

        own = [(int(level), address, text) for level, address, text in HEADING.findall(part)]
        contents += [(level, address, text, f"{name}#{address}") for level, address, text in own]
        sections = nested([(level, "", text, "#" + address) for level, address, text in own if level == 2])
        turn = " · ".join(f'<a href="{page}">{escape(text)}</a>' for page, text in (
            [(parts[place - 1][0], "← " + titles[place - 1])] if place else []) + [("manual.html", "Theory manual")]
            + ([(parts[place + 1][0], titles[place + 1] + " →")] if place + 1 < len(parts) else []))
        body = scrolled(re.sub(r'href="#([^"]*)"', link, part))
        if sections:
            body = body.replace("</h1>", f'</h1>\n<nav class="sections" aria-label="Sections">{sections}</nav>', 1)
        path = f"{folder}/{name}"
        for level, address, title, after in headings(body):
            tag = re.match(r"\(([A-Z]{2}-\d+[a-z]?)\) ?(.*)", title)
            url = path if level == 1 else f"{path}#{address}"
            if tag:
                site.theory[tag.group(1)] = url
                site.enter("equation", tag.group(1), url, f"{tag.group(2)}: {after}", [tag.group(2)])
            else:
                site.enter("theory", title, url, after)
        site.write(path, titles[place], f'{body}\n<nav class="turn" aria-label="Chapters">{turn}</nav>')
    listed = FOLLOW.replace("{addresses}", json.dumps(addresses, separators=(",", ":")))
    site.write(MANUAL, "Theory manual", "<h1>Theory manual</h1><p>Each equation with its source, its validity, and what it was held "
               f'against.</p>\n<nav class="sections" aria-label="Contents">{nested(contents)}</nav>\n{listed}')
    site.enter("page", "Theory manual", MANUAL, "chapters and equations")
