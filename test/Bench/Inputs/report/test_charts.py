"""What axes show, where names stand, and what of a chart comes into the page."""
import re
import unittest
import xml.etree.ElementTree as xml

import numpy
from cells import KIBI, cell, speed
from voxc_report.catalogue import make_catalogue
from voxc_report.charts import labels
from voxc_report.charts.frontier import frontier_chart
from voxc_report.charts.scales import power_text, ranges_of


class Ranges(unittest.TestCase):
    def test_are_shared_by_charts_that_are_compared(self):
        gpu = {"device": {"clock": "gpu"}, "speed": {"mrays_per_device_s": speed(700, 0)}}
        stages = make_catalogue([
            cell("G(11)", 100, 2), cell("G(11)", 900, 5, device={"name": "cpu"}), cell("G(11)", 50, 0.2, device={"name": "slow"}),
            cell("G(11)", 60, 7, **gpu), cell("G(11)", 5, 3, resolution=512)]).stages
        ranges = ranges_of(stages)
        self.assertEqual({(own.least_size, own.most_size) for own in ranges[:4]}, {(50, 900)})
        self.assertEqual(ranges[4].most_size, 5)
        speeds = {(stage.device.split()[0], stage.has_clock): own.most_speed for stage, own in zip(stages[:4], ranges)}
        self.assertEqual(speeds["llvmpipe", False], speeds["cpu", False])
        self.assertLess(speeds["slow", False], 0.3)  # It would lie flat on the others' axis.
        self.assertEqual(speeds["llvmpipe", True], 700)

    def test_tell_powers_of_two(self):
        self.assertEqual([power_text(exponent) for exponent in (0, 9, 10, 24, 31, -1)],
                         ["1 B", "512 B", "1 KiB", "16 MiB", "2 GiB", "0.5 B"])


class Labels(unittest.TestCase):
    FRAME = (0, 0, 400, 300)
    NOTHING = labels.as_boxes([])

    def test_cover_neither_each_other_nor_points(self):
        wanted = [labels.Label(f"R({i}³) G({i})", 100 + 25 * i, 60 + 22 * i) for i in range(8)]
        placed = labels.place_labels(wanted, self.FRAME, 12, self.NOTHING)
        boxes = numpy.vstack([one.box for one in placed])
        shared = labels.overlaps(boxes, boxes)
        self.assertAlmostEqual(shared.sum(), numpy.trace(shared))
        self.assertEqual(labels.overlaps(boxes, labels.point_boxes(wanted, 12)).sum(), 0)
        self.assertLess(labels.outside(boxes, self.FRAME).sum(), 1e-6)

    def test_stand_right_of_a_point_that_is_alone(self):
        [placed] = labels.place_labels([labels.Label("G(11)", 100, 100)], self.FRAME, 10, self.NOTHING)
        self.assertGreater(placed.box[0], 100)
        self.assertFalse(placed.has_leader)

    def test_are_left_out_where_there_is_no_room(self):
        taken = labels.as_boxes([(0, 0, 400, 90)])
        wanted = [labels.Label("above", 100, 40), labels.Label("below", 100, 150), labels.Label("too many", 300, 250)]
        placed = labels.place_where_free(wanted, self.FRAME, 10, taken, most=1)
        self.assertEqual([one.label.text for one in placed], ["below"])

    def test_stand_on_another_side_where_there_is_room(self):
        taken = labels.as_boxes([(105, 90, 400, 110)])
        [placed] = labels.place_where_free([labels.Label("G(11)", 100, 100)], self.FRAME, 10, taken, most=9)
        self.assertLess(placed.box[2], 100)


class Chart(unittest.TestCase):
    def draw(self, *cells, is_alone=False):
        catalogue = make_catalogue(cells)
        drawn = frontier_chart(catalogue, catalogue.stages[0], ranges_of(catalogue.stages)[0], is_alone)
        return [xml.fromstring(chart) for chart in re.findall("<svg.*?</svg>", drawn, re.DOTALL)]

    def points(self, chart):
        """Where the points of a chart lie, by the rows that they lead to."""
        return {point.get("href"): (float(point.find("use").get("x")), float(point.find("use").get("y"))) for point in chart.iter("a")}

    def test_is_drawn_for_each_width(self):
        names = [chart.get("class").split()[1] for chart in self.draw(cell("G(11)", 100, 1), is_alone=True)]
        self.assertEqual(names, ["wide", "narrow", "full"])
        self.assertEqual(len(self.draw(cell("G(11)", 100, 1))), 2)

    def test_places_points_by_size_and_speed(self):
        wide, _ = self.draw(cell("G(11)", 64 * KIBI, 1), cell("S(11)", 256 * KIBI, 2), cell("R(9^3)", 1024 * KIBI, 1))
        (x1, y1), (x2, y2), (x3, y3) = self.points(wide).values()
        found = self.points(wide)
        (x1, y1), (x2, y2), (x3, y3) = found["#r1"], found["#r2"], found["#r3"]
        self.assertAlmostEqual(x2 - x1, x3 - x2, delta=0.2)  # By the logarithm.
        self.assertEqual(y1, y3)
        self.assertLess(y2, y1)

    def test_leaders_lie_on_top_and_notes_in_one_drawing(self):
        wide, narrow = self.draw(cell("G(11)", 100, 1), cell("S(11)", 500, 0.5), cell("R(4^3) G(7)", 200, 2))
        self.assertEqual([point.get("class") for point in wide.iter("a")], ["point f3", "point f3 on", "point f1 on"])
        self.assertEqual(len(wide.findall(".//a/title")), 3)
        self.assertEqual(len(narrow.findall(".//a/title")), 0)
        self.assertEqual(len(narrow.findall(".//path[@class='rounds']")), 3)

    def test_names_have_no_formulas(self):
        wide, _ = self.draw(cell("$x^2$", 100, 1))
        self.assertIn("$x^2$", [text.text for text in wide.iter("text")])

    def test_gives_no_colours_and_loads_nothing(self):
        text = xml.tostring(self.draw(cell("G(11)", 100, 1))[0], encoding="unicode")
        for word in ("style", "#0", "#f", "url(", "http", "clip", "metadata"):
            self.assertNotIn(word, text)
