# SPDX-License-Identifier: Apache-2.0
"""Behaviour: `simulate --record` is killed and interrupted, goes on with --resume, and loses nothing.

A run ends because there is no room.  The next is killed by SIGKILL at a random moment after it has kept a
checkpoint, and the next by SIGINT.  Each run goes on from the checkpoint of the one before.  At the end the
record and the answer must have the same bytes as those of a run that was not interrupted, and no checkpoint
may be left.  Both forms of the record must have the same numbers, and the lines of the guide must read them.
A longer motion must not take more memory.  The environment variable STRAINWAVE_LONG asks for more stops.

usage: kill_record.py PROGRAM
"""

import importlib.util
import json
import os
import pathlib
import random
import re
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
GUIDE = ROOT / "docs/guide/motion.md"
KILLS = 20 if os.environ.get("STRAINWAVE_LONG") else 2
MOST_MEMORY = 16 * 1024  # that a longer motion may take in addition [KiB]


def drive(folder, seconds):
    """A drive at 3000 rpm, with a crack that the wave opens."""
    text = (EXAMPLES / "orders_size25.toml").read_text()
    text = text[:text.index("[[manoeuvre]]")]
    path = folder / f"turns_{seconds}.toml"
    path.write_text(text + f"""
[[manoeuvre]]
duration = "0.5 s"
input_speed = "3000 rpm"
output_torque = "40 N*m"

[[manoeuvre]]
duration = "{seconds} s"
input_speed = "3000 rpm"
""")
    return path


def kept(checkpoint):
    """bytes of the record that a checkpoint keeps"""
    return int(checkpoint.read_text().split("\n")[1]) if checkpoint.exists() else 0


def read_binary(path):
    """head, rows and the bytes of a torn row of a binary record"""
    data = path.read_bytes()
    version, length = struct.unpack_from("<II", data, 8)
    if data[:8] != b"swmotion" or version != 1 or (16 + length) % 8 != 0:
        sys.exit("the record does not begin as the guide says")
    head = json.loads(data[16:16 + length])
    body = data[16 + length:]
    torn = len(body) % head["row_bytes"]
    columns = len(head["columns"])
    return head, list(struct.iter_unpack(f"<{columns}d", body[:len(body) - torn])), torn


def check_forms(folder, command, file):
    """Both forms have the same rows with all digits, and a torn row is seen."""
    for form in "csv", "bin":
        subprocess.run([*command, str(file), "--record", str(folder / f"form.{form}")], check=True,
                       stdout=subprocess.DEVNULL)
    head, rows, torn = read_binary(folder / "form.bin")
    lines = (folder / "form.csv").read_text().splitlines()
    if lines[0] != ",".join(f"{of['name']} [{of['unit']}]" for of in head["columns"]):
        sys.exit("the columns of both forms differ")
    if torn or rows != [tuple(map(float, line.split(","))) for line in lines[1:]]:
        sys.exit("the rows of both forms differ")
    whole = (folder / "form.bin").read_bytes()
    (folder / "form.bin").write_bytes(whole[:-3])
    if read_binary(folder / "form.bin")[2] != head["row_bytes"] - 3:
        sys.exit("a torn row is not seen")


def check_guide(folder, command, file):
    """The lines of the guide that read a record print what the answer says."""
    subprocess.run([*command, str(file), "--record", str(folder / "motion.bin")], check=True,
                   stdout=subprocess.DEVNULL)
    lines = re.search(r"^```python\n(.*?)^```", GUIDE.read_text(), re.M | re.S)[1]
    said = subprocess.run([sys.executable, "-c", lines], cwd=folder, check=True, capture_output=True,
                          text=True).stdout
    _, rows, _ = read_binary(folder / "motion.bin")
    most = max(abs(row[6]) for row in rows)
    if said != f"{len(rows)} rows, largest torque {most} N*m\n":
        sys.exit(f"the guide reads another record: {said}")


def main():
    program = sys.argv[1]
    moments = random.Random(15)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        command = [program, "simulate", "--step", "1 ms"]
        short = drive(folder, 4)
        check_forms(folder, command, short)
        if importlib.util.find_spec("numpy"):
            check_guide(folder, command, short)
        memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        file = drive(folder, 600)
        answer = ["--format", "json"]
        whole = folder / "whole.bin"
        begin = time.monotonic()
        expected = subprocess.run([*command, str(file), *answer, "--record", str(whole)], check=True,
                                  stdout=subprocess.PIPE).stdout
        duration = time.monotonic() - begin
        rows = json.loads(expected)["result"]["rows"]
        if any(column["values"] for column in rows.values()):
            sys.exit("the answer holds rows that were recorded")
        longer = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
        if longer > memory + MOST_MEMORY:
            sys.exit(f"a motion of 150 times the time took {longer} KiB in place of {memory} KiB")
        record = folder / "record.bin"
        checkpoint = folder / "record.bin.checkpoint"
        run = [*command, str(file), *answer, "--record", str(record)]
        # A full disk ends the run as a limit of the size does; with more room the run goes on.
        room = whole.stat().st_size // 4
        full = subprocess.run(run, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE,
                                                                    (room, room)))
        if full.returncode != 7 or b"--resume" not in full.stderr:
            sys.exit(f"a record without room ends with {full}")
        stops = 0
        last = kept(checkpoint)
        begun = False
        while True:
            process = subprocess.Popen(run + ["--resume"], stdout=subprocess.PIPE,
                                       stderr=subprocess.PIPE)
            if stops < KILLS:
                stop = signal.SIGINT if stops % 2 else signal.SIGKILL
                # Each run must get further than the one before.
                while process.poll() is None and kept(checkpoint) <= last:
                    time.sleep(0.01)
                last = kept(checkpoint)
                time.sleep(moments.uniform(0, 0.3))
                process.send_signal(stop)
            out, said = process.communicate(timeout=120)
            if process.returncode == 0:
                break
            stops += 1
            if process.returncode == 130 and b"--resume" not in said:
                sys.exit(f"the interrupted run does not say how to go on: {said}")
            if process.returncode not in (130, -signal.SIGKILL):
                sys.exit(f"after stop {stops} the program ends with {process.returncode}: {said}")
            if not begun:
                refused = subprocess.run(run, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                if refused.returncode != 2 or b"add --resume" not in refused.stderr:
                    sys.exit(f"an unfinished record is replaced without a word: {refused}")
                begun = True
            # A record whose last row is torn, as a crash of the machine leaves it.
            with open(record, "ab") as torn:
                torn.write(b"torn")
        if record.read_bytes() != whole.read_bytes():
            sys.exit(f"after {stops} stops the record has other bytes than without a stop")
        if out != expected:
            sys.exit(f"after {stops} stops the answer is another one")
        if stops < KILLS:
            sys.exit(f"only {stops} runs were stopped before their end")
        left = sorted(path.name for path in folder.iterdir() if path.name.startswith("record"))
        if left != ["record.bin"]:
            sys.exit(f"files are left behind: {left}")
        again = subprocess.run(run + ["--resume"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        if again.returncode != 2 or b"no checkpoint" not in again.stderr:
            sys.exit("a finished record is replaced by --resume")
    print(f"{stops} stops of a run of {duration:.1f} s, {longer} KiB")


if __name__ == "__main__":
    main()
