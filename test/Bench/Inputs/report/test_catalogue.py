"""Which cells compete with which, how they stand, and pairs of cells that differ in one thing."""
import random
import unittest

from cells import BOTH, DEDUP, cell, failure, speed
from voxc_report.catalogue import make_catalogue
from voxc_report.devices import device_names
from voxc_report.formats import FAMILIES, look_of
from voxc_report.frontier import Place, standings
from voxc_report.pairs import pairs_by_pass, pairs_by_precision
from voxc_report.passes import pass_difference, common_passes
from voxc_report.speeds import Speed


def point(size, median, spread=0.02):
    return size, Speed(**speed(median, spread))


def places(*points):
    """A letter a point: L leads, = is as good, . is beaten."""
    letters = {Place.LEADING: "L", Place.AS_GOOD: "=", Place.BEATEN: "."}
    return "".join(letters[standing.place] for standing in standings(points))


def beats(a, b):
    return a[0] <= b[0] and a[1] >= b[1] and a != b


class Formats(unittest.TestCase):
    def test_have_one_name_for_all_spellings(self):
        for text, name in [("R(4^3) G(7)", "R(4³) G(7)"), ("R(4,4,4)G(7)", "R(4³) G(7)"), ("D(4^3, 6) S(7)", "D(4³, 6) S(7)"),
                           ("R(4, 3, 4)", "R(4, 3, 4)"), ("G(7, 1)", "G(7)"), ("G(6, 2)", "G(6, 2)"), ("M(2 ^ 3)", "M(2³)")]:
            self.assertEqual(look_of(text).name, name)

    def test_are_of_families(self):
        for text, family in [("R(4^3) S(3) G(4)", "R over a DAG (G)"), ("R(4^3) S(7)", "R over an octree (S)"),
                             ("D(4^3, 6) R(3^3) G(4)", "D over a tree"), ("D(6^3, 6) S(5)", "D over a tree"),
                             ("S(5) G(6)", "trees alone"), ("D(5^3, 6) R(4^3)", "grids alone"), ("S(5) R(4^3)", "others")]:
            self.assertEqual(FAMILIES[look_of(text).family][0], family)

    def test_keep_what_is_none(self):
        for text in ("<script>", "", "R", "R(4)", "G()", "S(1, 1)", "Q(3)", "R(4^3) ?"):
            self.assertEqual(look_of(text).name, text)
            self.assertEqual(FAMILIES[look_of(text).family][0], "others")


class Frontier(unittest.TestCase):
    def test_is_its_definition(self):
        chance = random.Random(7)
        for _ in range(200):
            points = [(1 + chance.randrange(5), 1 + chance.randrange(5)) for _ in range(chance.randrange(12))]
            found = standings([point(size, median, 0) for size, median in points])
            for one, standing in zip(points, found):
                self.assertEqual(standing.place is not Place.BEATEN, not any(beats(other, one) for other in points))

    def test_follows_the_medians_where_rounds_agree(self):
        self.assertEqual(places(), "")
        self.assertEqual(places(point(3, 3), point(1, 1), point(2, 0.5), point(2, 2)), "LL.L")
        self.assertEqual(standings([point(1, 2), point(5, 1)])[1].rival, 0)

    def test_does_not_lead_by_less_than_the_rounds_differ(self):
        self.assertEqual(places(point(100, 4.53), point(500, 4.55)), "L.")
        self.assertEqual(places(point(100, 4.53), point(500, 4.7)), "LL")

    def test_is_as_good_at_hardly_more_bytes(self):
        leader = point(1000, 6, 0.04)
        for size, median, expected in [(1000, 5.9, "L="), (1010, 6.1, "L="), (1011, 6.1, "L."), (1000, 4.5, "L.")]:
            self.assertEqual(places(leader, point(size, median, 0.01)), expected)

    def test_reaches_the_fastest_through_a_chain_of_equal_ones(self):
        self.assertEqual(places(*(point(*one, 0.1) for one in [(10, 1), (20, 1.08), (40, 1.16), (80, 1.22)])), "L.L.")


class Catalogue(unittest.TestCase):
    def test_has_a_stage_for_each_model_device_resolution_and_precision(self):
        catalogue = make_catalogue([cell("R(4^3) G(7)", 100, 1, **changes) for changes in (
            {}, {"model": {"name": "tower"}}, {"device": {"name": "cpu"}}, {"resolution": 512}, {"precision": "fast"})])
        self.assertEqual(len(catalogue.stages), 5)
        self.assertEqual(catalogue.models, ["hut", "tower"])
        self.assertEqual(catalogue.formats, 1)
        self.assertEqual([stage.resolution for stage in catalogue.stages[:4]], [2048, 2048, 2048, 512])

    def test_tells_models_of_one_name_apart(self):
        catalogue = make_catalogue([cell("G(11)", size, 1, model={"digest": digest}, resolution=side)
                                    for digest, side, size in (("a", 512, 9), ("b", 512, 8), ("c", 256, 4), ("a", 512, 7))])
        self.assertEqual([entry.model for entry in catalogue.entries], ["hut", "hut (2)", "hut", "hut"])
        self.assertEqual(sorted(len(stage.entries) for stage in catalogue.stages), [1, 1, 2])

    def test_compares_all_measured_passes(self):
        catalogue = make_catalogue([cell("R(4^3) G(7)", 100, 1), cell("R(4^3) G(7)", 50, 1, DEDUP), cell("G(11)", 40, 0.5, DEDUP),
                                    cell("G(11)", 40, 5, BOTH)])
        [stage] = catalogue.stages
        self.assertTrue(stage.has_other_passes)
        self.assertEqual(stage.common_passes, DEDUP)
        self.assertEqual([entry.standing.rival for entry in catalogue.entries], [3, 3, 3, 3])
        self.assertEqual([entry.is_leading for entry in catalogue.entries], [False, False, False, True])

    def test_names_say_the_passes_that_differ_from_most(self):
        entries = make_catalogue([cell("G(11)", 40, 1, DEDUP), cell("G(11)", 40, 1, BOTH), cell("G(11)", 90, 1),
                                  cell("G(11)", 40, 1, BOTH[::-1]), cell("G(9)", 4, 1, resolution=512)]).entries
        self.assertEqual([entry.name for entry in entries], ["G(11)", "G(11) +restart-sv", "G(11) −whole-level-dedup",
                                                             "G(11) +restart-sv", "G(9)"])
        self.assertEqual(entries[1].variant, entries[3].variant)
        self.assertNotEqual(entries[0].variant, entries[1].variant)

    def test_common_passes_are_those_of_more_than_half(self):
        self.assertEqual(common_passes([DEDUP, []]), [])
        self.assertEqual(common_passes([DEDUP, BOTH, []]), DEDUP)
        self.assertEqual(pass_difference(["short-pointers=9"], DEDUP), " +short-pointers=9 −whole-level-dedup")
        self.assertEqual(pass_difference(BOTH[::-1], BOTH), "")

    def test_names_the_rays_where_a_model_has_several(self):
        catalogue = make_catalogue([cell("G(11)", 100, 1), cell("G(11)", 100, 1, rays={"name": "back"}),
                                    cell("G(11)", 100, 1, model={"name": "tower"})])
        self.assertEqual(catalogue.columns, ["hut, front", "hut, back", "tower"])

    def test_draws_no_figures_that_make_no_sense(self):
        catalogue = make_catalogue([cell("G(11)", 0, 1), cell("G(11)", 1, -1), cell("G(11)", 1, 1e308), cell("G(11)", 1, 5e-324),
                                    failure("G(11)", "no")])
        self.assertFalse(any(entry.has_point for entry in catalogue.entries))

    def test_puts_rounds_in_order(self):
        rounds = {"mrays_per_cpu_s": {"min": -3, "median": 2, "max": 1e300, "spread": 0.1}}
        [entry] = make_catalogue([cell("G(11)", 1, 2, speed=rounds)]).entries
        self.assertEqual(entry.speed.min, 0)
        self.assertLessEqual(entry.speed.max, 1e12)

    def test_devices_have_names_as_short_as_tells_them_apart(self):
        def names(**changes):
            return device_names([cell("G(11)", 1, 1), cell("G(11)", 1, 1, **changes)])
        self.assertEqual(names(device={"name": "cpu"}), ["llvmpipe", "cpu"])
        self.assertEqual(names(device={"name": "llvmpipe (other)"}), ["llvmpipe (LLVM)", "llvmpipe (other)"])
        self.assertEqual(names(), ["llvmpipe", "llvmpipe"])
        self.assertEqual(names(made_by={"processor": "another"}),
                         ["llvmpipe (LLVM), 2 threads", "llvmpipe (LLVM), 2 threads, another"])


class Pairs(unittest.TestCase):
    def test_are_of_cells_that_differ_in_a_pass_alone(self):
        catalogue = make_catalogue([cell("G(11)", 300, 1), cell("G(11)", 100, 2, DEDUP), cell("G(11)", 100, 3, BOTH),
                                    cell("S(11)", 7, 1), cell("S(11)", 7, 1, DEDUP, model={"name": "tower"})])
        [dedup] = pairs_by_pass(catalogue, "whole-level-dedup")
        self.assertEqual(dedup.shrinkage, 3)
        [restart] = pairs_by_pass(catalogue, "restart-sv")
        self.assertEqual(restart.speed_up, 1.5)
        self.assertFalse(restart.is_as_fast)

    def test_are_as_fast_within_the_wider_spread(self):
        for spread, expected in [(0.02, False), (0.06, True)]:
            exact = cell("G(11)", 1, 1, speed={"mrays_per_cpu_s": speed(1, spread)})
            [pair] = pairs_by_precision(make_catalogue([exact, cell("G(11)", 1, 1.05, precision="fast")]))
            self.assertEqual(pair.is_as_fast, expected)

    def test_are_not_of_cells_that_failed(self):
        catalogue = make_catalogue([failure("G(11)", "no"), cell("G(11)", 1, 1, DEDUP)])
        self.assertEqual(pairs_by_pass(catalogue, "whole-level-dedup"), [])
