// What passes changed of a format, and what they found wrong in it.
#include "voxc/IR/FormatTraits.h"

namespace voxc {

std::vector<SourceRange> IrTraits<Format>::changedParts(const Format &before, const Format &after) {
  const bool areAsMany = before.levels.size() == after.levels.size();
  std::vector<SourceRange> changed;
  for (std::size_t i = 0; i < after.levels.size(); ++i)
    if (!areAsMany || !(before.levels[i] == after.levels[i]))
      changed.push_back(after.levels[i].range);
  return changed;
}

Error IrTraits<Format>::errorAt(const Format &format, const Diagnostics &diagnostics) {
  if (format.source)
    return toError(diagnostics, *format.source);
  return toError(diagnostics, toString(format), "format");
}

} // namespace voxc
