# SPDX-License-Identifier: Apache-2.0
"""Behaviour: `grow` is killed at random moments, goes on with --resume, and loses nothing.

Each run of the program is killed by SIGKILL after a random share of the time that a whole run takes.
The next run goes on from the checkpoint.  A run that ends by itself must have written the same bytes
as a run without a checkpoint, and the next one starts again.  At no moment may the output file be
there in part.  The environment variable STRAINWAVE_LONG asks for a thousand kills in place of a hundred.

usage: kill_grow.py PROGRAM
"""

import os
import pathlib
import random
import subprocess
import sys
import tempfile
import time

DRIVE = pathlib.Path(__file__).resolve().parents[2] / "examples/resonant_shaft.toml"
KILLS = 1000 if os.environ.get("STRAINWAVE_LONG") else 100
LEAST_ENDS = 3  # fewer would mean that a killed run begins anew each time


def main():
    program = sys.argv[1]
    moments = random.Random(15)
    with tempfile.TemporaryDirectory() as folder:
        whole = pathlib.Path(folder, "whole.json")
        answer = pathlib.Path(folder, "answer.json")
        checkpoint = pathlib.Path(folder, "checkpoint")
        command = [program, "grow", str(DRIVE), "--format", "json", "-o"]
        begin = time.monotonic()
        subprocess.run([*command, str(whole)], check=True, timeout=120)
        duration = time.monotonic() - begin
        kills = ends = kills_since_end = 0
        most_kept = 0
        while kills < KILLS or ends < LEAST_ENDS:
            if kills > 10 * KILLS:
                sys.exit(f"{kills} killed runs reached the end {ends} times only")
            run = subprocess.Popen([*command, str(answer), "--resume", str(checkpoint)],
                                   stdout=subprocess.DEVNULL)
            # On a machine that grows slower, the runs get longer until one of them ends.
            longest = 1.1 * duration * (1 + kills_since_end / 20)
            try:
                code = run.wait(timeout=moments.uniform(0, longest))
            except subprocess.TimeoutExpired:
                run.kill()
                run.wait()
                kills += 1
                kills_since_end += 1
                if checkpoint.exists():
                    most_kept = max(most_kept, checkpoint.stat().st_size)
                if answer.exists() and answer.read_bytes() != whole.read_bytes():
                    sys.exit(f"kill {kills} left an output file in part")
                continue
            if code != 0:
                sys.exit(f"after kill {kills} the program refused to go on: exit code {code}")
            if answer.read_bytes() != whole.read_bytes():
                sys.exit(f"after kill {kills} the resumed run gave another answer")
            ends += 1
            kills_since_end = 0
            answer.unlink()
            checkpoint.unlink()
        if most_kept == 0:
            sys.exit("no killed run left a step in its checkpoint, so nothing was tested")
    print(f"{kills} kills, {ends} runs to the end, up to {most_kept} bytes kept")


if __name__ == "__main__":
    main()
