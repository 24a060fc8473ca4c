// The rules of plans: those of the layout, and that each stratum is traversed and constructed in a way that
// it has.
#include "voxc/Plan/Plan.h"

#include "voxc/Layout/SlotKind.h"

namespace voxc {
namespace {

class Verifier {
public:
  Verifier(const Plan &plan, Diagnostics &diagnostics, const PlanRanges &ranges)
      : plan_(plan), diagnostics_(diagnostics), ranges_(ranges) {}

  void run() {
    verify(plan_.layout, diagnostics_, ranges_.strata);
    const std::size_t strata = plan_.layout.strata.size();
    if (plan_.traversals.size() != strata || plan_.constructions.size() != strata)
      return diagnostics_.error(ranges_.plan,
                                "a plan says of each stratum how it is traversed and constructed");
    question();
    traversal();
    choices();
    for (index_ = 0; index_ < strata; ++index_) {
      if (!plan_.layout.strata[index_].slots)
        continue;
      descent(plan_.layout.strata[index_], plan_.traversals[index_]);
      lookUps(plan_.layout.strata[index_], plan_.traversals[index_]);
      construction(plan_.layout.strata[index_], plan_.constructions[index_]);
    }
  }

private:
  /// Notes a problem of the plan unless `holds`.
  void rule(bool holds, const std::string &otherwise) {
    if (!holds)
      diagnostics_.error(ranges_.plan, otherwise);
  }

  /// Notes a problem of the stratum at hand unless `holds`.
  void stratumRule(bool holds, const std::string &otherwise) {
    if (!holds)
      diagnostics_.error(ranges_.of(index_), "stratum " + std::to_string(index_ + 1) + ": " + otherwise);
  }

  bool isOneLoop() const { return kindOf(plan_.levelTraversal).isOneLoop; }

  void question() {
    const std::string_view problem = problemOf({plan_.query, plan_.outputs, plan_.bounded});
    rule(problem.empty(), "the plan " + std::string(problem));
    rule(!plan_.isOfPoints() || (kindOf(plan_.levelTraversal).isOpen &&
                                 plan_.steps == StepArithmetic::Float32 && !plan_.stopsAboveVoxels()),
         "a point is looked up without a traversal, its steps and its detail");
    rule(!plan_.outputs.index || (plan_.layout.ranksVoxels() && !plan_.stopsAboveVoxels()),
         "the numbers of voxels are counted where their values stand apart, with detail=full");
    rule(plan_.addressing != Addressing::Paged || !plan_.isOfPoints(),
         "pages that are not here are what rays wait for, not points");
    rule(!plan_.bounded || !plan_.stopsAboveVoxels(), "a traversal between bounds stops at voxels alone");
  }

  void traversal() {
    rule(!plan_.sharesStack() || plan_.packing != Packing::Packets,
         "rays in packets have no memory of a group: their stack is private");
    rule(!isOneLoop() || !plan_.stopsAboveVoxels(), "one loop for all levels stops at voxels alone");
    rule(plan_.steps == StepArithmetic::Float32 || (plan_.arithmetic == Arithmetic::Ieee && plan_.isExact()),
         "exact traversals alone take doubles, with arithmetic=ieee");
  }

  /// What passes choose for speed alone.
  void choices() {
    const bool isDirect = kindOf(plan_.levelTraversal).fromRoot;
    rule(!plan_.speculative || (isDirect && plan_.isExact()),
         "a traversal looks back at its last step with levels=direct and precision=exact alone");
    rule(plan_.spanFaces == SpanFaces::Step || isDirect,
         "look-ups make the faces of empty spans with levels=direct alone");
    rule(plan_.packetWidth == PacketWidth::Wide || plan_.packing == Packing::Packets,
         "packets are narrow with packing=packets alone");
  }

  void descent(const Stratum &stratum, const Traversal &traversal) {
    stratumRule(stratum.isGrid() == (kindOf(traversal.descent).ofGrids),
                "a grid is traversed by index, and nothing else is");
    stratumRule(!isOneLoop() || !kindOf(traversal.descent).nestsAlone,
                "one loop for all levels goes down trees in its own way");
    stratumRule(!kindOf(traversal.descent).ofCells || stratum.depth == 0,
                "a tree with layers is more than a single cell");
    stratumRule((!traversal.stops && !traversal.sampled) || plan_.stopsAboveVoxels(),
                "traversals stop above voxels with detail=cone alone");
    stratumRule(!traversal.sampled || plan_.outputs.colour, "a colour is searched where one is asked for");
  }

  void lookUps(const Stratum &stratum, const Traversal &traversal) {
    stratumRule(traversal.lookUp == Loops::Whole ||
                    (plan_.loops == Loops::Cut && stratum.slots->lookUpLoops && !plan_.isOfPoints()),
                "look-ups of traversals can be cut where they loop, with loops=cut");
    stratumRule(traversal.readsValues || (plan_.layout.holdsVoxels(index_) && !storesValue(plan_.outputs)),
                "values are left unread where they are those of voxels and nobody asks for them");
    stratumRule(!traversal.voxelSteps ||
                    (kindOf(plan_.levelTraversal).nests && stratum.isGrid() && stratum.log2Cell == 0),
                "a nested traversal steps over voxels in grids of such");
  }

  void construction(const Stratum &stratum, const Construction &construction) {
    stratumRule(!construction.bricks || (plan_.layout.holdsVoxels(index_) && !stratum.isGrid()),
                "trees of voxels are read by bricks, and nothing else is");
    stratumRule(!construction.looksAhead || (construction.bricks && !stratum.hasRecords() && !stratum.ranked),
                "nodes of bricks=yes are announced, but no siblings and none with ranks");
  }

  const Plan &plan_;
  Diagnostics &diagnostics_;
  const PlanRanges &ranges_;
  std::size_t index_ = 0;
};

} // namespace

void verify(const Plan &plan, Diagnostics &diagnostics, const PlanRanges &ranges) {
  Verifier(plan, diagnostics, ranges).run();
}

} // namespace voxc
