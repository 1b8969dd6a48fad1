# SPDX-License-Identifier: Apache-2.0
"""Behaviour: completion in zsh and fish, asked as these shells ask.

usage: shells.py SHELL PROGRAM
"""

import pathlib
import shlex
import subprocess
import sys

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "examples/article.toml"
# The words of a command line, and what is offered in place of the last one.
LINES = {
    ("sti",): ["stiffness"],
    ("sif", ""): ["eval", "list", "plot", "show", "--help"],
    ("stiffness", "--method", ""): ["as-printed", "repaired", "corrected"],
    ("material", "show", "17-4"): ["17-4PH H900"],
    ("sweep", str(EXAMPLE), "--vary", "output_shaft.le"): ["output_shaft.length"],
    ("torsion", "a.toml", "--units", "mm,ar"): ["mm,arcmin", "mm,arcsec"],
    ("explain", "crack.thick"): ["crack.thick_wall"],
}
ZSH = """compdef() {{ : }}
compadd() {{ shift; print -rl -- "$@" }}
source <({program} completion zsh)
words=({program} {words})
CURRENT={current}
_strainwave"""
FISH = "{program} completion fish | sed 's/complete -c strainwave/complete -c {name}/' | source\n" \
       "complete -C {line}"


def offered(shell, program, words):
    if shell == "zsh":
        quoted = " ".join(shlex.quote(word) for word in words)
        script = ZSH.format(program=shlex.quote(program), words=quoted, current=len(words) + 1)
        command = ["zsh", "-fc", script]
    else:
        folder, name = program.rsplit("/", 1)
        line = shlex.quote(" ".join([name, *words]))
        command = ["fish", "--no-config", "-c",
                   f"set -x PATH {shlex.quote(folder)} $PATH\n"
                   + FISH.format(program=shlex.quote(program), name=name, line=line)]
    answer = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
    return [line for line in answer.stdout.split("\n") if line]


def main():
    shell, program = sys.argv[1:]
    faults = []
    for words, expected in LINES.items():
        found = offered(shell, program, words)
        if sorted(found) != sorted(expected):
            faults.append(f"{' '.join(words)}: offered {found}, expected {expected}")
    sys.exit("\n".join(faults) if faults else 0)


if __name__ == "__main__":
    main()
