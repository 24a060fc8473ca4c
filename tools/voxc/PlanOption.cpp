// A command with a plan, or with all that it takes without one.
#include "PlanOption.h"

#include <algorithm>

namespace voxc::tool {

void PlanOption::declare(CLI::App &app, const std::string &option, const std::string &summary,
                         const std::vector<std::string> &required, const std::vector<std::string> &allowed) {
  for (const std::string &name : required)
    app.get_option(name)->required(false);
  const std::vector<CLI::Option *> others = app.get_options();
  CLI::Option *plan =
      app.add_option("--plan", path_, "Build plan of voxc plan: all else stands in it")->type_name("P.plan");
  app.add_option(option, numbers_, summary)->type_name("LIST")->needs(plan);
  plan->needs(app.get_option(option));
  for (CLI::Option *other : others) {
    const auto is = [&](const std::string &name) { return other->check_name(name); };
    if (!is("--help") && std::ranges::none_of(allowed, is))
      plan->excludes(other);
  }
  app.parse_complete_callback([&app, plan, required] {
    for (const std::string &name : required)
      if (plan->count() == 0 && app.get_option(name)->count() == 0)
        throw CLI::RequiredError(name);
  });
}

} // namespace voxc::tool
