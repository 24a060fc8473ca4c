// Counting voxels, at full resolution or a coarser one.
#include "cluster/CubeCosts.h"

#include <algorithm>
#include <array>
#include <bit>

namespace voxc::tool::cluster {
namespace {

/// Cubes along an axis are at most 2^this: the table of costs stays small.
constexpr int kLog2MostCubes = 7;
constexpr int kLog2Brick = 3;

/// Meshes are looked at with voxels of 2^this times the size. A surface that goes through such a voxel has
/// about so many in it.
constexpr int kLog2Coarser = 3;
constexpr std::uint64_t kVoxelsInCoarse = 80;
/// Below this many voxels on the longest axis, all are counted.
constexpr int kSmallestEstimated = 512;

/// What it takes to put a voxel into a volume, what more if its colour is another than that of the voxel
/// before it, so that less is shared, and to look whether a triangle makes voxels of a chunk: in the same
/// unit, about 50 ns (docs/cluster.md).
constexpr std::uint64_t kVoxelCost = 1;
constexpr std::uint64_t kColourCost = 2;
constexpr std::uint64_t kRecordCost = 8;

int longestEdge(Int3 extent) { return std::max({extent.x, extent.y, extent.z, 1}); }
int log2Ceil(int value) { return std::bit_width(static_cast<unsigned>(value) - 1); }
Int3 childLow(const Cube &cube, int child) {
  return cube.low + Int3{child & 1, child >> 1 & 1, child >> 2} * (1 << (cube.log2Side - 1));
}

/// The voxels of a brick, and how often the colour of one is not that of the one before it, in Morton order.
struct BrickCount {
  std::uint64_t voxels = 0;
  std::uint64_t colours = 0;
};

/// Calls `visit(low, count)` for each brick of a source that has any, in Morton order.
template <typename Visit>
Expected<void> forEachBrick(VoxelSource &source, const Cube &cube, const Progress &progress, Visit &visit) {
  VOXC_TRY(progress.check());
  if (source.empty(cube))
    return {};
  if (cube.log2Side > kLog2Brick) {
    for (int child = 0; child < 8; ++child)
      if (auto visited = forEachBrick(source, {childLow(cube, child), cube.log2Side - 1}, progress, visit);
          !visited)
        return visited;
    return {};
  }
  std::array<std::uint32_t, 1 << 3 * kLog2Brick> words{};
  VOXC_TRY(source.read(cube, words.data()));
  BrickCount count;
  std::uint32_t before = 0;
  for (const std::uint32_t word : words) {
    if (word == 0)
      continue;
    ++count.voxels;
    count.colours += word != before ? 1 : 0;
    before = word;
  }
  visit(cube.low, count);
  return {};
}

/// Adds the voxels of a source, of which each stands for `weight`, and is 2^log2Coarser times as large as
/// those that costs are for.
Expected<void> addVoxels(VoxelSource &source, int log2Coarser, std::uint64_t weight, const Progress &progress,
                         CubeCosts &costs) {
  const Cube all = {{}, std::max(log2Ceil(longestEdge(source.extent())), kLog2Brick)};
  const int shift = std::max(costs.log2Side - log2Coarser, 0);
  const auto visit = [&](Int3 low, const BrickCount &count) {
    const std::uint64_t code = mortonCode(low >> shift);
    progress.at("count", static_cast<double>(code) / static_cast<double>(costs.costs.size()));
    costs.costs[std::min<std::uint64_t>(code, costs.costs.size() - 1)] +=
        weight * (kVoxelCost * count.voxels + kColourCost * count.colours);
    costs.voxels += weight * count.voxels;
  };
  return forEachBrick(source, all, progress, visit);
}

/// Opens a mesh with fewer, larger voxels.
Expected<Input> openCoarse(const std::string &name, InputOptions options, Int3 extent) {
  options.resolution = std::max(longestEdge(extent) >> kLog2Coarser, 1);
  const int holds = 2 * options.resolution;
  options.formatExtent = {holds, holds, holds};
  return openInput(name, options);
}

void addRecords(const VoxelSource &source, CubeCosts &costs) {
  for (std::uint64_t i = 0; i < costs.costs.size(); ++i) {
    const Cube cube = {mortonCell(i) * (1 << costs.log2Side), costs.log2Side};
    if (!contains(source.extent(), cube.low))
      continue;
    const std::uint64_t records = source.records(cube);
    costs.costs[i] += kRecordCost * records;
    costs.records += records;
  }
}

} // namespace

Expected<CubeCosts> predictCosts(const Input &input, const std::string &name, const InputOptions &options,
                                 int log2Side) {
  VoxelSource &source = *input.source;
  const int whole = log2Ceil(longestEdge(source.extent()));
  CubeCosts costs;
  costs.log2Side = std::max(log2Side, whole - kLog2MostCubes);
  costs.costs.resize(std::size_t{1} << 3 * std::max(whole - costs.log2Side, 0));
  const bool isMesh = input.triangles > 0 && !input.isCropped && input.interior == Interior::Keep;
  if (!isMesh || longestEdge(source.extent()) < kSmallestEstimated) {
    const std::unique_ptr<VoxelSource> view = source.view();
    VOXC_TRY(addVoxels(view ? *view : source, 0, 1, options.progress, costs));
  } else {
    auto coarse = VOXC_TRY(openCoarse(name, options, source.extent()));
    if (auto added = addVoxels(*coarse.source, kLog2Coarser, kVoxelsInCoarse, options.progress, costs);
        !added)
      return added.error();
  }
  addRecords(source, costs);
  return costs;
}

} // namespace voxc::tool::cluster
