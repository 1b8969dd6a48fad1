# SPDX-License-Identifier: Apache-2.0
"""Crosscheck: rows in HDF5, read by h5py and pandas, are those of CSV, of a summary and of shards.

The numbers of both forms must agree to the bit, and the summary of a study must follow from its rows.  Merged
shards must give the bytes of one run.  A run that is killed, interrupted, or out of room must not leave or
change the file of the rows.  Ten times as many rows must not take more memory.

usage: rows.py PROGRAM
"""

import csv
import hashlib
import json
import math
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import h5py
import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"
sys.path.insert(0, str(EXAMPLES))
from read_rows import dataset, read_rows, units  # noqa: E402

ARTICLE = EXAMPLES / "article.toml"
PROGRAM = sys.argv.pop() if len(sys.argv) > 1 else "strainwave"
MOST_MEMORY = 24 * 1024  # that ten times as many rows may take in addition [KiB]


class Rows(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory(prefix="strainwave_rows_")
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)

    def path(self, name):
        return str(self.folder / name)

    def run_it(self, *arguments, code=0, before=None, environment=None):
        run = subprocess.run([PROGRAM, *map(str, arguments)], text=True, capture_output=True, timeout=300,
                             preexec_fn=before, env={**os.environ, **(environment or {})})
        self.assertEqual(run.returncode, code, f"{arguments}: {run.stderr}")
        return run

    def drive(self):
        """A drive of which an eighth of the draws breaks a rule: the wall has no thickness."""
        text = (EXAMPLES / "article_scatter.toml").read_text()
        old = 'path = "flexspline.wall_thickness"\nrelative_standard_deviation = 0.01'
        self.assertIn(old, text)
        path = self.folder / "drive.toml"
        path.write_text(text.replace(old, old.replace("0.01", "0.9")))
        return path

    def check_against_csv(self, rows_csv, rows_h5):
        """Both files have the same columns, units, numbers, states and rules."""
        with open(rows_csv, newline="") as file:
            head, *lines = csv.reader(file)
        with h5py.File(rows_h5) as file:
            names = list(file["columns"].asstr()[:])
            self.assertEqual(head[-2:], ["status", "rule"])
            self.assertEqual([f"{name} [{dataset(file, name).attrs['unit']}]" for name in names], head[:-2])
            self.assertEqual(file.attrs["row_count"], len(lines))
            words = {code: word for word, code in h5py.check_enum_dtype(file["status"].dtype).items()}
            self.assertEqual([words[code] for code in file["status"][:]], [line[-2] for line in lines])
            rules = file["rules"].asstr()[:]
            self.assertEqual([rules[i] for i in file["rule"][:]], [line[-1] for line in lines])
            for i, name in enumerate(names):
                said = numpy.array([float(line[i]) if line[i] else math.nan for line in lines])
                column = dataset(file, name)
                numpy.testing.assert_array_equal(column[:], said)
                self.assertEqual((column.compression, column.shuffle), ("gzip", True))
        return lines

    def test_reference_sweep_is_the_csv_of_the_command(self):
        vary = ("sweep", ARTICLE, "--vary", "output_shaft.crack[0].depth=0.00005 m..0.02 m:9:log", "--quiet")
        said = self.run_it(*vary, "--units", "si").stdout
        self.assertEqual(self.run_it(*vary, "--rows", self.path("rows.h5")).stdout, "")
        self.assertEqual(self.run_it(*vary, "--rows", self.path("rows.csv"), "-o", "-",
                                     "--units", "si").stdout, said)
        lines = self.check_against_csv(self.path("rows.csv"), self.path("rows.h5"))
        head, *answer = csv.reader(said.splitlines())
        self.assertEqual([line[:-2] for line in lines], [line[:-2] for line in answer])
        self.assertEqual([line[-1] for line in lines], [line[-1] for line in answer])
        states = {line[-2] for line in lines}
        self.assertIn("usable", states)
        self.assertTrue(states - {"usable"}, "no point is refused")

    def test_reference_draws_give_the_summary(self):
        drive = self.drive()
        study = ("sensitivity", drive, "--scatter", "--samples", 4000, "--seed", 5, "--quiet", "--format", "json")
        answer = json.loads(self.run_it(*study, "--rows", self.path("rows.h5")).stdout)
        self.assertEqual(json.loads(self.run_it(*study, "--rows", self.path("rows.csv")).stdout), answer)
        self.check_against_csv(self.path("rows.csv"), self.path("rows.h5"))
        scatter = answer["result"]["scatter"]
        table = read_rows(self.path("rows.h5"))
        self.assertEqual(len(table), 4000)
        counts = table["status"].value_counts()
        self.assertEqual(counts["usable"], scatter["evaluated"])
        self.assertEqual(counts.get("refused", 0), scatter["refused"])
        self.assertGreater(scatter["refused"], 100)
        usable = table[table["status"] == "usable"]
        for output in scatter["outputs"]:
            values = usable[output["name"]]
            self.assertEqual(units(self.path("rows.h5"))[output["name"]], output["unit"])
            self.assertAlmostEqual(values.mean() / output["mean"], 1, delta=1e-12)
            deviation = values.std() / abs(values.mean())
            self.assertAlmostEqual(deviation / output["relative_deviation"]["value"], 1, delta=1e-9)
        # A refused row has its inputs, the rule, and no outputs.
        refused = table[table["status"] == "refused"]
        outputs = [output["name"] for output in scatter["outputs"]]
        self.assertTrue(refused[outputs].isna().all(axis=None))
        inputs = [one["path"] for one in scatter["inputs"]]
        self.assertFalse(table[inputs].isna().any(axis=None))
        self.assertTrue(refused["rule"].str.startswith("flexspline.").all())
        self.assertLess(len(refused["rule"].unique()), 10)
        # The file says where it comes from.
        said = table.attrs
        self.assertEqual(said["input_sha256"], hashlib.sha256(drive.read_bytes()).hexdigest())
        self.assertEqual(said["input_file"], str(drive))
        self.assertEqual((said["format"], said["program"], said["command"], said["seed"]),
                         ("strainwave-rows/1", "strainwave", "sensitivity", 5))
        self.assertEqual(said["version"], answer["provenance"]["version"])
        self.assertEqual(said["revision"], answer["provenance"]["revision"])
        self.assertIn("glibc", said["code_path"])
        self.assertIn("samples=4000", said["options"].split("\n"))
        part = read_rows(self.path("rows.h5"), 1000, 1010, outputs[:1])
        self.assertEqual(list(part.index), list(range(1000, 1010)))
        self.assertTrue(part[outputs[0]].equals(table[outputs[0]][1000:1010]))
        run = subprocess.run(["/usr/bin/python3", EXAMPLES / "read_rows.py", self.path("rows.h5")], text=True,
                             capture_output=True, check=True)
        self.assertIn(f"4000 draws of {drive}, {len(usable)} usable", run.stdout)

    def test_reference_draws_of_a_torsion_curve(self):
        study = ("torsion", EXAMPLES / "catalogue_size25.toml", "--draws", 6, "--quiet", "--format", "json")
        bands = json.loads(self.run_it(*study, "--rows", self.path("rows.h5")).stdout)["result"]["bands"]
        self.run_it(*study, "--rows", self.path("rows.csv"))
        self.check_against_csv(self.path("rows.csv"), self.path("rows.h5"))
        table = read_rows(self.path("rows.h5"))
        self.assertEqual(len(table), 6)
        self.assertAlmostEqual(table["K1"].median() / bands["K1"]["median"]["value"], 1, delta=1e-12)

    def test_reference_rows_of_the_other_studies(self):
        sobol = ("sensitivity", self.drive(), "--sobol", "--points", 160)
        inspect = ("inspect", EXAMPLES / "inspected_shaft.toml", "--draws", 30)
        for study, rows_are, count, columns in (
                (sobol, "points of the design", 160 * 10, ["base_point", "set", "intact.stiffness"]),
                (("torsion", EXAMPLES / "cracked_size25.toml", "--compare", "--angles", 3, "--draws", 0),
                 "positions of the wave generator", 3, ["angle", "positive.K1", "negative.K3"]),
                (("validate", "--draws", 2), "draws of the proportions", 2, ["rim_thickness", "flank_angle"]),
                (inspect, "draws", 30, ["life", "arrested", "weight", "output_shaft.crack[0].size_at_end"])):
            self.run_it(*study, "--quiet", "--rows", self.path("rows.h5"))
            answer = json.loads(self.run_it(*study, "--quiet", "--format", "json", "--rows",
                                            self.path("rows.csv")).stdout)["result"]
            self.check_against_csv(self.path("rows.csv"), self.path("rows.h5"))
            table = read_rows(self.path("rows.h5"))
            self.assertEqual((table.attrs["rows_are"], len(table)), (rows_are, count))
            for column in columns:
                self.assertIn(column, table)
            if study is inspect:
                lives = sorted(table["life"])
                self.assertEqual(answer["percentiles"]["share"]["values"][2], 0.5)
                self.assertEqual(answer["percentiles"]["life"]["values"][2], lives[14])
            if study is sobol:
                whole = table.groupby("base_point")["status"].agg(lambda states: (states == "usable").all())
                self.assertEqual(answer["sobol"]["left_out"], (~whole).sum())
                self.assertGreater(answer["sobol"]["left_out"], 10)

    def test_behaviour_all_rows_refused(self):
        # The study has no answer, but its rows say why; they replace what was there.
        text = (EXAMPLES / "article_scatter.toml").read_text()
        drive = self.folder / "drive.toml"
        drive.write_text(text[:text.index("[[scatter]]")] + """[[scatter]]
path = "flexspline.wall_thickness"
distribution = "table"
quantile = [{ probability = 0, ratio = 100 }, { probability = 1, ratio = 200 }]
""")
        scatter = ("sensitivity", drive, "--scatter", "--samples", 50, "--quiet")
        sweep = ("sweep", ARTICLE, "--vary", "output_shaft.crack[0].depth=100 mm..200 mm:50", "--quiet")
        for study, code, words in ((scatter, 4, "of 50 draws, 50 break a rule of the input"),
                                   (sweep, 3, "output_shaft.crack[0].depth")):
            for name in ("rows.h5", "rows.csv"):
                pathlib.Path(self.path(name)).write_bytes(b"as before")
                run = self.run_it(*study, "--rows", self.path(name), code=code)
                self.assertIn(words, run.stderr)
                self.assertIn(f"{name} has the rows of the study, with the rule that each refused row breaks",
                              run.stderr)
                self.assertEqual(run.stdout, "")
            self.check_against_csv(self.path("rows.csv"), self.path("rows.h5"))
            table = read_rows(self.path("rows.h5"))
            self.assertEqual(list(table["status"]), ["refused"] * 50)
            self.assertFalse((table["rule"] == "").any())
            self.assertFalse(table.iloc[:, 0].isna().any())
        shards = [self.path(f"{k}.shard") for k in (1, 2)]
        for k, shard in enumerate(shards, 1):
            self.run_it(*scatter, "--shard", f"{k}/2", "-o", shard)
        self.run_it(*scatter, "--rows", self.path("whole.h5"), code=4)
        self.run_it("merge", *shards, "--rows", self.path("merged.h5"), code=4)
        self.assertEqual(pathlib.Path(self.path("merged.h5")).read_bytes(),
                         pathlib.Path(self.path("whole.h5")).read_bytes())

    def test_identity_shards_give_the_bytes_of_one_run(self):
        compare = ("torsion", EXAMPLES / "cracked_size25.toml", "--compare", "--angles", 3, "--draws", 0)
        for name, study in (("sweep", ("sweep", ARTICLE, "--vary", "load.torque=1 N*m..50 N*m:20")),
                            ("sobol", ("sensitivity", self.drive(), "--sobol", "--points", 320)),
                            ("compare", compare),
                            ("validate", ("validate", "--draws", 3)),
                            ("inspect", ("inspect", EXAMPLES / "inspected_shaft.toml", "--draws", 30)),
                            ("scatter", ("sensitivity", self.drive(), "--scatter", "--samples", 40000))):
            whole, merged = self.path(f"{name}.h5"), self.path(f"{name}_merged.h5")
            self.run_it(*study, "--quiet", "--rows", whole, environment={"MALLOC_PERTURB_": "85"})
            shards = [self.path(f"{name}.{k}.shard") for k in (1, 2, 3)]
            for k, shard in enumerate(shards, 1):
                self.run_it(*study, "--quiet", "--shard", f"{k}/3", "-o", shard)
            self.run_it("merge", *shards[::-1], "--rows", merged, environment={"MALLOC_PERTURB_": "170"})
            self.assertEqual(pathlib.Path(merged).read_bytes(), pathlib.Path(whole).read_bytes(), name)
            if name in ("scatter", "sobol", "inspect"):
                self.run_it(*study, "--quiet", "--threads", 1, "--rows", self.path("one.h5"))
                self.assertEqual(pathlib.Path(self.path("one.h5")).read_bytes(),
                                 pathlib.Path(whole).read_bytes())
            # A merge without rows stays as it was, and a shard is needed whole.
            self.assertEqual(self.run_it("merge", *shards).stdout, self.run_it(*study, "--quiet").stdout)
        run = self.run_it("merge", *shards[:2], "--rows", self.path("none.h5"), code=3)
        self.assertIn("of 3 are missing", run.stderr)
        self.assertFalse(pathlib.Path(self.path("none.h5")).exists())

    def test_behaviour_killed_and_interrupted(self):
        target = pathlib.Path(self.path("rows.h5"))
        target.write_bytes(b"as before")
        for stop in (signal.SIGKILL, signal.SIGINT):
            run = subprocess.Popen([PROGRAM, "sensitivity", str(EXAMPLES / "article_scatter.toml"), "--scatter",
                                    "--samples", "30000000", "--quiet", "--rows", str(target)],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            deadline = time.monotonic() + 120
            while not any(part.stat().st_size > 100000 for part in self.folder.glob("rows.h5.*.part")):
                self.assertLess(time.monotonic(), deadline)
                self.assertIsNone(run.poll())
                time.sleep(0.02)
            run.send_signal(stop)
            code = run.wait(timeout=60)
            self.assertEqual(target.read_bytes(), b"as before")
            left = list(self.folder.glob("*.part"))
            if stop == signal.SIGINT:
                self.assertNotEqual(code, 0)
                self.assertEqual(left, [])
            for part in left:
                part.unlink()

    def test_behaviour_out_of_room(self):
        target = pathlib.Path(self.path("rows.h5"))
        for limit in (1000, 100_000, 1_000_000, 2_000_000):
            def out_of_room():
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
            run = self.run_it("sensitivity", EXAMPLES / "article_scatter.toml", "--scatter", "--samples", 40000,
                              "--quiet", "--rows", target, code=7, before=out_of_room)
            self.assertIn("rows.h5: cannot be written: File too large", run.stderr)
            self.assertEqual(run.stdout, "")
            self.assertEqual(list(self.folder.iterdir()), [])

    def test_input_refused(self):
        scatter = ("sensitivity", EXAMPLES / "article_scatter.toml")
        for arguments, code, words in (
                ((*scatter, "--scatter", "--rows", self.path("rows.txt")), 2,
                 "must end in .h5 or .csv, which chooses HDF5 or CSV; name another file"),
                ((*scatter, "--rows", self.path("rows.h5")), 2, "--rows: needs --scatter or --sobol; give one of them"),
                (("validate", "--rows", self.path("rows.h5")), 2, "--rows: needs draws; give their number with --draws"),
                ((*scatter, "--scatter", "--rows", "-"), 2, "both go to standard output"),
                ((*scatter, "--scatter", "--rows", "-", "-o", self.path("x")), 7, "must be a regular file"),
                ((*scatter, "--scatter", "--rows", "/dev/full"), 7, "must be a regular file"),
                ((*scatter, "--scatter", "--rows", self.path("none/rows.h5")), 7, "cannot be written"),
                ((*scatter, "--scatter", "--rows", EXAMPLES / "article_scatter.toml"), 2, "name the same file"),
                ((*scatter, "--scatter", "--shard", "1/2", "-o", self.path("a"), "--rows", self.path("rows.h5")), 2,
                 "leave out --rows, and give it to strainwave merge"),
                (("torsion", EXAMPLES / "cracked_size25.toml", "--draws", 0, "--rows", self.path("rows.h5")), 2,
                 "--rows: needs draws or positions; give --tolerances or --compare, or [[range]]"),
                (("stiffness", ARTICLE, "--rows", self.path("rows.h5")), 2, "this option belongs to")):
            run = self.run_it(*arguments, code=code)
            self.assertIn(words, run.stderr)
            self.assertEqual(run.stdout, "")
            self.assertEqual(list(self.folder.iterdir()), [])

    def test_limit_memory_is_constant(self):
        def peak(samples):
            # A process of its own, because the peak is that of the largest child.
            code = ("import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True); "
                    "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)")
            run = subprocess.run([sys.executable, "-c", code, PROGRAM, "sensitivity",
                                  str(EXAMPLES / "article_scatter.toml"), "--scatter", "--samples", str(samples),
                                  "--quiet", "-o", self.path("answer"), "--rows", self.path("rows.h5")],
                                 text=True, capture_output=True, check=True)
            return int(run.stdout)
        # Each draw takes 48 bytes until its values are summed (a study of up to ten million draws).
        few, many = 40_000, 400_000
        draws = (many - few) * 2 * 48 / 1024
        self.assertLess(peak(many) - peak(few), MOST_MEMORY + draws)


if __name__ == "__main__":
    unittest.main()
