// The rules that every format keeps, whatever made it (docs/formats.md): those of the layout that it is
// lowered to, and of what is lost on the way.
#include "voxc/IR/Format.h"
#include "voxc/IR/Limits.h"
#include "voxc/IR/Query.h"
#include "voxc/Layout/Layout.h"

#include <vector>

namespace voxc {
namespace {

/// Levels of one cell may come again and again.
void refuseLevels(const Format &format, std::size_t most, Diagnostics &diagnostics) {
  std::string message = "the format has " + std::to_string(format.levels.size()) +
                        " levels; it may have at most " + std::to_string(most);
  if (most < kMostLevels)
    message += ", or up to " + std::to_string(kMostLevels) + " where VOXC_MAX_LEVELS allows so many";
  diagnostics.error(format.levels[most].range, std::move(message));
}

/// A tree's nodes must come out even.
bool verifyBranching(const Level &level, Diagnostics &diagnostics) {
  const std::uint32_t branching = level.parameter(ParameterRole::Branching);
  const std::uint32_t side = level.parameter(ParameterRole::Side);
  const bool isEven = branching <= 1 || side % branching == 0;
  if (!isEven)
    diagnostics.error(level.range, "2^" + std::to_string(side) +
                                       " cells a side are no whole number of nodes of 2^" +
                                       std::to_string(branching) + " children a side; a multiple of " +
                                       std::to_string(branching) + " would be");
  return isEven;
}

/// What is stored is chosen for the closest hit alone.
void verifyQuestion(const Format &format, Diagnostics &diagnostics) {
  if (const std::string_view problem = problemOfQuestion(format); !problem.empty())
    diagnostics.error({format.levels.front().range.begin, format.levels.back().range.end},
                      "the format " + std::string(problem));
}

} // namespace

void verify(const Format &format, Diagnostics &diagnostics) {
  if (format.levels.empty())
    return diagnostics.error({}, "the format has no level");
  if (const std::size_t most = allowedLevels(); format.levels.size() > most)
    return refuseLevels(format, most, diagnostics);
  bool isLowered = true;
  std::vector<SourceRange> ranges;
  for (const Level &level : format.levels) {
    isLowered &= verifyBranching(level, diagnostics);
    ranges.push_back(level.range);
  }
  if (isLowered)
    verify(lowerLevels(format, diagnostics), diagnostics, ranges);
  verifyQuestion(format, diagnostics);
}

} // namespace voxc
