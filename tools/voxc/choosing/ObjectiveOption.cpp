// The objectives by their names.
#include "choosing/ObjectiveOption.h"

#include <map>

namespace voxc::tool {

namespace {

const std::map<std::string, Wish::Objective> kObjectives = {{"balanced", Wish::Objective::Balanced},
                                                            {"fastest", Wish::Objective::Fastest},
                                                            {"smallest", Wish::Objective::Smallest}};

} // namespace

void addObjectiveArgument(const CommandLine &command, std::string &objective, const std::string &what) {
  objective = "balanced";
  std::vector<std::string> names;
  names.reserve(std::size(kObjectives));
  for (const auto &[name, meaning] : kObjectives)
    names.push_back(name);
  command
      .add("--objective", objective,
           what + ": balanced (default; twice the speed is worth four times the bytes), fastest or smallest")
      .takes("WISH")
      .oneOf(names);
}

Wish::Objective objectiveOf(const std::string &name) { return kObjectives.at(name); }

} // namespace voxc::tool
