// The rules that every layout keeps, whatever made or rewrote it. Those of its slots each kind has itself.
#include "voxc/Layout/Layout.h"

#include "LayoutRules.h"

#include "voxc/Layout/SlotKind.h"

namespace voxc {
namespace {

std::string sizeText(Int3 log2) {
  return "2^" + std::to_string(log2.x) + " x 2^" + std::to_string(log2.y) + " x 2^" + std::to_string(log2.z);
}

class Verifier {
public:
  Verifier(const Layout &layout, Diagnostics &diagnostics, const std::vector<SourceRange> &ranges)
      : layout_(layout), diagnostics_(diagnostics), ranges_(ranges) {}

  void run() {
    if (layout_.strata.empty())
      return diagnostics_.error({}, "the layout has no stratum");
    for (index_ = 0; index_ < layout_.strata.size(); ++index_)
      isSound_ &= shape(layout_.strata[index_]);
    for (index_ = 0; isSound_ && index_ < layout_.strata.size(); ++index_)
      cellSide(layout_.strata[index_]);
    if (!isSound_ || !extent())
      return;
    for (index_ = 0; index_ < layout_.strata.size(); ++index_)
      stratum(layout_.strata[index_]);
    index_ = layout_.strata.size() - 1;
    payload();
  }

private:
  SourceRange rangeOf(std::size_t index) const {
    return index < ranges_.size() ? ranges_[index] : SourceRange{};
  }
  static std::string levelOf(std::size_t index) { return "level " + std::to_string(index + 1); }
  std::string level() const { return levelOf(index_); }

  /// Notes a problem of the stratum at hand unless `holds`.
  bool rule(bool holds, const std::string &otherwise) {
    if (!holds)
      diagnostics_.error(rangeOf(index_), otherwise);
    return holds;
  }

  /// What the rest stands on: slots, and sizes that fit each other.
  bool shape(const Stratum &stratum) {
    if (!rule(stratum.slots != nullptr, level() + " has no slots"))
      return false;
    const Int3 shape = stratum.log2Shape;
    const bool isCube = shape.x == shape.y && shape.y == shape.z;
    return rule(takes(*stratum.slots, stratum.encoding),
                level() + " has " + std::string(stratum.slots->name) + " slots, and what others have") &&
           rule(shape.x >= 0 && shape.y >= 0 && shape.z >= 0 && maxComponent(shape) <= kMaxLog2Extent &&
                    stratum.depth >= 0 && stratum.depth <= kMaxLog2Extent && stratum.log2Cell >= 0,
                "an axis has at most 2^" + std::to_string(kMaxLog2Extent) + " voxels") &&
           rule(!stratum.isGrid() || stratum.depth == 1, "cells that lie inline are those of one layer") &&
           rule(isCube || index_ == 0, level() + " has " + sizeText(stratum.log2Size()) +
                                           " cells; every level but the first must be a cube") &&
           rule(isCube || stratum.depth == 1, "only the one node of a grid may be no cube") &&
           rule(stratum.depth <= 1 || shape.x > 0, "layers of one child each say nothing");
  }

  void cellSide(const Stratum &stratum) {
    const bool isLast = layout_.holdsVoxels(index_);
    const Stratum &below = layout_.strata[isLast ? index_ : index_ + 1];
    const int side = isLast ? 0 : maxComponent(below.log2Size()) + below.log2Cell;
    isSound_ &= rule(stratum.log2Cell == side,
                     "the cells of " + level() + " have 2^" + std::to_string(stratum.log2Cell) +
                         " voxels a side, but what is below has 2^" + std::to_string(side));
  }

  bool extent() {
    const Int3 log2 = layout_.log2Extent();
    if (maxComponent(log2) <= kMaxLog2Extent)
      return true;
    const SourceRange all =
        ranges_.empty() ? SourceRange{} : SourceRange{ranges_.front().begin, ranges_.back().end};
    diagnostics_.error(all, "the levels have " + sizeText(log2) +
                                " voxels in all; an axis may have at most 2^" +
                                std::to_string(kMaxLog2Extent));
    return false;
  }

  void stratum(const Stratum &stratum) {
    const bool isLast = layout_.holdsVoxels(index_);
    rule(stratum.empty() != Empty::Transparent || layout_.alpha == Alpha::Positive,
         "distances in the slots of the last level cannot be distinguished from voxels unless none has an "
         "alpha of 0; state that by alpha=positive (the pass visible-voxels)");
    const std::string name = level() + ", " + stratum.level + ", ";
    rule(!stratum.ranked || stratum.slots->ranks,
         name + "does not count voxels, which values=apart asks for; raw, distance, masked and svdag do");
    rule(!stratum.ranked || !isLast || stratum.implied || !stratum.slots->ranks,
         name + "has no masks that mark voxels, which values=apart asks of the last level; masked has, and "
                "svdag of more than one cell");
    neighbours(stratum);
    rule(stratum.slots->placeBits == 32 || index_ == 0 || layout_.strata[index_ - 1].empty() != Empty::Tagged,
         name + "needs all bits of the references that lead to it, of which distances=in-slot takes some in "
                "the level above; leave out one of both");
    const std::string granules = granuleProblem(layout_, stratum);
    rule(granules.empty(), granules);
    const std::string problem = stratum.slots->problem(stratum);
    rule(problem.empty(), problem);
    const std::string size = sizeProblem(layout_, stratum);
    rule(size.empty(), size);
  }

  void neighbours(const Stratum &stratum) {
    if (const auto problemBelow = stratum.slots->problemBelow) {
      const bool isLast = layout_.holdsVoxels(index_);
      const std::string problem = problemBelow(isLast ? nullptr : &layout_.strata[index_ + 1]);
      const std::size_t named = isLast ? index_ : index_ + 1;
      if (!problem.empty())
        diagnostics_.error(rangeOf(named), levelOf(named) + problem);
    }
  }

  void payload() {
    const PayloadKind &payload = kindOf(layout_.payload);
    rule(layout_.granuleAfter(1) <= std::uint64_t{1} << kMaxLog2Granule,
         "granules have at most 2^" + std::to_string(kMaxLog2Granule) + " words");
    rule(!layout_.ranksVoxels() || payload.varies,
         "voxels of payload=" + layout_.payloadText() +
             " have no values that could stand apart; leave out one of both");
    rule(layout_.ranksVoxels() || payload.inPlace, "voxels of payload=" + layout_.payloadText() +
                                                       " save nothing in the words of cells; their values "
                                                       "stand apart by values=apart (the pass values-apart)");
  }

  const Layout &layout_;
  Diagnostics &diagnostics_;
  const std::vector<SourceRange> &ranges_;
  std::size_t index_ = 0;
  bool isSound_ = true;
};

} // namespace

void verify(const Layout &layout, Diagnostics &diagnostics, const std::vector<SourceRange> &ranges) {
  Verifier(layout, diagnostics, ranges).run();
}

} // namespace voxc
