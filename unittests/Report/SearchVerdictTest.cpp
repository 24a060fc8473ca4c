// The one verdict of a search, and what the page and the CSV make of it.
#include "MakeCell.h"

#include "report/Report.h"
#include "report/SearchVerdict.h"

#include <gmock/gmock.h>

namespace voxc::report {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

constexpr std::uint64_t kKibi = 1 << 10;

/// A format as a search measured it on two sets of rays, in so many rounds.
void add(std::vector<Cell> &cells, const std::string &format, std::uint64_t bytes, double overview,
         double bounced, std::uint64_t rounds = 7, std::vector<std::string> passes = {}) {
  for (const auto &[name, speed] : {std::pair("overview", overview), {"bounced", bounced}}) {
    Cell &cell = cells.emplace_back(makeCell(format, bytes, speed, passes));
    cell.rays.name = cell.rays.digest = name;
    cell.speed.rounds = rounds;
    cell.madeBy.command = "voxc search hut.obj --budget 10s -o found";
    cell.cell = format + name + std::to_string(cells.size());
  }
}

std::vector<std::string> told(const SearchVerdict &verdict) {
  std::vector<std::string> lines;
  for (const SearchAnswer &answer : verdict.answers) {
    const Finalist &finalist = verdict.frontier[answer.finalist];
    lines.push_back(answer.question + ": " + finalist.name + ", " + finalist.sizeText + " at " +
                    finalist.speedText);
  }
  return lines;
}

TEST(SearchVerdict, IsOfTheMeanTimeOfAllSetsOfRays) {
  std::vector<Cell> cells;
  add(cells, "G(11)", 10 * kKibi, 4, 1);
  add(cells, "S(11)", 20 * kKibi, 9, 1); // Faster on one set alone.
  add(cells, "R(9^3)", 2048 * kKibi, 6, 6);
  add(cells, "R(4^3) G(7)", 30 * kKibi, 1, 1); // Beaten.
  const auto verdicts = searchVerdicts(cells);
  ASSERT_THAT(verdicts, SizeIs(1));
  EXPECT_EQ(verdicts.front().formats, 4u);
  EXPECT_THAT(told(verdicts.front()),
              ElementsAre("smallest: G(11), 10.0 KiB at 1.60 M/s",
                          "best below 32 KiB: S(11), 20.0 KiB at 1.80 M/s",
                          "fastest: R(9^3), 2.00 MiB at 6.00 M/s", "balanced: G(11), 10.0 KiB at 1.60 M/s"));
  EXPECT_EQ(verdicts.front().frontier[1].setSpeedsText, "9.00 M/s overview, 1.00 M/s bounced");
}

TEST(SearchVerdict, ComparesTimesOfTheLastRounds) {
  std::vector<Cell> cells;
  add(cells, "G(11)", 10 * kKibi, 4, 4);
  add(cells, "S(11)", 20 * kKibi, 8, 8, 3); // On a machine that was less busy, perhaps.
  const auto verdicts = searchVerdicts(cells);
  EXPECT_EQ(verdicts.front().formats, 2u);
  EXPECT_THAT(verdicts.front().frontier, SizeIs(1));
  const std::string csv = makeReport(cells).csv;
  EXPECT_THAT(csv, HasSubstr(",off,20480,"));
}

TEST(SearchVerdict, CountsOtherPassesAsOtherFormatsAndNamesThem) {
  std::vector<Cell> cells;
  add(cells, "R(4^3) G(7)", 10 * kKibi, 4, 4, 7, {"whole-level-dedup"});
  add(cells, "R(4^3) G(7)", 8 * kKibi, 3, 3, 7, {"whole-level-dedup", "short-pointers=9", "octant-masks"});
  const auto verdicts = searchVerdicts(cells);
  EXPECT_EQ(verdicts.front().formats, 2u);
  EXPECT_EQ(verdicts.front().answer("smallest").name, "R(4^3) G(7) with short pointers, octant masks");
  EXPECT_EQ(verdicts.front().answer("fastest").name, "R(4^3) G(7)");
}

/// The worst of the best: neither the median, nor what beaten formats were foretold.
TEST(SearchVerdict, StatesTheErrorOfTheFrontier) {
  std::vector<Cell> cells;
  add(cells, "G(11)", 10 * kKibi, 4, 4);
  add(cells, "S(11)", 20 * kKibi, 5, 5);
  add(cells, "R(9^3)", 40 * kKibi, 1, 1);
  EXPECT_EQ(searchVerdicts(cells).front().worstFactor(), 0);
  const double foretold[] = {4, 4, 2.5, 2.5, 9, 9};
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells[i].predicted = tool::bench::PredictedPart{{}, foretold[i], {}, {}};
  const auto verdicts = searchVerdicts(cells);
  EXPECT_DOUBLE_EQ(verdicts.front().frontier[1].foretoldRatio, 0.5);
  EXPECT_DOUBLE_EQ(verdicts.front().worstFactor(), 2);
}

TEST(SearchVerdict, StandsOnThePageAsItIs) {
  std::vector<Cell> cells;
  add(cells, "G(11)", 10 * kKibi, 4, 1);
  add(cells, "S(11)", 20 * kKibi, 9, 1);
  const std::string html = makeReport(cells).html;
  EXPECT_THAT(html, HasSubstr("<dt>Fastest</dt>"));
  EXPECT_THAT(html, HasSubstr("<b>S(11)</b>, 20.0 KiB at 1.80 M/s (9.00 M/s overview, 1.00 M/s bounced)."));
  EXPECT_THAT(html, Not(HasSubstr("<h3>overview")));
  // The search itself may know better what to compare.
  std::vector<const Cell *> own;
  for (const Cell &cell : cells)
    own.push_back(&cell);
  const auto isSmall = [](const Cell &cell) { return cell.format.name == "G(11)"; };
  EXPECT_THAT(makeReport(cells, {}, {}, makeSearchVerdict(own, isSmall, "smallest")).html,
              Not(HasSubstr("<b>S(11)</b>")));
}

TEST(SearchVerdict, IsOfNoFormatWithoutSpeeds) {
  std::vector<Cell> cells;
  add(cells, "G(11)", 10 * kKibi, 0, 0);
  cells[0].failure = cells[1].failure = tool::bench::Failure{"build", "no", {}};
  const auto verdicts = searchVerdicts(cells);
  EXPECT_EQ(verdicts.front().formats, 1u);
  EXPECT_THAT(verdicts.front().frontier, SizeIs(0));
  EXPECT_THAT(makeReport(cells).html, Not(HasSubstr("class=\"verdict\"")));
}

} // namespace
} // namespace voxc::report
