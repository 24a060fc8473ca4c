// A command with a plan, or with all that it takes without one.
#include "jobs/PlanOption.h"

#include <algorithm>

namespace voxc::tool {

void PlanOption::declare(const CommandLine &command, const std::string &option, const std::string &summary,
                         const std::vector<std::string> &required, const std::vector<std::string> &allowed) {
  std::vector<Option> needless;
  needless.reserve(required.size());
  for (const std::string &name : required)
    needless.push_back(command.option(name));
  const auto take = [this, needless](const std::string &path) {
    path_ = path;
    for (const Option &option : needless)
      option.required(false);
  };
  const std::vector<Option> others = command.options();
  const Option plan =
      command.addTaken("--plan", take, "Build plan: all else stands in it; docs/cluster.md").takes("P.plan");
  command.add(option, numbers_, summary).takes("LIST").needs(plan);
  command.checkTogether([this, others, allowed, option]() -> Expected<void> {
    if (!isGiven())
      return {};
    if (numbers_.empty())
      return Error::usage("--plan requires " + option);
    for (const Option &other : others)
      if (other.count() > 0 &&
          std::ranges::none_of(allowed, [&](const std::string &name) { return other.isCalled(name); }))
        return Error::usage(other.name() + " excludes --plan");
    return {};
  });
}

} // namespace voxc::tool
