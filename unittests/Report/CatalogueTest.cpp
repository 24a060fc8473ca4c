// Which cells compete with which, and pairs of cells that differ in one thing.
#include "MakeCell.h"

#include "report/Catalogue.h"
#include "report/DeviceNames.h"
#include "report/Pairs.h"

#include <gmock/gmock.h>

namespace voxc::report {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const std::vector<std::string> kDedup = {"whole-level-dedup"};
const std::vector<std::string> kBoth = {"whole-level-dedup", "restart-sv"};

TEST(Catalogue, HasAStageForEachModelDeviceResolutionAndPrecision) {
  std::vector<Cell> cells(5, makeCell("R(4^3) G(7)", 100, 1));
  cells[1].model.name = "tower";
  cells[2].device.name = "cpu";
  cells[3].resolution = 512;
  cells[4].precision = "fast";
  const Catalogue catalogue = makeCatalogue(cells);
  EXPECT_THAT(catalogue.stages, SizeIs(5));
  EXPECT_THAT(catalogue.models, ElementsAre("hut", "tower"));
  EXPECT_EQ(catalogue.formats, 1u);
  EXPECT_EQ(catalogue.stages[0].resolution, 2048);
  EXPECT_EQ(catalogue.stages[3].resolution, 512);
}

TEST(Catalogue, ComparesAllMeasuredPasses) {
  const std::vector<Cell> cells = {makeCell("R(4^3) G(7)", 100, 1), makeCell("R(4^3) G(7)", 50, 1, kDedup),
                                   makeCell("G(11)", 40, 0.5, kDedup), makeCell("G(11)", 40, 5, kBoth)};
  const Catalogue catalogue = makeCatalogue(cells);
  ASSERT_THAT(catalogue.stages, SizeIs(1));
  EXPECT_THAT(catalogue.stages[0].entries, ElementsAre(0, 1, 2, 3));
  EXPECT_TRUE(catalogue.stages[0].hasOtherPasses);
  EXPECT_THAT(catalogue.stages[0].usualPasses, ElementsAre("whole-level-dedup"));
  EXPECT_TRUE(catalogue.entries[3].isLeading());
  for (const std::size_t beaten : {0u, 1u, 2u}) {
    EXPECT_EQ(catalogue.entries[beaten].standing.place, Place::Beaten);
    EXPECT_EQ(catalogue.entries[beaten].standing.rival, 3u);
  }
}

TEST(Catalogue, NamesSayThePassesThatDifferFromMost) {
  std::vector<Cell> cells = {makeCell("G(11)", 40, 1, kDedup), makeCell("G(11)", 40, 1, kBoth),
                             makeCell("G(11)", 90, 1), makeCell("G(11)", 40, 1, {kBoth[1], kBoth[0]}),
                             makeCell("G(9)", 4, 1)};
  cells[4].resolution = 512;
  const Catalogue catalogue = makeCatalogue(cells);
  std::vector<std::string> names;
  for (const Entry &entry : catalogue.entries)
    names.push_back(entry.name);
  EXPECT_THAT(names, ElementsAre("G(11)", "G(11) +restart-sv", "G(11) −whole-level-dedup",
                                 "G(11) +restart-sv", "G(9)"));
  EXPECT_EQ(catalogue.entries[1].variant, catalogue.entries[3].variant);
  EXPECT_NE(catalogue.entries[0].variant, catalogue.entries[1].variant);
  EXPECT_EQ(catalogue.formats, 2u);
}

TEST(PassNames, AreThoseOfMoreThanHalf) {
  const Passes none, dedup = kDedup, both = kBoth;
  const std::vector<const Passes *> half = {&dedup, &none};
  EXPECT_THAT(usualPasses(half), IsEmpty());
  const std::vector<const Passes *> most = {&dedup, &both, &none};
  EXPECT_THAT(usualPasses(most), ElementsAre("whole-level-dedup"));
  EXPECT_EQ(passDifference({"short-pointers=9"}, dedup), " +short-pointers=9 −whole-level-dedup");
  EXPECT_EQ(passDifference({"restart-sv", "whole-level-dedup"}, both), "");
}

TEST(Catalogue, NamesTheRaysWhereAModelHasSeveral) {
  std::vector<Cell> cells(3, makeCell("G(11)", 100, 1));
  cells[1].rays.name = "back";
  cells[2].model.name = "tower";
  const Catalogue catalogue = makeCatalogue(cells);
  EXPECT_THAT(catalogue.columns, ElementsAre("hut, front", "hut, back", "tower"));
}

TEST(Catalogue, DrawsNoFiguresThatMakeNoSense) {
  std::vector<Cell> cells = {makeCell("G(11)", 0, 1), makeCell("G(11)", 1, -1), makeCell("G(11)", 1, 1e308),
                             makeCell("G(11)", 1, 5e-324), makeFailure("G(11)", "no")};
  const Catalogue catalogue = makeCatalogue(cells);
  for (const Entry &entry : catalogue.entries)
    EXPECT_FALSE(entry.hasPoint());
}

TEST(Catalogue, PutsRoundsInOrder) {
  std::vector<Cell> cells = {makeCell("G(11)", 1, 2)};
  cells[0].speed.mraysPerCpuS = tool::bench::Speed{-3, 2, 1e300, 0.1};
  const Catalogue catalogue = makeCatalogue(cells);
  ASSERT_TRUE(catalogue.entries[0].hasPoint());
  EXPECT_EQ(catalogue.entries[0].speed->min, 0);
  EXPECT_LE(catalogue.entries[0].speed->max, 1e12);
}

TEST(DeviceNames, AreAsShortAsTellsThemApart) {
  std::vector<Cell> cells(2, makeCell("G(11)", 1, 1));
  cells[1].device.name = "cpu";
  EXPECT_THAT(deviceNames(cells), ElementsAre("llvmpipe", "cpu"));
  cells[1].device.name = "llvmpipe (other)";
  EXPECT_THAT(deviceNames(cells), ElementsAre("llvmpipe (LLVM)", "llvmpipe (other)"));
  cells[1].device = cells[0].device;
  EXPECT_THAT(deviceNames(cells), ElementsAre("llvmpipe", "llvmpipe"));
  cells[1].madeBy.processor = "another";
  EXPECT_THAT(deviceNames(cells),
              ElementsAre("llvmpipe (LLVM), 2 threads", "llvmpipe (LLVM), 2 threads, another"));
}

TEST(Pairs, AreOfCellsThatDifferInAPassAlone) {
  std::vector<Cell> cells = {makeCell("G(11)", 300, 1), makeCell("G(11)", 100, 2, kDedup),
                             makeCell("G(11)", 100, 3, kBoth), makeCell("S(11)", 7, 1),
                             makeCell("S(11)", 7, 1, kDedup)};
  cells[4].model.name = "tower";
  const Catalogue catalogue = makeCatalogue(cells);
  const auto dedup = pairsByPass(catalogue, "whole-level-dedup");
  ASSERT_THAT(dedup, SizeIs(1));
  EXPECT_DOUBLE_EQ(shrinkage(dedup[0]), 3);
  const auto restart = pairsByPass(catalogue, "restart-sv");
  ASSERT_THAT(restart, SizeIs(1));
  EXPECT_DOUBLE_EQ(speedUp(restart[0]), 1.5);
  EXPECT_FALSE(isAsFast(restart[0]));
}

TEST(Pairs, AreAsFastWithinTheWiderSpread) {
  std::vector<Cell> cells = {makeCell("G(11)", 1, 1), makeCell("G(11)", 1, 1.05)};
  cells[1].precision = "fast";
  const auto isEqual = [&] { return isAsFast(pairsByPrecision(makeCatalogue(cells)).at(0)); };
  EXPECT_FALSE(isEqual());
  cells[0].speed.mraysPerCpuS = makeSpeed(1, 0.06);
  EXPECT_TRUE(isEqual());
}

TEST(Pairs, AreNotOfCellsThatFailed) {
  std::vector<Cell> cells = {makeFailure("G(11)", "no"), makeCell("G(11)", 1, 1, kDedup)};
  EXPECT_THAT(pairsByPass(makeCatalogue(cells), "whole-level-dedup"), IsEmpty());
}

} // namespace
} // namespace voxc::report
