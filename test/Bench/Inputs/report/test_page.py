"""The page as a whole: what it holds, what it leaves out, and that no record can put code into it."""
import tempfile
import unittest
from pathlib import Path

from cells import DEDUP, MEBI, cell, failure, page
from PIL import Image
from voxc_report.catalogue import make_catalogue
from voxc_report.csv_table import to_csv
from voxc_report.markup import fill, tag, text_tag
from voxc_report.catalogue import make_entries
from voxc_report.page import load_pictures
from voxc_report.pictures import thumbnail
from voxc_report.problems import Problem
from voxc_report.text import bytes_text, count_text, number_text, percent_text, plural


class Text(unittest.TestCase):
    def test_numbers_have_three_digits(self):
        for value, text in [(0, "0"), (0.03124, "0.0312"), (4.7361, "4.74"), (99.95, "100.0"), (12345.6, "12346")]:
            self.assertEqual(number_text(value), text)
        self.assertEqual(len(number_text(1e300)), 301)

    def test_tells_counts_sizes_and_shares(self):
        self.assertEqual([count_text(value) for value in (0, 999, 1440000)], ["0", "999", "1,440,000"])
        self.assertEqual([bytes_text(value) for value in (512, 12.5 * MEBI, 5e15)], ["512 B", "12.5 MiB", "4547 TiB"])
        self.assertEqual(percent_text(0.0234), "2.3 %")
        self.assertEqual([plural(count, "format") for count in (1, 1000)], ["1 format", "1,000 formats"])

    def test_is_escaped(self):
        self.assertEqual(text_tag("b", {"title": '"<&>'}, "<script>&"),
                         '<b title="&quot;&lt;&amp;&gt;">&lt;script&gt;&amp;</b>')
        self.assertEqual(tag("td", {}, ""), "<td></td>")

    def test_fills_templates_once(self):
        self.assertIn('<div class="rounds">{{content}} {{other}}</div>', fill("section/frontier.html",
                                                                              content="{{content}} {{other}}"))
        self.assertNotIn("{{", fill("section/frontier.html"))


class Page(unittest.TestCase):
    def test_has_a_point_for_each_speed_and_a_row_for_each_cell(self):
        html = page([cell("G(11)", 100, 1), cell("S(11)", 500, 0.5), cell("R(4^3) G(7)", 200, 2), failure("R(8^3) G(3)", "too large")])
        drawings = html.count('<svg class="chart')
        self.assertEqual(html.count('<a class="point'), 3 * drawings)
        self.assertEqual(html.count(' on" href="#r'), 2 * drawings)  # G(11) and R(4^3) G(7).
        self.assertEqual(html.count("<tr id=r"), 4)
        self.assertIn("missed 0, ghost 0, wrong 0 of 1,000 rays", html)
        self.assertIn("too large (it reached 12,345 words)", html)

    def test_leaves_out_sections_that_it_has_no_records_for(self):
        small = page([cell("G(11)", 100, 1)])
        for name in ("frontier", "predictions", "dedup", "restart", "unroll", "precision", "memory", "failures"):
            self.assertNotIn(f'<div id="{name}">', small)
        studied = page([cell("G(11)", 300, 1), cell("G(11)", 100, 1, DEDUP)])
        self.assertIn('<div id="dedup">', studied)
        self.assertIn("3.00×", studied)

    def test_is_made_of_failures_alone_too(self):
        html = page([failure("G(99)", "too large")])
        self.assertIn('<div id="failures">', html)
        self.assertNotIn('<div id="models">', html)

    def test_compares_frontiers_of_models_that_have_speeds(self):
        tower = {"model": {"name": "tower"}}
        self.assertIn("On the frontier of every model: G(11).", page([cell("G(11)", 100, 1), cell("G(11)", 100, 1, **tower)]))
        self.assertNotIn('<div id="frontier">', page([failure("G(", "no format"), failure("S(", "no format", **tower)]))

    def test_begins_each_model_with_the_verdict(self):
        given = {"model": {"input": "hut.obj"}}
        html = page([cell("G(11)", 5 * MEBI, 1, **given), cell("R(9^3)", 100 * MEBI, 4, **given), cell("D(9^3, 6)", 120 * MEBI, 3.99)])
        self.assertLess(html.index("<dt>Smallest</dt>"), html.index('<svg class="chart'))
        self.assertIn("<b>G(11)</b>, 5.00 MiB: 1.00 Mrays/CPU s on llvmpipe.", html)
        self.assertIn("<code>voxc build 'G(11)' hut.obj -o hut.hvx</code>", html)
        self.assertIn('As fast, within the spread: <span class="name">D(9³, 6)</span>.', html)

    def test_names_speeds_that_are_not_steady(self):
        self.assertIn('Not steady: <span class="name">G(11)</span>.', page([cell("G(11)", 100, 1, speed={"steady": False})]))

    def test_reports_what_a_search_predicted(self):
        def predicted(*words):
            return page([cell(form, 400, median, volume={"words": words[i]}, predicted={"words": 100, "mrays_per_s": median * 1.1})
                         for i, (form, median) in enumerate([("G(11)", 1), ("S(11)", 2)])])
        html = predicted(100, 100)
        self.assertIn("2 speeds: median error 10.0 %, rank correlation 1.00.", html)
        self.assertIn("All 2 sizes are as predicted, to the word.", html)
        self.assertIn("the others are off by 3 words at most.", predicted(100, 103))

    def test_tells_the_bytes_of_each_level_of_a_leader(self):
        self.assertIn("<small>R(4³) 96.0 B · G(7) 3.91 KiB</small>",
                      page([cell("R(4^3) G(7)", 4096, 1, volume={"level_words": [24, 1000]})]))
        self.assertNotIn('levels-bar"', page([cell("R(4^3) G(7)", 4096, 1, volume={"level_words": [24]})]))

    def test_links_to_its_figures(self):
        self.assertNotIn(".csv", page([cell("G(11)", 100, 1)]))
        self.assertIn('<a href="./a%20b.csv">a b.csv</a>', page([cell("G(11)", 100, 1)], "a b.csv"))

    def test_paints_no_memory_that_is_about_the_same(self):
        def built(*peaks):
            return page([cell(form, 100, 1, build={"peak_rss_bytes": peak * MEBI}) for form, peak in zip(("G(11)", "S(11)"), peaks)])
        self.assertIn("all of 2 formats need about the same, 169 MiB to 174 MiB.", built(169, 174))
        self.assertIn('class="bar worse"', built(169, 400))

    def test_rings_points_with_errors(self):
        self.assertNotIn('class="ring"', page([cell("G(11)", 100, 1)]))
        self.assertIn('class="ring"', page([cell("G(11)", 100, 1, error={"wrong": 1})]))

    def test_escapes_what_records_say(self):
        evil = "<script>alert(1)</script>\"'{{style}}"
        said = {"model": {"name": evil}, "precision": evil, "device": {"name": evil, "kind": evil, "driver": evil},
                "rays": {"name": evil}, "format": {"label": evil},
                "made_by": {"voxc": evil, "llvm": evil, "processor": evil, "command": evil}}
        failed = failure(evil, evil, **{**said, "rays": {"name": evil + "2"}})
        failed["failure"]["stage"] = evil
        html = page([cell(evil, 100, 1, [evil], **said), cell(evil, 100, 1, **said), failed], notes={evil: evil})
        self.assertEqual((html.count("<script>"), html.count("</script>")), (1, 1))
        self.assertIn("&lt;script&gt;alert(1)", html)
        self.assertNotIn("<script>alert", html)

    def test_takes_whatever_text_may_hold(self):
        name = "a\x00\x1b\u2028\n日本 \U0001f600 \ufffe"
        html = page([cell(name, 100, 1), cell("G(11)", 200, 2, [name])])
        self.assertIn("日本 \U0001f600", html)

    def test_loads_nothing(self):
        html = page([cell("G(11)", 100, 1)])
        for word in ("http:", "https:", "@import", "url(", "<link", "src="):
            self.assertNotIn(word, html)
        self.assertIn("default-src 'none'", html)


class Csv(unittest.TestCase):
    def test_has_a_line_for_each_cell(self):
        csv = to_csv(make_catalogue([cell("R(4^3) G(7)", 100, 0.1, ["a", "b"]), failure("G(99)", 'say "no"\nor yes')]))
        self.assertTrue(csv.startswith("model,input,resolution,"))
        self.assertIn('\r\nhut,,2048,front,100,auto,,llvmpipe,cpu,exact,R(4^3) G(7),"a, b",,measured,on,100,', csv)
        self.assertIn(",0.1,0.099,0.101,", csv)
        self.assertIn(",failed,,,", csv)
        self.assertIn(',"say ""no""\nor yes",', csv)


class Pictures(unittest.TestCase):
    def setUp(self):
        self.folder = self.enterContext(tempfile.TemporaryDirectory())

    def write(self, name="a.png"):
        path = Path(self.folder) / name
        Image.new("RGB", (32, 16), "#804020").save(path)
        return str(path)

    def test_lie_in_the_page_within_a_bound(self):
        path = self.write()
        self.assertTrue(thumbnail(path, 90_000).startswith("data:image/jpeg;base64,/9j/"))
        self.assertRaises(Problem, thumbnail, path, 100)
        self.assertRaises(Problem, thumbnail, path + "none", 90_000)

    def test_that_cannot_be_read_are_noted(self):
        path = Path(self.folder) / "b.png"
        path.write_text("no picture")
        pictures, notes = load_pictures(make_entries([cell("G(11)", 1, 1, model={"picture": str(path)})]), 500_000)
        self.assertEqual((pictures, len(notes)), ({}, 1))
        pictures, notes = load_pictures(make_entries([cell("G(11)", 1, 1, model={"picture": self.write()})]), 500_000)
        self.assertEqual((list(pictures), notes), (["hut"], []))
