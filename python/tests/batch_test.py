# SPDX-License-Identifier: Apache-2.0
"""Many evaluations of one drive."""

import contextlib
import csv
import io
import json
import unittest

import numpy as np
import strainwave as sw
from support import EXAMPLES, main, missing

OUTPUTS = ("cracked.positive.stiffness", "intact.stiffness")


def size25():
    return sw.read(EXAMPLES / "cracked_size25.toml")


class Batch(unittest.TestCase):
    def test_identity_each_row_is_a_single_evaluation(self):
        depths = np.linspace(0.5e-3, 5e-3, 7)
        rows = size25().batch({"output_shaft.crack[0].depth": depths}, OUTPUTS)
        for depth, stiffness in zip(depths, rows["cracked.positive.stiffness"]):
            drive = size25()
            drive["output_shaft.crack[0].depth"] = depth
            self.assertEqual(drive.stiffness().cracked.positive.stiffness.value, stiffness)
        self.assertTrue(rows.ok.all())

    def test_identity_the_number_of_threads_changes_no_bit(self):
        depths = np.linspace(0.5e-3, 5e-3, 100)
        first = size25().batch({"output_shaft.crack[0].depth": depths}, OUTPUTS, threads=1)
        for threads in (0, 2, 7):
            rows = size25().batch({"output_shaft.crack[0].depth": depths}, OUTPUTS, threads=threads)
            np.testing.assert_array_equal(rows.numbers, first.numbers)

    def test_crosscheck_error_of_the_tables(self):
        # Source: single evaluations by the engine (ST-22).  A long batch reads tables of the cracks.
        depths = np.linspace(0.5e-3, 3.5e-3, 20_000)
        output = "cracked.positive.stiffness"
        shaft = sw.read(EXAMPLES / "article.toml")
        rows = shaft.batch({"output_shaft.crack[0].depth": depths}, [output])
        self.assertGreaterEqual(rows.tables.cracks, 1)
        self.assertEqual(rows.tables.points, 1000)
        self.assertTrue(0 < rows.tables.largest_error < 1e-10, rows.tables)
        for place in range(0, len(depths), 1999):
            single = shaft.batch({"output_shaft.crack[0].depth": depths[place]}, [output])
            self.assertIsNone(single.tables)
            self.assertAlmostEqual(rows[output][place] / float(single[output]), 1, delta=1e-10)
        said = {"cracks": rows.tables.cracks, "points": 1000,
                "largest_error": rows.tables.largest_error}
        self.assertEqual(json.loads(json.dumps(rows.to_dict()))["tables"], said)
        said_once = single.to_dict()
        self.assertIsNone(said_once["tables"])
        self.assertEqual(said_once["outputs"][output], float(single[output]))
        if missing("pandas") is None:
            self.assertEqual(rows.to_frame().attrs["tables"], said)
        self.assertIn("differ from the engine by", rows._repr_html_())
        self.assertNotIn("differ from the engine by", single._repr_html_())

    def test_behaviour_values_are_broadcast(self):
        rows = size25().batch({"output_shaft.crack[0].depth": np.linspace(1e-3, 2e-3, 3),
                               "load.torque": np.array([[10.0], [20.0]])}, OUTPUTS)
        self.assertEqual((rows.numbers.shape, rows.codes.shape), ((2, 2, 3), (2, 3)))
        self.assertEqual(rows.inputs["load.torque"].shape, (2, 3))
        single = size25().batch({"load.torque": 10.0}, OUTPUTS)
        self.assertEqual(single["intact.stiffness"].shape, ())

    def test_behaviour_kinds_of_arrays(self):
        torque = np.array([10, 20, 30, 40])
        want = size25().batch({"load.torque": torque.astype(float)}, OUTPUTS).numbers
        strided = np.zeros(8)
        strided[::2] = torque
        locked = torque.astype(float)
        locked.setflags(write=False)
        for given in (torque, list(torque), tuple(torque), torque.astype(np.float32), strided[::2],
                      torque.astype(">f8"), locked, torque.astype(np.uint8),
                      np.asfortranarray(torque)[::-1][::-1]):
            np.testing.assert_array_equal(size25().batch({"load.torque": given}, OUTPUTS).numbers,
                                          want)

    def test_behaviour_refused_rows(self):
        rows = size25().batch({"output_shaft.crack[0].depth": [1e-3, -1e-3, 2e-3, np.nan]}, OUTPUTS)
        self.assertEqual(list(rows.codes), [0, 1, 0, 1])
        self.assertEqual(list(rows.ok), [True, False, True, False])
        self.assertTrue(np.isnan(rows.numbers[:, 1]).all())
        self.assertIn("violates: > 0", rows.faults["refused"])

    def test_behaviour_numbers_that_may_not_be_used_are_not_given(self):
        rows = sw.read(EXAMPLES / "article.toml").batch(
            {"output_shaft.crack[0].depth": [1e-4, 11e-3]}, ["cracked.positive.stiffness"])
        self.assertEqual([sw.ROW_CODES[code] for code in rows.codes], ["ok", "not-usable"])
        self.assertTrue(np.isnan(rows.numbers[0, 1]))
        self.assertIn("a/t = 0.88", rows.faults["not-usable"])

    def test_limit_no_rows_and_many_rows(self):
        empty = size25().batch({"load.torque": np.zeros((0, 3))}, OUTPUTS)
        self.assertEqual(empty.numbers.shape, (2, 0, 3))
        many = sw.read(EXAMPLES / "solid_shaft.toml").batch(
            {"load.torque": np.linspace(1, 2, 20000)}, ["intact.stiffness"], threads=2)
        self.assertTrue(many.ok.all())
        self.assertEqual(len(set(many["intact.stiffness"])), 1)  # a shaft is linear

    def test_behaviour_numbers_go_to_a_given_array(self):
        out = np.full((2, 3), -1.0)
        rows = size25().batch({"load.torque": [1.0, 2.0, 3.0]}, OUTPUTS, out=out)
        self.assertIs(rows.numbers, out)
        self.assertTrue((out > 0).all())
        wide = np.full((2, 6), -1.0)
        size25().batch({"load.torque": [1.0, 2.0, 3.0]}, OUTPUTS, out=wide[:, ::2])
        np.testing.assert_array_equal(wide[:, ::2], out)
        for wrong in (np.zeros((3, 2)), np.zeros((2, 3), np.float32), np.zeros((2, 3), ">f8"),
                      [[0.0] * 3] * 2):
            with self.assertRaises(sw.InputError):
                size25().batch({"load.torque": [1.0, 2.0, 3.0]}, OUTPUTS, out=wrong)
        out.setflags(write=False)
        with self.assertRaises(sw.InputError):
            size25().batch({"load.torque": [1.0, 2.0, 3.0]}, OUTPUTS, out=out)

    def test_input_each_rule_broken_once(self):
        drive, torque = size25(), "load.torque"
        for values, outputs, options in (
                ({"load.torq": [1.0]}, OUTPUTS, {}), ({torque: [1.0]}, ["cracked.stiffnes"], {}),
                ({torque: [1.0]}, OUTPUTS, {"method": "best"}),
                ({torque: [1.0]}, OUTPUTS, {"threads": 257}),
                ({torque: [1.0]}, OUTPUTS, {"threads": -1}),
                ({torque: [1.0]}, OUTPUTS, {"threads": 1 << 31}),
                ({torque: [1.0]}, OUTPUTS, {"threads": 1 << 40}),
                ({torque: ["1 N*m"]}, OUTPUTS, {}), ({torque: [True]}, OUTPUTS, {}),
                ({torque: [1j]}, OUTPUTS, {}), ({torque: [None]}, OUTPUTS, {}),
                ({torque: [[1.0], [1.0, 2.0]]}, OUTPUTS, {}),
                ({torque: [1.0, 2.0], "drive.ratio": [1.0, 2.0, 3.0]}, OUTPUTS, {}),
                ({torque: [1.0]}, OUTPUTS + OUTPUTS, {})):
            with self.assertRaises(sw.InputError, msg=f"{values} {outputs} {options}") as caught:
                drive.batch(values, outputs, **options)
            self.assertGreater(len(str(caught.exception)), 15)
        for threads in (1 << 31, 1 << 40, -(1 << 31) - 1):  # the message names the number that was given
            with self.assertRaisesRegex(sw.InputError, f"from 0 to 256.* {threads}"):
                drive.batch({torque: [1.0]}, OUTPUTS, threads=threads)
        for values, outputs, sentence in (
                ({3: [1.0]}, OUTPUTS, "the path of a field is text, .* not int"),
                ([1.0], OUTPUTS, "values must be arrays by the paths of fields, .* not list"),
                ({torque: [1.0]}, None, "outputs must be names of outputs, .* not None"),
                ({torque: [1.0]}, [3], r"outputs must be names of outputs, .* not \[3\]")):
            with self.assertRaisesRegex(TypeError, sentence):
                drive.batch(values, outputs)
        with self.assertRaises(TypeError):
            drive.batch({torque: [1.0]}, OUTPUTS, threads=1.5)
        with self.assertRaises(KeyError):
            drive.batch({torque: [1.0]}, OUTPUTS)["cracked.negative.stiffness"]

    def test_input_masked_values(self):
        for masked, count in ((np.ma.array([1.0, 2.0, 3.0], mask=[0, 1, 1]), 2), (np.ma.masked, 1)):
            with self.assertRaisesRegex(sw.InputError, f"load.torque: {count} of its values are masked"):
                size25().batch({"load.torque": masked}, OUTPUTS)
        nothing_masked = np.ma.array([1.0, 2.0])
        self.assertTrue(size25().batch({"load.torque": nothing_masked}, OUTPUTS).ok.all())

    def test_input_a_wrong_array_is_refused_before_the_computation(self):
        told = []
        with self.assertRaises(sw.InputError):
            size25().batch({"load.torque": np.linspace(1, 2, 2000)}, OUTPUTS, out=np.zeros(3),
                           progress=told.append)
        self.assertEqual(told, [])

    def test_behaviour_as_dicts_and_as_html(self):
        rows = size25().batch({"output_shaft.crack[0].depth": [[1e-3], [-1e-3], [np.nan]]}, OUTPUTS)
        given = json.loads(json.dumps(rows.to_dict(), allow_nan=False))
        self.assertEqual(given["inputs"], {"output_shaft.crack[0].depth": [[1e-3], [-1e-3], [None]]})
        self.assertEqual(given["outputs"]["intact.stiffness"],
                         [[rows["intact.stiffness"][0, 0]], [None], [None]])
        self.assertEqual(given["outcomes"], [["ok"], ["refused"], ["refused"]])
        self.assertEqual(given["units"], {"output_shaft.crack[0].depth": "m", "intact.stiffness": "N*m/rad",
                                          "cracked.positive.stiffness": "N*m/rad"})
        self.assertEqual(given["faults"], rows.faults)
        shown = rows._repr_html_()
        self.assertIn("<td>ok</td><td>1</td>", shown)
        self.assertRegex(shown, "<td>refused</td><td>2</td><td>.*violates: &gt; 0</td>")
        self.assertEqual(repr(rows), "<BatchResult of 3 rows: 1 ok, 2 refused>")

    @unittest.skipIf(missing("pandas"), missing("pandas"))
    def test_behaviour_a_frame_names_units_and_faults(self):
        rows = size25().batch({"load.torque": [1.0, np.nan]}, ["cracked.positive.stiffness_change"])
        attrs = rows.to_frame().attrs
        self.assertEqual(attrs["units"], {"load.torque": "N*m", "cracked.positive.stiffness_change": "1"})
        self.assertEqual(attrs["faults"], rows.faults)

    def test_identity_the_units_of_outputs_are_those_of_the_table(self):
        """Every output of an example with cracks of many kinds."""
        lines = size25().stiffness().document("csv").splitlines()
        stated = {row["path"]: row["unit"] for row in csv.DictReader(
            line for line in lines if not line.startswith("#"))}
        rows = size25().batch({"drive.ratio": [100.0]}, list(stated))
        self.assertEqual(rows.units, {"drive.ratio": "1", **stated})
        self.assertGreater(len(set(stated.values())), 6)

    def test_behaviour_progress(self):
        told = []
        size25().batch({"load.torque": np.linspace(1, 2, 2000)}, OUTPUTS, threads=1,
                       progress=told.append)
        self.assertEqual(told[-1], 1.0)
        self.assertEqual(told, sorted(told))

    def test_behaviour_a_progress_function_stops_by_an_exception(self):
        class Enough(Exception):
            pass

        def stop(_fraction):
            raise Enough

        with self.assertRaises(Enough):
            size25().batch({"load.torque": np.linspace(1, 2, 100000)}, OUTPUTS, progress=stop)
        with self.assertRaises(Enough):
            sw.read(EXAMPLES / "catalogue_size25.toml").torsion(compare=True, progress=stop)

    def test_behaviour_the_line_of_progress_ends(self):
        shown = io.StringIO()
        with contextlib.redirect_stderr(shown):
            size25().torsion(compare=True, angles=4, draws=0, progress=True)
        self.assertRegex(shown.getvalue(), r"^\r\[[#.]+\] +\d+\.\d %")
        self.assertTrue(shown.getvalue().endswith("] 100.0 %\n"), shown.getvalue()[-60:])

    def test_limit_the_line_of_progress_is_written_only_if_it_changes(self):
        told, shown = [], io.StringIO()
        drive = sw.read(EXAMPLES / "solid_shaft.toml")
        torque = np.linspace(1, 2, 50000)
        drive.batch({"load.torque": torque}, ["intact.stiffness"], progress=told.append)
        with contextlib.redirect_stderr(shown):
            drive.batch({"load.torque": torque}, ["intact.stiffness"], progress=True)
        written = shown.getvalue().split("\r")[1:]
        self.assertGreater(len(told), 2000)
        self.assertLess(len(written), 1100)  # a thousand tenths of a percent, and the steps of the bar
        self.assertTrue(all(one != other for one, other in zip(written, written[1:])))
        self.assertEqual(shown.getvalue().count("\n"), 1)


if __name__ == "__main__":
    main()
