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

TEST(Catalogue, ComparesFormatsWithThePassesThatMostHave) {
  const std::vector<Cell> cells = {makeCell("R(4^3) G(7)", 100, 1), makeCell("R(4^3) G(7)", 50, 1, kDedup),
                                   makeCell("G(11)", 40, 0.5, kDedup), makeCell("G(11)", 40, 5, kBoth)};
  const Catalogue catalogue = makeCatalogue(cells);
  ASSERT_THAT(catalogue.stages, SizeIs(1));
  EXPECT_EQ(catalogue.stages[0].passes, "whole-level-dedup");
  EXPECT_THAT(catalogue.stages[0].entries, ElementsAre(1, 2));
  EXPECT_EQ(catalogue.stages[0].otherPasses, 2u);
  EXPECT_TRUE(catalogue.entries[1].onFrontier && catalogue.entries[2].onFrontier);
  EXPECT_FALSE(catalogue.entries[0].onFrontier || catalogue.entries[3].onFrontier);
}

TEST(Catalogue, TakesNoPassesWhereMostHaveNone) {
  const std::vector<Cell> cells = {makeCell("S(11)", 100, 1), makeCell("R(4^3) G(7)", 50, 1, kDedup),
                                   makeCell("R(4^3) G(7)", 60, 1)};
  EXPECT_EQ(makeCatalogue(cells).stages.at(0).passes, kNoPasses);
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
  cells[0].speed.mraysPerCpuS->spread = 0.06;
  EXPECT_TRUE(isEqual());
}

TEST(Pairs, AreNotOfCellsThatFailed) {
  std::vector<Cell> cells = {makeFailure("G(11)", "no"), makeCell("G(11)", 1, 1, kDedup)};
  EXPECT_THAT(pairsByPass(makeCatalogue(cells), "whole-level-dedup"), IsEmpty());
}

} // namespace
} // namespace voxc::report
