// The functions of a kernel: the runtime files that a plan names, in order of use, with each level's
// constants.
#include "KernelFunctions.h"

#include "Names.h"

#include "voxc/Emit/Emit.h"

#include "voxc/Layout/SlotKind.h"

#include <algorithm>

namespace voxc {
namespace {

constexpr const char *kBeforeStep[] = {"ray", "number", "products", "pairs", "crossing"};
constexpr const char *kAfterStep[] = {"step", "near", "enter", "prepare", "root"};

class FunctionEmitter {
public:
  explicit FunctionEmitter(KernelBuilder &builder)
      : builder_(builder), plan_(builder.plan()), levels_(kindOf(plan_.levelTraversal)) {}

  void emit() {
    file("memory/at");
    if (plan_.isOfPoints())
      pointFunctions();
    else
      traversalFunctions();
    builder_.addText("// ---- What follows is the same in every kernel ----\n");
    builder_.endFormat();
  }

private:
  /// A traversal along a ray, and what is asked of its hit.
  void traversalFunctions() {
    for (const char *path : kBeforeStep)
      file(path);
    if (plan_.steps == StepArithmetic::Refined || plan_.arithmetic == Arithmetic::Nearest)
      file("step/compensated");
    else if (plan_.arithmetic == Arithmetic::Ieee)
      file("step/doubles");
    file("step/" + std::string(toString(plan_.precision)));
    for (const char *path : kAfterStep)
      file(path);
    file("time");
    file("entered_face");
    file("arrival");
    if (levels_.nests)
      file("unit");
    if (plan_.stopsAboveVoxels())
      file("detail/cone");
    beginFormat();
    const bool looksUpValues = plan_.layout.ranksVoxels() && storesValue(plan_.outputs);
    if (looksUpValues)
      file("rank/order");
    levels(&FunctionEmitter::level);
    if (isFlat())
      flatTraversal();
    if (levels_.fromRoot)
      file("traversal/direct");
    if (looksUpValues)
      ranks();
    if (storesValue(plan_.outputs))
      file("payload/" + std::string(plan_.outputs.index ? "index" : kindOf(plan_.layout.payload).hit));
  }

  /// One way down from the root.
  void pointFunctions() {
    file("number");
    beginFormat();
    levels(&FunctionEmitter::pointLevel);
  }

  bool isFlat() const { return levels_.isOneLoop && !levels_.fromRoot; }

  void beginFormat() {
    builder_.beginFormat();
    builder_.addText("// ---- The format: " + plan_.layout.format + " ----\n");
    if (hasLayers())
      file("traversal/tree");
    const bool hasFields = plan_.layout.ranksVoxels() && plan_.outputs.colour;
    if (hasFields || plan_.layout.hasArray())
      file("field");
  }

  /// A function stands before its callers: the last level first.
  void levels(void (FunctionEmitter::*write)(std::size_t)) {
    for (std::size_t i = plan_.layout.strata.size(); i-- > 0;)
      (this->*write)(i);
  }

  bool hasLayers() const { return std::ranges::any_of(plan_.layout.strata, &Stratum::hasLayers); }

  /// A file that is written once.
  void file(const std::string &path) { builder_.add(path); }

  /// A file that is written for each level.
  void leaf(std::size_t index, const std::string &path) { builder_.addLevel(path, index); }

  /// A file that is written for each layer of a tree, from the lowest nodes up.
  void layers(std::size_t index, const std::string &path) {
    for (int layer = 1; layer <= plan_.layout.strata[index].depth; ++layer)
      builder_.addLayer(path, index, layer);
  }

  std::string constants(std::size_t index) {
    const Stratum &stratum = plan_.layout.strata[index];
    const std::string prefix = "LEVEL_" + std::to_string(index + 1) + "_";
    const auto number = [&](const char *name, int value) {
      return "const int " + prefix + name + " = " + std::to_string(value) + ";\n";
    };
    const std::string own =
        stratum.isGrid() ? "const ivec3 " + prefix + "LOG2_SIZE = " + intVector(stratum.log2Size()) + ";\n"
                         : number("DEPTH", stratum.depth) + number("BRANCH", stratum.log2Shape.x);
    return own + number("LOG2_CELL", stratum.log2Cell) +
           number("LOG2_SIDE", maxComponent(stratum.log2Size()) + stratum.log2Cell);
  }

  /// What a level's functions speak of: its size, and how a node keeps its children, if there are nodes.
  void beginLevel(std::size_t index) {
    const Stratum &stratum = plan_.layout.strata[index];
    builder_.addText(levelComment(plan_, index));
    builder_.addText(constants(index), false);
    if (!stratum.isGrid())
      leaf(index, "slots/tree");
    if (kindOf(plan_.traversals[index].descent).ofCells)
      return;
    for (const std::string_view file : stratum.slots->accessor(stratum))
      leaf(index, "slots/" + std::string(file));
  }

  void level(std::size_t index) {
    const Stratum &stratum = plan_.layout.strata[index];
    const Traversal &traversal = plan_.traversals[index];
    const DescentKind &descent = kindOf(traversal.descent);
    const bool isSingle = descent.ofCells;
    beginLevel(index);
    if (traversal.sampled)
      leaf(index, isSingle ? "detail/single" : stratum.isGrid() ? "detail/grid" : "detail/tree");
    if (levels_.fromRoot)
      return locate(index);
    if (isFlat() ? reportsBall(stratum) : !descent.keepsNodes && !isSingle)
      leaf(index, "traversal/within");
    if (reportsBall(stratum))
      leaf(index, "traversal/march");
    if (isFlat())
      return;
    if (descent.byLayers)
      layers(index, "traversal/unrolled_node");
    leaf(index, "traversal/" + std::string(toString(traversal.descent)));
  }

  void pointLevel(std::size_t index) {
    beginLevel(index);
    down(index, "point");
  }

  /// The level as a function from a cell to what is there.
  void locate(std::size_t index) { down(index, "traversal/direct"); }

  /// From a voxel to its rank, level by level, and from there to its value if that is asked.
  void ranks() {
    levels(&FunctionEmitter::rank);
    if (plan_.outputs.colour)
      file("values/" + std::string(kindOf(plan_.layout.payload).blocks));
  }

  void rank(std::size_t index) { down(index, "rank"); }

  /// A function that goes straight down through the level, from the files of a folder.
  void down(std::size_t index, const std::string &folder) {
    const Stratum &stratum = plan_.layout.strata[index];
    leaf(index, folder + (stratum.hasLayers() ? "/tree" : stratum.isGrid() ? "/grid" : "/single"));
  }

  /// One loop, and what each level adds to its parts.
  void flatTraversal() {
    file("traversal/flat/path");
    levels(&FunctionEmitter::flatLevel);
    file("traversal/flat");
  }

  void flatLevel(std::size_t index) {
    leaf(index, plan_.layout.strata[index].hasLayers() ? "traversal/flat/tree" : "traversal/flat/cell");
    leaf(index, "traversal/flat/march");
    leaf(index, "traversal/flat/climb");
  }

  KernelBuilder &builder_;
  const Plan &plan_;
  const LevelTraversalKind &levels_;
};

} // namespace

void addKernelFunctions(KernelBuilder &builder) { FunctionEmitter(builder).emit(); }

void addVolumeSize(KernelBuilder &builder) {
  const Int3 log2 = builder.plan().layout.log2Extent();
  builder.addText("// Voxels along each axis.\nconst ivec3 VOLUME_SIZE = " +
                  intVector({1 << log2.x, 1 << log2.y, 1 << log2.z}) + ";\n");
}

} // namespace voxc
