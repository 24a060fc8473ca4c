// Processes of this program, each with a share of what is missing.
#include "jobs/LocalRun.h"

#include "cluster/NumberList.h"
#include "common/Command.h"
#include "jobs/Child.h"

#include <algorithm>
#include <system_error>
#include <thread>

namespace voxc::tool {

namespace {

using Numbers = std::vector<std::uint64_t>;

/// Deals items out to so many lists, the dearest first, each to the list that has the least.
std::vector<Numbers> deal(const Jobs &jobs, std::size_t level, Numbers numbers, std::size_t lists) {
  const auto costOf = [&](std::uint64_t number) { return jobs.costOf(level, number); };
  std::ranges::stable_sort(numbers, std::ranges::greater(), costOf);
  std::vector<Numbers> dealt(std::min(lists, numbers.size()));
  Numbers costs(dealt.size());
  for (const std::uint64_t number : numbers) {
    const auto least = static_cast<std::size_t>(std::ranges::min_element(costs) - costs.begin());
    dealt[least].push_back(number);
    costs[least] += costOf(number);
  }
  for (Numbers &list : dealt)
    std::ranges::sort(list);
  return dealt;
}

/// Numbers of a command; Linux takes words of less than 128 KiB.
constexpr std::size_t kMostNumbers = 8192;

/// A list as a message shows it.
std::string shortened(const std::string &numbers) {
  constexpr std::size_t kMost = 80;
  return numbers.size() <= kMost ? numbers : numbers.substr(0, numbers.rfind(',', kMost)) + ",...";
}

/// Runs a level; returns the first failure of a process, if there was one.
Expected<void> runLevel(const Jobs &jobs, std::size_t level, const Numbers &missing, unsigned processes,
                        const JobWatch &watch) {
  const auto lists = deal(jobs, level, missing, processes);
  std::vector<Expected<void>> outcomes(lists.size());
  const auto runList = [&](std::size_t i) {
    for (std::size_t at = 0; at < lists[i].size() && outcomes[i]; at += kMostNumbers) {
      const auto begin = lists[i].begin() + static_cast<std::ptrdiff_t>(at);
      const auto count = static_cast<std::ptrdiff_t>(std::min(kMostNumbers, lists[i].size() - at));
      const std::string numbers = cluster::numberListText(Numbers(begin, begin + count));
      const auto report = runChild(jobs.command(level, numbers), watch.progress.silent(), [] {});
      if (!report)
        outcomes[i] = report.error();
      else if (!report->succeeded)
        outcomes[i] = Error::environment(jobs.itemName(level) + " of " + shortened(numbers) +
                                         " failed: " + report->failure);
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < lists.size(); ++i) {
    try {
      threads.emplace_back(runList, i);
    } catch (const std::system_error &) {
      runList(i); // A limit on threads: the lists come one after the other.
    }
  }
  threads.clear(); // Joins them.
  VOXC_TRY(watch.progress.check());
  const auto failed = std::ranges::find_if(outcomes, [](const Expected<void> &outcome) { return !outcome; });
  return failed == outcomes.end() ? Expected<void>() : *failed;
}

/// Runs the levels one after the other, up to the first that fails.
Expected<void> runLevels(const Jobs &jobs, const Jobs::Missing &missing, unsigned processes,
                         const JobWatch &watch) {
  for (std::size_t level = 0; level < missing.size(); ++level) {
    watch.progress.at(jobs.itemName(level), static_cast<double>(level) / static_cast<double>(missing.size()));
    if (missing[level].empty())
      continue;
    VOXC_TRY(runLevel(jobs, level, missing[level], processes, watch));
  }
  return {};
}

} // namespace

Expected<void> runLocally(const Jobs &jobs, unsigned processes, const JobWatch &watch, Json &figures) {
  auto missing = jobs.missing();
  if (!missing)
    return missing.error();
  figures["missing"] = countOf(*missing);
  std::uint64_t rounds = 0;
  for (; countOf(*missing) > 0; ++rounds) {
    Expected<void> done = runLevels(jobs, *missing, processes, watch);
    if (!done && done.error().kind == ErrorKind::Interrupted)
      return done;
    auto left = jobs.missing();
    if (!left)
      return left.error();
    if (*left == *missing)
      return done ? Error::environment(std::to_string(countOf(*left)) + " of " + jobs.allName() +
                                       " are still missing, though no process failed")
                  : done;
    if (!done && !watch.quiet)
      printNote("note: " + done.error().message + "; what is missing is done again");
    missing = std::move(left);
  }
  figures["rounds"] = rounds;
  return {};
}

} // namespace voxc::tool
