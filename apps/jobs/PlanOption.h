// The options --plan of the commands that are tasks of a build plan: all that they need stands in the plan.
#pragma once

#include "common/CommandLine.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxc::tool {

class PlanOption {
public:
  /// Adds --plan and `option`, which says what of the plan is asked for, to a command that has all other
  /// options. Those of `required` are needed without a plan; with one, none is allowed but those of
  /// `allowed`.
  void declare(const CommandLine &command, const std::string &option, const std::string &summary,
               const std::vector<std::string> &required, const std::vector<std::string> &allowed);

  bool isGiven() const { return !path_.empty(); }
  const std::string &path() const { return path_; }
  /// "0,3,5-9".
  const std::string &numbers() const { return numbers_; }

private:
  std::string path_;
  std::string numbers_;
};

} // namespace voxc::tool
