#!/usr/bin/python3
"""Compares the times of strainwave and of a peer in numpy and scipy, on the same machine in the same run.

    cmake --preset benchmark && cmake --build --preset benchmark
    cmake --build --preset fe --target strainwave_cli
    benchmarks/compare.py

Prints one table: the times and ratios of `GOALS`, each with its goal, and whether both programs agree.  The peers are those of
benchmarks/peer, and CalculiX for the finite elements (compare_fe.py).  The exit status is 1 if a goal is missed.  Run the script on a quiet machine.
"""
import json
import math
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import time

import compare_fe

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build/fe/apps/cli/strainwave"
BENCHMARKS = ROOT / "build/benchmark/benchmarks/strainwave_benchmarks"
PEER = ROOT / "benchmarks/peer/three_crack_drive.py"
LIFE_PEER = ROOT / "benchmarks/peer/crack_life_peer.py"
MOTION_PEER = ROOT / "benchmarks/peer/joint_motion_peer.py"
BALANCE_PEER = ROOT / "benchmarks/peer/duffing_balance_peer.py"
GROUP_PEER = ROOT / "benchmarks/peer/crack_group_peer.py"
CURVE_PEER = ROOT / "benchmarks/peer/coupled_drive_peer.py"
GOALS = {"evaluation [us]": ("<=", 15.0), "peer / strainwave": (">=", 100.0),
         "draw by tables [us]": ("<=", 1.0), "peer / draw by tables": (">=", 30.0),
         "a million draws, two threads [s]": ("<=", 0.8), "one thread / two threads": (">=", 1.9),
         "numpy in columns / draw of a million": (">=", 10.0),
         "draw by tables / as many multiply-adds": ("<=", 10.0),
         "time over draws, exponent": ("<=", 1.05), "time over cracks, exponent": ("<=", 1.05),
         "all elasticities [us]": ("<=", 60.0),
         "--version [ms]": ("<", 20.0), "stiffness article.toml [ms]": ("<", 50.0),
         "curve of 11 points [ms]": ("<=", 0.6), "curve of 200 points [ms]": ("<=", 5.0),
         "comparison at 200 positions [ms]": ("<=", 200.0), "band of 200 draws [ms]": ("<=", 60.0),
         "report of size 25 [ms]": ("<=", 150.0),
         "peer / strainwave, 11 points": (">=", 5.0), "peer / strainwave, 200 points": (">=", 5.0),
         "life, quad in numpy / strainwave": (">=", 100.0),
         "life, quad in Python / strainwave": (">=", 12.0),
         "motion in contacts / real time": (">=", 50.0),
         "motion / real time": (">=", 250.0), "motion, best of scipy / strainwave": (">=", 60.0),
         "turn, 36 angles, one torque [ms]": ("<=", 5.0),
         "backbone of 200 points [ms]": ("<=", 20.0), "backbone with hysteresis [ms]": ("<=", 200.0),
         "backbone, numpy / strainwave": (">=", 10.0),
         "1e5 lives of the example drive, two threads [s]": ("<=", 60.0),
         "lives, one thread / two threads": (">=", 1.9),
         "1e5 lives of constant amplitude [s]": ("<=", 0.1),
         "lives, numpy / strainwave": (">=", 1.0),
         "both plans of inspections from kept draws [s]": ("<=", 1.0),
         "likelihood of 44 specimens [ms]": ("<=", 50.0), "fit of 44 specimens [s]": ("<=", 10.0),
         "group of 10 cracks [ms]": ("<=", 20.0), "group of 100 cracks [s]": ("<=", 20.0),
         "crack of a row [ms]": ("<=", 2.0), "group, numpy / strainwave": (">=", 1.0)}


def benchmark(name, counter):
    """CPU time of one evaluation (median of 5 runs), and its counter after the run."""
    out = subprocess.check_output(
        [BENCHMARKS, f"--benchmark_filter=^{name}$", "--benchmark_format=json",
         "--benchmark_repetitions=5"], text=True, stderr=subprocess.DEVNULL)
    rows = json.loads(out)["benchmarks"]
    median = next(row for row in rows if row.get("aggregate_name") == "median")
    return median["cpu_time"], median[counter]


def wall_time(name):
    """Wall time of one evaluation."""
    out = subprocess.check_output(
        [BENCHMARKS, f"--benchmark_filter=^{name}$", "--benchmark_format=json"], text=True,
        stderr=subprocess.DEVNULL)
    return json.loads(out)["benchmarks"][0]["real_time"]


def curve_peer():
    """The peer's answer, on one thread."""
    environment = os.environ | {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    return json.loads(subprocess.check_output(["/usr/bin/python3", CURVE_PEER, "--repeat", "3"],
                                              env=environment))


def life_peer():
    return json.loads(subprocess.check_output(["/usr/bin/python3", LIFE_PEER]))


def motion_peer():
    """The best simulated time over CPU time of scipy's methods, and the exact angle."""
    answer = json.loads(subprocess.check_output(["/usr/bin/python3", MOTION_PEER]))
    exact = answer.pop("exact")
    return max(method["real_time"] for method in answer.values()), exact


def motion(name):
    """Simulated time over CPU time with the loosest tolerance that is within 1e-6 rad, and the angle."""
    for digits in range(6, 11):
        out = subprocess.check_output(
            [BENCHMARKS, f"--benchmark_filter=^{name}/{digits}$", "--benchmark_format=json"],
            text=True, stderr=subprocess.DEVNULL)
        row = json.loads(out)["benchmarks"][0]
        if row["error_rad"] <= 1e-6:
            return row["real_time"], row["output_angle"]
    raise RuntimeError(f"no tolerance of {name} is within 1e-6 rad")


def balance_peer():
    """Seconds of numpy for the backbone of a cubic spring, and its last frequency, on one thread."""
    one = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    answer = json.loads(subprocess.check_output(["/usr/bin/python3", BALANCE_PEER], env=one))
    return answer["seconds"], answer["last_hertz"]


def peer():
    out = json.loads(subprocess.check_output(["/usr/bin/python3", PEER, "--repeat", "20"]))
    return out["seconds_per_evaluation"] * 1e6, out["stiffness_positive"]


def columns_peer():
    """Microseconds of a draw of eight numbers in columns of numpy, on one thread."""
    one = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    out = json.loads(subprocess.check_output(["/usr/bin/python3", PEER, "--draws", "1000000"], env=one))
    return out["seconds_per_draw"] * 1e6


def exponent(name, decades):
    """Slope of the logarithm of the time over that of the size, by least squares."""
    sizes = [10.0**d for d in decades]
    x = [math.log(size) for size in sizes]
    y = [math.log(wall_time(f"{name}/{size:.0f}")) for size in sizes]
    middle = statistics.mean(x)
    return sum((a - middle) * b for a, b in zip(x, y)) / sum((a - middle)**2 for a in x)


def group_peer():
    """K of 10 cracks and the mean of 1e5 lives by numpy, with their seconds, on one thread."""
    one = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    return json.loads(subprocess.check_output(["/usr/bin/python3", GROUP_PEER], env=one))


def program(*arguments, runs=21):
    """Median wall time of a whole process in milliseconds."""
    times = []
    for _ in range(runs):
        start = time.perf_counter()
        subprocess.run([PROGRAM, *arguments], check=True, stdout=subprocess.DEVNULL)
        times.append((time.perf_counter() - start) * 1e3)
    return statistics.median(times)


def main():
    own, stiffness = benchmark("three_crack_drive", "stiffness")
    other, peer_stiffness = peer()
    curve_11, twist = benchmark("torsion_curve_points/11", "twist")
    curve_200, _ = benchmark("torsion_curve_points/200", "twist")
    curve_other = curve_peer()
    life, life_error = benchmark("growth_life", "error")  # [ns]
    life_other = life_peer()
    moved, angle = motion("joint_motion")
    in_contacts, _ = motion("motion_in_contacts")
    moved_other, angle_other = motion_peer()
    turn, _ = benchmark("drive_turn_of_through_crack/1", "range")
    backbone, hertz = benchmark("backbone_of_200_points/0", "last_hertz")
    with_hysteresis, _ = benchmark("backbone_of_200_points/3", "last_hertz")
    backbone_other, hertz_other = balance_peer()
    draw, draw_stiffness = benchmark("draw_of_three_cracks", "stiffness")
    million = {threads: wall_time(f"scatter_of_a_million/{threads}/real_time") for threads in (1, 2)}
    lives = {threads: wall_time(f"lives_of_the_shaft/{threads}/real_time") * 1e5 / 2000
             for threads in (1, 2)}
    constant, mean_life = benchmark("lives_of_constant_amplitude", "mean")  # [s]
    group, factor = benchmark("crack_groups/10", "K")  # [ms]
    group_other = group_peer()
    size_25 = ROOT / "examples/catalogue_size25.toml"
    measured = {"evaluation [us]": own, "peer / strainwave": other / own,
                "draw by tables [us]": draw, "peer / draw by tables": other / draw,
                "a million draws, two threads [s]": million[2],
                "one thread / two threads": million[1] / million[2],
                "numpy in columns / draw of a million": columns_peer() / million[1],
                "draw by tables / as many multiply-adds": draw / wall_time("multiply_adds_of_a_draw"),
                "time over draws, exponent": exponent("scatter_of_draws", range(3, 8)),
                "time over cracks, exponent": exponent("compliance_of_cracks", range(0, 5)),
                "all elasticities [us]": wall_time("sensitivity_of_three_cracks"),
                "--version [ms]": program("--version"),
                "stiffness article.toml [ms]": program("stiffness", ROOT / "examples/article.toml"),
                "curve of 11 points [ms]": curve_11, "curve of 200 points [ms]": curve_200,
                "comparison at 200 positions [ms]": program(
                    "torsion", "--compare", "--angles", "200", ROOT / "examples/cracked_size25.toml"),
                "band of 200 draws [ms]": program("torsion", size_25, "--draws", "200")
                - program("torsion", size_25, "--draws", "0"),
                "report of size 25 [ms]": program("report", size_25),
                "peer / strainwave, 11 points": 1e3 * curve_other["seconds_11"] / curve_11,
                "peer / strainwave, 200 points": 1e3 * curve_other["seconds_200"] / curve_200,
                "life, quad in numpy / strainwave": 1e9 * life_other["numpy"]["seconds"] / life,
                "life, quad in Python / strainwave": 1e9 * life_other["python"]["seconds"] / life,
                "motion in contacts / real time": in_contacts,
                "motion / real time": moved, "motion, best of scipy / strainwave": moved / moved_other,
                "turn, 36 angles, one torque [ms]": turn,
                "backbone of 200 points [ms]": backbone,
                "backbone with hysteresis [ms]": with_hysteresis,
                "backbone, numpy / strainwave": 1e3 * backbone_other / backbone,
                "1e5 lives of the example drive, two threads [s]": lives[2],
                "lives, one thread / two threads": lives[1] / lives[2],
                "1e5 lives of constant amplitude [s]": constant,
                "lives, numpy / strainwave": group_other["lives"]["seconds"] / constant,
                "both plans of inspections from kept draws [s]": wall_time("inspection_plan"),
                "likelihood of 44 specimens [ms]": wall_time("growth_likelihood"),
                "fit of 44 specimens [s]": wall_time("growth_fit") / 1e3,
                "group of 10 cracks [ms]": group,
                "group of 100 cracks [s]": wall_time("crack_groups/100/iterations:1") / 1e3,
                "crack of a row [ms]": wall_time("crack_of_a_row"),
                "group, numpy / strainwave": 1e3 * group_other["group"]["seconds"] / group}
    goals = dict(GOALS)
    if shutil.which("ccx"):
        ratios = compare_fe.ratios()
        measured |= ratios
        goals |= {name: (">=", compare_fe.goal(name)) for name in ratios}
    print(f"{'peer evaluation [us]':46} {other:9.1f}")
    missed = 0
    for name, value in measured.items():
        sense, goal = goals[name]
        met = value <= goal if sense != ">=" else value >= goal
        missed += not met
        print(f"{name:46} {value:9.3g}   goal {sense} {goal:g}{'' if met else '   MISSED'}")
    difference = abs(peer_stiffness / stiffness - 1)
    print(f"{'stiffness, relative difference':46} {difference:9.1e}   goal < 1e-07")
    by_tables = abs(draw_stiffness / stiffness - 1)
    print(f"{'stiffness by tables, difference':46} {by_tables:9.1e}   goal < 1e-10")
    turned = abs(curve_other["twist_at_T3"] / twist - 1)
    print(f"{'twist, relative difference':46} {turned:9.1e}   goal < 1e-07")
    print(f"{'life, relative error':46} {abs(life_error):9.1e}   goal < 1e-09")
    print(f"{'motion, difference [rad]':46} {abs(angle - angle_other):9.1e}   goal < 2e-06")
    print(f"{'backbone, relative difference':46} {abs(hertz / hertz_other - 1):9.1e}   goal < 1e-07")
    same_K = abs(group_other["group"]["value"] / factor - 1)
    print(f"{'K of a group, difference':46} {same_K:9.1e}   goal < 1e-05")
    same_life = abs(group_other["lives"]["value"] / mean_life - 1)
    print(f"{'mean life, difference':46} {same_life:9.1e}   goal < 1e-06")
    agree = (same_K < 1e-5 and same_life < 1e-6 and by_tables < 1e-10 and abs(hertz / hertz_other - 1) < 1e-7 and difference < 1e-7 and turned < 1e-7 and abs(life_error) < 1e-9
             and abs(angle - angle_other) < 2e-6)
    return 1 if missed or not agree else 0


if __name__ == "__main__":
    sys.exit(main())
