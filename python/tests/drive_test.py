# SPDX-License-Identifier: Apache-2.0
"""A drive: reading, changing, comparing, copying."""

import copy
import os
import pickle
import re
import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np
import strainwave as sw
from strainwave._units import unit_of
from support import EXAMPLES, ROOT, main


def size25():
    return sw.read(EXAMPLES / "cracked_size25.toml")


class Reading(unittest.TestCase):
    def test_behaviour_a_file_with_a_table_beside_it(self):
        drive = sw.read(EXAMPLES / "tabulated_crack.toml")
        self.assertEqual(len(drive.tables), 1)
        self.assertTrue(drive.stiffness().usable)

    def test_behaviour_a_table_that_is_handed_over(self):
        drive = sw.read(EXAMPLES / "tabulated_crack.toml")
        again = sw.parse(drive.text, "elsewhere.toml", drive.tables)
        self.assertEqual(again.stiffness().cracked, drive.stiffness().cracked)

    def test_behaviour_a_text_finds_no_table_in_the_working_folder(self):
        """A drive that was parsed reads no file, even if a file has its name."""
        text = (EXAMPLES / "tabulated_crack.toml").read_text()
        before = os.getcwd()
        os.chdir(EXAMPLES)
        try:
            drive = sw.parse((EXAMPLES / "through_crack.toml").read_text(), "tabulated_crack.toml")
            table = re.search(r'compliance_table = "([^"]+)"', text).group(1)
            with self.assertRaises(sw.InputError):
                drive["flexspline.crack[0].compliance_table"] = table
            read = sw.read("through_crack.toml")
            read["flexspline.crack[0].compliance_table"] = table
            self.assertEqual(list(read.tables), [table])
        finally:
            os.chdir(before)

    def test_input_a_missing_table_is_named(self):
        text = (EXAMPLES / "tabulated_crack.toml").read_text()
        with self.assertRaisesRegex(sw.InputError, "tables/"):
            sw.parse(text)

    def test_input_the_fault_is_located(self):
        with self.assertRaises(sw.InputError) as caught:
            sw.parse('format = "strainwave-drive/1"\n[drive]\nratio = 100\npitch_diameter = "3 kg"\n', "mine.toml")
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column, error.path, error.value),
                         ("mine.toml", 4, 18, "drive.pitch_diameter", '"3 kg"'))
        self.assertTrue(str(error).startswith("mine.toml:4:18: drive.pitch_diameter"))
        self.assertIsInstance(error, ValueError)
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.line, again.path), (str(error), 4, error.path))

    def test_input_the_rule_is_named(self):
        with self.assertRaises(sw.InputError) as caught:
            size25()["output_shaft.crack[0].depth"] = "-1 mm"
        self.assertEqual(caught.exception.rule, "> 0")

    def test_input_files_that_are_no_drives(self):
        with self.assertRaises(FileNotFoundError):
            sw.read("no/such/file.toml")
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(OSError):
                sw.read(folder)
            file = Path(folder, "bytes.toml")
            file.write_bytes(b"\xff\xfe\x00")
            with self.assertRaises(sw.InputError):
                sw.read(file)
            file.write_bytes(b"#" * ((1 << 20) + 1))
            with self.assertRaisesRegex(sw.InputError, "MiB|1048576|large|long"):
                sw.read(file)

    def test_behaviour_new_drives(self):
        self.assertTrue(sw.new().stiffness().usable)
        drive = sw.new(size=25, ratio=100)
        self.assertEqual(drive["drive.ratio"], 100)
        with self.assertRaises(sw.OptionError):
            sw.new(size=26)


class Changing(unittest.TestCase):
    def test_behaviour_text_quantity_and_bare_number_agree(self):
        texts = set()
        for depth in ("3 mm", "0.003 m", 3e-3, np.float64(3e-3), sw.Quantity(3e-3, "m")):
            drive = size25()
            drive["output_shaft.crack[0].depth"] = depth
            self.assertEqual(float(drive["output_shaft.crack[0].depth"]), 3e-3)
            texts.add(repr(drive.stiffness().cracked.positive.stiffness.value))
        self.assertEqual(len(texts), 1)

    def test_behaviour_numbers_without_a_unit(self):
        drive = size25()
        drive["drive.ratio"] = 80
        drive["wave_generator.crack[0].aspect_ratio"] = 0.6
        self.assertEqual((drive["drive.ratio"], drive["wave_generator.crack[0].aspect_ratio"]),
                         (80, 0.6))

    def test_behaviour_a_name_that_looks_like_a_quantity_stays_text(self):
        drive = size25()
        drive["name"] = "25 mm"
        self.assertEqual((drive["name"], drive.fields()["name"]), ("25 mm", "25 mm"))

    def test_identity_every_quantity_of_every_example_is_recognised(self):
        """Text that looks like a quantity remains only where the file has text: bounds of a range
        in their own unit, and names of steels."""
        def remaining(value, path):
            if isinstance(value, str):
                return [path] if re.fullmatch(r"-?[0-9.e+-]+ [A-Za-z/*^0-9()]+", value) else []
            if isinstance(value, dict):
                return [one for name, part in value.items() for one in remaining(part, f"{path}.{name}")]
            return [one for part in value for one in remaining(part, path)] if isinstance(value, list) else []

        for file in sorted(EXAMPLES.glob("*.toml")):
            for path in remaining(sw.read(file).fields(), ""):
                self.assertRegex(path, r"^\.range\.(lower|upper)$|\.material$")

    def test_identity_the_units_of_bare_numbers_are_those_of_the_reference(self):
        """Every field of the reference of the input that has a unit, under each kind of its table."""
        section, compared = "", 0
        for line in (ROOT / "docs" / "guide" / "input_file.md").read_text().splitlines():
            if line.startswith("## "):
                named = re.match(r"## `\[+([\w.]+)\]+", line)
                section = named.group(1) if named else ""
            row = re.match(r"\| `(\w+)` \| `([^`]+)` \|", line)
            if row and section:
                self.assertEqual(unit_of(f"{section}.{row.group(1)}"), row.group(2), f"{section}: {line}")
                compared += 1
        self.assertGreater(compared, 150)

    def test_behaviour_names_of_any_characters(self):
        """TOML wants other escapes than JSON."""
        drive = sw.read(EXAMPLES / "article.toml")
        steel = {"youngs_modulus": "200 GPa", "poissons_ratio": 0.3}
        drive["material"] = {"steel": steel, "st\u00e5l \U0001f600": steel, "a\x7fb": steel, 'a "b"': steel}
        self.assertEqual(sorted(drive["material"]), sorted(["steel", "st\u00e5l \U0001f600", "a\x7fb", 'a "b"']))

    def test_behaviour_comments_stay(self):
        drive = sw.parse((EXAMPLES / "article.toml").read_text() + "\n# the last line\n")
        drive["load.torque"] = "7 N*m"
        self.assertTrue(drive.text.endswith("# the last line\n"))
        self.assertIn('torque = "7 N*m"', drive.text)

    def test_behaviour_a_refused_change_leaves_the_drive(self):
        drive = size25()
        before = drive.text
        for path, value in (("output_shaft.crack[0].depth", "-3 mm"),
                            ("output_shaft.crack[0].depht", "3 mm"), ("drive.ratio", "many"),
                            ("output_shaft.crack[7].depth", "3 mm")):
            with self.assertRaises(sw.InputError):
                drive[path] = value
            self.assertEqual(drive.text, before)
        with self.assertRaises(sw.InputError):  # the first change alone would be valid
            drive.edit({"load.torque": "5 N*m", "drive.ratio": -1})
        self.assertEqual(drive.text, before)

    def test_behaviour_changes_that_need_each_other(self):
        drive = sw.read(EXAMPLES / "solid_shaft.toml")
        outer = float(drive["output_shaft.outer_diameter"])
        with self.assertRaises(sw.InputError):
            drive["output_shaft.inner_diameter"] = 1.5 * outer
        drive.edit({"output_shaft.inner_diameter": 1.5 * outer,
                    "output_shaft.outer_diameter": 2 * outer})
        self.assertEqual(float(drive["output_shaft.inner_diameter"]), 1.5 * outer)

    def test_behaviour_cracks(self):
        drive = size25()
        count = len(drive.cracks)
        crack = drive.cracks.append("output_shaft", kind="annular", depth="1 mm")
        self.assertEqual((crack.path, len(drive.cracks)), ("output_shaft.crack[1]", count + 1))
        crack["depth"] = 2e-3
        self.assertEqual(float(drive["output_shaft.crack[1].depth"]), 2e-3)
        self.assertEqual(crack.fields()["kind"], "annular")
        self.assertIn("output_shaft.crack[1]", drive)
        del drive["output_shaft.crack[1]"]
        self.assertNotIn("output_shaft.crack[1]", drive)
        self.assertEqual([one.path for one in drive.cracks], [one.path for one in size25().cracks])
        drive.cracks.clear()
        self.assertEqual(len(drive.cracks), 0)
        with self.assertRaisesRegex(sw.InputError, r"this drive has no \[gear\]; give its fields first"):
            drive.cracks.append("gear", kind="annular", depth="1 mm")
        with self.assertRaisesRegex(sw.InputError, "load can have no crack; name one of the members"):
            drive.cracks.append("load", kind="annular", depth="1 mm")

    def test_behaviour_cracks_of_one_table(self):
        drive = size25()
        count = len(drive.cracks)
        group = drive.cracks.append("output_shaft", kind="annular", depth="1 mm",
                                    positions=["10 mm", "12 mm", "15 mm"])
        self.assertEqual((group.path, len(drive.cracks)), ("output_shaft.crack[1]", count + 3))
        self.assertEqual([float(drive[f"output_shaft.crack[{i}].distance"]) for i in (1, 2, 3)],
                         [0.01, 0.012, 0.015])
        group["depth"] = "2 mm"  # the table is that of all three
        self.assertEqual(float(drive["output_shaft.crack[3].depth"]), 2e-3)
        single = drive.cracks.append("output_shaft", **drive.cracks[count - 1].fields())
        self.assertEqual(single.path, "output_shaft.crack[2]")  # before the copies of the group
        self.assertEqual(float(drive["output_shaft.crack[4].distance"]), 0.015)
        drive.cracks.clear()
        self.assertEqual(len(drive.cracks), 0)

    def test_input_paths_and_values_of_wrong_types(self):
        drive = size25()
        for path in ("no.such", "drive.ratio.more", "output_shaft.crack[9]", ""):
            with self.assertRaises(KeyError):
                drive[path]
        with self.assertRaises(TypeError):
            drive[3]
        for value in (object(), b"3 mm", 1j, {1, 2}):
            with self.assertRaises(TypeError):
                drive["load.torque"] = value
        for value in (float("nan"), float("inf"), "nan N*m", "", "3", "3 mm", "\ud800"):
            with self.assertRaises(ValueError):
                drive["load.torque"] = value


class Values(unittest.TestCase):
    def test_behaviour_equal_drives(self):
        one, other = size25(), size25()
        self.assertEqual(one, other)
        self.assertEqual(hash(one), hash(other))
        other["load.torque"] = "1 N*m"
        self.assertNotEqual(one, other)
        self.assertNotEqual(one, one.text)

    def test_behaviour_the_same_text_is_the_same_drive_under_any_name(self):
        one = size25()
        other = sw.parse(one.text)
        self.assertNotEqual(one.name, other.name)
        self.assertEqual(one, other)
        self.assertEqual(hash(one), hash(other))

    def test_behaviour_drives_with_other_tables_differ(self):
        one = sw.read(EXAMPLES / "tabulated_crack.toml")
        (name, table), = one.tables.items()
        self.assertEqual(one, sw.parse(one.text, tables=one.tables))
        self.assertEqual(hash(one), hash(sw.parse(one.text, tables={**one.tables, "unused.csv": "x"})))
        self.assertNotEqual(one, sw.parse(one.text, tables={name: table.replace("\n", "\n# other\n", 1)}))

    def test_behaviour_a_notebook_shows_name_cracks_and_text(self):
        drive = sw.parse(size25().text + "\n# <end>\n", "a<b.toml")
        shown = drive._repr_html_()
        for part in ("a&lt;b.toml", "output_shaft.crack[0] (annular)", "# &lt;end&gt;"):
            self.assertIn(part, shown)
        drive.cracks.clear()
        self.assertIn("cracks: none", drive._repr_html_())

    def test_behaviour_copies_are_independent(self):
        one = size25()
        for other in (one.copy(), copy.copy(one), copy.deepcopy(one),
                      pickle.loads(pickle.dumps(one))):
            self.assertEqual(one, other)
            other["load.torque"] = "1 N*m"
            self.assertEqual(float(one["load.torque"]), 48)
            self.assertEqual(float(other["load.torque"]), 1)

    def test_behaviour_a_pickled_drive_keeps_its_tables(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(EXAMPLES / "tabulated_crack.toml", folder)
            shutil.copytree(EXAMPLES / "tables", Path(folder, "tables"))
            drive = sw.read(Path(folder, "tabulated_crack.toml"))
            before = drive.stiffness().cracked
            stored = pickle.dumps(drive)
        again = pickle.loads(stored)
        again["load.torque"] = again["load.torque"]
        self.assertEqual(again.stiffness().cracked.positive.stiffness.value,
                         before.positive.stiffness.value)

    def test_identity_saved_and_read_again(self):
        with tempfile.TemporaryDirectory() as folder:
            drive = size25()
            drive["load.torque"] = "30 N*m"
            drive.save(Path(folder, "saved.toml"))
            self.assertEqual(sw.read(Path(folder, "saved.toml")).text, drive.text)

    def test_identity_every_example_has_readable_fields(self):
        for file in sorted(EXAMPLES.glob("*.toml")):
            drive = sw.read(file)
            self.assertEqual(drive["drive.ratio"], drive.fields()["drive"]["ratio"])
            for crack in drive.cracks:
                self.assertIn("kind", crack.fields())

    def test_identity_a_field_set_to_its_own_value_changes_no_result(self):
        drive = size25()
        before = drive.stiffness().to_dict()
        for crack in list(drive.cracks):
            for name, value in crack.fields().items():
                if not isinstance(value, (list, dict)):
                    crack[name] = value
        self.assertEqual(drive.stiffness().to_dict(), before)


if __name__ == "__main__":
    main()
