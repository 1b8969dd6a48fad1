#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Judges the closed forms by finite elements (theory manual, chapter FE).

    tools/judge_closed_forms.py run FAMILY ... [--program FILE] [--work DIRECTORY]
    tools/judge_closed_forms.py write [--work DIRECTORY]       tests/data/judgement_*.csv of the points
    tools/judge_closed_forms.py table [--program FILE]         closed form over finite elements, Markdown

`run` writes an input file for every point of a family, runs `strainwave fe` on it and keeps its answer
in the work directory (build/judgement unless given).  It does not repeat finished points; a killed run
loses only one point.  Families: annular, through, inclined, closed, surface, cup; `all`.  A family takes
minutes to an hour on one core.  `write` takes every finished point whose finite elements pass their own
checks, and names the other points.  `table` runs `strainwave stiffness` and `strainwave sif eval` at the
points of the tables.  Both sides use the same numbers; among them is the shear modulus E/(2(1+nu)).

The program is build/fe/apps/cli/strainwave unless given (preset `fe`).  Numbers are dimensionless;
see `normalised` of each family.  Exit status 0 done, 1 a point failed, 2 no program or no points.
"""

import argparse
import json
import math
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
DATA = ROOT / "tests/data"
E = 210e9  # Pa
TORQUE, FORCE = 100.0, 1000.0  # N*m, N
RADIUS = 0.07  # of tubes and shafts [m]

HEAD = """format = "strainwave-drive/1"
[material.steel]
youngs_modulus = "{E!r} Pa"
poissons_ratio = {nu!r}
[drive]
ratio = 100
pitch_diameter = "{pitch!r} m"
radial_displacement = "{displacement!r} m"
[load]
torque = "{torque!r} N*m"
axial_force = "{force!r} N"
"""


def head(nu, pitch, force=0.0):
    return HEAD.format(E=E, nu=nu, pitch=pitch, displacement=pitch / 200, torque=TORQUE, force=force)


def value(node):
    return float(node["value"])


def evidence_of_solid(answer, evidence):
    return (f"finite elements of order {answer['solid_order']}; {evidence['unknowns']} unknowns; "
            f"growth check {abs(value(evidence['growth_check'])):.0e}")


class Annular:
    """Annular crack from outside in a solid or hollow shaft, four diameters long."""
    name = "annular"
    table = "judgement_annular"
    inputs = ("radius_ratio [1]", "depth_ratio [1]", "poissons_ratio [1]")
    member = "output-shaft"

    @staticmethod
    def points():
        ratios = (0.0, 0.3, 0.6, 0.8, 0.9)
        depths = (0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
        points = [(r, d, 0.3) for r in ratios for d in depths]
        # Poisson's ratio enters tension only.
        return points + [(r, d, nu) for nu in (0.0, 0.45) for r in ratios for d in (0.1, 0.4, 0.8)]

    @staticmethod
    def file(point):
        ratio, depth, nu = point
        return head(nu, 2 * RADIUS, FORCE) + f"""
[output_shaft]
material = "steel"
outer_diameter = "{2 * RADIUS!r} m"
inner_diameter = "{2 * RADIUS * ratio!r} m"
length = "{8 * RADIUS!r} m"
[[output_shaft.crack]]
kind = "annular"
depth = "{depth * RADIUS * (1 - ratio)!r} m"
"""

    @staticmethod
    def normalised(point, added_T, added_P, K_III, K_I):
        """Divides by the values of a shallow crack: K over nominal stress sqrt(pi a), with K_I/1.1215."""
        ratio, depth, nu = point
        a = depth * RADIUS * (1 - ratio)
        mu = E / (2 * (1 + nu))
        J = math.pi / 2 * RADIUS ** 4 * (1 - ratio ** 4)
        A = math.pi * RADIUS ** 2 * (1 - ratio ** 2)
        shallow = math.pi ** 2 * a ** 2 * RADIUS
        return {"C_T": added_T / (shallow * RADIUS ** 2 / (mu * J ** 2)),
                "C_P": added_P / (2 * (1 - nu ** 2) / E * 1.1215 ** 2 * shallow / A ** 2),
                "K_III": K_III / (TORQUE * RADIUS / J * math.sqrt(math.pi * a)),
                "K_I": K_I / (1.1215 * FORCE / A * math.sqrt(math.pi * a))}

    @classmethod
    def elements(cls, point, answer):
        crack = answer["output_shaft"]["cracks"][0]
        if not (crack["torsion"]["usable"] and crack["tension"]["usable"]):
            return None, crack["torsion"]["reason"] or crack["tension"]["reason"]
        K = crack["stress_intensity"]
        source = (f"finite elements of order {answer['section_order']}; "
                  f"{crack['tension']['evidence']['unknowns']} unknowns; growth check "
                  f"{abs(value(crack['tension']['evidence']['growth_check'])):.0e}")
        return cls.normalised(point, value(crack["torsion"]["added_compliance"]),
                              value(crack["tension"]["added_compliance"]),
                              value(K["K_III"]), value(K["K_I"])), source

    @classmethod
    def closed(cls, point, program):
        crack = stiffness(program, cls.file(point))["cracks"][0]
        added = crack["added_compliance"]["positive"]
        K = crack["stress_intensity"]["deepest"]
        return cls.normalised(point, value(added["torsion_torsion"]), value(added["axial_axial"]),
                              value(K["K_III"]), value(K["K_I"]))


class Through:
    """Through crack at 45 degrees in a tube under torque that opens it; length, wall and nu vary."""
    name = "through"
    table = "judgement_through"
    inputs = ("radius_ratio [1]", "length_ratio [1]", "angle [rad]", "poissons_ratio [1]")
    member = "flexspline"

    @staticmethod
    def points():
        points = [(35, a, 45, 0.3) for a in (0.05, 0.1, 0.2, 0.35, 0.5, 0.75, 1, 1.5, 2, 3, 4.5, 6.5,
                                             9, 13)]
        points += [(20, a, 45, 0.3) for a in (0.25, 0.5, 1, 2, 3, 4.5, 6.5, 9, 11)]
        points += [(60, a, 45, 0.3) for a in (0.5, 1, 2, 3, 4.5, 6.5, 9, 13, 17)]
        return points + [(35, a, 45, nu) for nu in (0.0, 0.45) for a in (1, 4.5)]

    @staticmethod
    def file(point):
        ratio, length, degrees, nu = point
        t = RADIUS / ratio
        return head(nu, 2 * RADIUS + t) + f"""
[flexspline]
material = "steel"
shape = "cylinder"
wall_thickness = "{t!r} m"
length = "{4 * RADIUS!r} m"
[[flexspline.crack]]
kind = "through"
half_length = "{length * t!r} m"
angle = "{float(degrees)!r} deg"
"""

    @staticmethod
    def normalised(point, added, release):
        """Divides by the values of a flat sheet in plane stress, at any angle: 2 pi t tau^2 a^2/(E T^2) and
        tau^2 pi a/E; tau is the exact stress at mid-wall in each of them."""
        ratio, length, _, _ = point
        t = RADIUS / ratio
        a = length * t
        J = math.pi / 2 * ((RADIUS + t / 2) ** 4 - (RADIUS - t / 2) ** 4)
        tau = TORQUE * RADIUS / J
        return {"C": added * TORQUE ** 2 * E / (2 * math.pi * t * (tau * a) ** 2),
                "G": release * E / (tau ** 2 * math.pi * a)}

    @classmethod
    def elements(cls, point, answer):
        sense = answer["flexspline"]["cracks"][0]["positive"]
        # At 90 degrees only the ends of the tube open or close the crack, by 1e-3 of K_II.
        faces = ("open", "partly closed") if point[2] == 90 else ("open",)
        if not sense["usable"] or sense["faces"] not in faces:
            return None, sense["reason"] or f"the faces are {sense['faces']}"
        result = cls.normalised(point, value(sense["added_compliance"]),
                                value(sense["energy_release_rate"]))
        unit = TORQUE / (2 * math.pi * RADIUS ** 3 / point[0])
        unit *= math.sqrt(math.pi * point[1] * RADIUS / point[0])
        fronts = [front["from_inner_to_outer_face"] for front in sense["fronts"]]
        for name, k in (("inner", 0), ("middle", len(fronts[0]["K_I"]["values"]) // 2), ("outer", -1)):
            for mode in ("K_I", "K_II"):
                mean = sum(front[mode]["values"][k] for front in fronts) / len(fronts)
                # The elements count sliding in the other sense.
                result[f"{mode}_{name}"] = (mean if mode == "K_I" else -mean) / unit
        return result, evidence_of_solid(answer, sense["evidence"])

    @classmethod
    def closed(cls, point, program):
        ratio, length, degrees, nu = point
        t = RADIUS / ratio
        crack = stiffness(program, cls.file(point))["cracks"][0]
        added = value(crack["added_compliance"]["positive"]["torsion_torsion"])
        fields = {"half_length": f"{length * t!r} m", "angle": f"{float(degrees)!r} deg",
                  "mean_radius": f"{RADIUS!r} m", "thickness": f"{t!r} m",
                  "poissons_ratio": repr(nu), "torque": f"{TORQUE!r} N*m"}
        sets = [f"--set={name}={text}" for name, text in fields.items()]
        shell = output(program, ["sif", "eval", "tube-through-inclined", *sets, "--format", "json"])
        K = {point["name"]: point for point in shell["points"]}
        wall = {name: (value(K[name]["K_I"]), value(K[name]["K_II"])) for name in ("inner", "middle", "outer")}
        # Linear through the wall: Simpson's rule is exact.
        release = sum(w * (k[0] ** 2 + k[1] ** 2) for w, k in
                      ((1 / 6, wall["inner"]), (2 / 3, wall["middle"]), (1 / 6, wall["outer"]))) / E
        result = cls.normalised(point, added, release)
        unit = TORQUE / (2 * math.pi * RADIUS ** 2 * t) * math.sqrt(math.pi * length * t)
        for name, k in wall.items():
            result[f"K_I_{name}"], result[f"K_II_{name}"] = k[0] / unit, k[1] / unit
        return result


class Inclined(Through):
    """Through crack at other angles under torque that opens it."""
    name = "inclined"

    @staticmethod
    def points():
        return [(35, a, degrees, 0.3) for degrees in (0, 15, 30, 60, 75, 90) for a in (1.5, 4.5, 9)]


class Closed(Inclined):
    """Through crack under torque that closes it; the faces slide without friction."""
    name = "closed"
    table = "judgement_closed"

    @staticmethod
    def points():
        return [(35, a, degrees, 0.3) for degrees in (15, 30, 60, 75) for a in (4.5, 9)]

    @classmethod
    def elements(cls, point, answer):
        sense = answer["flexspline"]["cracks"][0]["negative"]
        if not sense["usable"] or sense["faces"] != "closed":
            return None, sense["reason"] or f"the faces are {sense['faces']}"
        return (cls.normalised(point, value(sense["added_compliance"]),
                               value(sense["energy_release_rate"])),
                evidence_of_solid(answer, sense["evidence"]))

    @classmethod
    def closed(cls, point, program):
        crack = stiffness(program, cls.file(point))["cracks"][0]
        added = crack["added_compliance"]["negative"]["torsion_torsion"]
        return {"C": cls.normalised(point, value(added), 0.0)["C"]}


class Surface:
    """Semi-elliptical crack from outside in a tube, r/t = 35, under torque that opens it."""
    name = "surface"
    table = "judgement_surface"
    inputs = ("radius_ratio [1]", "depth_ratio [1]", "aspect_ratio [1]", "angle [rad]")
    member = "flexspline"

    @staticmethod
    def points():
        points = [(35, depth, aspect, 45) for depth in (0.2, 0.5, 0.8) for aspect in (0.4, 1)]
        return points + [(35, 0.5, aspect, degrees) for aspect in (0.4, 1) for degrees in (20, 70)]

    @staticmethod
    def file(point):
        ratio, depth, aspect, degrees = point
        t = RADIUS / ratio
        return head(0.3, 2 * RADIUS + t) + f"""
[flexspline]
material = "steel"
shape = "cylinder"
wall_thickness = "{t!r} m"
length = "{2 * RADIUS!r} m"
[[flexspline.crack]]
kind = "surface"
depth = "{depth * t!r} m"
half_length = "{depth / aspect * t!r} m"
angle = "{float(degrees)!r} deg"
"""

    @staticmethod
    def normalised(point, added, K):
        """Divides by 2 pi tau^2 a^2 c/(E T^2) and tau sqrt(pi a) with Bredt's tau; K at the deepest point."""
        ratio, depth, aspect, _ = point
        t = RADIUS / ratio
        a = depth * t
        tau = TORQUE / (2 * math.pi * RADIUS ** 2 * t)
        return {"C": added * TORQUE ** 2 * E / (2 * math.pi * tau ** 2 * a ** 3 / aspect),
                **{mode: abs(value(K[mode])) / (tau * math.sqrt(math.pi * a))
                   for mode in (("K_I",) if point[3] == 45 else ("K_I", "K_III"))}}

    @classmethod
    def elements(cls, point, answer):
        sense = answer["flexspline"]["cracks"][0]["positive"]
        if not sense["usable"] or sense["faces"] != "open":
            return None, sense["reason"] or f"the faces are {sense['faces']}"
        front = {name: column["values"] for name, column in sense["from_upper_to_lower_end"].items()}
        at = min(range(len(front["K_I"])), key=lambda i: abs(front["front_angle"][i] - math.pi / 2))
        deepest = {mode: {"value": front[mode][at]} for mode in ("K_I", "K_III")}
        return (cls.normalised(point, value(sense["added_compliance"]), deepest),
                evidence_of_solid(answer, sense["evidence"]))

    @classmethod
    def closed(cls, point, program):
        crack = stiffness(program, cls.file(point))["cracks"][0]
        return cls.normalised(point, value(crack["added_compliance"]["positive"]["torsion_torsion"]),
                              crack["stress_intensity"]["deepest"])


class Cup:
    """Sound cup, barrel 80.5 x 0.6 x 40 mm; the diaphragm's bore and thickness vary."""
    name = "cup"
    table = "judgement_cup"
    inputs = ("bore_ratio [1]", "diaphragm_ratio [1]")
    member = "flexspline"
    OUTER, WALL, LENGTH = 80.5e-3, 0.6e-3, 40e-3

    @staticmethod
    def points():
        return [(bore, h) for bore in (0.3, 0.5, 0.7, 0.85) for h in (0.5, 1, 2, 4)]

    @classmethod
    def file(cls, point, free="sections"):
        bore, h = point
        inner = cls.OUTER - 2 * cls.WALL
        text = head(0.3, cls.OUTER) + f"""
[flexspline]
material = "steel"
shape = "cup"
wall_thickness = "{cls.WALL!r} m"
length = "{cls.LENGTH!r} m"
crack_free = "{free}"
"""
        if free == "factor":
            return text + "shape_factor = 0.83\n"
        return text + f"""
[flexspline.barrel]
outer_diameter = "{cls.OUTER!r} m"
wall_thickness = "{cls.WALL!r} m"
length = "{cls.LENGTH!r} m"
[flexspline.diaphragm]
outer_diameter = "{cls.OUTER - cls.WALL!r} m"
inner_diameter = "{bore * inner!r} m"
thickness = "{h * cls.WALL!r} m"
"""

    @classmethod
    def normalised(cls, compliance):
        """Divides by the compliance of the barrel alone."""
        r, q = cls.OUTER / 2, cls.OUTER / 2 - cls.WALL
        return compliance * E / 2.6 * math.pi / 2 * (r ** 4 - q ** 4) / cls.LENGTH

    @classmethod
    def elements(cls, point, answer):
        sound = answer["flexspline"]["sound"]
        if not sound["usable"]:
            return None, sound["reason"]
        return ({"compliance": cls.normalised(value(sound["compliance"]))},
                f"finite elements of order {answer['section_order']}; "
                f"{sound['evidence']['unknowns']} unknowns; order below {abs(value(sound['evidence']['lower_order'])):.0e}")

    @classmethod
    def closed(cls, point, program):
        return {"compliance": cls.normalised(value(
                    stiffness(program, cls.file(point))["intact"]["compliance"]["flexspline"])),
                "factor": cls.normalised(value(
                    stiffness(program, cls.file(point, "factor"))["intact"]["compliance"]["flexspline"]))}


FAMILIES = {family.name: family for family in (Annular, Through, Inclined, Closed, Surface, Cup)}


def output(program, arguments, text=None):
    """The result in the JSON that the program prints; exit code 4 means that the answer failed its own checks."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OMPI_ALLOW_RUN_AS_ROOT": "1",
                   "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    done = subprocess.run([program, *arguments], input=text, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, env=environment)
    if done.returncode not in (0, 4):
        raise RuntimeError(done.stderr.strip() or f"exit status {done.returncode}")
    return json.loads(done.stdout)["result"]


def stiffness(program, text):
    return output(program, ["stiffness", "-", "--format", "json"], text)


def stem(family, point):
    return family.name + "".join(f"_{x:g}" for x in point)


def run(families, program, work):
    failed = 0
    work.mkdir(parents=True, exist_ok=True)
    for family in families:
        for point in family.points():
            path = work / f"{stem(family, point)}.json"
            if path.exists():
                continue
            drive = work / f"{stem(family, point)}.toml"
            drive.write_text(family.file(point))
            try:
                answer = output(program, ["fe", str(drive), "--member", family.member, "--format", "json"])
            except (RuntimeError, json.JSONDecodeError) as error:
                print(f"{path.stem}: {error}", flush=True)
                failed += 1
                continue
            partial = path.with_suffix(".partial")
            partial.write_text(json.dumps(answer))
            partial.rename(path)
            print(f"{path.stem}: {family.elements(point, answer)}", flush=True)
    return 1 if failed else 0


def write(work):
    tables = {}
    for family in FAMILIES.values():
        for point in family.points():
            path = work / f"{stem(family, point)}.json"
            if not path.exists():
                print(f"{path.stem}: not there")
                continue
            result, source = family.elements(point, json.loads(path.read_text()))
            if result is None:
                print(f"{path.stem}: left out, {source}")
                continue
            rows = tables.setdefault(family.table, [["case", *family.inputs, "value", "unit", "digits",
                                                     "source"]])
            cells = [repr(math.radians(x) if name.startswith("angle") else float(x))
                     for name, x in zip(family.inputs, point)]
            digits = "4" if family in (Annular, Cup) else "3"
            for case, x in result.items():
                rows.append([case, *cells, f"{x:.6g}", "1", digits, source.replace(",", ";")])
    for name, rows in tables.items():
        (DATA / f"{name}.csv").write_text("".join(",".join(row) + "\n" for row in rows), encoding="ascii")
        print(f"tests/data/{name}.csv: {len(rows) - 1} rows")
    return 0 if tables else 2


def read(table):
    """{point in the CSV's own numbers: {case: value}}, in the order of the file."""
    lines = [line.split(",") for line in (DATA / f"{table}.csv").read_text().splitlines()]
    points = {}
    for case, *rest in lines[1:]:
        points.setdefault(tuple(map(float, rest[:-4])), {})[case] = float(rest[-4])
    return points


def table(program):
    for family in (Annular, Through, Closed, Surface, Cup):
        if not (DATA / f"{family.table}.csv").exists():
            continue
        points = read(family.table)
        print(f"\n{family.table}: closed form over finite elements, - 1 in per cent\n")
        header = None
        for point, elements in points.items():
            own = list(point)
            for i, name in enumerate(family.inputs):
                if name.startswith("angle"):
                    own[i] = round(math.degrees(own[i]), 9)
            closed = family.closed(tuple(own), program)
            if family is Cup:
                elements["factor"] = elements["compliance"]
            cases = [case for case in elements if case in closed]
            if header is None:
                header = [name.split()[0] for name in family.inputs] + cases
                print("| " + " | ".join(header) + " |\n|" + "---:|" * len(header))
            cells = [f"{x:g}" for x in own]
            for case in cases:
                if case.startswith(("K_I_", "K_II_")):  # of tau sqrt(pi a): some are about zero
                    cells.append(f"{100 * (closed[case] - elements[case]):+.1f}")
                else:
                    cells.append(f"{100 * (closed[case] / elements[case] - 1):+.2f}"
                                 if elements[case] else "")
            print("| " + " | ".join(cells) + " |", flush=True)
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("command", choices=("run", "write", "table"))
    parser.add_argument("family", nargs="*", default="all", choices=[*FAMILIES, "all"])
    parser.add_argument("--program", type=pathlib.Path, default=ROOT / "build/fe/apps/cli/strainwave")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/judgement")
    arguments = parser.parse_args()
    if arguments.command != "write" and not arguments.program.exists():
        print(f"{arguments.program} is not there: build strainwave_cli and strainwave_fe (preset fe)")
        return 2
    if arguments.command == "run":
        names = FAMILIES if "all" in arguments.family else arguments.family
        families = [FAMILIES[name] for name in names]
        return run(families, arguments.program, arguments.work)
    if arguments.command == "write":
        return write(arguments.work)
    return table(arguments.program)


if __name__ == "__main__":
    sys.exit(main())
