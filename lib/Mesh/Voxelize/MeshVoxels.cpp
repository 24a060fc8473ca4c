// Sorting the triangles of a scene into chunks.
#include "Mesh/Voxelize/MeshVoxels.h"

#include <utility>
#include <vector>

namespace voxc {

namespace {

/// Triangles between two looks at memory, and at the progress.
constexpr std::uint64_t kMemoryStep = 64;
constexpr std::uint64_t kProgressStep = 1 << 14;

CellRange allChunks(Int3 extent, int log2Chunk) {
  return {{}, ((extent - Int3{1, 1, 1}) >> log2Chunk) + Int3{1, 1, 1}};
}

} // namespace

MeshVoxels::MeshVoxels(std::shared_ptr<const TriangleScene> theScene, MeshModel theModel,
                       std::shared_ptr<WorkingMemory> theMemory, ChunkBins<std::uint32_t> theBins,
                       const VoxelizeOptions &options, int theLog2Chunk)
    : scene(std::move(theScene)), model(std::move(theModel)), memory(std::move(theMemory)),
      bins(std::move(theBins)), log2Chunk(theLog2Chunk),
      voxelShape(options.coverage == Coverage::Thin ? CellShape::cross(model.grid.bits())
                                                    : CellShape::cube(model.grid.bits())),
      progress(options.progress) {}

template <typename Visit> Expected<void> MeshVoxels::forEachChunk(double progressBefore, Visit visit) {
  const CellShape shape = CellShape::cube(model.grid.bits() + bins.log2Chunk());
  const CellRange chunks = allChunks(model.extent(), bins.log2Chunk());
  const auto count = model.numbers.size();
  TriangleCursor cursor(*scene, model.numbers);
  std::vector<CellMask> masks;
  for (std::uint64_t number = 0; number < count; ++number) {
    if (number % kProgressStep == 0) {
      if (progress.stopped())
        return Error::interrupted();
      progress.at("bin", progressBefore + 0.5 * static_cast<double>(number) / static_cast<double>(count));
    }
    if (number % kMemoryStep == 0)
      memory->relieve();
    cursor.moveTo(number);
    coverCells(model.snapped(cursor), shape, chunks, masks);
    for (const CellMask &mask : masks)
      forEachCell(mask, [&](Int3 chunk) { visit(chunk, static_cast<std::uint32_t>(number)); });
  }
  return {};
}

Expected<std::shared_ptr<MeshVoxels>> MeshVoxels::open(std::shared_ptr<const TriangleScene> scene,
                                                       const VoxelizeOptions &options,
                                                       const std::shared_ptr<WorkingMemory> &memory,
                                                       const MeshTuning &tuning) {
  auto model = MeshModel::open(*scene, options, memory.get());
  if (!model)
    return model.error();
  using Bins = ChunkBins<std::uint32_t>;
  const int log2Chunk = Bins::log2ChunkFor(model->extent(), tuning.log2Chunk, tuning.log2Grid);
  auto bins = Bins::create(model->extent(), log2Chunk, memory);
  if (!bins)
    return bins.error();
  auto mesh = std::make_shared<MeshVoxels>(std::move(scene), std::move(*model), memory, std::move(*bins),
                                           options, tuning.log2Chunk);
  const auto count = [&](Int3 chunk, std::uint32_t) { mesh->bins.count(chunk); };
  if (auto counted = mesh->forEachChunk(0, count); !counted)
    return counted.error();
  if (auto allocated = mesh->bins.allocate(); !allocated)
    return allocated.error();
  const auto place = [&](Int3 chunk, std::uint32_t number) { mesh->bins.place(chunk, number); };
  if (auto placed = mesh->forEachChunk(0.5, place); !placed)
    return placed.error();
  return mesh;
}

} // namespace voxc
