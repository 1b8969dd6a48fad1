#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the commands of README and guides, in their order, as a reader would type them.

    tests/cli/pages.py PROGRAM [PAGE ...]   PROGRAM is strainwave, wherever it was built;
                                            without a PAGE, README and all guides
    tests/cli/pages.py --self-test PROGRAM

The commands of a page run in one folder that has the examples.  A block below a block of commands shows their
output: each of its lines must be in this output, in this order, with any number of blanks. `...` stands for
any lines, and within a line for any words.
Commands of `strainwave fe` run only if strainwave-fe is beside the program.  Those of MINUTES that write files
run with --dry-run, unless the environment variable STRAINWAVE_LONG asks for all of the work.  A shell command of
another program must be one of KNOWN, which other tests run.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = ["README.md", *sorted(str(p.relative_to(ROOT)) for p in (ROOT / "docs/guide").glob("*.md"))]
BLOCK = re.compile(r"^```(\w*)\n((?:(?!```).*\n)*)```\n|^((?:    .*\n)+)", re.M)
KNOWN = {"./demo", "./check", "cmake", "mpirun", "sbatch", "sudo", "tools/install_dependencies", "python3", "v/bin/pip", "tools/judge_closed_forms.py"}
MINUTES = {"turn", "tabulate"}  # commands of strainwave fe
ENDS = {"require": {0, 5, 6}}  # met, not met, cannot be told


def commands_of(block):
    """The commands of a block of a shell; empty if the block is not one."""
    lines = [line for line in re.sub(r"\\\n\s*", "", block).splitlines() if line.strip() and not line.startswith("#")]
    return lines if lines and lines[0].split()[0] in {"strainwave", *KNOWN} else []


def faults_of_block(page, commands, folder, programs):
    """(faults, output) of the commands, run in the folder."""
    faults, printed = [], ""
    for command in commands:
        words = command.split()
        finite_elements = words[:2] == ["strainwave", "fe"]
        if words[0] in KNOWN or (finite_elements and not (programs / "strainwave-fe").exists()):
            continue
        if finite_elements and words[2] in MINUTES and "-o" in words and not os.environ.get("STRAINWAVE_LONG"):
            command += " --dry-run"
        done = subprocess.run(["bash", "-c", command], cwd=folder, capture_output=True, text=True,
                              env={"PATH": f"{programs}:/usr/bin:/bin", "LC_ALL": "C.UTF-8"})
        printed += done.stdout + done.stderr
        if words[0] != "strainwave":
            faults.append(f"{page}: {command}: this test does not know {words[0]}")
        elif done.returncode not in ENDS.get(words[1], {0}):
            faults.append(f"{page}: {command}: exit code {done.returncode}: {done.stderr.strip()}")
    return faults, printed


def unprinted(block, printed):
    """The first line of a block that does not follow the previous lines in the output; None if all lines
    follow."""
    lines = iter([" ".join(line.split()) for line in printed.splitlines()])
    for line in block.splitlines():
        pattern = re.escape(" ".join(line.split())).replace(re.escape("..."), ".*")
        if line.strip() not in ("", "...") and not any(re.fullmatch(pattern, one) for one in lines):
            return line
    return None


def faults_of_page(page, text, program):
    faults = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / "folder"
        folder.mkdir()
        shutil.copytree(ROOT / "examples", folder / "examples")
        printed = ""
        for match in BLOCK.finditer(text):
            language, block = match[1] or "", match[2] or re.sub(r"^    ", "", match[3] or "", flags=re.M)
            commands = commands_of(block) if language in ("", "sh", "bash") else []
            if commands:
                found, printed = faults_of_block(page, commands, folder, program.parent)
                faults += found
            elif language == "" and printed:
                line = unprinted(block, printed)
                if line is not None:
                    faults.append(f"{page}: not printed by the commands above it: {line}")
                printed = ""
    return faults


def self_test(program):
    good = "```\nstrainwave new -o drive.toml\nstrainwave stiffness drive.toml \\\n  --format csv\n```\n\n```\npath,value,unit,relative_uncertainty\n...\n```\n"
    broken = {good.replace("-o drive.toml", ""): "cannot be opened for reading",
              good.replace("stiffness", "stifness"): "exit code 2",
              good.replace("path,value", "value,path"): "not printed",
              good.replace("strainwave stiffness", "strange stiffness"): "does not know strange"}
    unseen = [what for text, what in broken.items() if not any(what in fault for fault in faults_of_page("page", text, program))]
    return faults_of_page("page", good, program) + [f"self-test: unseen: {what}" for what in unseen]


def main(arguments):
    program = pathlib.Path(arguments[1 if arguments[0] == "--self-test" else 0]).resolve()
    if arguments[0] == "--self-test":
        faults = self_test(program)
    else:
        faults = [fault for page in arguments[1:] or PAGES for fault in faults_of_page(page, (ROOT / page).read_text(), program)]
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
