// The one verdict of a search.
#include "voxc/Measure/SearchVerdict.h"

#include "Measure/Json.h"
#include "voxc/Support/File.h"

#include <gmock/gmock.h>

#include <deque>
#include <filesystem>

namespace voxc::measure {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::uint64_t kKibi = 1 << 10;

/// What a search measured; cells that are added leave the others where they are.
using Cells = std::deque<Record>;

/// A format as a search measured it on two sets of rays, in so many rounds.
void add(Cells &cells, const std::string &format, std::uint64_t bytes, double overview, double bounced,
         std::uint64_t rounds = 7, std::vector<std::string> passes = {}) {
  for (const auto &[name, speed] : {std::pair("overview", overview), {"bounced", bounced}}) {
    Record &cell = cells.emplace_back();
    cell.cell = format + name + std::to_string(cells.size());
    cell.model.name = "hut";
    cell.format.name = format;
    cell.format.passes = passes;
    cell.resolution = 2048;
    cell.precision = "exact";
    cell.device = {"llvmpipe (LLVM)", "vulkan", "Mesa", 2, "cpu"};
    cell.rays = {name, "camera", 100, {}, name, {}};
    cell.volume.bytes = bytes;
    cell.speed.rounds = rounds;
    cell.speed.mraysPerCpuS = Speed{speed * 0.99, speed, speed * 1.01, 0.02};
    cell.error.rays = 1000;
    cell.error.missed = cell.error.ghost = cell.error.wrong = 0;
  }
}

/// The verdict where formats of seven rounds are compared.
SearchVerdict verdictOf(const Cells &cells, double leastSpeed = 0) {
  std::vector<const Record *> all;
  for (const Record &cell : cells)
    all.push_back(&cell);
  return makeSearchVerdict(
      all, [](const Record &cell) { return cell.speed.rounds == 7u; }, "balanced", leastSpeed);
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
  Cells cells;
  add(cells, "G(11)", 10 * kKibi, 4, 1);
  add(cells, "S(11)", 20 * kKibi, 9, 1); // Faster on one set alone.
  add(cells, "R(9^3)", 2048 * kKibi, 6, 6);
  add(cells, "R(4^3) G(7)", 30 * kKibi, 1, 1); // Beaten.
  const SearchVerdict verdict = verdictOf(cells);
  EXPECT_EQ(verdict.formats, 4u);
  EXPECT_THAT(told(verdict),
              ElementsAre("smallest: G(11), 10.0 KiB at 1.60 M/s",
                          "best below 32 KiB: S(11), 20.0 KiB at 1.80 M/s",
                          "fastest: R(9^3), 2.00 MiB at 6.00 M/s", "balanced: G(11), 10.0 KiB at 1.60 M/s"));
  EXPECT_EQ(verdict.frontier[1].setSpeedsText, "9.00 M/s overview, 1.00 M/s bounced");
}

TEST(SearchVerdict, AnswersWithNothingThatIsTooSlow) {
  Cells cells;
  add(cells, "G(11)", 10 * kKibi, 4, 1);
  add(cells, "S(11)", 20 * kKibi, 9, 1);
  add(cells, "R(9^3)", 2048 * kKibi, 6, 6);
  const SearchVerdict some = verdictOf(cells, 1.7);
  EXPECT_EQ(some.formats, 3u);
  EXPECT_THAT(told(some), Contains("smallest: S(11), 20.0 KiB at 1.80 M/s"));
  EXPECT_THAT(some.frontier, SizeIs(2));
  const SearchVerdict none = verdictOf(cells, 7);
  EXPECT_THAT(none.frontier, IsEmpty());
  EXPECT_THAT(none.answers, IsEmpty());
  EXPECT_DOUBLE_EQ(none.fastest, 6);
}

TEST(SearchVerdict, ComparesTimesOfTheLastRounds) {
  Cells cells;
  add(cells, "G(11)", 10 * kKibi, 4, 4);
  add(cells, "S(11)", 20 * kKibi, 8, 8, 3); // On a machine that was less busy, perhaps.
  const SearchVerdict verdict = verdictOf(cells);
  EXPECT_EQ(verdict.formats, 2u);
  EXPECT_THAT(verdict.frontier, SizeIs(1));
}

TEST(SearchVerdict, CountsOtherPassesAsOtherFormatsAndNamesThem) {
  Cells cells;
  add(cells, "R(4^3) G(7)", 10 * kKibi, 4, 4, 7, {"whole-level-dedup"});
  add(cells, "R(4^3) G(7)", 8 * kKibi, 3, 3, 7, {"whole-level-dedup", "short-pointers=9", "octant-masks"});
  const SearchVerdict verdict = verdictOf(cells);
  EXPECT_EQ(verdict.formats, 2u);
  EXPECT_EQ(verdict.answer("smallest").name, "R(4^3) G(7) with short pointers, octant masks");
  EXPECT_EQ(verdict.answer("fastest").name, "R(4^3) G(7)");
}

/// The worst of the best: neither the median, nor what beaten formats were predicted.
TEST(SearchVerdict, StatesTheErrorOfTheFrontier) {
  Cells cells;
  add(cells, "G(11)", 10 * kKibi, 4, 4);
  add(cells, "S(11)", 20 * kKibi, 5, 5);
  add(cells, "R(9^3)", 40 * kKibi, 1, 1);
  EXPECT_EQ(verdictOf(cells).worstFactor(), 0);
  const double predicted[] = {4, 4, 2.5, 2.5, 9, 9};
  for (std::size_t i = 0; i < cells.size(); ++i)
    cells[i].predicted = PredictedPart{{}, predicted[i], {}, {}};
  const SearchVerdict verdict = verdictOf(cells);
  EXPECT_DOUBLE_EQ(verdict.frontier[1].predictedRatio, 0.5);
  EXPECT_DOUBLE_EQ(verdict.worstFactor(), 2);
}

/// One file for each place, whose later verdict replaces the earlier one.
TEST(SearchVerdict, IsLeftForThePage) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "voxc-search-verdicts";
  std::filesystem::create_directories(folder);
  Cells cells;
  add(cells, "G(11)", 10 * kKibi, 4, 1);
  ASSERT_TRUE(writeVerdict(folder.string(), verdictOf(cells)));
  add(cells, "S(11)", 20 * kKibi, 9, 1, 3);
  ASSERT_TRUE(writeVerdict(folder.string(), verdictOf(cells)));
  std::vector<std::filesystem::path> files;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    files.push_back(entry.path());
  ASSERT_THAT(files, SizeIs(1));
  const Json json = Json::parse(*readTextFile(files.front().string()));
  EXPECT_EQ(json["formats"], 2);
  EXPECT_THAT(json["cells"], SizeIs(4));
  EXPECT_THAT(json["compared"], SizeIs(2));
  EXPECT_EQ(json["frontier"][0]["speed"], "1.60 M/s");
  EXPECT_EQ(json["answers"][0]["question"], "smallest");
  EXPECT_EQ(json["answers"][0]["format"], 0);
  std::filesystem::remove_all(folder);
}

TEST(SearchVerdict, IsOfNoFormatWithoutSpeeds) {
  Cells cells;
  add(cells, "G(11)", 10 * kKibi, 0, 0);
  cells[0].failure = cells[1].failure = Failure{"build", "no", {}};
  const SearchVerdict verdict = verdictOf(cells);
  EXPECT_EQ(verdict.formats, 1u);
  EXPECT_THAT(verdict.frontier, SizeIs(0));
}

} // namespace
} // namespace voxc::measure
