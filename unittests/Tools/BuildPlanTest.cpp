// Build plans: their text, their tree, how costs are cut, and what is found missing.
#include "cluster/BuildPlan.h"
#include "cluster/EvenCut.h"
#include "cluster/NumberList.h"
#include "cluster/PlanLock.h"
#include "cluster/Slurm.h"
#include "cluster/Work.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <random>
#include <string>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace voxc::tool::cluster {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

using Numbers = std::vector<std::uint64_t>;

/// The largest sum of a run.
std::uint64_t largest(const Numbers &costs, const Numbers &ends) {
  std::uint64_t most = 0;
  std::uint64_t begin = 0;
  for (const std::uint64_t end : ends) {
    most =
        std::max(most, std::accumulate(costs.begin() + static_cast<std::ptrdiff_t>(begin),
                                       costs.begin() + static_cast<std::ptrdiff_t>(end), std::uint64_t{0}));
    begin = end;
  }
  return most;
}

/// The same of the best cut, by trying all.
std::uint64_t leastLargest(const Numbers &costs, std::size_t begin, std::uint64_t count) {
  if (count == 1)
    return std::accumulate(costs.begin() + static_cast<std::ptrdiff_t>(begin), costs.end(), std::uint64_t{0});
  std::uint64_t best = ~std::uint64_t{0};
  std::uint64_t sum = 0;
  for (std::size_t end = begin; end <= costs.size(); ++end) {
    best = std::min(best, std::max(sum, leastLargest(costs, end, count - 1)));
    sum += end < costs.size() ? costs[end] : 0;
  }
  return best;
}

TEST(EvenCut, leavesTheLargestRunAsSmallAsCanBe) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    Numbers costs(1 + random() % 9);
    for (std::uint64_t &cost : costs)
      cost = random() % 3 == 0 ? 0 : random() % 20;
    const std::uint64_t count = 1 + random() % 5;
    const Numbers ends = cutEvenly(costs, count);
    ASSERT_EQ(ends.size(), count);
    EXPECT_TRUE(std::ranges::is_sorted(ends));
    EXPECT_EQ(ends.back(), costs.size());
    EXPECT_EQ(largest(costs, ends), leastLargest(costs, 0, count)) << testing::PrintToString(costs);
  }
}

TEST(EvenCut, givesEveryRunSomething) {
  EXPECT_THAT(cutEvenly(Numbers{9, 1, 1, 1, 1}, 4), ElementsAre(1, 2, 3, 5));
  EXPECT_THAT(cutEvenly(Numbers{0, 0}, 3), ElementsAre(2, 2, 2));
}

TEST(MergeTree, joinsSomeAStep) {
  const MergeTree tree(65, 8);
  ASSERT_EQ(tree.levels(), 4u);
  EXPECT_EQ(tree.count(1), 9u);
  EXPECT_EQ(tree.count(2), 2u);
  EXPECT_EQ(tree.merges(), 12u);
  EXPECT_EQ(tree.partsOf({1, 8}), std::pair(std::uint64_t{64}, std::uint64_t{65}));
  EXPECT_EQ(tree.partsOf({2, 1}), std::pair(std::uint64_t{64}, std::uint64_t{65}));
  EXPECT_EQ(tree.partsOf(tree.root()), std::pair(std::uint64_t{0}, std::uint64_t{65}));
  EXPECT_THAT(tree.childrenOf({2, 1}), ElementsAre(WorkItem{1, 8}));
  for (std::uint64_t number = 0; number < tree.merges(); ++number)
    EXPECT_EQ(tree.numberOf(tree.merge(number)), number);
  EXPECT_EQ(tree.merge(11), tree.root());
}

TEST(MergeTree, hasOneMergeOfAsManyPartsAsItJoins) {
  EXPECT_EQ(MergeTree(64, 64).merges(), 1u);
  EXPECT_EQ(MergeTree(65, 64).merges(), 3u);
}

TEST(MergeTree, hasOneMergeOfOnePart) {
  const MergeTree tree(1, 8);
  EXPECT_EQ(tree.merges(), 1u);
  EXPECT_THAT(tree.childrenOf(tree.root()), ElementsAre(WorkItem{0, 0}));
}

TEST(NumberList, standsForRanges) {
  EXPECT_EQ(parseNumberList("0,3,5-7", 8), (Numbers{0, 3, 5, 6, 7}));
  EXPECT_EQ(numberListText({0, 3, 5, 6, 7}), "0,3,5-7");
  EXPECT_EQ(numberListText({}), "");
  for (const char *wrong :
       {"", ",", "8", "5-8", "3-1", "1-", "-1", "1,,2", "1 ", "x", "99999999999999999999"})
    EXPECT_FALSE(parseNumberList(wrong, 8)) << wrong;
}

TEST(Slurm, timesAreDaysHoursMinutesAndSeconds) {
  EXPECT_DOUBLE_EQ(secondsOfTime("1-02:03:04"), 93784);
  EXPECT_DOUBLE_EQ(secondsOfTime("02:03:04"), 7384);
  EXPECT_DOUBLE_EQ(secondsOfTime("03:04.5"), 184.5);
  EXPECT_DOUBLE_EQ(secondsOfTime("UNLIMITED"), 0);
}

TEST(MissingWork, leavesOutWhatNothingAsksFor) {
  const MergeTree tree(9, 8);
  const MissingWork all(tree, [](const WorkItem &) { return false; });
  EXPECT_THAT(all.at(0), SizeIs(9));
  EXPECT_THAT(all.at(1), SizeIs(2));
  EXPECT_THAT(all.at(2), SizeIs(1));
  // The first merge stands: its parts may be gone.
  const MissingWork some(
      tree, [](const WorkItem &item) { return item == WorkItem{1, 0} || item == WorkItem{0, 8}; });
  EXPECT_THAT(some.at(0), IsEmpty());
  EXPECT_THAT(some.at(1), ElementsAre(1));
  EXPECT_THAT(some.at(2), ElementsAre(0));
  const MissingWork none(tree, [](const WorkItem &) { return true; });
  for (std::size_t level = 0; level < none.levels(); ++level)
    EXPECT_THAT(none.at(level), IsEmpty());
}

BuildPlan samplePlan() {
  BuildPlan plan;
  plan.format = *parseFormat("R(2^3) G(4)");
  plan.input = "builtin:terrain:64";
  plan.files = {{"0123456789abcdef", "/a folder/file.obj"}};
  plan.options = {"resolution=64", "crop=yes"};
  plan.volume = "terrain.hvx";
  plan.extent = {64, 40, 64};
  plan.cubes = {4, 64};
  plan.ranges = {{0, 10, 5}, {10, 64, 7}};
  return plan;
}

TEST(BuildPlan, isWhatItsTextSays) {
  const BuildPlan plan = samplePlan();
  const std::string text = printPlan(plan);
  const auto read = parsePlan(text, "p");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(printPlan(*read), text);
  EXPECT_EQ(read->format, plan.format);
  EXPECT_EQ(read->files, plan.files);
  EXPECT_EQ(read->options, plan.options);
  EXPECT_EQ(read->extent, plan.extent);
  EXPECT_EQ(read->ranges, plan.ranges);
  EXPECT_EQ(read->digest(), plan.digest());
  const FragmentShare share = plan.shareOf({0, 1});
  EXPECT_EQ(share.begin, 10u);
  EXPECT_EQ(share.end, 64u);
  EXPECT_EQ(share.count, 2u);
}

TEST(BuildPlan, textThatWasChangedIsAnError) {
  const std::string text = printPlan(samplePlan());
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] ^= 1;
    EXPECT_FALSE(parsePlan(changed, "p")) << "byte " << i;
    EXPECT_FALSE(parsePlan(std::string_view(text).substr(0, i), "p")) << "cut at byte " << i;
  }
  EXPECT_FALSE(parsePlan(text + "\n", "p"));
  EXPECT_THAT(parsePlan("x", "p").error().message, HasSubstr("'p' is no build plan"));
}

TEST(PlanLock, isHeldByOneAndByWhomItStarts) {
  std::string folder = testing::TempDir() + "voxc-lock-XXXXXX";
  ASSERT_TRUE(::mkdtemp(folder.data()));
  const std::atomic<bool> stop = true;
  const auto isTaken = [&] {
    int waited = 0;
    const auto lock = PlanLock::take(folder, {.stop = &stop}, [&] { ++waited; });
    EXPECT_EQ(waited, lock ? 0 : 1);
    EXPECT_TRUE(lock || lock.error().kind == ErrorKind::Interrupted);
    return !lock;
  };
  EXPECT_FALSE(isTaken());
  pid_t child = -1;
  {
    const auto lock = PlanLock::take(folder, {}, [] {});
    ASSERT_TRUE(lock);
    EXPECT_TRUE(isTaken());
    char sleep[] = "sleep", seconds[] = "60";
    char *arguments[] = {sleep, seconds, nullptr};
    ASSERT_EQ(::posix_spawnp(&child, sleep, nullptr, nullptr, arguments, environ), 0);
  }
  EXPECT_TRUE(isTaken()) << "a process that was started meanwhile has it";
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_FALSE(isTaken()) << "the dead keep no lock";
  std::filesystem::remove_all(folder);
}

/// A plan whose digest is right but which says what cannot be.
TEST(BuildPlan, contradictionsAreErrors) {
  const auto expectError = [](auto change) {
    BuildPlan plan = samplePlan();
    change(plan);
    const auto read = parsePlan(printPlan(plan), "p");
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().message, HasSubstr("'p' contradicts itself"));
  };
  expectError([](BuildPlan &plan) { plan.ranges[1].begin = 11; });
  expectError([](BuildPlan &plan) { plan.ranges[1].end = 63; });
  expectError([](BuildPlan &plan) { plan.ranges.clear(); });
  expectError([](BuildPlan &plan) { plan.extent.x = 1 << 22; });
  expectError([](BuildPlan &plan) { plan.cubes.count = 0; });
  expectError([](BuildPlan &plan) { plan.volume = "a\nb"; });
}

} // namespace
} // namespace voxc::tool::cluster
