// Options that set the attributes of a format as a whole: --precision and its kin, one for each, and
// --outputs for those that are chosen together.
#pragma once

#include "common/CommandLine.h"
#include "voxc/IR/Format.h"

#include <map>
#include <string>
#include <vector>

namespace voxc::tool {

class AttributeOptions {
public:
  /// Adds an option for each traversal attribute of `formatAttributes()`, or for each list of such.
  void declare(const CommandLine &command);

  /// Adds --ray-bounds, for a command whose rays may have bounds.
  void declareBounds(const CommandLine &command);

  /// Sets what was given; the rest stays as `format` says. Error: what was given does not go together.
  Expected<void> apply(Format &format) const;

private:
  void declareList(const CommandLine &command, const AttributeList &list);

  std::map<const AttributeKind *, std::string> values_;              // Empty: not given.
  std::map<const AttributeList *, std::vector<std::string>> listed_; // The same.
  bool bounds_ = false;
};

} // namespace voxc::tool
