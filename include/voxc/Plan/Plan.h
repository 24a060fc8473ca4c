// The plan: the layout of a format, and how a kernel goes through it. Every text that voxc generates is
// printed from it, and no emitter makes a choice that is not written here. docs/ir.md has its text.
#pragma once

#include "voxc/IR/Choices.h"
#include "voxc/IR/Format.h"
#include "voxc/IR/Query.h"
#include "voxc/IR/Stack.h"
#include "voxc/Layout/Addressing.h"
#include "voxc/Layout/Layout.h"
#include "voxc/Support/EnumText.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/PassManager.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// The numbers that an exact traversal steps in, until integers have to decide.
enum class StepArithmetic {
  Float32,
  Refined, ///< Float32, and at once sums of two where that is not sure: best where few lanes make a branch
           ///< cheap.
  Float64, ///< Slower, but sure of nearly every step of a long traversal.
};

/// Who puts rays into the lanes of registers.
enum class Packing {
  Device,  ///< The device, for as long as a traversal takes.
  Packets, ///< What runs around the kernel: a traversal is let go when few lanes are still at work, and goes
           ///< on in a packet of such.
};

/// Who makes the faces ahead of what a direct traversal finds empty.
enum class SpanFaces {
  Step,   ///< The step over it: once for all levels.
  Lookup, ///< The look-up that finds it, while it waits for what it reads.
};

/// How a kernel finds which of the faces ahead a ray passes first.
enum class Compare {
  Bits,    ///< By the bits of float32, in the order of integers.
  Numbers, ///< By comparing numbers.
};

/// How many lanes a packet of this processor has.
enum class PacketWidth {
  Wide,   ///< All that registers take.
  Narrow, ///< Half as many.
};

template <>
inline constexpr std::array<std::string_view, 3> kEnumNames<StepArithmetic> = {"float32", "refined",
                                                                               "float64"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Packing> = {"device", "packets"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<SpanFaces> = {"step", "lookup"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Compare> = {"bits", "numbers"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<PacketWidth> = {"wide", "narrow"};

/// How a kernel goes through one stratum; one that looks at points alone goes down from the root.
struct Traversal {
  Descent descent{};  ///< By index.
  bool stops = false; ///< `stopsAboveVoxels`: the traversal may stop at nodes and cells of this stratum.
  bool sampled =
      false; ///< Where it stops, here or above, a colour is searched in sub-volumes of this stratum.
  Loops lookUp = Loops::Whole; ///< `Cut`: a device may end a look-up early, and the kernel asks if it has.
  bool readsValues = true;     ///< Of a full cell its value is read; else no more than that it is there.
  bool voxelSteps =
      false; ///< A nested traversal steps over single voxels here, by a shorter way than over empty spans.

  bool operator==(const Traversal &) const = default;
};

/// How generated construction code makes the nodes of one stratum.
struct Construction {
  bool bricks = false;     ///< Of a tree of voxels: those of 8 x 8 x 8 are read at once, not one by one.
  bool looksAhead = false; ///< The nodes of a brick are announced before they are compared with others.

  bool operator==(const Construction &) const = default;
};

struct Plan {
  Layout layout;
  Addressing addressing = Addressing::Buffer;
  LevelTraversal levelTraversal{}; ///< Still to be chosen.
  Stack stack = Stack::Private;    ///< Of a traversal that keeps one.
  Precision precision{};           ///< Exact.
  StepArithmetic steps = StepArithmetic::Float32;
  Detail detail{}; ///< Down to voxels.
  Query query{};   ///< The closest hit.
  Outputs outputs; ///< Those of the query.
  Loops loops = Loops::Whole;
  Arithmetic arithmetic = Arithmetic::Any;
  Packing packing = Packing::Device;
  bool bounded = false; ///< Rays have a tmin and a tmax, between which voxels are looked for.
  /// A traversal goes on with the cell that a step leads to before it is known if the step was sure, and
  /// looks back if it was not.
  bool speculative = false;
  SpanFaces spanFaces = SpanFaces::Step;
  Compare compare = Compare::Bits;
  PacketWidth packetWidth = PacketWidth::Wide;
  bool defersValues = true;          ///< A voxel's value is looked up once it is hit, not where it is found.
  std::vector<Traversal> traversals; ///< One for each stratum of the layout.
  std::vector<Construction> constructions; ///< The same.

  bool operator==(const Plan &) const = default;

  bool isOfPoints() const { return voxc::isOfPoints(query); }
  bool isExact() const { return precision == Precision::Exact; }
  bool stopsAboveVoxels() const { return detail == Detail::Cone; }
  bool sharesStack() const { return stack == Stack::Shared; }
};

/// What a kernel is made for.
struct PlanOptions {
  Addressing addressing = Addressing::Buffer;
  Loops loops = Loops::Cut; ///< The safe choice, where the device is not known.
  Arithmetic arithmetic = Arithmetic::Any;
  Packing packing = Packing::Device;
  std::optional<Question> question = {}; ///< Asked in place of what the format asks.
  bool inGroups = true;                  ///< Rays come in groups with memory of their own.
};

/// What the kernels of this processor are made for.
inline constexpr PlanOptions kCpuPlan = {
    .loops = Loops::Whole, .arithmetic = Arithmetic::Ieee, .packing = Packing::Packets, .inGroups = false};

/// What functions for the shaders and programs of others are made for, which answer all that can be asked of
/// a ray.
inline constexpr PlanOptions kHeaderPlan = {
    .loops = Loops::Whole, .question = Question{Query::Closest, {.face = true}, true}, .inGroups = false};

/// The same where rays have no bounds.
inline constexpr PlanOptions kFirstHitPlan = {
    .loops = Loops::Whole, .question = Question{Query::Closest, {.face = true}}, .inGroups = false};

/// Lowers a verified format to a plan that says what its attributes ask for, and nothing of what follows from
/// that.
Plan lowerToPlan(const Format &format, const PlanOptions &options = {});

/// A pass over plans: docs/ir.md lists them as `planPasses` does.
struct PlanPass {
  std::string_view name;
  std::string_view summary;
  std::string_view place; ///< Why it stands where it does.
  void (*run)(Plan &plan);
};

/// All of them, in the order in which they run.
std::span<const PlanPass> planPasses();

/// The pass of this name, or null.
const PlanPass *findPlanPass(std::string_view name);

/// What the step from the level IR to a plan is called among passes.
inline constexpr std::string_view kLowering = "lower";

/// `lowerToPlan` as a pass, for those who watch. Nothing if they leave it out.
std::optional<Plan> lowerToPlan(const Format &format, const PlanOptions &options,
                                const PipelineOptions &pipeline);

/// Runs passes over a plan, in this order. Error: one left a wrong plan, a defect of voxc.
Expected<void> runPlanPasses(Plan &plan, std::span<const PlanPass *const> passes,
                             const PipelineOptions &options = {});

/// Makes every choice for a verified format: lowers it and runs all passes, each followed by the verifier. An
/// error here is a defect of voxc and says so.
Expected<Plan> makePlan(const Format &format, const PlanOptions &options = {});

/// Error (`Usage`) if a kernel of this format cannot wait for pages: it stops above voxels, looks at points,
/// or is asked to traverse in another way than down from the root.
Expected<void> checkPaging(const Format &format);

/// Where a plan stands in a text.
struct PlanRanges {
  SourceRange plan;                ///< Its first words.
  std::vector<SourceRange> strata; ///< What each is.

  /// That of a stratum, by index; an empty one if nothing is known of it.
  SourceRange of(std::size_t stratum) const {
    return stratum < strata.size() ? strata[stratum] : SourceRange{};
  }
};

/// Checks the layout's rules, and that traversals, constructions and strata fit. `ranges`, where given, say
/// where each stands.
void verify(const Plan &plan, Diagnostics &diagnostics, const PlanRanges &ranges = {});

/// Checks of a plan that keeps all rules whether it is finished: whether it has all choices without which
/// emitters would make wrong code of it. Those that `makePlan` makes are.
void verifyFinished(const Plan &plan, Diagnostics &diagnostics, const PlanRanges &ranges = {});

/// The plan as text: parsing it gives the same plan, printing that the same text.
std::string printPlan(const Plan &plan);

/// True if a text begins as that of a plan does, and no format can.
bool isPlanText(std::string_view text);

/// Parses plan text; the result is verified, and only meaningful if no error was added to `diagnostics`.
Plan parsePlan(std::string_view text, Diagnostics &diagnostics);

/// Parses the text of a finished plan, for emitters. Errors are rendered with the text's `name`.
Expected<Plan> parseFinishedPlan(std::string_view text, std::string_view name);

} // namespace voxc
