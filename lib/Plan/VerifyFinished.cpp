// The rules of finished plans: no choice is left of which emitters would make wrong code.
#include "voxc/Plan/Plan.h"

#include "voxc/IR/Limits.h"
#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <cctype>

namespace voxc {
namespace {

class FinishedVerifier {
public:
  FinishedVerifier(const Plan &plan, Diagnostics &diagnostics, const PlanRanges &ranges)
      : plan_(plan), diagnostics_(diagnostics), ranges_(ranges) {}

  void run() {
    text();
    traversal();
    for (index_ = 0; index_ < plan_.layout.strata.size(); ++index_) {
      descent();
      stops();
      construction();
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

  /// Emitted text has the format in comments and in strings.
  void text() {
    const auto fits = [](unsigned char c) {
      return std::isalnum(c) ||
             std::string_view("(), ^").find(static_cast<char>(c)) != std::string_view::npos;
    };
    const std::string &format = plan_.layout.format;
    rule(std::ranges::all_of(format, fits) && !format.empty() &&
             std::isalpha(static_cast<unsigned char>(format.front())),
         "the format in quotation marks is written as 'R(4, 4, 4) G(8)' is");
    rule(plan_.layout.strata.size() <= allowedLevels(),
         "a plan has at most " + std::to_string(allowedLevels()) + " strata");
  }

  void traversal() {
    rule(plan_.isOfPoints() || !kindOf(plan_.levelTraversal).isOpen,
         "levels=auto is not chosen yet: write levels=nested, flat or direct, or run voxc-opt on it");
    rule(plan_.addressing != Addressing::Paged || kindOf(plan_.levelTraversal).fromRoot,
         "rays wait for pages with levels=direct alone");
    rule(plan_.steps != StepArithmetic::Float64 || plan_.compare == Compare::Numbers,
         "doubles are compared as numbers: compare=numbers");
    rule(!plan_.stopsAboveVoxels() || !storesValue(plan_.outputs) || !plan_.defersValues,
         "a traversal that stops above voxels has a colour from each stop: defers-values=no");
  }

  void descent() {
    const Stratum &stratum = plan_.layout.strata[index_];
    stratumRule(stratum.isGrid() || stratum.depth > 0 || kindOf(plan_.traversals[index_].descent).ofCells,
                "a tree without layers is one leaf: traversal=single");
    stratumRule(plan_.loops == Loops::Whole || !stratum.slots->lookUpLoops || plan_.isOfPoints() ||
                    plan_.traversals[index_].lookUp == Loops::Cut,
                "with loops=cut the device may cut its look-ups: lookup=cut");
  }

  /// Where a traversal stops, a colour is searched in what is below.
  void stops() {
    const Stratum &stratum = plan_.layout.strata[index_];
    const Traversal &traversal = plan_.traversals[index_];
    if (!plan_.outputs.colour)
      return;
    const bool hasInnerNodes = !stratum.isGrid() && stratum.depth > 0;
    stratumRule(!traversal.stops || !hasInnerNodes || traversal.sampled,
                "a traversal stops at its nodes, and a colour is searched there: sampled=yes");
    const bool asksBelow = (traversal.stops || traversal.sampled) && !plan_.layout.holdsVoxels(index_);
    stratumRule(!asksBelow || plan_.traversals[index_ + 1].sampled,
                "a colour is searched in the next stratum too: sampled=yes there");
  }

  void construction() {
    const Stratum &stratum = plan_.layout.strata[index_];
    stratumRule(!stratum.ranked || stratum.isGrid() || !plan_.layout.holdsVoxels(index_) ||
                    plan_.constructions[index_].bricks,
                "voxels with ranks are counted as bricks are read: bricks=yes");
  }

  const Plan &plan_;
  Diagnostics &diagnostics_;
  const PlanRanges &ranges_;
  std::size_t index_ = 0;
};

} // namespace

void verifyFinished(const Plan &plan, Diagnostics &diagnostics, const PlanRanges &ranges) {
  FinishedVerifier(plan, diagnostics, ranges).run();
}

} // namespace voxc
