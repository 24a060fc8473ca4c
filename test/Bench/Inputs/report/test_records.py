"""Reading records and verdicts, whoever wrote them."""
import copy
import json
import tempfile
import unittest
from pathlib import Path

from cells import KIBI, cell
from voxc_report.catalogue import make_catalogue
from voxc_report.csv_table import to_csv
from voxc_report.page import make_page
from voxc_report.problems import Problem
from voxc_report.records import parse_record, read_folders
from voxc_report.searches import read_verdicts


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory()))

    def write(self, *records, name="results.jsonl"):
        path = self.folder / name
        path.parent.mkdir(exist_ok=True)
        path.write_text("".join(json.dumps(record) + "\n" for record in records))
        return str(path.parent)


class Records(Folder):
    def test_of_later_folders_count(self):
        first = self.write(cell("G(11)", 100, 1), cell("S(11)", 7, 1))
        later = self.write({**cell("G(11)", 100, 1), "volume": {"bytes": 50}}, name="later/results.jsonl")
        self.assertEqual([record["volume"]["bytes"] for record in read_folders([first, later])], [50, 7])
        self.assertEqual([record["volume"]["bytes"] for record in read_folders([later, first])], [100, 7])
        self.assertRaisesRegex(Problem, "folder .*none' cannot be read", read_folders, [first + "/none"])

    def test_that_were_cut_short_are_left_out(self):
        folder = self.write(cell("G(11)", 100, 1))
        with open(self.folder / "results.jsonl", "a") as file:
            file.write('{"schema": 1, "cel')
        self.assertEqual(len(read_folders([folder])), 1)

    def test_have_pictures_in_their_folder_alone(self):
        folder = self.write(*(cell("G(11)", 1, i + 1, model={"picture": path})
                              for i, path in enumerate(["pictures/a.png", "../a.png", "/a.png"])))
        self.assertEqual([record["model"].get("picture") for record in read_folders([folder])],
                         [f"{folder}/pictures/a.png", None, None])

    def test_are_refused_by_the_name_of_what_is_wrong(self):
        def refused(text, **changes):
            record = cell("G(11)", 100, 1)
            for place, value in changes.items():
                *sections, name = place.split("__")
                inner = record
                for section in sections:
                    inner = inner[section]
                inner[name] = value
            with self.assertRaisesRegex(Problem, text):
                parse_record(json.dumps(record))
        refused('should have "schema": 1', schema=2)
        refused('should have "schema": 1', schema=True)
        refused('"cell" has a value of another type', cell=1)
        refused('"cell" has a value of another type', cell="\ud800")
        refused('"model" should be an object', model=[])
        refused('"model.size" has a value', model__size=[1, 2])
        refused('"format.passes" has a value', format__passes=[1])
        refused('"rays.count" has a value', rays__count=-1)
        refused('"rays.count" has a value', rays__count=2**64)
        refused('"volume.bytes" has a value', volume__bytes=True)
        refused('"speed.mrays_per_cpu_s.median" has a value', speed__mrays_per_cpu_s__median="1")
        refused('"speed.mrays_per_cpu_s.max" is missing', speed__mrays_per_cpu_s={"min": 1, "median": 1})
        refused('"status" should be "measured"', status="failed")
        refused('"status" should be "failed"', failure={"stage": "build", "reason": ""})
        refused('"failure" should be an object', failure=None, status="failed")

    def test_are_json_objects(self):
        for line in (b"", b"[]", b"{", b"\xff\xff", b"[" * 100_000, b'{"schema": 1e999}'):
            self.assertRaises(Problem, parse_record, line)
        text = json.dumps(cell("G(11)", 100, 1))
        for number in ("NaN", "1e999", "9" * 400):
            self.assertRaisesRegex(Problem, "min", parse_record, text.replace('"min": 0.99', f'"min": {number}'))

    def test_may_lack_what_is_null(self):
        record = cell("G(11)", 100, 1, volume={"words": 3})
        record["volume"]["words"] = record["resolution"] = None
        self.assertNotIn("words", parse_record(json.dumps(record))["volume"])


class Verdicts(Folder):
    """A search of two formats, of which one was compared, on two sets of rays."""

    def setUp(self):
        super().setUp()
        self.records = [cell(form, size * KIBI, median, cell=f"{form} {rays}", rays={"name": rays, "digest": rays},
                             made_by={"command": "voxc search hut.obj"})
                        for form, size, speeds in (("G(11)", 10, (4, 1)), ("S(11)", 20, (8, 2)))
                        for rays, median in zip(("overview", "bounced"), speeds)]
        cells = [record["cell"] for record in self.records]
        self.verdict = {"formats": 2, "cells": cells, "compared": cells[:2],
                        "frontier": [{"name": "G(11) with flat-traversal", "size": "10.0 KiB", "speed": "1.60 M/s",
                                      "set_speeds": "4.00 M/s overview, 1.00 M/s bounced", "cells": cells[:2]}],
                        "answers": [{"question": "fastest", "format": 0, "as_fast": ["S(9)"]}]}

    def read(self, verdict):
        (self.folder / "verdict-0123.json").write_text(json.dumps(verdict))
        return read_verdicts([self.write(*self.records)], self.records)

    def test_stand_on_the_page_and_in_the_figures_as_they_are(self):
        verdicts, notes = self.read(self.verdict)
        catalogue = make_catalogue(self.records, verdicts)
        html, _ = make_page(catalogue, {}, "")
        self.assertEqual(notes, [])
        self.assertIn("<dt>Fastest</dt>", html)
        self.assertIn("<b>G(11) with flat-traversal</b>, 10.0 KiB at 1.60 M/s (4.00 M/s overview, 1.00 M/s bounced). As fast", html)
        self.assertNotIn("<h3>overview", html)
        # Formats whose times are of other moments are beaten.
        self.assertEqual([entry.is_leading for entry in catalogue.entries], [True, True, False, False])
        self.assertIn(",off,20480,", to_csv(catalogue))
        self.assertIn(",fastest\r\n", to_csv(catalogue))

    def test_of_nothing_that_was_measured_tell_nothing(self):
        verdicts, _ = self.read({**self.verdict, "compared": [], "frontier": [], "answers": []})
        self.assertNotIn('class="verdict"', make_page(make_catalogue(self.records, verdicts), {}, "")[0])

    def test_that_are_not_of_these_records_are_noted(self):
        wrong = [[], {}, {**self.verdict, "formats": "2"}, {**self.verdict, "answers": [{"question": "fastest", "format": 1, "as_fast": []}]}]
        stranger = copy.deepcopy(self.verdict)
        stranger["frontier"][0]["cells"] = ["another"]
        for verdict in [*wrong, stranger]:
            verdicts, notes = self.read(verdict)
            self.assertEqual((verdicts, len(notes)), ([], 1))
