#!/usr/bin/python3
"""Times strainwave beside a peer in numpy and scipy, on the same machine in the same run.

    cmake --preset benchmark && cmake --build --preset benchmark
    cmake --build --preset release --target strainwave_cli
    benchmarks/compare.py

Prints the time of one full corrected evaluation of the article's three-crack drive by both, their
ratio, whether they agree, and how long the program takes to start.  Exit status 1 if a goal of
`GOALS` is missed: run it on a quiet machine.
"""
import json
import pathlib
import statistics
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/release/apps/cli/strainwave"
BENCHMARKS = ROOT / "build/benchmark/benchmarks/strainwave_benchmarks"
PEER = ROOT / "benchmarks/peer/three_crack_drive.py"
GOALS = {"evaluation [us]": ("<=", 50.0), "peer / strainwave": (">=", 50.0),
         "--version [ms]": ("<", 20.0), "stiffness article.toml [ms]": ("<", 50.0)}


def evaluation():
    """Microseconds of one evaluation (median of 5 runs), and the stiffness it gave [N*m/rad]."""
    out = subprocess.check_output(
        [BENCHMARKS, "--benchmark_filter=three_crack_drive", "--benchmark_format=json",
         "--benchmark_repetitions=5"], text=True, stderr=subprocess.DEVNULL)
    rows = json.loads(out)["benchmarks"]
    median = next(row for row in rows if row.get("aggregate_name") == "median")
    return median["cpu_time"], median["stiffness"]


def peer():
    out = json.loads(subprocess.check_output(["/usr/bin/python3", PEER, "--repeat", "20"]))
    return out["seconds_per_evaluation"] * 1e6, out["stiffness_positive"]


def program(*arguments, runs=21):
    """Median wall time of a whole process in milliseconds."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        subprocess.run([PROGRAM, *arguments], check=True, stdout=subprocess.DEVNULL)
        times.append((time.perf_counter() - start) * 1e3)
    return statistics.median(times)


def main():
    own, stiffness = evaluation()
    other, peer_stiffness = peer()
    measured = {"evaluation [us]": own, "peer / strainwave": other / own,
                "--version [ms]": program("--version"),
                "stiffness article.toml [ms]": program("stiffness", ROOT / "examples/article.toml")}
    print(f"{'peer evaluation [us]':30} {other:10.1f}")
    missed = 0
    for name, value in measured.items():
        sense, goal = GOALS[name]
        met = value <= goal if sense != ">=" else value >= goal
        missed += not met
        print(f"{name:30} {value:10.1f}   goal {sense} {goal:g}{'' if met else '   MISSED'}")
    difference = abs(peer_stiffness / stiffness - 1)
    print(f"{'stiffness, relative difference':30} {difference:10.1e}   goal < 1e-07")
    return 1 if missed or not difference < 1e-7 else 0


if __name__ == "__main__":
    sys.exit(main())
