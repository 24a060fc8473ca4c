// Exports that are nothing but a list: dense grids and points.
#include "Source/Export/VoxelVisit.h"
#include "Source/Export/Writers.h"

#include <algorithm>
#include <span>
#include <string>

namespace voxc {

namespace {

struct PlyVoxel {
  std::int32_t position[3];
  std::uint32_t colour;
};
static_assert(sizeof(PlyVoxel) == 16);

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
  return forEachRun(volume, options.save.progress, [&](std::span<const std::uint32_t> words) {
    return file.write(words.data(), words.size_bytes());
  });
}

Expected<void> writePoints(const Volume &volume, OutputFile &file, const ExportOptions &options, Exported &) {
  const Progress &progress = options.save.progress;
  std::uint64_t count = 0;
  const auto add = [&](const Cube &cube, std::uint32_t) {
    count += cellsWithin(cube, volume.info().extent);
    return true;
  };
  VOXC_TRY(decode(volume, add, progress));
  const std::string header = "ply\nformat binary_little_endian 1.0\ncomment voxc words\nelement vertex " +
                             std::to_string(count) +
                             "\nproperty int x\nproperty int y\nproperty int z\nproperty uchar red\n"
                             "property uchar green\nproperty uchar blue\nproperty uchar alpha\nend_header\n";
  Expected<void> written = file.write(header.data(), header.size());
  const auto write = [&](Int3 voxel, std::uint32_t word) {
    const PlyVoxel point{{voxel.x, voxel.y, voxel.z}, word};
    written = file.write(&point, sizeof point);
    return bool(written);
  };
  if (!written)
    return written;
  VOXC_TRY(forEachVoxel(volume, progress, write));
  return written;
}

} // namespace voxc
