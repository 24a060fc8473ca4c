// The objectives by their names.
#include "search/ObjectiveOption.h"

#include <CLI/CLI.hpp>

#include <map>

namespace voxc::tool {

namespace {

const std::map<std::string, Wish::Objective> kObjectives = {{"balanced", Wish::Objective::Balanced},
                                                            {"fastest", Wish::Objective::Fastest},
                                                            {"smallest", Wish::Objective::Smallest}};

} // namespace

void addObjectiveArgument(CLI::App &app, std::string &objective, const std::string &what) {
  objective = "balanced";
  app.add_option(
         "--objective", objective,
         what + ": balanced (default; twice the speed is worth four times the bytes), fastest or smallest")
      ->type_name("WISH")
      ->check(CLI::IsMember(kObjectives).description(""));
}

Wish::Objective objectiveOf(const std::string &name) { return kObjectives.at(name); }

} // namespace voxc::tool
