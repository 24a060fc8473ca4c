#!/usr/bin/env python3
"""The report of made-up records in a real browser: report-in-browser.py VOXC"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from browser import Browser

HERE = Path(__file__).parent
# A chart is drawn for several widths; this one is shown on wide screens.
POINTS = "[...document.querySelectorAll('.wide .point')]"
TIP = "document.getElementById('tip')"
TABLE = "document.querySelector('table.sortable')"
ROWS = f"[...{TABLE}.tBodies[0].rows]"


def make_report(voxc, folder):
    subprocess.run([sys.executable, HERE / "make-records.py", folder], check=True)
    subprocess.run([voxc, "bench", "report", folder, "--quiet"], check=True)
    return [json.loads(line) for line in (folder / "records.jsonl").read_text().splitlines()]


def is_drawn(record):
    return record["status"] == "measured"


def point(name, index=0):
    """A point by the name in its figures."""
    return f"{POINTS}.filter(p => p.getAttribute('aria-label').startsWith('{name};'))[{index}]"


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.records = make_report(VOXC, Path(cls.folder.name))
        cls.page = Path(cls.folder.name) / "report.html"

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        self.browser = self.enterContext(Browser())
        self.browser.open(self.page)

    def tearDown(self):
        self.assertEqual(self.browser.errors, [])

    def is_shown(self, expression):
        return self.browser.evaluate(f"{expression}.getBoundingClientRect().width > 0")

    def column(self, heading):
        place = f"[...{TABLE}.tHead.rows[0].cells].findIndex(cell => cell.textContent === '{heading}')"
        return self.browser.evaluate(f"{ROWS}.filter(row => !row.hidden).map(row => row.cells[{place}].textContent)")

    def click_heading(self, heading):
        self.browser.click(f"[...{TABLE}.querySelectorAll('button')].find(button => button.textContent === '{heading}')")

    def test_has_a_point_for_each_speed(self):
        self.assertEqual(self.browser.evaluate(f"{POINTS}.length"), sum(map(is_drawn, self.records)))
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.narrow .point').length"), sum(map(is_drawn, self.records)))
        self.assertEqual(self.browser.evaluate(f"{ROWS}.length"), len(self.records))
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.portrait').length"), 2)

    def test_pointing_tells_the_figures(self):
        self.assertFalse(self.is_shown(TIP))
        self.browser.point_at(point("R(3³) G(8)"))
        self.assertTrue(self.is_shown(TIP))
        lines = self.browser.evaluate(f"[...{TIP}.children].map(line => line.textContent)")
        self.assertEqual(lines[0], "R(3³) G(8)")
        self.assertRegex(lines[1], r"^[0-9.]+ [KMG]iB, [0-9.]+ bytes a voxel$")
        self.assertRegex(lines[2], r"^[0-9.]+ Mrays/CPU s, spread [0-9.]+ %")
        self.assertEqual(lines[3], "missed 0, ghost 0, wrong 0 of 20,000 rays")
        same = self.browser.evaluate(f"{POINTS}.filter(p => p.matches('.same')).map(p => p.getAttribute('aria-label').split(';')[0])")
        self.assertEqual(same, 4 * ["R(3³) G(8)"])
        self.assertRegex(lines[5], r"^(On the frontier|As good as .*|Beaten by .*, ([0-9.]+× )?as fast at .* size)$")
        self.browser.point_at("document.querySelector('h1')")
        self.assertFalse(self.is_shown(TIP))

    def test_pointing_near_tells_the_nearest(self):
        chart = "document.querySelector('.chart.wide')"
        middle = self.browser.evaluate(f"""(() => {{ {chart}.scrollIntoView({{block: "center", behavior: "instant"}});
            return [...{chart}.querySelectorAll('.point')].map(p => {{ const b = p.querySelector('use').getBoundingClientRect();
              return [p.getAttribute('aria-label').split(';')[0], b.left + b.width / 2, b.top + b.height / 2]; }}) }})()""")
        name, x, y = middle[0]
        x, y = x + 9, y + 11
        nearest = min(middle, key=lambda point: (point[1] - x) ** 2 + (point[2] - y) ** 2)[0]
        self.browser.wait_until_still()
        self.browser.call("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        self.browser.wait_until_still()
        self.assertEqual(self.browser.evaluate(f"{TIP}.firstChild.textContent"), nearest)

    def test_spreads_and_names_of_other_passes_are_drawn(self):
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.wide .point .rounds').length"), sum(map(is_drawn, self.records)))
        names = self.browser.evaluate(f"{POINTS}.map(p => p.getAttribute('aria-label').split(';')[0])")
        self.assertIn("S(11) +restart-sv", names)
        self.assertIn("R(4³) G(7) −whole-level-dedup", names)

    def test_neighbours_have_the_same_axes(self):
        axes = self.browser.evaluate("""[...document.querySelectorAll('.model:first-child .chart.wide')]
            .map(chart => [...chart.querySelectorAll('.tick')].map(tick => tick.textContent).join(' '))""")
        self.assertEqual(len(axes), 3)
        self.assertEqual(len(set(axes)), 1)

    def test_begins_with_answers_and_commands(self):
        self.assertEqual(self.browser.evaluate("document.querySelector('.verdict dt').textContent"), "Smallest")
        self.assertTrue(self.browser.evaluate("document.querySelector('.verdict').getBoundingClientRect().top < innerHeight"))
        self.assertRegex(self.browser.evaluate("document.querySelector('.verdict code').textContent"),
                         r"^voxc build '.*' pagoda.obj --whole-level-dedup( --[a-z-]+)* -o pagoda.hvx$")
        self.assertEqual(self.browser.evaluate("document.querySelector('#cells a').getAttribute('href')"), "./report.csv")

    def test_every_point_tells_its_own_name(self):
        labels = self.browser.evaluate("[...document.querySelectorAll('.point')].map(p => [p.getAttribute('aria-label').split(';')[0], "
                                       "document.querySelector(p.getAttribute('href')).cells[0].textContent])")
        for label, name in labels:
            self.assertTrue(label == name or label.startswith(name + " +") or label.startswith(name + " −"), (label, name))

    def test_the_arrows_go_from_point_to_point_and_return_leads_to_the_row(self):
        self.assertEqual(self.browser.evaluate("[...document.querySelectorAll('.chart')].every(c => c.querySelectorAll('[tabindex=\"0\"]').length === 1)"), True)
        self.browser.evaluate("document.querySelector('summary').focus()")
        while not self.browser.evaluate("document.activeElement.matches('.point')"):
            self.browser.press("Tab")
        first = self.browser.evaluate(f"{TIP}.firstChild.textContent")
        self.browser.press("ArrowRight")
        self.assertTrue(self.is_shown(TIP))
        second = self.browser.evaluate(f"{TIP}.firstChild.textContent")
        self.assertNotEqual(first, second)
        self.browser.press("Escape")
        self.assertFalse(self.is_shown(TIP))
        self.browser.evaluate("document.activeElement.dispatchEvent(new MouseEvent('click', {bubbles: true, cancelable: true}))")
        self.browser.wait_until_still()
        row = self.browser.evaluate("document.querySelector('tr:target').cells[0].textContent")
        self.assertTrue(second.startswith(row), (second, row))

    def test_the_table_sorts(self):
        self.click_heading("Size, MiB")
        sizes = [float(text) for text in self.column("Size, MiB") if text]
        self.assertEqual(sizes, sorted(sizes))
        self.assertEqual(self.column("Size, MiB")[-2:], ["", ""])
        self.click_heading("Size, MiB")
        self.assertEqual([float(text) for text in self.column("Size, MiB") if text], sorted(sizes, reverse=True))
        self.assertEqual(self.column("Size, MiB")[-2:], ["", ""])
        self.click_heading("Model")
        models = self.column("Model")
        self.assertEqual(models, sorted(models))
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('[aria-sort]').length"), 1)

    def test_rows_are_found(self):
        self.browser.click("document.querySelector('.finder input')")
        self.browser.call("Input.insertText", text="tangle  LLVMpipe")
        self.browser.wait_until_still()
        self.assertEqual(set(self.column("Model")), {"tangle"})
        self.assertEqual(set(self.column("Device")), {"llvmpipe"})
        hidden = f"{ROWS}.findIndex(row => row.hidden)"
        self.browser.evaluate(f"location.hash = {ROWS}[{hidden}].id")
        self.browser.wait_until_still()
        self.assertTrue(self.is_shown("document.querySelector('tr:target')"))

    def test_fits_a_phone(self):
        self.browser.resize(390, 844)
        self.browser.open(self.page)
        self.assertEqual(self.browser.evaluate("document.documentElement.scrollWidth"), 390)
        chart = "document.querySelector('.chart.{}')"
        self.assertTrue(self.is_shown(chart.format("narrow")))
        self.assertFalse(self.is_shown(chart.format("wide")))
        # What is told of a point is told of it in each drawing.
        self.browser.point_at("document.querySelector('.narrow .point.on')")
        self.assertTrue(self.is_shown(TIP))
        self.assertRegex(self.browser.evaluate(f"{TIP}.textContent"), "Mrays/CPU s")

    def test_is_light_and_dark(self):
        colours = set()
        for scheme in ("light", "dark"):
            self.browser.prefer(scheme)
            colours.add(self.browser.evaluate("getComputedStyle(document.body).backgroundColor"))
        self.assertEqual(len(colours), 2)

    def test_is_whole_without_javascript(self):
        self.browser.call("Emulation.setScriptExecutionDisabled", value=True)
        self.browser.open(self.page)
        self.assertIn("Mrays/CPU s", self.browser.evaluate("document.querySelector('.point title').textContent"))
        self.assertTrue(self.is_shown(TABLE))
        self.assertEqual(self.browser.evaluate(f"{ROWS}.length"), len(self.records))


if __name__ == "__main__":
    VOXC = sys.argv.pop(1)
    unittest.main()
