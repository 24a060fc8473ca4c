// merge-grids and split-grids: a run of R levels is one grid in meaning, however it is cut.
//
// Contract: merge-grids makes one R level of each run of them; split-grids makes two of each R level with at
// least four cells an axis, the upper one of the larger half. Volumes have other words and the same voxels.
// Merging is left out where the merged grid would take more words than a volume can have; attributes are
// those of the lower level.
#include "voxc/Passes/Pass.h"

#include <algorithm>

namespace voxc {
namespace {

bool isRaw(const Level &level) { return level.kind == findLevelKind('R'); }

Level rawLevel(Int3 log2Size, const Level &like) {
  Level level = like;
  level.parameters.clear();
  for (int axis = 0; axis < 3; ++axis)
    level.parameters.push_back(static_cast<std::uint32_t>(log2Size[axis]));
  return level;
}

bool isValid(const Format &format) {
  Diagnostics diagnostics;
  verify(format, diagnostics);
  return !diagnostics.hasErrors();
}

PassResult replaceIfChanged(Format &format, Format &&result, const char *otherwise,
                            Diagnostics &diagnostics) {
  if (result.levels == format.levels) {
    diagnostics.note({}, otherwise);
    return PassResult::Unchanged;
  }
  format = std::move(result);
  return PassResult::Changed;
}

} // namespace

PassResult mergeGrids(Format &format, Diagnostics &diagnostics) {
  Format merged = format;
  for (std::size_t i = 0; i + 1 < merged.levels.size();) {
    Format next = merged;
    if (isRaw(next.levels[i]) && isRaw(next.levels[i + 1])) {
      next.levels[i] =
          rawLevel(next.levels[i].log2Size() + next.levels[i + 1].log2Size(), next.levels[i + 1]);
      next.levels.erase(next.levels.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
    if (next.levels.size() < merged.levels.size() && isValid(next))
      merged = std::move(next);
    else
      ++i;
  }
  return replaceIfChanged(format, std::move(merged), "no two R levels are neighbours that fit as one",
                          diagnostics);
}

PassResult splitGrids(Format &format, Diagnostics &diagnostics) {
  Format split = format;
  split.levels.clear();
  for (const Level &level : format.levels) {
    const Int3 size = level.log2Size();
    const int lower = std::min({size.x, size.y, size.z}) / 2; // The lower grid is a cube.
    if (isRaw(level) && lower > 0) {
      split.levels.push_back(rawLevel(size - Int3{lower, lower, lower}, level));
      split.levels.push_back(rawLevel({lower, lower, lower}, level));
    } else {
      split.levels.push_back(level);
    }
  }
  return replaceIfChanged(format, std::move(split), "no R level has four cells on each axis", diagnostics);
}

} // namespace voxc
