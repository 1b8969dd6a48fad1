# SPDX-License-Identifier: Apache-2.0
"""The package against the command line: the same envelope, byte for byte, and the same sentences."""

import collections
import json
import os
import re
import shlex
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
SLOW = {"report", "grow", "sweep"}
LONG = bool(os.environ.get("STRAINWAVE_LONG"))


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
    """Files that options name, decoded as the package decodes a file that it opens."""
    return {value: (EXAMPLES / value).read_bytes().decode("utf-8", "surrogateescape") for value in options.values()
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


def same_spelling(sentence, command):
    """A sentence whose options and positional arguments are spelled in one way: the command line calls them
    --cage-phase and FILE, Python cage_phase and file."""
    name = POSITIONAL.get(command, "")
    if name and sentence.startswith(name.upper() + ":"):
        sentence = name + sentence[len(name):]
    return re.sub(r"(?<=[a-z])-(?=[a-z])", "_", sentence.replace("--", ""))


def unescaped(text):
    """The bytes that a text of tests/data/wrong_inputs.txt stands for."""
    marks = {b"n": b"\n", b"t": b"\t", b"r": b"\r"}
    return re.sub(rb"\\(?:x([0-9a-f]{2})|(.))",
                  lambda match: bytes.fromhex(match[1].decode()) if match[1] else marks.get(match[2], match[2]),
                  text.encode())


def file_of(braces, folder):
    """Writes the file that a word of tests/data/wrong_inputs.txt stands for, as wrong_inputs_test.cpp does."""
    name, *parts = braces.split(" | ")
    parts = [unescaped(part) for part in parts]
    if name in ("csv", "drive"):
        content = parts[0]
    else:
        content = (EXAMPLES / f"{name}.toml").read_bytes()
        for old, new in zip(parts[::2], parts[1::2]):
            content = content + new if old == b"END" else content.replace(old, new, 1)
    file = folder / ("table.csv" if name == "csv" else "drive.toml")
    file.write_bytes(content)
    return str(file)


def call_of(line, folder):
    """Command, file of the drive, and options of Python that a line of tests/data/wrong_inputs.txt asks for.
    None if only the command line can ask so: a command or an option that does not exist in Python (such as
    --output and --shard), an option without its value or given twice, several drives, or no drive."""
    words = shlex.split(re.sub(r"\{([a-z_0-9]+( \| .*?)?)\}", lambda match: file_of(match[1], folder), line))
    command = next((name for name in (" ".join(words[:2]), words[0]) if name in COMMANDS), None)
    if command is None:
        return None
    about = json.loads(sw.schema(of="options", command=command).schema)["properties"]
    options, others = {}, []
    words = words[len(command.split()):]
    while words:
        word = words.pop(0)
        if not word.startswith("-") or word == "-":
            others.append(word)
            continue
        name, sign, value = word[2:].partition("=")
        name = name.replace("-", "_")
        if not word.startswith("--") or name not in about:
            return None
        kind = about[name].get("type")
        if kind == "boolean":
            options[name] = True
            continue
        if not sign and not words:
            return None
        value = value if sign else words.pop(0)
        if kind == "array":
            options.setdefault(name, []).append(value)
            continue
        if name in options:
            return None
        options[name] = value
        if kind in ("integer", "number"):
            try:
                options[name] = json.loads(value)
            except ValueError:  # the text goes to Python as it is
                pass
    takes = COMMANDS[command]["takes"]
    drive = others.pop(0) if takes != "nothing" and others else None
    if drive == "-" or drive is None and takes == "drive":
        return None
    if command == "require":
        options["requirements"] = others
        return command, drive, options
    names = ["first", "second"] if command == "diff" else [POSITIONAL[command]] if command in POSITIONAL else []
    if len(others) > len(names):
        return None
    options.update(zip(names, others))
    return command, drive, options


def refusal(command, drive, options):
    """What Python says to a wrong call, and the exit code of the command line for its kind of error."""
    try:
        said, status = asked(command, options, None if drive is None else sw.read(drive))
        if status == 0:  # an answer is a refusal if it must not be used
            said, status = json.loads(said)["unusable_because"], 4
        return said, status
    except sw.InputError as error:  # of the drive
        return str(error), 3
    except (TypeError, OSError) as error:
        return f"{type(error).__name__}: {error}", None


# Refusals that differ by design: the reason, what the command line says, what Python says.
BY_DESIGN = [
    ("Python opens the file of a drive and raises its own OSError",
     r".*: cannot be opened for reading: .*|.*: is a directory|FILE must name a file; .*",
     r"(FileNotFoundError|IsADirectoryError): .*"),
    ("text in an option names an attached text, where the program opens a file",
     r".*: cannot be opened for reading: .*|\w+ must name a file; .*",
     r"\w*: (names a text that is not attached|the text of this file is missing); give a pathlib\.Path, .*|"
     r"requirements: .* is neither a requirement nor an existing file; .*"),
    ("the program opens a file before it looks at the other options",
     r"x\.csv: cannot be opened for reading: .*", r"catalogue: give either catalogue or measured"),
    ("Python itself refuses a call without a required argument",
     r"[a-z ]+ needs .*; see strainwave [a-z ]+", r"TypeError: \w.* missing \d required positional arguments?: .*"),
    ("Python has read the number before the library sees its digits",
     r"seed: 9{20} violates: .*|samples: 1e4 is not a whole number.*",
     r"seed: 1e\+20 is not a whole number.*|samples: 10000\.0 is not a whole number.*"),
]


class Parity(unittest.TestCase):
    def test_identity_every_command_has_a_trial_a_function_and_a_class(self):
        self.assertEqual({command for command, _ in trials()}, set(COMMANDS))
        for name, command in COMMANDS.items():
            if command["takes"] != "nothing":
                self.assertTrue(callable(getattr(sw.Drive, name.replace(" ", "_"))))
            if command["takes"] != "drive":
                self.assertIn(name.replace(" ", "_") if name != "new" else "new", sw.__all__)

    def test_identity_the_same_bytes_and_the_same_refusals(self):
        """Every command with its options of trial on every third example, other ones for each command, and on
        further ones until one of them is answered; slow commands on every ninth.  Commands without a drive run once.
        The environment variable STRAINWAVE_LONG asks for every example."""
        examples = sorted(file.name for file in EXAMPLES.glob("*.toml"))
        compared = collections.Counter()
        answered = 0
        for number, (command, text) in enumerate(trials()):
            options = json.loads(text)
            alone = COMMANDS[command]["takes"] == "nothing" or "rainflow" in options
            found = 0
            step = (1 if LONG else 3) * (3 if command in SLOW else 1)
            first = examples[number % step::step]
            for example in [None] if alone else first + [other for other in examples if other not in first]:
                if found and example not in (None, *first):
                    break
                with subprocess.Popen(command_line(command, options, example), stdout=subprocess.PIPE,
                                      stderr=subprocess.PIPE, text=True, cwd=EXAMPLES) as program:
                    # Python computes at the same time.
                    drive = sw.Drive._read(Path(example)) if example else None
                    message, status = asked(command, options, drive)
                    answer, said = program.communicate()
                with self.subTest(command=command, options=text, example=example):
                    if status == 0:
                        self.assertIn(program.returncode, (0, 4, 5, 6), said)
                        self.assertEqual(message, answer)
                        found += 1
                    else:
                        self.assertEqual(program.returncode, status, f"{message}\n{said}")
                        self.assertEqual(same_spelling(message, command),
                                         same_spelling(said.strip()[len("strainwave: "):], command))
                compared[command] += 1
            with self.subTest(command=command, options=text):
                self.assertGreater(found, 0)
            answered += found > 0
        self.assertGreater(sum(compared.values()), 1000 if LONG else 400)
        self.assertEqual(answered, len(trials()))

    def test_identity_wrong_inputs_are_refused_by_the_same_sentences(self):
        """The wrong inputs of the command line, as far as Python can ask so."""
        lines = (DATA / "wrong_inputs.txt").read_text().splitlines()
        compared, met = collections.Counter(), set()
        with tempfile.TemporaryDirectory() as folder:
            for line, answer in zip(lines, lines[1:]):
                call = call_of(line[2:], Path(folder)) if line.startswith("$ ") else None
                if call is None:
                    continue
                command = call[0]
                code, said = re.fullmatch(r"(\d) strainwave: (.*)", answer).groups()
                wanted = same_spelling(unescaped(said).decode(), command), int(code)
                message, status = refusal(*call)
                for name in ("drive.toml", "table.csv"):
                    message = message.replace(str(Path(folder, name)), "FILE")
                found = same_spelling(message, command), status
                reasons = [reason for reason, here, there in BY_DESIGN
                           if re.fullmatch(here, wanted[0]) and re.fullmatch(there, found[0])]
                met.update(reasons)
                with self.subTest(line):
                    if not reasons:
                        self.assertEqual(found, wanted)
                compared[command] += 1
        self.assertEqual(met, {reason for reason, _, _ in BY_DESIGN}, "an exception without a case")
        self.assertGreater(sum(compared.values()), 600)
        self.assertGreater(len(compared), 15)


if __name__ == "__main__":
    main()
