// A command with a plan, or with all that it takes without one.
#include "PlanOption.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace voxc::tool {

void PlanOption::declare(CLI::App &app, const std::string &option, const std::string &summary,
                         const std::vector<std::string> &required, const std::vector<std::string> &allowed) {
  const auto take = [this, &app, required](const std::string &path) {
    path_ = path;
    for (const std::string &name : required)
      app.get_option(name)->required(false);
  };
  const std::vector<CLI::Option *> others = app.get_options();
  CLI::Option *plan = app.add_option_function<std::string>(
                             "--plan", take, "Build plan: all else stands in it; docs/cluster.md")
                          ->type_name("P.plan")
                          ->trigger_on_parse();
  app.add_option(option, numbers_, summary)->type_name("LIST")->needs(plan);
  app.parse_complete_callback([this, others, allowed, option] {
    if (!isGiven())
      return;
    if (numbers_.empty())
      throw CLI::RequiresError("--plan", option);
    for (const CLI::Option *other : others)
      if (other->count() > 0 &&
          std::ranges::none_of(allowed, [&](const std::string &name) { return other->check_name(name); }))
        throw CLI::ExcludesError(other->get_name(), "--plan");
  });
}

} // namespace voxc::tool
