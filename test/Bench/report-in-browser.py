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
TIP = "document.getElementById('tip')"
TABLE = "document.querySelector('table.sortable')"
ROWS = f"[...{TABLE}.tBodies[0].rows]"


def make_report(voxc, folder):
    subprocess.run([sys.executable, HERE / "make-records.py", folder], check=True)
    subprocess.run([voxc, "bench", "report", folder, "--quiet"], check=True)
    return [json.loads(line) for line in (folder / "records.jsonl").read_text().splitlines()]


def is_drawn(record):
    """Formats with the passes that most have; those with float steps are a chart of their own."""
    return record["status"] == "measured" and record["format"]["passes"] == ["whole-level-dedup"]


def point(name, index=0):
    """A point by the name in its figures."""
    return f"[...document.querySelectorAll('.point')].filter(p => p.getAttribute('aria-label').startsWith('{name};'))[{index}]"


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
        self.assertEqual(self.browser.evaluate("document.querySelectorAll('.point').length"), sum(map(is_drawn, self.records)))
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
        same = self.browser.evaluate("[...document.querySelectorAll('.point.same')].map(p => p.getAttribute('aria-label').split(';')[0])")
        self.assertEqual(same, 4 * ["R(3³) G(8)"])
        self.browser.point_at("document.querySelector('h1')")
        self.assertFalse(self.is_shown(TIP))

    def test_every_point_tells_its_own_name(self):
        labels = self.browser.evaluate("[...document.querySelectorAll('.point')].map(p => [p.getAttribute('aria-label').split(';')[0], "
                                       "document.querySelector(p.getAttribute('href')).cells[0].textContent])")
        for label, name in labels:
            self.assertEqual(label, name)

    def test_tabbing_tells_them_too_and_return_leads_to_the_row(self):
        self.browser.evaluate(f"{point('G(11)')}.previousElementSibling.focus()")
        self.browser.press("Tab")
        self.assertTrue(self.is_shown(TIP))
        self.assertEqual(self.browser.evaluate(f"{TIP}.firstChild.textContent"), "G(11)")
        self.browser.press("Escape")
        self.assertFalse(self.is_shown(TIP))
        self.browser.evaluate("document.activeElement.dispatchEvent(new MouseEvent('click', {bubbles: true}))")
        self.browser.settle()
        self.assertEqual(self.browser.evaluate("document.querySelector('tr:target').cells[0].textContent"), "G(11)")

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
        self.browser.settle()
        self.assertEqual(set(self.column("Model")), {"tangle"})
        self.assertEqual(set(self.column("Device")), {"llvmpipe"})
        hidden = f"{ROWS}.findIndex(row => row.hidden)"
        self.browser.evaluate(f"location.hash = {ROWS}[{hidden}].id")
        self.browser.settle()
        self.assertTrue(self.is_shown("document.querySelector('tr:target')"))

    def test_fits_a_phone(self):
        self.browser.resize(390, 844)
        self.browser.open(self.page)
        self.assertEqual(self.browser.evaluate("document.documentElement.scrollWidth"), 390)
        labels = "document.querySelector('.chart .{} text')"
        self.assertTrue(self.is_shown(labels.format("narrow")))
        self.assertFalse(self.is_shown(labels.format("wide")))

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
