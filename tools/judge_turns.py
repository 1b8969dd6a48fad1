#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Judges K over a turn of the wave generator by finite elements (theory manual, chapter IN).

    tools/judge_turns.py run [--program FILE] [--work DIRECTORY]
    tools/judge_turns.py write [--work DIRECTORY]        tests/data/judgement_turn.csv
    tools/judge_turns.py table [--program FILE]          differences, as Markdown

`run` writes an input file for every crack, runs `strainwave fe turn` on it and keeps its answer in the
work directory (build/judgement_turn unless given).  It does not repeat finished cracks.  It takes about
half an hour on one core.  `write` takes every crack whose finite elements pass their own checks, and names
the others.  `table` runs `strainwave turn` on the cracks of the table.  The cracks are not nodes of
data/through_crack.txt.

The program is build/fe/apps/cli/strainwave unless given (preset `fe`).  Exit status 0 done, 1 a crack
failed, 2 no program or no cracks.
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
TABLE = ROOT / "tests/data/judgement_turn.csv"

# Lengths in mm: barrel, rim, diaphragm (thickness, bore; None: a cylinder), w_0, cam, torque in N*m.
CUPS = {
    "size 25": dict(barrel=(62.499, 0.453, 17.2), rim=(62.801, 0.755, 9.5), plate=(0.762, 36.8), w0=0.3175,
                    flattening=0.0, clearance=0.0, band=9.2, torque=48.0),
    "small": dict(barrel=(34.9, 0.30, 10.5), rim=(35.1, 0.48, 5.5), plate=(0.45, 20.0), w0=0.178,
                  flattening=0.0, clearance=0.0, band=5.0, torque=9.0),
    "large": dict(barrel=(100.0, 0.9, 30.0), rim=(100.4, 1.3, 16.0), plate=(1.1, 60.0), w0=0.95,
                  flattening=1.5, clearance=0.0, band=14.0, torque=300.0),
    "long": dict(barrel=(62.5, 0.6, 40.0), rim=(62.9, 0.9, 12.0), plate=(0.9, 30.0), w0=0.4,
                 flattening=0.0, clearance=0.02, band=10.0, torque=90.0),
    "thin": dict(barrel=(100.0, 0.45, 27.0), rim=(100.2, 0.8, 13.0), plate=(0.8, 55.0), w0=0.5,
                 flattening=1.5, clearance=0.01, band=0.0, torque=120.0),
    "thick": dict(barrel=(40.0, 0.55, 14.0), rim=(40.2, 0.75, 7.0), plate=(0.7, 22.0), w0=0.2,
                  flattening=3.0, clearance=0.0, band=6.0, torque=25.0),
    "cylinder": dict(barrel=(50.0, 0.5, 30.0), rim=(50.2, 0.7, 8.0), plate=None, w0=0.25, flattening=0.0,
                     clearance=0.0, band=7.0, torque=40.0),
}
# a in mm, beta in degrees, distance from the diaphragm in mm.
CRACKS = {
    "size 25": [(0.3, 45, 8.6), (5.0, 45, 8.6), (0.7, 45, 8.6), (1.3, 45, 6.0), (2.0, 45, 8.6), (2.0, 45, 11.5), (2.0, -45, 8.6), (3.2, 45, 8.6),
                (2.0, 30, 8.6), (2.0, 60, 7.5), (1.5, 10, 8.6), (2.5, 80, 9.0)],
    "small": [(0.4, 45, 5.2), (1.0, 45, 5.2), (1.6, 35, 5.6), (1.0, 65, 4.5)],
    "large": [(1.5, 45, 15.0), (3.0, 45, 15.0), (5.0, 50, 15.0), (3.0, 15, 12.0), (3.0, 75, 18.0)],
    "long": [(1.0, 45, 20.0), (2.0, 45, 30.0), (4.0, 45, 20.0), (3.0, 5, 20.0), (3.0, 85, 24.0), (6.0, 45, 20.0), (9.0, 45, 20.0)],
    "thin": [(1.2, 45, 13.5), (2.5, 45, 13.5), (4.5, 40, 13.5), (6.5, 45, 13.5), (2.5, -30, 16.0), (2.5, 70, 11.0)],
    "thick": [(0.8, 45, 7.0), (1.8, 45, 7.0), (1.8, 20, 7.0), (1.8, 70, 7.0), (3.5, 45, 7.0)],
    "cylinder": [(1.0, 45, 15.0), (2.5, 45, 20.0), (2.5, 25, 15.0), (2.5, 55, 12.0), (5.0, 45, 15.0), (7.5, 60, 15.0)],
}

# Surface cracks: depth and half length in mm, beta in degrees, distance in mm, mouth.
SURFACES = {
    "size 25": [(0.12, 0.15, 45, 8.6, "outer"), (0.2, 0.4, 45, 8.6, "inner"), (0.18, 0.6, 45, 11.0, "inner"),
                (0.3, 0.5, 45, 8.6, "outer"), (0.15, 0.3, 20, 8.6, "outer"), (0.15, 0.3, 70, 7.5, "inner")],
    "small": [(0.1, 0.2, 45, 5.2, "outer"), (0.2, 0.3, 40, 5.6, "inner")],
    "large": [(0.3, 0.5, 45, 15.0, "outer"), (0.6, 1.0, 50, 15.0, "inner")],
    "thick": [(0.2, 0.5, 45, 7.0, "outer"), (0.4, 0.5, 60, 7.0, "inner")],
}

DRIVE = """format = "strainwave-drive/1"
[material.steel]
youngs_modulus = "206 GPa"
poissons_ratio = 0.3
[drive]
ratio = 100
pitch_diameter = "{pitch!r} mm"
radial_displacement = "{w0!r} mm"
[load]
torque = "{torque!r} N*m"
[wave_generator]
material = "steel"
force_transmission_coefficient = 0.404
cam_flattening = {flattening!r}
[wave_generator.bearing]
ball_diameter = "{ball!r} mm"
inner_raceway_diameter = "{inner!r} mm"
outer_raceway_diameter = "{outer!r} mm"
inner_conformity = 0.53
outer_conformity = 0.53
loaded_balls = 5
ball_count = 23
clearance = "{clearance!r} mm"
{ring}[flexspline]
material = "steel"
wall_thickness = "{rim[1]!r} mm"
length = "{length!r} mm"
crack_free = "sections"
{shape}[flexspline.rim]
outer_diameter = "{rim[0]!r} mm"
wall_thickness = "{rim[1]!r} mm"
length = "{rim[2]!r} mm"
[flexspline.barrel]
outer_diameter = "{barrel[0]!r} mm"
wall_thickness = "{barrel[1]!r} mm"
length = "{barrel[2]!r} mm"
{plate_text}[[flexspline.crack]]
{crack}half_length = "{a!r} mm"
angle = "{beta!r} deg"
distance = "{distance!r} mm"
"""


def drive(name, a, beta, distance, depth=None, mouth=None):
    cup = CUPS[name]
    bore = cup["rim"][0] - 2 * cup["rim"][1]
    ring = ""
    if cup["band"]:
        ring = (f'[wave_generator.bearing.outer_ring]\nmean_radius = "{bore / 2 - bore / 80!r} mm"\n'
                f'thickness = "{bore / 40!r} mm"\nwidth = "{cup["band"]!r} mm"\n')
    outer = bore * 0.95
    ball = bore * 0.076
    plate = cup["plate"]
    plate_text = "" if plate is None else (
        f'[flexspline.diaphragm]\nouter_diameter = "{cup["barrel"][0] - cup["barrel"][1]!r} mm"\n'
        f'inner_diameter = "{plate[1]!r} mm"\nthickness = "{plate[0]!r} mm"\n')
    crack = 'kind = "through"\n' if depth is None else (
        f'kind = "surface"\ndepth = "{depth!r} mm"\nmouth = "{mouth}"\n')
    return DRIVE.format(crack=crack, pitch=cup["rim"][0] * 1.012, outer=outer, inner=outer - 2 * ball, ball=ball, ring=ring,
                        length=cup["barrel"][2] + cup["rim"][2], plate_text=plate_text,
                        shape="" if plate else 'shape = "cylinder"\n', a=a, beta=beta, distance=distance, **cup)


COLUMNS = ("barrel_diameter [m]", "barrel_wall [m]", "barrel_length [m]", "rim_diameter [m]", "rim_wall [m]",
           "rim_length [m]", "plate [m]", "bore [m]", "displacement [m]", "flattening [1]", "clearance [m]",
           "band [m]", "half_length [m]", "angle [rad]", "distance [m]", "depth [m]", "inside [1]")


def inputs(name, a, beta, distance, depth=None, mouth=None):
    """The columns of a crack, in SI units."""
    cup = CUPS[name]
    values = [*cup["barrel"], *cup["rim"], *(cup["plate"] or (None, None)), cup["w0"], cup["flattening"],
              cup["clearance"], cup["band"], a, beta, distance, depth,
              None if mouth is None else float(mouth == "inner")]
    cells = []
    for column, value in zip(COLUMNS, values):
        factor = {"m": 1e-3, "rad": math.pi / 180, "1": 1.0}[column.split("[")[1][:-1]]
        cells.append("" if value is None else f"{value * factor:.12g}")
    return cells


def cracks():
    """Name of the cup, arguments of the crack, name of its file."""
    for name, rows in CRACKS.items():
        for a, beta, distance in rows:
            yield name, (a, beta, distance), f"{name.replace(' ', '_')}_{a}_{beta}_{distance}"
    for name, rows in SURFACES.items():
        for depth, c, beta, distance, mouth in rows:
            yield (name, (c, beta, distance, depth, mouth),
                   f"{name.replace(' ', '_')}_{depth}_{c}_{beta}_{distance}_{mouth}")


def stations(answer):
    """K_max and Delta K in MPa*m^0.5 over torque and station, each of the worse tip."""
    found = {}
    size = answer["result"]["sizes"][0]
    for torque in size.get("turn", size)["torques"]:
        for station in torque["stations"]:
            key = (round(number(torque["torque"]), 9), number(station["station"]))
            K = station["mode_I"]
            pair = (number(K["largest"]) / 1e6, number(K["range"]) / 1e6)
            old = found.get(key, (0.0, 0.0))
            found[key] = (max(old[0], pair[0]), max(old[1], pair[1]))
    return found


def modes(answer):
    """K_II and K_III in MPa*m^0.5 at 30 and 120 degrees, of the upper tip under the largest torque."""
    size = answer["result"]["sizes"][0]
    torque = max(size.get("turn", size)["torques"], key=lambda of: number(of["torque"]))
    found = {}
    for station in torque["stations"]:
        if station["tip"] == "upper":
            found[(round(number(torque["torque"]), 9), number(station["station"]))] = {
                f"{mode}_{degrees}": station["factors"][mode]["values"][degrees // 5] / 1e6
                for mode in ("K_II", "K_III") for degrees in (30, 120)}
    return found


def at_place(found, place):
    """Values at a torque and a station, linear between the stations."""
    torque, station = place
    rows = sorted((s, values) for (t, s), values in found.items() if t == torque)
    for (s0, v0), (s1, v1) in zip(rows, rows[1:]):
        if s0 <= station <= s1:
            share = (station - s0) / (s1 - s0)
            return tuple(a + share * (b - a) for a, b in zip(v0, v1))
    raise ValueError(f"no station {station} at {torque} N*m")


def at_mode(found, place, case):
    return at_place({key: (values[0][case],) for key, values in found.items()}, place)[0]


def number(node):
    return float(node["value"]) if isinstance(node, dict) else float(node)


def ask(program, command, path):
    done = subprocess.run([*program, *command, path, "--format", "json"], capture_output=True, text=True,
                          check=False)
    try:
        answer = json.loads(done.stdout)
    except ValueError:
        return None, done.stderr.strip()
    return answer, done.stderr.strip()


def run(program, work):
    work.mkdir(parents=True, exist_ok=True)
    failed = False
    for name, crack, key in cracks():
        kept = work / f"{key}.json"
        if kept.exists():
            continue
        path = work / f"{key}.toml"
        path.write_text(drive(name, *crack))
        answer, error = ask(program, ["fe", "turn"], path)
        if answer is None:
            print(f"{key}: {error}", file=sys.stderr)
            failed = True
            continue
        kept.write_text(json.dumps(answer))
        print(key, flush=True)
    return 1 if failed else 0


def write(work):
    rows = []
    failed = False
    for name, crack, key in cracks():
        kept = work / f"{key}.json"
        if not kept.exists():
            print(f"{key}: not computed; run first", file=sys.stderr)
            failed = True
            continue
        answer = json.loads(kept.read_text())
        if not answer["usable"]:
            print(f"{key}: {answer['verdict']['reason']}", file=sys.stderr)
            failed = True
            continue
        unknowns = answer["result"]["sizes"][0]["turn"]["torques"][0]["evidence"]["unknowns"]
        ranges = {place: dict(zip(("K_max", "range"), values)) for place, values in stations(answer).items()}
        for place, more in modes(answer).items():
            ranges[place] |= more
        for (torque, station), values in sorted(ranges.items()):
            for case, value in values.items():
                rows.append([case, *inputs(name, *crack), f"{torque:g}", f"{station:g}",
                             f"{value * 1e6:.5g}", "Pa*m^0.5", 3, f"strainwave fe turn; {unknowns} unknowns"])
    head = ["case", *COLUMNS, "torque [N*m]", "station [1]", "value", "unit", "digits", "source"]
    rows.insert(0, head)
    TABLE.write_text("".join(",".join(str(cell) for cell in row) + "\n" for row in rows))
    return 1 if failed else 0


def table(program, work):
    work.mkdir(parents=True, exist_ok=True)
    known = {}
    with TABLE.open() as file:
        for row in csv.DictReader(file):
            place = (round(float(row["torque [N*m]"]), 9), float(row["station [1]"]))
            known.setdefault(tuple(row[column] for column in COLUMNS), {}).setdefault(place, {})[
                row["case"]] = float(row["value"]) / 1e6
    print("| cup | size, mm | $\\beta$ | $z$, mm | $K_\\text{max}$ | $\\Delta K$ | worst station | sheared |")
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    for name, crack, key in cracks():
        truth = known.get(tuple(inputs(name, *crack)))
        if truth is None:
            continue
        path = work / f"{key}.toml"
        path.write_text(drive(name, *crack))
        answer, error = ask(program, ["turn"], path)
        if answer is None and "at most a sixth" in error:
            continue  # longer than the program takes
        if answer is None:
            print(error, file=sys.stderr)
            return 1
        ours = stations(answer)
        largest = max(values["K_max"] for values in truth.values())
        widest = max(values["range"] for values in truth.values())
        worst = max(abs(at_place(ours, place)[i] - values[case]) / largest
                    for place, values in truth.items() for i, case in enumerate(("K_max", "range")))
        # K_II and K_III over the largest K of all modes
        of_modes = {place: (values,) for place, values in modes(answer).items()}
        most = max(largest, *(abs(value) for values in truth.values() for case, value in values.items()))
        sheared = max(abs(at_mode(of_modes, place, case) - value) / most
                      for place, values in truth.items() for case, value in values.items() if "_II" in case)
        size, beta, distance = crack[:3]
        if len(crack) > 3:
            size = f"{crack[3]} × {2 * crack[0]:g} {crack[4]}"
        pairs = [(at_place(ours, place), values) for place, values in truth.items()]
        print(f"| {name} | {size} | {beta}° | {distance} | {100 * (max(v[0] for v, _ in pairs) / largest - 1):+.1f} "
              f"| {100 * (max(v[1] for v, _ in pairs) / widest - 1):+.1f} | {100 * worst:.1f} | {100 * sheared:.1f} |", flush=True)
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=("run", "write", "table"))
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/fe/apps/cli/strainwave")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/judgement_turn")
    arguments = parser.parse_args()
    if arguments.action == "write":
        return write(arguments.work)
    if not arguments.program.exists():
        print(f"{arguments.program} is missing; build the preset fe", file=sys.stderr)
        return 2
    program = [str(arguments.program)]
    return (run if arguments.action == "run" else table)(program, arguments.work)


if __name__ == "__main__":
    sys.exit(main())
