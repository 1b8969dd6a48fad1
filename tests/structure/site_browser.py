#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Opens pages of the rendered site in a browser without a window, from files.

    tests/structure/site_browser.py FOLDER        pages of each kind in 360 px, a search, an old address, a print
    tests/structure/site_browser.py --self-test   a page that is too wide and a search without a hit

Exit status 77: Chromium is not installed.
"""

import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

PROGRAMS = ("chromium", "chromium-headless-shell", "chromium-browser", "google-chrome")
WIDTH = 360
# One page of each kind: they share their head, and differ in tables, formulas, code and pictures.
SAMPLE = ("index.html", "readme.html", "CHANGELOG.html", "docs/guide/python.html", "docs/guide/input_file.html",
          "docs/guide/turn.html", "docs/guide/finite_elements.html", "docs/theory/manual.html", "docs/theory/FR.html",
          "docs/theory/FE.html", "docs/theory/TC.html", "docs/theory/90_audit.html", "docs/theory/traceability.html", "commands/index.html",
          "commands/stiffness.html", "commands/fe_run.html", "commands/merge.html", "notes.html", "libraries.html",
          "python.html", "python_results.html", "cpp/sif.html", "verification.html", "docs/adr/0003-independent-roads.html",
          "examples/notebooks/index.html")
# The search field takes the words, and the first hit is clicked.
QUERY, HIT = "FR-9", "docs/theory/FR.html#FR-9"
OLD = "docs/theory/manual.html#FR-9"
# Frames as narrow as a telephone: a window cannot be that narrow everywhere.
PROBE = """<!DOCTYPE html><meta charset="utf-8"><title>probe</title><pre id="answer"></pre><script>
const answer = { widths: {} };
const opened = (url) => new Promise((resolve) => {
  const frame = document.createElement("iframe");
  frame.style.cssText = "width: WIDTHpx; height: 740px; border: 0";
  frame.onload = () => resolve(frame);
  frame.src = url;
  document.body.append(frame);
});
const until = async (met) => {
  for (let tries = 0; tries < 100 && !met(); ++tries) await new Promise((resolve) => setTimeout(resolve, 50));
};
const settled = (frame, part) => until(() => frame.contentWindow.location.href.endsWith(part) &&
  frame.contentDocument.readyState === "complete");
(async () => {
  for (const page of PAGES) {
    const frame = await opened(ROOT + page);
    answer.widths[page] = frame.contentDocument.documentElement.scrollWidth;
    frame.remove();
  }
  const frame = await opened(ROOT + "index.html");
  const field = frame.contentDocument.getElementById("search");
  field.value = QUERY;
  field.dispatchEvent(new Event("input"));
  const link = frame.contentDocument.querySelector("#found a");
  if (link) {
    link.click();
    await settled(frame, HIT);
    answer.hit = frame.contentWindow.location.href;
    answer.target = frame.contentDocument.querySelector(":target")?.textContent ?? "";
  }
  const old = await opened(ROOT + OLD);
  await settled(old, HIT);
  answer.old = old.contentWindow.location.href;
})().catch((error) => { answer.error = String(error); })
  .finally(() => { document.getElementById("answer").textContent = JSON.stringify(answer); });
</script>"""


def browser():
    return next(filter(None, map(shutil.which, PROGRAMS)), None)


def run(program, *words):
    """The output of the browser; its complaints about the machine do not matter."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        sandbox = ["--no-sandbox"] if os.geteuid() == 0 else []  # Chromium does not run in its sandbox as root.
        return subprocess.run([program, "--headless", "--disable-gpu", f"--user-data-dir={profile}", *sandbox, *words],
                              capture_output=True, text=True, timeout=50, check=False).stdout


def probe(program, folder, pages, query):
    """What the pages of a site say: widths, the address that the first hit leads to, where an old address leads."""
    given = {"WIDTH": str(WIDTH), "PAGES": json.dumps(pages), "ROOT": json.dumps(folder.as_uri() + "/"),
             "QUERY": json.dumps(query), "HIT": json.dumps(HIT), "OLD": json.dumps(OLD)}
    text = re.sub(r"\b(WIDTH|PAGES|ROOT|QUERY|HIT|OLD)(?=\b|px)", lambda word: given[word.group(1)], PROBE)
    with tempfile.TemporaryDirectory() as place:
        page = pathlib.Path(place, "probe.html")
        page.write_text(text, encoding="utf-8")
        # The probe looks into pages of other files; the pages themselves need no permission.
        dumped = run(program, "--allow-file-access-from-files", "--virtual-time-budget=60000", "--dump-dom", page.as_uri())
    found = re.search(r'<pre id="answer">(.*?)</pre>', dumped, re.S)
    return json.loads(html.unescape(found.group(1)) if found and found.group(1) else '{"error": "the probe gave no answer", "widths": {}}')


def faults_of(program, folder, pages=SAMPLE, query=QUERY):
    answer = probe(program, folder, [page for page in pages if (folder / page).is_file()], query)
    faults = [f"{page}: is not there" for page in pages if not (folder / page).is_file()]
    if "error" in answer:
        faults.append(answer["error"])
    faults += [f"{page}: is {width} px wide in a window of {WIDTH} px"
               for page, width in answer["widths"].items() if width > WIDTH]
    if not answer.get("hit", "").endswith(HIT) or QUERY not in answer.get("target", ""):
        faults.append(f"search for {query}: the first hit leads to {answer.get('hit', 'nothing')}")
    if not answer.get("old", "").endswith(HIT):
        faults.append(f"{OLD} leads to {answer.get('old', 'nothing')}")
    with tempfile.TemporaryDirectory() as place:
        printed = pathlib.Path(place, "page.pdf")
        run(program, f"--print-to-pdf={printed}", (folder / HIT.partition("#")[0]).as_uri())
        if not printed.is_file() or not printed.read_bytes().startswith(b"%PDF") or b"/Page" not in printed.read_bytes():
            faults.append(f"{HIT}: makes no PDF")
    return faults


def self_test(program):
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        (folder / "docs" / "theory").mkdir(parents=True)
        (folder / "index.html").write_text('<input id="search"><ol id="found"></ol><p style="width: 500px">wide</p>')
        (folder / "docs" / "theory" / "manual.html").write_text("<p>no way on</p>")
        (folder / "docs" / "theory" / "FR.html").write_text("<p>FR</p>")
        faults = faults_of(program, folder, ("index.html", "absent.html"))
    wanted = ("absent.html: is not there", "index.html: is 5", "leads to nothing", f"{OLD} leads to")
    unseen = [part for part in wanted if not any(part in fault for fault in faults)]
    print("\n".join(f"not reported: {part}" for part in unseen))
    return unseen


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = browser()
    if program is None:
        print("Chromium is not installed")
        sys.exit(77)
    if sys.argv[1] == "--self-test":
        sys.exit(1 if self_test(program) else 0)
    folder = pathlib.Path(sys.argv[1]).resolve()
    faults = faults_of(program, folder)
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
