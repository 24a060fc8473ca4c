// A plan's items by their numbers, and the commands that do them.
#include "jobs/PlanRun.h"

#include "cluster/Work.h"
#include "common/FiguresFile.h"

namespace voxc::tool {

using namespace cluster;

Expected<void> PlanRun::checkFigures(const CommonOptions &common) const {
  VOXC_TRY(checkFiguresApart(common.stats, files_.output(plan_.tree().root())));
  return checkFiguresApart(common.stats, files_.folder());
}

Expected<Jobs::Missing> PlanRun::missing() const {
  const MergeTree tree = plan_.tree();
  const MissingWork work(tree, [this](const WorkItem &item) { return files_.stands(item); });
  Missing missing;
  for (std::size_t level = 0; level < work.levels(); ++level) {
    missing.push_back(work.at(level));
    if (level > 0)
      for (std::uint64_t &number : missing.back())
        number = tree.numberOf({level, number});
  }
  return missing;
}

std::vector<std::string> PlanRun::command(std::size_t level, const std::string &numbers) const {
  std::vector<std::string> words = {level == 0 ? "build" : "merge",   "--plan", path_,
                                    level == 0 ? "--task" : "--node", numbers,  "--quiet"};
  const auto add = [&](const char *option, const std::string &value) {
    if (!value.empty())
      words.insert(words.end(), {option, value});
  };
  add("--memory", means_.memory);
  add("--scratch", means_.scratch);
  if (level == 0 && means_.threads > 0)
    add("--threads", std::to_string(means_.threads));
  return words;
}

std::uint64_t PlanRun::costOf(std::size_t level, std::uint64_t number) const {
  const MergeTree tree = plan_.tree();
  const auto [first, last] = tree.partsOf(level == 0 ? WorkItem{0, number} : tree.merge(number));
  std::uint64_t cost = 1;
  for (std::uint64_t part = first; part < last; ++part)
    cost += plan_.ranges[part].cost;
  return cost;
}

} // namespace voxc::tool
