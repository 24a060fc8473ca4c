// Sorting the triangles of a scene into chunks.
#include "Mesh/Voxelize/MeshVoxels.h"

#include "Mesh/Solid/Facing.h"
#include "Mesh/Voxelize/RegionFilter.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace voxc {

namespace {

/// Triangles between two looks at memory and whether to stop, and between two words on the progress.
constexpr std::uint64_t kStep = 64;
constexpr std::uint64_t kProgressStep = 1 << 14;

/// A box around the chunks that will be asked for.
CellRange chunksOf(Int3 extent, std::span<const std::array<Int3, 2>> regions, int log2Chunk) {
  const CellRange all{{}, ((extent - Int3{1, 1, 1}) >> log2Chunk) + Int3{1, 1, 1}};
  if (regions.empty())
    return all;
  CellRange chunks{all.high, all.low};
  for (const auto &[low, high] : regions)
    for (int axis = 0; axis < 3; ++axis) {
      const int last = (high[axis] - 1) >> log2Chunk;
      chunks.low[axis] = std::min(chunks.low[axis], std::max(low[axis] >> log2Chunk, 0));
      chunks.high[axis] = std::max(chunks.high[axis], std::min(last + 1, all.high[axis]));
    }
  return chunks;
}

/// The chunks that are filled, and the triangles that may touch them.
struct Region {
  CellRange chunks;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> triangles;
};

/// Calls `visit(chunk, triangle)` for each triangle and each bin's chunk that it touches. This is one half of
/// the work, `done` of which is done.
template <typename Visit>
Expected<void> forEachChunk(const MeshVoxels &mesh, const Region &region, double done, Visit visit) {
  const CellShape shape = CellShape::cube(mesh.model.grid.bits() + mesh.bins.log2Chunk());
  const std::uint64_t count = mesh.model.numbers.size();
  TriangleCursor cursor(*mesh.scene, mesh.model.numbers);
  std::vector<CellMask> masks;
  for (const auto &[first, end] : region.triangles)
    for (std::uint64_t number = first; number < end; ++number) {
      if (number % kStep == 0) {
        VOXC_TRY(mesh.progress.check());
        mesh.memory->relieve();
      }
      if (number % kProgressStep == 0)
        mesh.progress.at("bin", done + 0.5 * static_cast<double>(number) / static_cast<double>(count));
      cursor.moveTo(number);
      const std::array<glm::dvec3, 3> corners = cursor.corners();
      if (cursor.isCollapsed(corners))
        continue;
      coverCells(mesh.model.snapped(corners), shape, region.chunks, masks);
      for (const CellMask &mask : masks)
        forEachCell(mask, [&](Int3 chunk) { visit(chunk, static_cast<std::uint32_t>(number)); });
    }
  return {};
}

Expected<void> fill(ChunkBins<std::uint32_t> &bins, const MeshVoxels &mesh, const Region &region) {
  const auto count = [&](Int3 chunk, std::uint32_t) { bins.count(chunk); };
  VOXC_TRY(forEachChunk(mesh, region, 0, count));
  VOXC_TRY(bins.allocate());
  return forEachChunk(mesh, region, 0.5,
                      [&](Int3 chunk, std::uint32_t number) { bins.place(chunk, number); });
}

} // namespace

Expected<std::shared_ptr<const MeshVoxels>> MeshVoxels::open(std::shared_ptr<const TriangleScene> scene,
                                                             const VoxelizeOptions &options,
                                                             const std::shared_ptr<WorkingMemory> &memory,
                                                             const MeshTuning &tuning) {
  auto model = VOXC_TRY(MeshModel::open(*scene, options, memory.get()));
  using Bins = ChunkBins<std::uint32_t>;
  const int log2Bin = Bins::log2ChunkFor(model.extent(), tuning.log2Chunk, tuning.log2Grid);
  auto bins = VOXC_TRY(Bins::create(model.extent(), log2Bin, memory));
  Facing facing = tuning.facing.value_or(Facing::Unknown);
  if (options.coverage == Coverage::Inner && !tuning.facing)
    facing = VOXC_TRY(facingOf(*scene, model, memory, options.progress));
  const VoxelRule rule(options.coverage, model.grid.bits(), facing, model.extent());
  auto mesh = std::make_shared<MeshVoxels>(std::move(scene), memory, std::move(model), std::move(bins), rule,
                                           tuning.log2Chunk, options.progress);
  if (options.colour == ColourRule::Mean)
    mesh->means = VOXC_TRY(SceneMeans::of(*mesh->scene, memory, options.progress));
  const Region region{chunksOf(mesh->model.extent(), options.regions, log2Bin),
                      trianglesNear(options.regions, *mesh->scene, mesh->model)};
  VOXC_TRY(fill(mesh->bins, *mesh, region));
  return std::shared_ptr<const MeshVoxels>(std::move(mesh));
}

} // namespace voxc
