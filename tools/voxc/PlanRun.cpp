// Processes of this program, each with a share of what is missing.
#include "PlanRun.h"

#include "sweep/Child.h"

#include <algorithm>
#include <mutex>
#include <optional>
#include <thread>

#include "cluster/NumberList.h"

namespace voxc::tool {

using namespace cluster;

MissingWork PlanRun::missing() const {
  return MissingWork(plan.tree(), [this](const WorkItem &item) { return files.stands(item); });
}

std::vector<std::string> PlanRun::command(std::size_t level, const std::string &numbers) const {
  std::vector<std::string> words = {level == 0 ? "build" : "merge",   "--plan", path,
                                    level == 0 ? "--task" : "--node", numbers,  "--quiet"};
  const auto add = [&](const char *option, const std::string &value) {
    if (!value.empty())
      words.insert(words.end(), {option, value});
  };
  add("--memory", means.memory);
  add("--scratch", means.scratch);
  if (level == 0 && means.threads > 0)
    add("--threads", std::to_string(means.threads));
  return words;
}

std::vector<std::uint64_t> PlanRun::numbersOf(std::size_t level,
                                              const std::vector<std::uint64_t> &indices) const {
  if (level == 0)
    return indices;
  std::vector<std::uint64_t> numbers;
  const MergeTree tree = plan.tree();
  for (const std::uint64_t index : indices)
    numbers.push_back(tree.numberOf({level, index}));
  return numbers;
}

namespace {

/// Deals items out to so many lists, the dearest first, each to the list that has the least.
std::vector<std::vector<std::uint64_t>> deal(const PlanRun &run, std::size_t level,
                                             std::vector<std::uint64_t> indices, std::size_t lists) {
  const MergeTree tree = run.plan.tree();
  const auto costOf = [&](std::uint64_t index) {
    const auto [first, last] = tree.partsOf({level, index});
    std::uint64_t cost = 1;
    for (std::uint64_t part = first; part < last; ++part)
      cost += run.plan.ranges[part].cost;
    return cost;
  };
  std::ranges::stable_sort(indices, std::ranges::greater(), costOf);
  std::vector<std::vector<std::uint64_t>> dealt(std::min(lists, indices.size()));
  std::vector<std::uint64_t> costs(dealt.size());
  for (const std::uint64_t index : indices) {
    const auto least = static_cast<std::size_t>(std::ranges::min_element(costs) - costs.begin());
    dealt[least].push_back(index);
    costs[least] += costOf(index);
  }
  for (auto &list : dealt)
    std::ranges::sort(list);
  return dealt;
}

/// Runs a level; returns the first failure of a process, if there was one.
Expected<void> runLevel(const PlanRun &run, std::size_t level, const std::vector<std::uint64_t> &indices,
                        unsigned processes) {
  const auto lists = deal(run, level, indices, processes);
  std::mutex mutex;
  std::optional<Error> failure;
  std::vector<std::thread> threads;
  for (const auto &list : lists)
    threads.emplace_back([&, numbers = numberListText(run.numbersOf(level, list))] {
      const auto report =
          bench::runChild(run.command(level, numbers), Progress{{}, run.progress.stop}, [] {});
      const std::lock_guard lock(mutex);
      if (!report)
        failure = report.error();
      else if (!report->succeeded && !failure)
        failure = Error::environment(std::string(level == 0 ? "a part" : "a merge") + " of " + numbers +
                                     " failed: " + report->failure);
    });
  for (std::thread &thread : threads)
    thread.join();
  return failure ? *failure : Expected<void>();
}

} // namespace

Expected<void> runLocally(const PlanRun &run, unsigned processes, Json &figures) {
  std::uint64_t rounds = 0;
  MissingWork missing = run.missing();
  const std::uint64_t all = missing.count();
  figures["missing"] = all;
  for (; !missing.empty(); ++rounds) {
    Expected<void> done;
    for (std::size_t level = 0; level < missing.levels() && done; ++level) {
      run.progress.at(level == 0 ? "parts" : "merge",
                      static_cast<double>(level) / static_cast<double>(missing.levels()));
      if (!missing.at(level).empty())
        done = runLevel(run, level, missing.at(level), processes);
    }
    if (!done && done.error().kind == ErrorKind::Interrupted)
      return done;
    const MissingWork left = run.missing();
    if (!done && left == missing)
      return done;
    if (!done && !run.common.quiet)
      printNote("note: " + done.error().message + "; what is missing is done again");
    missing = left;
  }
  figures["rounds"] = rounds;
  return {};
}

} // namespace voxc::tool
