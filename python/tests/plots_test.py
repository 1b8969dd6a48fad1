# SPDX-License-Identifier: Apache-2.0
"""Charts drawn by matplotlib against the numbers that the SVG carries."""

import json
import math
import os
import unittest

import strainwave as sw
from strainwave import plots
from support import EXAMPLES, main, missing, python, trials


def read(name):
    return sw.read(EXAMPLES / f"{name}.toml")


@unittest.skipIf(missing("matplotlib"), missing("matplotlib"))
class Plots(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        import matplotlib
        matplotlib.use("Agg")

    def tearDown(self):
        from matplotlib import pyplot
        pyplot.close("all")

    def assert_same(self, drawn, given):
        self.assertEqual(len(drawn), len(given))
        for one, other in zip(drawn, given):
            self.assertTrue(one == other or other is None and math.isnan(one))

    def test_identity_lines(self):
        answer = read("catalogue_size25").torsion()
        axes, panels = answer.plot(), plots.panels_of(answer.svg())
        self.assertEqual(len(axes), len(panels))
        for ax, panel in zip(axes, panels):
            self.assertEqual((ax.get_xlabel(), ax.get_ylabel()), (panel["x_label"], panel["y_label"]))
            self.assertEqual(ax.get_xscale(), panel["x_scale"])
            lines = [line for line in ax.get_lines() if line.get_marker() == "None"]
            self.assertEqual([line.get_label() for line in lines],
                             [series["label"] for series in panel["series"]])
            for line, series in zip(lines, panel["series"]):
                self.assert_same(list(line.get_xdata()), series["x"])
                self.assert_same(list(line.get_ydata()), series["y"])
                self.assertEqual(line.get_color(), series["colour"])

    def test_identity_the_numbers_are_those_of_the_result(self):
        answer = read("catalogue_size25").torsion()
        series = plots.panels_of(answer.svg())[0]["series"][0]
        torque = answer.curve.points.torque
        self.assertAlmostEqual(max(series["x"]), max(torque), delta=1e-4 * max(torque))

    def test_identity_bars(self):
        answer = read("article_scatter").sensitivity()
        panel = plots.panels_of(answer.svg())[0]
        ax = answer.plot()[0]
        self.assert_same([bar.get_width() for bar in ax.containers[0]], panel["series"][0]["values"])
        self.assertEqual([label.get_text() for label in ax.get_yticklabels()], panel["labels"])
        self.assertTrue(ax.yaxis_inverted())  # the first bar is the uppermost
        for row, bar in enumerate(ax.containers[0]):  # one series: each bar is at its label
            self.assertAlmostEqual(bar.get_y() + bar.get_height() / 2, row)
        self.assertEqual([list(line.get_xdata()) for line in ax.lines], [[0, 0]])  # where bars begin

    def test_identity_contours(self):
        from matplotlib.colors import to_hex
        answer = read("solid_shaft").sweep(vary=["output_shaft.crack[0].depth=1 mm..20 mm:5",
                                                 "output_shaft.length=100 mm..300 mm:4"])
        panel = plots.panels_of(answer.svg())[0]
        self.assertEqual(len(panel["values"]), 20)
        axes = answer.plot()
        first = axes[0] if isinstance(axes, list) else axes
        colours = [to_hex(colour).upper() for one in first.collections for colour in one.get_edgecolor()]
        self.assertEqual(colours, panel["colours"])
        self.assertEqual(len(panel["levels"]), len(colours))
        self.assertGreater(len(colours), 4)
        self.assertTrue(all(min(panel["values"]) < level < max(panel["values"])
                            for level in panel["levels"]))
        self.assertEqual([*first.get_xlim(), *first.get_ylim()],
                         [min(panel["x"]), max(panel["x"]), min(panel["y"]), max(panel["y"])])

    def test_behaviour_given_axes(self):
        from matplotlib import pyplot
        answer = read("article").sweep(vary=["load.torque=10 N*m..50 N*m:5"])
        panels = plots.panels_of(answer.svg())
        _, axes = pyplot.subplots(len(panels), squeeze=False)
        drawn = answer.plot(axes)
        self.assertEqual(drawn if isinstance(drawn, list) else [drawn], list(axes.flat))
        with self.assertRaisesRegex(ValueError, f"the chart has {len(panels)} panels"):
            answer.plot([axes.flat[0]] * (len(panels) + 1))

    def test_behaviour_every_plot_of_the_trials_is_drawn(self):
        from matplotlib import pyplot
        examples = sorted(EXAMPLES.glob("*.toml"))
        drawn = set()
        for command, text in trials():
            options = json.loads(text)
            function = getattr(sw.Drive, command.replace(" ", "_"), None)
            if function is None or command in drawn:
                continue
            for example in examples:
                try:
                    answer = function(sw.read(example), **{
                        name + "_" if name == "from" else name: value for name, value in options.items()})
                    svg = answer.svg()
                except (sw.Error, ValueError):
                    continue
                answer.plot()
                pyplot.close("all")
                self.assertTrue(plots.panels_of(svg))
                drawn.add(command)
                break
        self.assertGreaterEqual(len(drawn), 14, drawn)

    def test_input_a_text_that_is_no_picture(self):
        with self.assertRaisesRegex(ValueError, "is no SVG, it begins with 'what,name"):
            sw.Svg("what,name\n")

    def test_input_no_chart_and_no_matplotlib(self):
        with self.assertRaisesRegex(ValueError, "carries no numbers"):
            plots.draw("<svg></svg>", None)
        with self.assertRaises(ValueError):
            sw.catalogue(size=25).plot()
        ended = python("import sys; sys.modules['matplotlib'] = None; import strainwave as sw\n"
                       "try: sw.read(sys.argv[1]).torsion().plot()\n"
                       "except ImportError as error: print(error)",
                       os.fspath(EXAMPLES / "catalogue_size25.toml"))
        self.assertIn("plot() needs matplotlib", ended.stdout, ended.stderr)


if __name__ == "__main__":
    main()
