// The objectives by their names.
#include "choosing/ObjectiveOption.h"

namespace voxc::tool {

void addObjectiveArgument(const CommandLine &command, std::string &objective, const std::string &what) {
  objective = "balanced";
  command
      .add("--objective", objective,
           what + ": balanced (default; twice the speed is worth four times the bytes), fastest or smallest")
      .takes("WISH")
      .oneOf({kEnumNames<Wish::Objective>.begin(), kEnumNames<Wish::Objective>.end()});
}

Wish::Objective objectiveOf(const std::string &name) { return *fromString<Wish::Objective>(name); }

} // namespace voxc::tool
