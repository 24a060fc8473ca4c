// Answers to the questions of a reader, and the commands that build them.
#include "MakeCell.h"

#include "report/BuildCommand.h"
#include "report/Verdict.h"

#include <gmock/gmock.h>

namespace voxc::report {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::uint64_t kMebi = 1 << 20;

/// "Smallest: G(11); Fastest: R(9³) (D(9³, 6))", of all stages.
std::vector<std::string> told(const std::vector<Cell> &cells) {
  const Catalogue catalogue = makeCatalogue(cells);
  std::vector<const Stage *> stages;
  for (const Stage &stage : catalogue.stages)
    stages.push_back(&stage);
  std::vector<std::string> lines;
  for (const Question &question : verdict(catalogue, stages)) {
    std::string line = question.text + ":";
    for (const Answer &answer : question.answers) {
      line += " " + answer.entry->name;
      for (const Entry *rival : answer.asFast)
        line += " = " + rival->name;
    }
    lines.push_back(line);
  }
  return lines;
}

TEST(Verdict, AsksWhatHasDifferentAnswers) {
  EXPECT_THAT(told({makeCell("S(11)", 5 * kMebi, 1), makeCell("G(11)", 12 * kMebi, 2),
                    makeCell("R(4^3) G(7)", 60 * kMebi, 3), makeCell("R(9^3)", 70 * kMebi, 4)}),
              ElementsAre("Smallest: S(11)", "Best below 16 MiB: G(11)", "Best below 64 MiB: R(4³) G(7)",
                          "Fastest: R(9³)"));
  EXPECT_THAT(told({makeCell("S(11)", 5 * kMebi, 1), makeCell("G(11)", 12 * kMebi, 0.5)}),
              ElementsAre("Smallest and fastest: S(11)"));
  EXPECT_THAT(told({makeFailure("S(11)", "no")}), IsEmpty());
}

TEST(Verdict, AsksForThreeBudgetsAtMost) {
  std::vector<Cell> cells;
  for (int i = 0; i < 9; ++i)
    cells.push_back(
        makeCell("R(1^3) G(10)", kMebi << i, i + 1.0, {"short-pointers=" + std::to_string(i + 9)}));
  EXPECT_EQ(told(cells).size(), 5u);
}

TEST(Verdict, TellsWhatIsAsFastFastestFirst) {
  std::vector<Cell> cells = {makeCell("G(11)", kMebi, 1), makeCell("S(11)", 9 * kMebi, 0.99),
                             makeCell("R(9^3)", 8 * kMebi, 1.01)};
  EXPECT_THAT(told(cells), ElementsAre("Smallest and fastest: G(11) = R(9³) = S(11)"));
}

/// What leads on one device by chance gives way to what leads on the other, if it is as good there.
TEST(Verdict, MakesNoTwoAnswersOfOneByChance) {
  std::vector<Cell> cells = {makeCell("G(11)", kMebi, 1.01), makeCell("S(11)", kMebi, 1),
                             makeCell("G(11)", kMebi, 2), makeCell("S(11)", kMebi, 2.01)};
  cells[2].device.name = cells[3].device.name = "cpu";
  EXPECT_THAT(told(cells), ElementsAre("Smallest and fastest: G(11) = S(11) G(11) = S(11)"));
}

/// The command that builds a cell of a model, by the command that measured it.
std::string built(const std::string &input, const std::string &command) {
  Cell cell = makeCell("R(4^3) G(7)", 1, 1, {"whole-level-dedup", "short-pointers=20"});
  cell.model.input = input;
  cell.madeBy.command = command;
  return buildCommand(cell);
}

TEST(BuildCommand, NamesTheInputAndItsPasses) {
  EXPECT_EQ(built("hut.obj", ""),
            "voxc build 'R(4^3) G(7)' hut.obj --whole-level-dedup --short-pointers=20 -o hut.hvx");
  EXPECT_EQ(built("builtin:terrain:64", "voxc bench builtin:terrain:64 --formats 'G(6)' -o r").substr(0, 43),
            "voxc build 'R(4^3) G(7)' builtin:terrain:64");
}

TEST(BuildCommand, TakesTheOptionsOfTheInput) {
  EXPECT_EQ(built("a b.ply", "voxc bench 'hut=dir/a b.ply --up z --bounds -1,0,0,1,1,1' other.ply --crop "
                             "--up y --check 9 --resolution 512 -o r"),
            "voxc build 'R(4^3) G(7)' 'dir/a b.ply' --crop --resolution=512 --up=z --bounds=-1,0,0,1,1,1 "
            "--whole-level-dedup --short-pointers=20 -o hut.hvx");
  EXPECT_EQ(built("x.nii", "voxc search x.nii --window 1 --window 9 --budget 180s").substr(0, 43),
            "voxc build 'R(4^3) G(7)' x.nii --window=1,9");
}

TEST(BuildCommand, QuotesWhatAShellWouldTakeForMore) {
  EXPECT_EQ(built("a';rm -r x", "").substr(0, 41), "voxc build 'R(4^3) G(7)' 'a'\\'';rm -r x' ");
  EXPECT_EQ(built("-x.obj", "").substr(0, 34), "voxc build 'R(4^3) G(7)' ./-x.obj ");
}

} // namespace
} // namespace voxc::report
