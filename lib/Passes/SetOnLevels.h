// What the passes that set one attribute have in common.
#pragma once

#include "voxc/Passes/Pass.h"

#include <cstddef>
#include <string_view>

namespace voxc {

/// Sets an attribute on every level from levels[first] on that takes it.
inline PassResult setOnLevels(Format &format, std::size_t first, const AttributeKind &kind,
                              std::string_view value) {
  bool changed = false;
  for (std::size_t i = first; i < format.levels.size(); ++i)
    changed |= format.levels[i].setAttribute(kind, value);
  return changed ? PassResult::Changed : PassResult::Unchanged;
}

} // namespace voxc
