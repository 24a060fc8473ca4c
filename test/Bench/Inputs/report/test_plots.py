"""The plots of voxc accuracy."""
import unittest
import xml.etree.ElementTree as xml

from voxc_report.accuracy import plots_of
from voxc_report.charts.plots import COLOURS, Axis, Plot, Series, power_text

SVG = "{http://www.w3.org/2000/svg}"


def score(label, speed, wrong=0):
    return {"label": label, "mrays_per_cpu_s": speed, "error": {"rays": 1000, "missed": 0, "ghost": wrong, "wrong": 0}}


FIGURES = {"format": "G(5)", "rays": 3072, "variants": [score("exact stack", 2), score("fast stack", 3, 5)],
           "lods": [{"pixels": 1, "speed_up": 1, "psnr": None}, {"pixels": 2.5, "speed_up": 2, "psnr": 30}],
           "series": {"distance": [{"voxels": 10**i, "variants": [score("", 1), score("", 2, i)]} for i in range(4)]}}


def titles(svg):
    return [title.text for title in xml.fromstring(svg).iter(SVG + "title")]


class Plots(unittest.TestCase):
    def test_are_of_what_there_is(self):
        self.assertEqual(list(plots_of(FIGURES)), ["accuracy", "lod", "distance-error", "distance-speed"])
        self.assertEqual(list(plots_of({key: FIGURES[key] for key in ("format", "rays", "variants")})), ["accuracy"])

    def test_tell_each_point(self):
        svg = plots_of(FIGURES)["accuracy"].to_svg()
        self.assertEqual(titles(svg), ["Speed against error",
                                       "exact stack: 2 million rays per CPU second, 0 errors per million",
                                       "fast stack: 3 million rays per CPU second, 5000 errors per million"])
        self.assertIn("G(5), 3072 rays", svg)

    def test_leave_out_what_has_no_value(self):
        self.assertEqual(titles(plots_of(FIGURES)["lod"].to_svg())[1:], ["2.5 pixels"])

    def test_have_a_line_for_each_variant(self):
        svg = plots_of(FIGURES)["distance-error"].to_svg()
        self.assertEqual(len(titles(svg)), 1 + 8)
        self.assertIn("Error against the distance of the origin", svg)

    def test_escape_text_and_have_no_formulas(self):
        svg = Plot("a < b & $c$", "", Axis("x"), Axis("y"), [Series("s", [(1, 2, "<note>")])]).to_svg()
        self.assertIn("a &lt; b &amp; $c$", svg)
        self.assertIn("&lt;note&gt;", svg)

    def test_are_light_and_dark_and_load_nothing(self):
        for plot in plots_of(FIGURES).values():
            svg = plot.to_svg()
            style, drawing = svg.split("</style>", 1)
            self.assertIn("prefers-color-scheme:dark", style)
            for light, dark in COLOURS.values():
                self.assertNotIn(light, drawing)
                self.assertIn(dark, style)
            for word in ("@import", "url(http", 'href="http'):
                self.assertNotIn(word, svg)

    def test_powers_of_ten_are_short(self):
        self.assertEqual([power_text(value) for value in (0, 0.01, 1, 100, 1e3, 1e-5)], ["0", "0.01", "1", "100", "10³", "10⁻⁵"])
