// The passes over plans, in their order.
#include "Passes.h"

#include "voxc/IR/FormatTraits.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace voxc {

template <> struct IrTraits<Plan> {
  static constexpr std::string_view kName = "plan";
  static void verify(const Plan &plan, Diagnostics &diagnostics) { voxc::verify(plan, diagnostics); }
  static std::string print(const Plan &plan) { return printPlan(plan); }
  /// The strata that are traversed otherwise; a plan does not know where they were written.
  static std::vector<SourceRange> changedParts(const Plan &before, const Plan &after) {
    std::vector<SourceRange> changed;
    for (std::size_t i = 0; i < after.traversals.size(); ++i)
      if (i >= before.traversals.size() || before.traversals[i] != after.traversals[i] ||
          before.constructions[i] != after.constructions[i])
        changed.emplace_back();
    return changed;
  }
  static Error errorAt(const Plan &plan, const Diagnostics &diagnostics) {
    return toError(diagnostics, printPlan(plan), "plan");
  }
};

namespace {

constexpr std::array<PlanPass, 15> kPasses = {{
    {"choose-descents", "what layers leave no choice of: a tree without any is one leaf",
     "First: what follows asks how a stratum is traversed, not what it is.", chooseDescents},
    {"choose-traversal",
     "nested loops, one flat loop or a direct one: as asked; else direct from 8 levels on, and where the "
     "first level stores octants above at most 8 layers of nodes, or all others, two at least, are masked "
     "grids of 4 cells a side; but nested where restart-sv, unroll-sv or detail=cone need it",
     "After the descents: they may ask for nesting.", chooseTraversal},
    {"choose-steps",
     "of exact traversals, where the device has doubles: in packets sums of two float32 for steps that one "
     "cannot decide, else doubles for all steps through 2^11 voxels a side and more; float32 everywhere "
     "else, "
     "which relies on arithmetic=nearest there",
     "Anywhere: it asks for nothing that others choose.", chooseSteps},
    {"choose-comparison",
     "the first of the faces ahead is found by the bits of float32; in packets, and of doubles, by comparing "
     "numbers",
     "After the steps, which choose the numbers.", chooseComparison},
    {"choose-speculation",
     "a direct exact traversal reads what is in the next cell before it is known if the step there was sure",
     "After the traversal: others do more between two reads.", chooseSpeculation},
    {"choose-span-faces",
     "on devices the look-ups of a direct traversal make the faces of what they find empty, while they wait; "
     "in packets the step does, once for all levels",
     "After the traversal: in others the step makes them.", chooseSpanFaces},
    {"choose-packet-width",
     "packets are narrow where each of several levels has a loop, in which lanes wait for those in another",
     "After the traversal, which has the loops.", choosePacketWidth},
    {"place-stack", "where the nodes above a cell are kept: as asked, if the traversal keeps any",
     "After the traversal, which may keep none.", placeStack},
    {"place-stops", "where a kernel of detail=cone may stop, and where it then searches a colour",
     "After the descents: a single leaf has no inner node to stop at.", placeStops},
    {"defer-values", "a voxel's value is looked up once it is hit, unless detail=cone stops elsewhere too",
     "Anywhere: it asks for nothing that others choose.", deferValues},
    {"drop-values", "voxels whose values nobody asks for are not read", "Anywhere.", dropValues},
    {"guard-lookups",
     "where the device cuts loops, a traversal asks after each look-up that loops whether it was cut",
     "Anywhere.", guardLookUps},
    {"choose-voxel-steps",
     "nested traversals step over single voxels in a shorter way, where nothing reports more than one",
     "After the traversal and the descents.", chooseVoxelSteps},
    {"choose-bricks", "construction goes through the voxels below a tree by bricks of 8 x 8 x 8",
     "Anywhere: it is of construction alone.", chooseBricks},
    {"choose-look-ahead",
     "construction announces the nodes of a brick that it will compare with those written, but of siblings "
     "and beside ranks",
     "After the bricks, whose nodes they are.", chooseLookAhead},
}};

} // namespace

std::span<const PlanPass> planPasses() { return kPasses; }

const PlanPass *findPlanPass(std::string_view name) {
  const auto found = std::ranges::find(kPasses, name, &PlanPass::name);
  return found == kPasses.end() ? nullptr : &*found;
}

std::optional<Plan> lowerToPlan(const Format &format, const PlanOptions &options,
                                const PipelineOptions &pipeline) {
  const auto lower = [&options](const Format &from) { return lowerToPlan(from, options); };
  return runLowering<Format, Plan>(kLowering, format, lower, pipeline);
}

Expected<void> runPlanPasses(Plan &plan, std::span<const PlanPass *const> passes,
                             const PipelineOptions &options) {
  PassManager<Plan> manager;
  for (const PlanPass *pass : passes)
    manager.add(pass->name, [pass](Plan &ir, Diagnostics &) { pass->run(ir); });
  return manager.run(plan, options);
}

Expected<Plan> makePlan(const Format &format, const PlanOptions &options) {
  Plan plan = lowerToPlan(format, options);
  std::vector<const PlanPass *> all;
  std::ranges::transform(kPasses, std::back_inserter(all), [](const PlanPass &pass) { return &pass; });
  VOXC_TRY(runPlanPasses(plan, all));
  return plan;
}

} // namespace voxc
