// Options that set the attributes of a format as a whole: --precision and its kin, one for each.
#pragma once

#include "voxc/IR/Format.h"

#include <CLI/CLI.hpp>

#include <map>
#include <string>

namespace voxc::tool {

class AttributeOptions {
public:
  /// Adds an option for each attribute of `formatAttributes()`.
  void declare(CLI::App &app);

  /// Sets what was given; the rest stays as `format` says.
  void apply(Format &format) const;

private:
  std::map<const AttributeKind *, std::string> values_; // Empty: not given.
};

} // namespace voxc::tool
