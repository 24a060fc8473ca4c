// The rules that every format keeps, whatever made it (docs/formats.md).
#include "voxc/IR/Format.h"
#include "voxc/IR/Limits.h"
#include "voxc/IR/Query.h"
#include "voxc/Layout/Layout.h"
#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <bit>

namespace voxc {
namespace {

std::string sizeText(Int3 log2) {
  return "2^" + std::to_string(log2.x) + " x 2^" + std::to_string(log2.y) + " x 2^" + std::to_string(log2.z);
}

/// Levels of one cell may come again and again.
void refuseLevels(const Format &format, std::size_t most, Diagnostics &diagnostics) {
  std::string message = "the format has " + std::to_string(format.levels.size()) +
                        " levels; it may have at most " + std::to_string(most);
  if (most < kMostLevels)
    message += ", or up to " + std::to_string(kMostLevels) + " where VOXC_MAX_LEVELS allows so many";
  diagnostics.error(format.levels[most].range, std::move(message));
}

void verifyCubic(const Level &level, std::size_t index, Diagnostics &diagnostics) {
  if (index > 0 && !level.isCubic())
    diagnostics.error(level.range, "level " + std::to_string(index + 1) + " has " +
                                       sizeText(level.log2Size()) +
                                       " cells; every level but the first must be a cube");
}

/// A tree's nodes must come out even.
void verifyBranching(const Level &level, Diagnostics &diagnostics) {
  const std::uint32_t branching = level.parameter(ParameterRole::Branching);
  const std::uint32_t side = level.parameter(ParameterRole::Side);
  if (branching > 1 && side % branching != 0)
    diagnostics.error(level.range, "2^" + std::to_string(side) +
                                       " cells a side are no whole number of nodes of 2^" +
                                       std::to_string(branching) + " children a side; a multiple of " +
                                       std::to_string(branching) + " would be");
}

/// A hashed grid's cells must have numbers, and what references lead to must begin where they count.
void verifySlots(const Level &level, int log2Granule, Diagnostics &diagnostics) {
  const Stratum stratum = level.kind->lower(level);
  if (const std::string problem = granuleProblem(stratum, log2Granule); !problem.empty())
    diagnostics.error(level.range, problem);
  if (const std::string problem = stratum.slots->problem(stratum); !problem.empty())
    diagnostics.error(level.range, problem);
}

/// Voxels can be told from distances in empty slots only by their alpha.
void verifyDistances(const Format &format, Diagnostics &diagnostics) {
  const Level &last = format.levels.back();
  if (last.attribute(kDistancesAttribute) == "in-slot" &&
      format.attributes.value(kAlphaAttribute) != "positive")
    diagnostics.error(
        last.range, "distances in the slots of the last level cannot be told from voxels unless none has an "
                    "alpha of 0; state that by alpha=positive (the pass visible-voxels)");
}

/// A layout with nothing but the payload.
Layout payloadOf(const Format &format) {
  Layout layout;
  layout.setPayload(format.attributes.value(kPayloadAttribute));
  return layout;
}

/// Values apart are found by the ranks of voxels, which masks and counts tell.
void verifyValues(const Format &format, Diagnostics &diagnostics) {
  const bool isApart = format.attributes.value(kValuesAttribute) == "apart";
  if (const Layout voxels = payloadOf(format); isApart && !kindOf(voxels.payload).varies)
    diagnostics.error(format.levels.back().range,
                      "voxels of payload=" + voxels.payloadText() +
                          " have no values that could stand apart; leave out one of both");
  else if (!isApart && !kindOf(voxels.payload).inPlace)
    diagnostics.error(
        format.levels.back().range,
        "voxels of payload=" + voxels.payloadText() +
            " save nothing in the words of cells; their values stand apart by values=apart (the "
            "pass values-apart)");
  if (!isApart)
    return;
  for (std::size_t i = 0; i < format.levels.size(); ++i) {
    const Level &level = format.levels[i];
    const Stratum stratum = level.kind->lower(level);
    const std::string name = "level " + std::to_string(i + 1) + ", " + std::string(level.kind->name) + ", ";
    if (!stratum.slots->ranks)
      diagnostics.error(level.range, name +
                                         "does not count voxels, which values=apart asks for; raw, distance, "
                                         "masked and svdag do");
    else if (i + 1 == format.levels.size() && (!stratum.slots->tellsByMasks || stratum.depth == 0))
      diagnostics.error(level.range, name +
                                         "has no masks that tell voxels, which values=apart asks of the last "
                                         "level; svdag and masked have");
  }
}

/// Numbers in place of offsets: of which levels, and in which.
void verifyPointers(const Format &format, Diagnostics &diagnostics) {
  for (std::size_t i = 0; i < format.levels.size(); ++i) {
    const Level &level = format.levels[i];
    if (level.attribute(kPointersAttribute) == "word")
      continue;
    if (format.log2Granule() > 0)
      diagnostics.error(level.range, "level " + std::to_string(i + 1) +
                                         " has short pointers, which lead to an array in 2^32 words, and "
                                         "references cannot count granules; leave out one of both");
    const bool isLast = i + 1 == format.levels.size();
    const bool isMasks =
        !kindOf(payloadOf(format).payload).varies || format.attributes.value(kValuesAttribute) == "apart";
    if (!isLast || !isMasks || level.log2Size() != Int3{2, 2, 2} || i == 0 ||
        format.levels[i - 1].kind != level.kind) {
      diagnostics.error(level.range, "level " + std::to_string(i + 1) +
                                         " has short pointers, which lead to the last level alone: masked(2, "
                                         "2, 2) below another masked level, with payload=occupancy, "
                                         "payload=constant or values=apart");
      continue;
    }
    const Int3 above = format.levels[i - 1].log2Size();
    if (above.x + above.y + above.z > kMaxLog2IndexedCells)
      diagnostics.error(format.levels[i - 1].range,
                        "level " + std::to_string(i) + " has more than 2^" +
                            std::to_string(kMaxLog2IndexedCells) +
                            " cells, too many for short pointers; two masked levels in its place would do");
  }
}

/// Counts of voxels for octants alone: of which numbers.
void verifyCounts(const Format &format, Diagnostics &diagnostics) {
  for (std::size_t i = 0; i < format.levels.size(); ++i) {
    const Level &level = format.levels[i];
    if (level.attribute(kCountsAttribute) == "each")
      continue;
    if (level.attribute(kPointersAttribute) == "word" ||
        format.attributes.value(kValuesAttribute) != "apart" || i == 0 ||
        format.levels[i - 1].log2Size() != Int3{2, 2, 2})
      diagnostics.error(level.range, "level " + std::to_string(i + 1) +
                                         " has counts of octants, which stand behind short pointers in a "
                                         "masked(2, 2, 2), with values=apart");
  }
}

/// Masks by octants: of which sub-volumes.
void verifyMasks(const Format &format, Diagnostics &diagnostics) {
  for (std::size_t i = 0; i < format.levels.size(); ++i)
    if (const Level &level = format.levels[i];
        level.attribute(kMasksAttribute) != "whole" && level.attribute(kPointersAttribute) == "word")
      diagnostics.error(level.range, "level " + std::to_string(i + 1) +
                                         " has masks by octants, which stand where short pointers lead to");
}

/// What is stored is chosen for the closest hit alone.
void verifyQuestion(const Format &format, Diagnostics &diagnostics) {
  if (const std::string_view problem = problemOfQuestion(format); !problem.empty())
    diagnostics.error({format.levels.front().range.begin, format.levels.back().range.end},
                      "the format " + std::string(problem));
}

/// A grid whose slots alone need more words than references reach cannot hold even one voxel.
void verifyWords(const Level &level, int log2Granule, Diagnostics &diagnostics) {
  const Stratum stratum = level.kind->lower(level);
  const std::uint64_t words = stratum.slots->leastWords(stratum);
  // So many words would leave none for the root's reference.
  const int log2Most = std::bit_width(kMaxWords) - 1 + log2Granule;
  if (words >> log2Most == 0)
    return;
  const Int3 size = level.log2Size();
  std::string message = "one sub-volume of " + sizeText(size) + " cells takes 2^" +
                        std::to_string(std::bit_width(words) - 1) + " words; a volume holds fewer than 2^" +
                        std::to_string(log2Most);
  if (const int needed = std::bit_width(words) - std::bit_width(kMaxWords) + 1; needed <= kMaxLog2Granule)
    message += ", or more with granule=" + std::to_string(1 << needed) + " in IR text";
  const auto isPower = [](std::int32_t n) { return n > 1 && (n & (n - 1)) == 0; };
  if (isPower(size.x) && isPower(size.y) && isPower(size.z))
    message += " (sizes are log2: " + std::to_string(size.x) + " cells are written " +
               std::to_string(std::bit_width(static_cast<std::uint32_t>(size.x)) - 1) + ")";
  diagnostics.error(level.range, message);
}

void verifyExtent(const Format &format, Diagnostics &diagnostics) {
  const Int3 extent = format.log2Extent();
  const int longest = std::max({extent.x, extent.y, extent.z});
  if (longest > kMaxLog2Extent)
    diagnostics.error({format.levels.front().range.begin, format.levels.back().range.end},
                      "the levels have " + sizeText(extent) + " voxels in all; an axis may have at most 2^" +
                          std::to_string(kMaxLog2Extent));
}

} // namespace

void verify(const Format &format, Diagnostics &diagnostics) {
  if (format.levels.empty())
    return diagnostics.error({}, "the format has no level");
  if (const std::size_t most = allowedLevels(); format.levels.size() > most)
    return refuseLevels(format, most, diagnostics);
  for (std::size_t i = 0; i < format.levels.size(); ++i) {
    verifyCubic(format.levels[i], i, diagnostics);
    verifyBranching(format.levels[i], diagnostics);
    verifySlots(format.levels[i], format.log2Granule(), diagnostics);
    verifyWords(format.levels[i], format.log2Granule(), diagnostics);
  }
  verifyDistances(format, diagnostics);
  verifyValues(format, diagnostics);
  verifyPointers(format, diagnostics);
  verifyCounts(format, diagnostics);
  verifyMasks(format, diagnostics);
  verifyQuestion(format, diagnostics);
  verifyExtent(format, diagnostics);
}

} // namespace voxc
