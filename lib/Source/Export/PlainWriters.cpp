// Exports that are nothing but a list: dense grids and points.
#include "Source/Export/VoxelVisit.h"
#include "Source/Export/Writers.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

namespace voxc {

namespace {

struct PlyPoint {
  std::int32_t position[3];
  std::uint32_t colour;
};
static_assert(sizeof(PlyPoint) == 16);

/// The cells of a cube that lie in [0, extent).
std::uint64_t cellsWithin(const Cube &cube, Int3 extent) {
  std::uint64_t cells = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t end = std::min<std::int64_t>(cube.low[axis] + cube.side(), extent[axis]);
    cells *= static_cast<std::uint64_t>(std::max<std::int64_t>(end - cube.low[axis], 0));
  }
  return cells;
}

} // namespace

Expected<void> writeGrid(const Volume &volume, OutputFile &file, const ExportOptions &options, Exported &) {
  const Int3 extent = volume.info().extent;
  // Layers are read eight at a time, or as many as take 64 MiB.
  constexpr std::int64_t kCellsAtOnce = std::int64_t{1} << 24;
  const std::int64_t layer = std::max<std::int64_t>(std::int64_t{extent.x} * extent.y, 1);
  const auto layers = static_cast<std::int32_t>(std::clamp<std::int64_t>(kCellsAtOnce / layer, 1, 8));
  const auto rows = static_cast<std::int32_t>(
      std::clamp<std::int64_t>(kCellsAtOnce / std::max(extent.x, 1), 1, std::max(extent.y, 1)));
  std::vector<std::uint32_t> words(static_cast<std::size_t>(layers * std::int64_t{extent.x} * rows));
  for (Int3 low; low.z < extent.z; low.z += layers)
    for (low.y = 0; low.y < extent.y; low.y += rows) {
      if (options.save.progress.stopped())
        return Error::interrupted();
      const Int3 high{extent.x, std::min(low.y + rows, extent.y), std::min(low.z + layers, extent.z)};
      const Int3 size = high - low;
      const auto box =
          std::span(words).first(static_cast<std::size_t>(std::int64_t{size.x} * size.y * size.z));
      readBox(volume, low, high, box);
      if (auto written = file.write(box.data(), box.size_bytes()); !written)
        return written;
    }
  return {};
}

Expected<void> writePoints(const Volume &volume, OutputFile &file, const ExportOptions &options, Exported &) {
  const Progress &progress = options.save.progress;
  std::uint64_t count = 0;
  const auto add = [&](const Cube &cube, std::uint32_t) {
    count += cellsWithin(cube, volume.info().extent);
    return true;
  };
  if (auto counted = decode(volume, add, progress); !counted)
    return counted;
  const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(count) +
                             "\nproperty int x\nproperty int y\nproperty int z\nproperty uchar red\n"
                             "property uchar green\nproperty uchar blue\nproperty uchar alpha\nend_header\n";
  Expected<void> written = file.write(header.data(), header.size());
  const auto write = [&](Int3 voxel, std::uint32_t word) {
    const PlyPoint point{{voxel.x, voxel.y, voxel.z}, word};
    written = file.write(&point, sizeof point);
    return bool(written);
  };
  if (!written)
    return written;
  if (auto visited = forEachVoxel(volume, progress, write); !visited)
    return visited;
  return written;
}

} // namespace voxc
