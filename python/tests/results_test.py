# SPDX-License-Identifier: Apache-2.0
"""Results: quantities, arrays, evidence, documents, frames."""

import copy
import dataclasses
import json
import math
import os
import pickle
import tempfile
import unittest
import unittest.mock
from pathlib import Path

import numpy as np
import strainwave as sw
from strainwave import parts
from support import EXAMPLES, main, missing


def read(name):
    return sw.read(EXAMPLES / f"{name}.toml")


class Quantities(unittest.TestCase):
    def test_identity_quantities_compare_as_their_numbers(self):
        for one, other in ((1.0, 2.0), (2.0, 1.0), (2.0, 2.0)):
            quantity = sw.Quantity(one, "m")
            for right in (other, sw.Quantity(other, "m")):
                self.assertEqual((quantity < right, quantity <= right, quantity > right, quantity >= right),
                                 (one < other, one <= other, one > other, one >= other))

    def test_behaviour_digits_follow_the_accuracy(self):
        for value, uncertainty, shown in ((72811.46, 0.3, "7.3e+04 m"), (72811.46, 0.05, "7.28e+04 m"),
                                          (72811.46, 0.001, "7.281e+04 m"), (72811.46, None, "72811.5 m"),
                                          (1 / 3, 1e-30, "0.333333333333 m"), (0.0, 0.1, "0 m"),
                                          (math.nan, None, "nan m"), (-0.5, 0.2, "-0.5 m")):
            self.assertEqual(str(sw.Quantity(value, "m", uncertainty)), shown)
        self.assertEqual(str(sw.Quantity(2, "1")), "2")

    def test_behaviour_arithmetic_gives_numbers(self):
        two, three = sw.Quantity(2, "m", 0.1), sw.Quantity(3, "m")
        self.assertEqual((two + three, two - 1, 1 - two, two * three, 6 / three, three / two, -two,
                          abs(sw.Quantity(-2, "m")), 1 + two, 2 * two), (5, 1, -1, 6, 2, 1.5, -2, 2, 3, 4))
        self.assertTrue(two < three and three > two and two <= 2 and two >= 2 and two == 2)
        self.assertEqual((two.uncertainty, three.uncertainty), (0.2, None))
        self.assertEqual(f"{two:.2f} {two}", "2.00 2 m")
        self.assertEqual(np.sqrt(sw.Quantity(9, "m")), 3)
        self.assertEqual(len({two, sw.Quantity(2, "m", 0.1), three}), 2)
        self.assertNotEqual(two, sw.Quantity(2, "mm", 0.1))
        self.assertNotEqual(two, "2 m")

    def test_behaviour_an_unusable_result_refuses_its_numbers(self):
        number = parts.quantity({"value": 5.0, "unit": "m"}, "it did not converge")
        for use in (float, lambda q: q.value, lambda q: q + 1, lambda q: q < 3, np.asarray, abs):
            with self.assertRaisesRegex(sw.NotUsable, "it did not converge"):
                use(number)
        self.assertEqual(str(number), "not usable: it did not converge")
        self.assertEqual(number._repr_html_(), "<strong>not usable: it did not converge</strong>")

    def test_behaviour_a_notebook_shows_unit_and_uncertainty(self):
        self.assertEqual(sw.Quantity(2, "a<b", 0.015)._repr_html_(), "2 a&lt;b (&plusmn; 1.5 %)")
        self.assertEqual(sw.Quantity(2, "m")._repr_html_(), "2 m")


class Results(unittest.TestCase):
    def test_identity_numbers_are_those_of_the_document(self):
        answer = read("cracked_size25").stiffness()
        document = json.loads(answer.document("json"))
        self.assertEqual(answer.envelope(), document)
        self.assertEqual(answer.to_dict(), document["result"])
        stated = document["result"]["cracked"]["positive"]["stiffness"]
        self.assertEqual((answer.cracked.positive.stiffness.value,
                          answer.cracked.positive.stiffness.unit), (stated["value"], "N*m/rad"))
        self.assertEqual([note.code for note in answer.notes],
                         [note["code"] for note in document["notes"]])
        self.assertEqual(answer.equations, tuple(document["equations"]))
        self.assertEqual(answer.verdict.reason, document["verdict"]["reason"])
        for given, stated in zip(answer.accuracies, document["accuracies"]):
            self.assertEqual((given.path, float(given.relative_uncertainty), given.source),
                             (stated["path"], stated["relative_uncertainty"]["value"], stated["source"]))
        self.assertEqual(len(answer.accuracies), len(document["accuracies"]))
        self.assertEqual(answer.provenance, document["provenance"])

    def test_behaviour_an_unusable_answer_shows_that_first(self):
        drive = read("article")
        drive["output_shaft.crack[0].depth"] = "11 mm"  # leaves too little of the shaft
        answer = drive.stiffness()
        self.assertFalse(answer.usable)
        self.assertIn("a/t = 0.88", answer.unusable_because)
        self.assertIn("not usable: output_shaft.crack[0]", repr(answer))
        self.assertIn("not usable", str(answer.cracked.positive.stiffness))
        self.assertTrue(answer._repr_html_().startswith("<p><strong>The numbers must not be used"))
        with self.assertRaises(sw.NotUsable):
            float(answer.cracked.positive.stiffness)
        self.assertGreater(answer.to_dict()["cracked"]["positive"]["stiffness"]["value"], 0)

    def test_behaviour_a_notebook_links_to_the_documentation_that_is_named(self):
        answer = read("article").stiffness()
        self.assertNotIn("href", answer._repr_html_())
        with unittest.mock.patch.dict(os.environ, {"STRAINWAVE_SITE": "https://example.org/a&b/"}):
            shown = answer._repr_html_()
        self.assertIn('<a href="https://example.org/a&amp;b/docs/theory/manual.html#ST-1">ST-1</a>', shown)
        self.assertIn(f'/notes.html#{answer.notes[0].code}">', shown)
        self.assertEqual(shown.count("manual.html#"), len(answer.equations))

    def test_behaviour_an_unusable_answer_refuses_bare_numbers_and_arrays(self):
        drive = read("article")
        drive["output_shaft.crack[0].depth"] = "11 mm"
        answer = drive.sensitivity()
        row = answer.inputs[0] if isinstance(answer.inputs, tuple) else answer.inputs
        for read_it in (lambda: row.value, lambda: row.influence.elasticity):
            with self.assertRaisesRegex(sw.NotUsable, "the result must not be used: .* a/t = 0.88"):
                read_it()
        self.assertIn("value=not usable", repr(row) + row._repr_html_().replace("</th><td><strong>", "="))
        self.assertEqual(row.influence.unit_of("elasticity"), "1")
        self.assertTrue(answer.to_dict()["inputs"])
        with self.assertRaises(AttributeError):
            row.valu
        for again in (pickle.loads(pickle.dumps(row)), copy.copy(row), copy.deepcopy(answer).inputs):
            with self.assertRaises(sw.NotUsable):
                (again[0] if isinstance(again, tuple) else again).value
        column = drive.sweep(vary=["load.torque=10 N*m..50 N*m:3"]).columns[1]
        with self.assertRaises(sw.NotUsable):
            column.values
        self.assertEqual(column.unit, "rad/(N*m)")

    def test_behaviour_what_a_part_of_an_unusable_answer_still_gives(self):
        class Kinds(parts.Part):
            _fields = {"word": ("word", parts.plain), "count": ("count", parts.plain),
                       "number": ("number", parts.plain_number), "array": ("array", parts.floats),
                       "mixed": ("mixed", parts.entries), "counts": ("counts", parts.entries),
                       "rows": ("rows", parts.floats), "many": ("many", parts.many(parts.plain_number)),
                       "absent": ("absent", parts.plain_number)}

        given = {"word": "a", "count": 3, "number": 1.5, "array": {"values": [1.0, None]},
                 "mixed": {"values": [0.5, None]}, "counts": {"values": [1, 2]},
                 "rows": {"values": [[1.0], [2.0, 3.0]]}, "many": [1.0]}
        part = Kinds._of(given, "it did not converge")
        self.assertEqual((part.word, part.count, list(part.counts), part.absent), ("a", 3, [1, 2], None))
        for name in ("number", "array", "mixed", "rows", "many"):
            with self.assertRaisesRegex(sw.NotUsable, "it did not converge"):
                getattr(part, name)
        self.assertEqual(part.to_dict(), given)
        self.assertEqual(Kinds._of(given, "").number, 1.5)

    def test_behaviour_a_notebook_shows_nested_parts(self):
        shown = read("article").stiffness().cracked._repr_html_()
        self.assertRegex(shown, r"<th>positive</th><td><table>.*<th>stiffness</th><td>[0-9.e+]+ N\*m/rad")
        self.assertEqual(shown.count("<table>"), shown.count("</table>"))
        points = read("catalogue_size25").torsion().curve._repr_html_()
        self.assertRegex(points, r"<th>torque</th><td>array of \d+ \[N\*m\]</td>")
        solutions = sw.sif_list()
        self.assertIn(f"and {len(solutions.solutions) - parts.MOST_SHOWN} more", parts.html_table(solutions))

    def test_identity_numbers_without_a_unit_beside_them(self):
        audit = sw.audit()
        stated = audit.to_dict()["rows"]
        self.assertEqual(len(audit.rows), len(stated))
        self.assertEqual([row.corrected for row in audit.rows],
                         [given.get("corrected") for given in stated])
        self.assertGreater(sum(row.corrected is not None for row in audit.rows), 10)
        self.assertTrue(math.isnan(parts.plain_number(None, "")))

    def test_behaviour_results_are_frozen(self):
        answer = read("article").stiffness()
        with self.assertRaises(dataclasses.FrozenInstanceError):
            answer.method = "repaired"
        with self.assertRaises(dataclasses.FrozenInstanceError):
            answer.cracked.positive.stiffness = 3
        curve = read("catalogue_size25").torsion()
        with self.assertRaises(ValueError):
            curve.curve.points.torque[0] = 1
        given = answer.to_dict()
        given["method"] = "changed"
        self.assertEqual(answer.method, "corrected")

    def test_behaviour_arrays_have_units(self):
        answer = read("catalogue_size25").torsion()
        points = answer.curve.points
        self.assertEqual(points.torque.dtype, np.float64)
        self.assertEqual(points.unit_of("torque"), "N*m")
        self.assertEqual(points.unit_of("twist"), "rad")
        self.assertEqual(len(points.torque), len(points.twist))
        self.assertEqual(answer.positive.unit_of("K1"), "N*m/rad")
        self.assertEqual(sw.audit().rows[0].unit_of("verdict"), "1")
        ragged = parts.floats({"values": [[1.0, None], [3.0]]}, "")
        self.assertEqual([len(row) for row in ragged], [2, 1])
        self.assertTrue(math.isnan(ragged[0][1]))
        self.assertEqual(parts.floats({"values": [[1.0, 2.0], [3.0, 4.0]]}, "").shape, (2, 2))
        self.assertEqual(parts.floats({"values": []}, "").shape, (0,))

    def test_behaviour_pickled_and_copied_results_make_their_documents(self):
        answer = read("article").stiffness()
        for again in (pickle.loads(pickle.dumps(answer)), copy.copy(answer), copy.deepcopy(answer)):
            self.assertEqual(again, answer)
            self.assertEqual(again.document("text"), answer.document("text"))
        drive = read("article")
        answer = drive.stiffness()
        stored = pickle.dumps(answer)
        drive["load.torque"] = "1 N*m"
        self.assertEqual(pickle.loads(stored).document("json"), answer.document("json"))

    def test_behaviour_documents(self):
        answer = read("catalogue_size25").torsion()
        self.assertIn("plot", answer.documents)
        self.assertTrue(answer.svg().startswith("<svg") or "<svg" in answer.svg())
        self.assertEqual(str(answer), answer.document("text"))
        with tempfile.TemporaryDirectory() as folder:
            for name, start in (("a.json", "{"), ("a.csv", ""), ("a.txt", ""), ("a.svg", "<")):
                answer.save(Path(folder, name))
                self.assertTrue(Path(folder, name).read_text().startswith(start))
            answer.save(Path(folder, "other.dat"), "json")
            self.assertEqual(Path(folder, "other.dat").read_text(), answer.document("json"))
            with self.assertRaisesRegex(ValueError, "json, text, csv, plot"):
                answer.save(Path(folder, "a.png"))
        with self.assertRaises(sw.OptionError):
            answer.document("picture")
        with self.assertRaises(ValueError):
            sw.audit().svg()

    def test_behaviour_libraries(self):
        self.assertIn("17-4PH H900", sw.materials)
        self.assertEqual(float(sw.materials["17-4PH H900"].material[0].yield_strength.value), 1.17e9)
        self.assertEqual(len(list(sw.materials)), len(sw.materials))
        with self.assertRaises(KeyError):
            sw.materials["unobtainium"]
        with self.assertRaises(KeyError):
            sw.sif["no-such-solution"]
        self.assertNotIn("no-such-solution", sw.sif)
        self.assertIn("tube-through-inclined", sw.sif)
        self.assertEqual(len(list(sw.sif)), len(sw.sif))
        tube = sw.sif["tube-through-inclined"]
        texts = tube(half_length="4 mm", torque="100 N*m")
        numbers = tube(half_length=4e-3, torque=sw.Quantity(100, "N*m"))
        self.assertEqual(texts.largest, numbers.largest)
        self.assertEqual(texts.largest.unit_of("K_I"), "Pa*m^0.5")
        with self.assertRaises(sw.InputError):
            tube(half_lenght="4 mm")
        self.assertEqual(tube.show().name, "tube-through-inclined")

    def test_behaviour_a_file_and_a_drive_as_options(self):
        counted = sw.duty(rainflow=EXAMPLES / "joint_history.csv", column="torque")
        self.assertGreater(counted.history.points, 0)
        changed = read("article")
        changed["load.torque"] = "1 N*m"
        difference = sw.diff(read("article"), changed)
        self.assertIn("load.torque", difference.document("text"))
        with self.assertRaises(FileNotFoundError):
            sw.duty(rainflow=Path("no_such_history.csv"))

    def test_behaviour_texts_that_options_name(self):
        text = (EXAMPLES / "joint_history.csv").read_text()
        given = sw.duty(rainflow="mine.csv", column="torque", texts={"mine.csv": text})
        same = sw.duty(rainflow=EXAMPLES / "joint_history.csv", column="torque")
        self.assertEqual(given.history.points, same.history.points)

    def test_input_a_text_that_is_not_given(self):
        """The sentence says what to do."""
        for call in (lambda: sw.duty(rainflow="mine.csv", column="torque"), lambda: sw.fit("x.csv"),
                     lambda: read("article").calibrate(measured="folder/file.csv"),
                     lambda: read("inspected_shaft").inspect(detection_data="x.csv"),
                     lambda: sw.diff("a.toml", "b.toml")):
            with self.assertRaisesRegex(sw.OptionError, r"give a pathlib\.Path, .* texts=\{NAME: TEXT\}"):
                call()

    def test_input_the_path_of_an_error_is_the_argument(self):
        """The library spells an option with or without dashes."""
        history = (EXAMPLES / "growth_specimens.csv").read_text()
        read_all = {name: read(name) for name in ("cracked_size25", "article", "inspected_shaft")}
        for command, options, path in (
                ("accuracy", {"tool_radius": "x"}, "tool_radius"), ("accuracy", {"speed": "-1 m"}, "speed"),
                ("backbone", {"load_torque": "x"}, "load_torque"), ("backbone", {"from_": "x"}, "from_"),
                ("frf", {"from_": "x"}, "from_"), ("frf", {"to": "x"}, "to"), ("modes", {"torque": "x"}, "torque"),
                ("simulate", {"step": "x"}, "step"), ("torsion", {"cage_phase": "x"}, "cage_phase"),
                ("transmission", {"torque": "x"}, "torque"), ("transmission", {"spline_teeth": "x"}, "spline_teeth"),
                ("grow", {"until": "x"}, "until"), ("inspect", {"until": "x"}, "until"),
                ("inspect", {"false_calls": 3}, "false_calls"), ("inspect", {"detection_data": "x"}, "detection_data"),
                ("sweep", {"vary": ["x"]}, "vary"), ("solve", {"vary": "a", "target": "b"}, "vary"),
                ("stiffness", {"method": "best"}, "method"), ("turn", {"half_length": ["x"]}, "half_length"),
                ("fit", {"data": "d", "stress_range": "x", "texts": {"d": history}}, "stress_range"),
                ("fit", {"data": "d", "plate_width": "x", "stress_range": "60 MPa", "texts": {"d": history}},
                 "plate_width"),
                ("sif_eval", {"name": "plate-surface", "set": ["x"]}, "set")):
            name = "inspected_shaft" if command in ("inspect", "grow") else "cracked_size25"
            call = getattr(read_all[name], command, None) or getattr(sw, command)
            with self.subTest(command=command, options=options), self.assertRaises(sw.InputError) as caught:
                call(**options)
            self.assertEqual(caught.exception.path, path, f"{command}: {caught.exception}")
        with self.assertRaises(sw.InputError) as caught:  # a field of the drive stays as it is
            read_all["article"]["load.torque"] = "3 kg"
        self.assertEqual(caught.exception.path, "load.torque")


@unittest.skipIf(missing("pandas"), missing("pandas"))
class Frames(unittest.TestCase):
    def test_identity_the_table_of_a_sweep(self):
        answer = read("article").sweep(vary=["load.torque=10 N*m..50 N*m:5"])
        frame = answer.to_frame()
        self.assertEqual(list(frame["load.torque"]), [10, 20, 30, 40, 50])
        self.assertEqual(frame.attrs["units"]["load.torque"], "N*m")
        self.assertEqual(len(frame), 5)

    def test_behaviour_arrays_of_a_part(self):
        points = read("catalogue_size25").torsion().curve.points
        frame = points.to_frame()
        self.assertEqual(frame.attrs["units"]["torque"], "N*m")
        np.testing.assert_array_equal(frame["twist"], points.twist)

    def test_behaviour_frames_carry_the_evidence(self):
        drive = read("article")
        good = drive.sweep(vary=["load.torque=10 N*m..50 N*m:2"])
        attrs = good.to_frame().attrs
        self.assertEqual((attrs["unusable_because"], attrs["verdict"]), ("", good.verdict.to_dict()))
        drive["output_shaft.crack[0].depth"] = "11 mm"
        bad = drive.sweep(vary=["load.torque=10 N*m..50 N*m:2"])
        self.assertRegex(bad.to_frame().attrs["unusable_because"], "points are not usable")
        column = bad.columns[1].to_frame()
        self.assertEqual(column.attrs["unusable_because"], bad.unusable_because)
        self.assertEqual(list(column["values"]), bad.to_dict()["columns"][1]["values"]["values"])

    def test_behaviour_what_has_no_table(self):
        with self.assertRaises(ValueError):
            read("article").stiffness().cracked.to_frame()
        with self.assertRaises(ValueError):
            sw.explain("load.torque").to_frame()

    def test_behaviour_rows_of_a_batch(self):
        frame = read("article").batch({"load.torque": [10.0, -1e9]}, ["intact.stiffness"]).to_frame()
        self.assertEqual(list(frame.columns), ["load.torque", "intact.stiffness", "outcome"])


if __name__ == "__main__":
    main()
