"""Answers to the questions of a reader, the commands that build them, and how well predictions came true."""
import unittest

from cells import DEDUP, MEBI, cell, failure
from voxc_report.build_command import build_command
from voxc_report.catalogue import make_catalogue
from voxc_report.predictions import median_error, predictions_of, rank_correlation, word_predictions_of
from voxc_report.questions import questions_of


def told(*records):
    """"Smallest: G(11)", "Fastest: R(9³) = D(9³, 6)", of all stages."""
    lines = []
    for question in questions_of(make_catalogue(records).stages):
        answers = [" = ".join([answer.entry.name, *(rival.name for rival in answer.as_fast)]) for answer in question.answers]
        lines.append(" ".join([question.text + ":", *answers]))
    return lines


class Verdict(unittest.TestCase):
    def test_asks_what_has_different_answers(self):
        self.assertEqual(told(cell("S(11)", 5 * MEBI, 1), cell("G(11)", 12 * MEBI, 2), cell("R(4^3) G(7)", 60 * MEBI, 3),
                              cell("R(9^3)", 70 * MEBI, 4)),
                         ["Smallest: S(11)", "Best below 16 MiB: G(11)", "Best below 64 MiB: R(4³) G(7)", "Fastest: R(9³)"])
        self.assertEqual(told(cell("S(11)", 5 * MEBI, 1), cell("G(11)", 12 * MEBI, 0.5)), ["Smallest and fastest: S(11)"])
        self.assertEqual(told(failure("S(11)", "no")), [])

    def test_asks_for_three_budgets_at_most(self):
        cells = [cell("R(1^3) G(10)", MEBI << i, i + 1, [f"short-pointers={i + 9}"]) for i in range(9)]
        self.assertEqual(len(told(*cells)), 5)

    def test_tells_what_is_as_fast_fastest_first(self):
        self.assertEqual(told(cell("G(11)", MEBI, 1), cell("S(11)", 9 * MEBI, 0.99), cell("R(9^3)", 8 * MEBI, 1.01)),
                         ["Smallest and fastest: G(11) = R(9³) = S(11)"])

    def test_makes_no_two_answers_of_one_by_chance(self):
        """What leads on one device by chance gives way to what leads on the other, if it is as good there."""
        other = {"device": {"name": "cpu"}}
        self.assertEqual(told(cell("G(11)", MEBI, 1.01), cell("S(11)", MEBI, 1), cell("G(11)", MEBI, 2, **other),
                              cell("S(11)", MEBI, 2.01, **other)),
                         ["Smallest and fastest: G(11) = S(11) G(11) = S(11)"])


def built(given, command=""):
    """The command that builds a cell of a model, by the command that measured it."""
    return build_command(cell("R(4^3) G(7)", 1, 1, [*DEDUP, "short-pointers=20"], model={"input": given},
                              made_by={"command": command}))


class BuildCommand(unittest.TestCase):
    def test_names_the_input_and_its_passes(self):
        self.assertEqual(built("hut.obj"), "voxc build 'R(4^3) G(7)' hut.obj --whole-level-dedup --short-pointers=20 -o hut.hvx")
        self.assertIn(" builtin:terrain:64 --whole", built("builtin:terrain:64", "voxc bench builtin:terrain:64 --formats 'G(6)'"))

    def test_takes_the_options_of_the_input(self):
        self.assertEqual(built("a b.ply", "voxc bench 'hut=dir/a b.ply --up z --bounds -1,0,0,1,1,1' other.ply --crop --up y "
                               "--check 9 --resolution 512 -o r"),
                         "voxc build 'R(4^3) G(7)' 'dir/a b.ply' --crop --resolution=512 --up=z --bounds=-1,0,0,1,1,1 "
                         "--whole-level-dedup --short-pointers=20 -o hut.hvx")
        self.assertIn(" x.nii --window=1,9 --whole", built("x.nii", "voxc search x.nii --window 1 --window 9 --budget 180s"))

    def test_quotes_what_a_shell_would_take_for_more(self):
        self.assertIn(" 'a'\\'';rm -r x' ", built("a';rm -r x"))
        self.assertIn(" ./-x.obj ", built("-x.obj"))


def predicted(*speeds):
    """The stage of cells of which each was predicted so fast and is so fast."""
    return make_catalogue([cell("G(11)", 100 + i, measured, predicted={"mrays_per_s": expected})
                           for i, (expected, measured) in enumerate(speeds)]).stages[0]


class Predictions(unittest.TestCase):
    def order(self, *speeds):
        return rank_correlation(predictions_of(predicted(*speeds)))

    def test_have_the_median_error(self):
        self.assertEqual(median_error(predictions_of(predicted((1.5, 1), (1, 1), (3, 4)))), 0.25)
        self.assertEqual(median_error(predictions_of(predicted((1.5, 1), (3, 4)))), 0.375)
        self.assertEqual(median_error([]), 0)

    def test_have_spearmans_correlation(self):
        self.assertAlmostEqual(self.order((1, 10), (2, 11), (9, 50)), 1)
        self.assertAlmostEqual(self.order((1, 3), (2, 2), (3, 1)), -1)
        self.assertAlmostEqual(self.order((1, 1), (2, 3), (3, 2), (4, 4)), 0.8)
        # Equal ones share their mean rank: (1, 2.5, 2.5, 4) with (1, 2, 3, 4).
        self.assertAlmostEqual(self.order((1, 1), (2, 2), (2, 3), (4, 4)), 4.5 / (4.5 * 5) ** 0.5)
        self.assertIsNone(self.order((1, 1), (1, 2)))

    def test_compare_words(self):
        cells = [cell("G(11)", 1, 1, volume={"words": 7}, predicted={"words": 7}),
                 cell("G(11)", 1, 1, volume={"words": 10}, predicted={"words": 12}), cell("G(11)", 1, 1, predicted={"words": 1})]
        self.assertEqual(word_predictions_of(make_catalogue(cells).stages[0]), (2, 1, 2))
