# SPDX-License-Identifier: Apache-2.0
"""The package against the command line: the same envelope, byte for byte, and the same sentences."""

import json
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import strainwave as sw
from strainwave import _library
from support import CLI, DATA, EXAMPLES, main, trials

COMMANDS = {command["name"]: command for command in _library.commands()}
POSITIONAL = {"require": "requirements", "sif show": "name", "sif eval": "name", "sif plot": "name",
              "material show": "name", "explain": "word",
              "fit": "data"}
SLOW = {"torsion", "accuracy", "backbone", "simulate", "validate", "calibrate", "transmission", "frf",
        "modes", "report", "turn", "oval", "life", "grow", "solve"}


def command_line(command, options, drive):
    """The command line of a command; the JSON envelope is its answer."""
    words = command.split() + ([drive] if drive else [])
    if command in POSITIONAL:
        given = options.get(POSITIONAL[command], [])
        words += given if isinstance(given, list) else [given]
    if command == "diff":
        words += [options["first"], options["second"]]
    for name, value in options.items():
        if name == POSITIONAL.get(command) or command == "diff" and name in ("first", "second"):
            continue
        spelled = "--" + name.replace("_", "-")
        for one in value if isinstance(value, list) else [value]:
            words += [spelled] if one is True else [] if one is False else [f"{spelled}={one}"]
    return [CLI, *words, "--format", "json"]


def function(command, drive):
    """The method or function of a command."""
    name = command.replace(" ", "_")
    if command == "new":  # sw.new gives a drive
        return sw._commands.new
    return getattr(drive, name) if drive is not None else getattr(sw, name)


def texts_of(options):
    return {value: (EXAMPLES / value).read_text() for value in options.values()
            if isinstance(value, str) and (EXAMPLES / value).is_file()}


def asked(command, options, drive):
    """The envelope, or the message of the error, and the exit code of the command line."""
    given = {name if name not in ("from", "in") else name + "_": value
             for name, value in options.items()}
    try:
        answer = function(command, drive)(**given, texts=texts_of(options))
        return answer.document("json"), 0
    except sw.OptionError as error:
        return str(error), 2
    except sw.InputError as error:
        return str(error), 3
    except sw.SolverError as error:
        return str(error), 4


class Parity(unittest.TestCase):
    def test_identity_every_command_has_a_trial_a_function_and_a_class(self):
        self.assertEqual({command for command, _ in trials()}, set(COMMANDS))
        for name, command in COMMANDS.items():
            if command["takes"] != "nothing":
                self.assertTrue(callable(getattr(sw.Drive, name.replace(" ", "_"))))
            if command["takes"] != "drive":
                self.assertIn(name.replace(" ", "_") if name != "new" else "new", sw.__all__)

    def test_identity_the_same_bytes_and_the_same_refusals(self):
        """Every command with its options of trial: commands without a drive once; quick commands on
        every example, others on every sixth, and until one example is answered."""
        examples = sorted(EXAMPLES.glob("*.toml"))
        compared = answered = 0
        for command, text in trials():
            options = json.loads(text)
            takes = COMMANDS[command]["takes"]
            rows = list(examples if command not in SLOW else examples[::6])
            rows += [one for one in examples if one not in rows]
            least = 1 if takes == "nothing" else len(examples) if command not in SLOW else len(examples[::6])
            if takes == "nothing" or command == "duty" and "rainflow" in options:
                rows, least = [None], 1
            found = 0
            for place, example in enumerate(rows):
                if place >= least and found > 0:
                    break
                drive = sw.Drive._read(Path(example.name)) if example else None
                message, status = asked(command, options, drive)
                said = subprocess.run(command_line(command, options, example.name if example else None),
                                      capture_output=True, text=True, cwd=EXAMPLES, check=False)
                with self.subTest(command=command, options=text, example=example):
                    if status == 0:
                        self.assertIn(said.returncode, (0, 4, 5, 6), said.stderr)
                        self.assertEqual(message, said.stdout)
                        found += 1
                    else:
                        self.assertEqual(said.returncode, status, f"{message}\n{said.stderr}")
                compared += 1
            with self.subTest(command=command, options=text):
                self.assertGreater(found, 0)
            answered += found > 0
        self.assertGreater(compared, 200)
        self.assertEqual(answered, len(trials()))

    def test_identity_wrong_drives_are_refused_by_the_same_sentences(self):
        """The wrong inputs of the command line whose drive is refused before any option matters."""
        lines = (DATA / "wrong_inputs.txt").read_text().splitlines()
        compared = 0
        with tempfile.TemporaryDirectory() as folder:
            for command, answer in zip(lines, lines[1:]):
                match = re.fullmatch(r"\$ stiffness \{(\w+) \| (.*) \| (.*)\}", command)
                said = re.fullmatch(r"3 strainwave: (.*)", answer)
                if not match or not said:
                    continue
                example, old, new = (part.replace("\\n", "\n") for part in match.groups())
                text = (EXAMPLES / f"{example}.toml").read_text()
                if old not in text:
                    continue
                file = Path(folder, "wrong.toml")
                file.write_text(text.replace(old, new, 1))
                with self.subTest(command):
                    try:
                        sw.read(file).stiffness()
                        self.fail("was not refused")
                    except sw.InputError as error:
                        self.assertEqual(str(error).replace(str(file), "FILE"),
                                         said.group(1).replace("\\\\", "\\"))
                compared += 1
        self.assertGreater(compared, 100)


if __name__ == "__main__":
    main()
