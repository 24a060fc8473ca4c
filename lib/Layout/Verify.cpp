// The rules that every layout keeps, whatever made or rewrote it.
#include "voxc/Layout/Layout.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>

namespace voxc {
namespace {

class Verifier {
public:
  Verifier(const Layout &layout, Diagnostics &diagnostics, const std::vector<SourceRange> &ranges)
      : layout_(layout), diagnostics_(diagnostics), ranges_(ranges) {}

  void run() {
    if (layout_.strata.empty())
      return diagnostics_.error({}, "the layout has no stratum");
    for (index_ = 0; index_ < layout_.strata.size(); ++index_)
      stratum(layout_.strata[index_]);
    index_ = layout_.strata.size() - 1;
    const PayloadKind &payload = kindOf(layout_.payload);
    rule(layout_.values == Values::InPlace || payload.varies,
         "voxels without a colour each have no values that could stand apart");
    rule(layout_.values == Values::Apart || payload.inPlace,
         "payload=" + layout_.payloadText() + " saves nothing in the words of cells; its values stand apart");
  }

private:
  /// Notes a problem of the stratum at hand unless `holds`.
  void rule(bool holds, const std::string &otherwise) {
    if (!holds)
      diagnostics_.error(index_ < ranges_.size() ? ranges_[index_] : SourceRange{},
                         "stratum " + std::to_string(index_ + 1) + ": " + otherwise);
  }

  void stratum(const Stratum &stratum) {
    if (!stratum.slots)
      return rule(false, "it has no slots");
    shape(stratum);
    cells(stratum);
    distances(stratum);
    indices(stratum);
    granules(stratum);
    const std::string problem = stratum.slots->problem(stratum);
    rule(problem.empty(), problem);
  }

  void shape(const Stratum &stratum) {
    const Int3 shape = stratum.log2Shape;
    const bool isCube = shape.x == shape.y && shape.y == shape.z;
    rule(shape.x >= 0 && shape.y >= 0 && shape.z >= 0 && longest(shape) <= kMaxLog2Extent &&
             stratum.depth >= 0 && stratum.depth <= kMaxLog2Extent && stratum.log2Cell >= 0 &&
             longest(stratum.log2Size()) + stratum.log2Cell <= kMaxLog2Extent,
         "an axis has at most 2^" + std::to_string(kMaxLog2Extent) + " voxels");
    rule(isCube || (stratum.depth == 1 && index_ == 0),
         "only the one node of the first stratum may be no cube");
    rule(stratum.depth == 1 || shape.x > 0 || stratum.depth == 0, "layers of one child each say nothing");
    const bool isLast = index_ + 1 == layout_.strata.size();
    const int below =
        isLast ? 0 : longest(layout_.strata[index_ + 1].log2Size()) + layout_.strata[index_ + 1].log2Cell;
    rule(stratum.log2Cell == below, "its cells have 2^" + std::to_string(stratum.log2Cell) +
                                        " voxels a side, but what is below has 2^" + std::to_string(below));
  }

  void cells(const Stratum &stratum) {
    rule(!stratum.isGrid() || stratum.depth == 1, "cells that lie inline are those of one layer");
    rule(stratum.isGrid() != stratum.leaves,
         "children may be leaves where cells lie outside their node, and only there");
    const bool isApart = layout_.values == Values::Apart;
    rule(!stratum.implied || (layout_.holdsVoxels(index_) && (!kindOf(layout_.payload).varies || isApart) &&
                              stratum.slots->tellsByMasks && stratum.depth > 0),
         "values are implied where cells are voxels of payload=occupancy, payload=constant or values=apart, "
         "which "
         "masks tell");
    rule(!isApart || stratum.implied || !layout_.holdsVoxels(index_),
         "values stand apart where masks tell the voxels, as those of svdag and masked do");
    rule(stratum.ranked == isApart, "voxels have ranks where their values stand apart, and only there");
    rule(!stratum.ranked || stratum.slots->ranks,
         std::string(stratum.slots->name) + " slots do not count voxels, which values apart ask for");
  }

  void indices(const Stratum &stratum) {
    rule(stratum.counts == Counts::Each ||
             (stratum.isIndexed() && stratum.ranked && stratum.log2Shape == Int3{2, 2, 2}),
         "counts of octants stand behind the numbers of ranked grids of 4 x 4 x 4 cells");
    const Stratum *const above = index_ > 0 ? &layout_.strata[index_ - 1] : nullptr;
    rule(stratum.isInOctants() == (above && above->isIndexed() && above->grids == Grids::Octants) &&
             (!stratum.isInOctants() ||
              (stratum.slots->name == "octants" && stratum.arrayHead == above->arrayHead)),
         "grids stand by octants in the array that the numbers above lead to");
    rule(stratum.isIndexed() || stratum.grids == Grids::Masks, "numbers lead to grids by octants");
    if (!stratum.isIndexed())
      return;
    const Stratum *const below = layout_.holdsVoxels(index_) ? nullptr : &layout_.strata[index_ + 1];
    rule(stratum.indexBits >= 1 && stratum.indexBits <= 31 && stratum.isGrid() && stratum.slots->indexes,
         "numbers of 1 to 31 bits stand in the slots of masked grids");
    rule(below && below->isGrid() && below->implied && below->slots && below->log2Shape == Int3{2, 2, 2},
         "numbers lead to grids of 4 x 4 x 4 voxels that are masks alone");
    rule(stratum.log2Children() <= kMaxLog2IndexedCells,
         "numbers stand in grids of at most 2^" + std::to_string(kMaxLog2IndexedCells) + " cells");
    rule(stratum.arrayHead + 1 == static_cast<int>(layout_.headWords()),
         "the array that numbers lead to is told by the last word of the head");
  }

  void granules(const Stratum &stratum) {
    const int log2 = layout_.log2Granule;
    rule(log2 >= 0 && log2 <= kMaxLog2Granule,
         "granules have at most 2^" + std::to_string(kMaxLog2Granule) + " words");
    const std::string problem = granuleProblem(stratum, std::clamp(log2, 0, kMaxLog2Granule));
    rule(problem.empty(), problem);
  }

  void distances(const Stratum &stratum) {
    const bool inSlot = stratum.empty != Empty::Zero;
    const bool isLast = layout_.holdsVoxels(index_);
    rule((stratum.skip != Skip::None) == (stratum.reach > 0), "a reach goes with distances");
    rule(stratum.skip != Skip::Octant || stratum.reach < 1u << stratum.fieldBits(),
         "a reach of " + std::to_string(stratum.reach) + " does not fit into " +
             std::to_string(stratum.fieldBits()) + " bits, which an octant has");
    rule(!inSlot || stratum.skip != Skip::None, "empty slots that are not 0 hold distances");
    rule(stratum.empty != Empty::Tagged || !isLast, "references can be told by a tag, voxels cannot");
    rule(stratum.empty != Empty::Transparent || (isLast && layout_.alpha == Alpha::Positive),
         "voxels can be told by their alpha where none has an alpha of 0, references cannot");
    rule(!inSlot || stratum.skip != Skip::L1 ||
             stratum.reach < (stratum.empty == Empty::Tagged ? 1u << 31 : 1u << 24),
         "a reach of " + std::to_string(stratum.reach) + " does not fit into an empty slot");
    rule(stratum.skip == Skip::None || (stratum.isGrid() && stratum.slots->keepsEmpty),
         "distances stand in slots that empty cells have too");
  }

  const Layout &layout_;
  Diagnostics &diagnostics_;
  const std::vector<SourceRange> &ranges_;
  std::size_t index_ = 0;
};

/// log2 of the most cells of a grid whose masks tell them, where references count granules: all its slots, of
/// two words each, and its mask are `kMaxNodeWords` at most.
constexpr int kMaxLog2MaskedCells = 30;

} // namespace

std::string granuleProblem(const Stratum &stratum, int log2Granule) {
  if (log2Granule == 0)
    return {};
  const std::string granules = "granules of " + std::to_string(1 << log2Granule) + " words";
  if (stratum.slots->sharesBlocks &&
      stratum.slots->leastWords(stratum) % (std::uint64_t{1} << log2Granule) != 0)
    return "its records, of " + std::to_string(stratum.slots->leastWords(stratum)) +
           " words each, stand side by side and would not begin at " + granules +
           "; granule=2, or svdag in place of svo, would do";
  if (stratum.isIndexed())
    return "short pointers lead to an array in 2^32 words, and references cannot count " + granules +
           "; leave out one of both";
  if (stratum.isGrid() && stratum.slots->tellsByMasks && stratum.log2Children() > kMaxLog2MaskedCells)
    return "a masked grid has at most 2^" + std::to_string(kMaxLog2MaskedCells) +
           " cells where references count " + granules + "; two masked levels in its place would do";
  return {};
}

void verify(const Layout &layout, Diagnostics &diagnostics, const std::vector<SourceRange> &ranges) {
  Verifier(layout, diagnostics, ranges).run();
}

} // namespace voxc
