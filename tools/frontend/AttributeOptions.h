// Options that set the attributes of a format as a whole: --precision and its kin, one for each, and
// --outputs for those that are chosen together.
#pragma once

#include "common/CliNames.h"
#include "voxc/IR/Format.h"

#include <map>
#include <string>
#include <vector>

namespace voxc::tool {

class AttributeOptions {
public:
  /// Adds an option for each walk attribute of `formatAttributes()`, or for each list of such.
  void declare(CLI::App &app);

  /// Adds --ray-bounds, for a command whose rays may have bounds.
  void declareBounds(CLI::App &app);

  /// Sets what was given; the rest stays as `format` says. Error: what was given does not go together.
  Expected<void> apply(Format &format) const;

private:
  void declareList(CLI::App &app, const AttributeList &list);

  std::map<const AttributeKind *, std::string> values_;              // Empty: not given.
  std::map<const AttributeList *, std::vector<std::string>> listed_; // The same.
  bool bounds_ = false;
};

} // namespace voxc::tool
