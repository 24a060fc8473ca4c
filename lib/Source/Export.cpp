// Exporting volumes: the table of kinds, dense grids and points.
#include "voxc/Source/Export.h"

#include "Source/CubeTools.h"
#include "Source/VoxWriter.h"
#include "Support/PathEnding.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

namespace voxc {

namespace {

/// The words of one row along x: a lookup for each run of equal ones that the volume stores.
void readRow(const Volume &volume, Int3 cell, std::vector<std::uint32_t> &row) {
  const auto width = static_cast<std::int32_t>(row.size());
  while (cell.x < width) {
    const Lookup found = volume.lookup(cell);
    const std::int64_t side = std::int64_t{1} << found.log2Side;
    const std::int64_t end = std::min<std::int64_t>((cell.x & -side) + side, width);
    for (; cell.x < end; ++cell.x)
      row[static_cast<std::size_t>(cell.x)] = found.value;
  }
}

/// Words as they lie in memory, which is little-endian on every machine that voxc runs on.
Expected<void> writeGrid(const Volume &volume, OutputFile &file, const Progress &progress) {
  const Int3 extent = volume.info().extent;
  std::vector<std::uint32_t> row(static_cast<std::size_t>(extent.x));
  for (Int3 cell; cell.z < extent.z; ++cell.z)
    for (cell.y = 0; cell.y < extent.y; ++cell.y) {
      if (progress.stopped())
        return Error::interrupted();
      readRow(volume, cell, row);
      if (auto written = file.write(row.data(), row.size() * sizeof row[0]); !written)
        return written;
    }
  return {};
}

std::uint64_t gridSize(const Volume &volume) {
  const Int3 extent = volume.info().extent;
  return static_cast<std::uint64_t>(extent.x) * static_cast<std::uint64_t>(extent.y) *
         static_cast<std::uint64_t>(extent.z);
}

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

Expected<void> writePoints(const Volume &volume, OutputFile &file, const Progress &progress) {
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

std::uint64_t voxelCount(const Volume &volume) { return volume.info().voxels; }

struct ExportKind {
  std::string_view ending;
  const char *unit;        ///< What the file is made of,
  std::uint64_t bytesEach; ///< and how large each of them is.
  std::uint64_t (*count)(const Volume &volume);
  Expected<void> (*write)(const Volume &volume, OutputFile &file, const Progress &progress);
};

constexpr std::array<ExportKind, 3> kKinds{{{".raw", "cells", 4, gridSize, writeGrid},
                                            {".ply", "points", sizeof(PlyPoint), voxelCount, writePoints},
                                            {".vox", "voxels", 4, voxelCount, writeMagicaVoxel}}};

/// Refuses what does not fit on the disk before filling it: a small volume may stand for 2^63 voxels.
Expected<void> checkSpace(const ExportKind &kind, const Volume &volume, const std::string &path) {
  const std::uint64_t count = kind.count(volume);
  std::error_code unknown;
  const auto space = std::filesystem::space(std::filesystem::absolute(path).parent_path(), unknown);
  if (unknown || count <= space.available / kind.bytesEach)
    return {};
  return Error::environment(std::to_string(count) + " " + kind.unit + " of " +
                            std::to_string(kind.bytesEach) + " bytes do not fit beside '" + path +
                            "', where " + std::to_string(space.available) + " bytes are free");
}

} // namespace

Expected<void> exportVoxels(const Volume &volume, const std::string &path, const SaveOptions &options) {
  const std::string ending = pathEnding(path);
  if (ending == ".hvx")
    return volume.save(path, options);
  if (options.compress)
    return Error::usage("'" + path +
                        "' is no volume that could be compressed; only a file that ends in .hvx is");
  for (const ExportKind &kind : kKinds) {
    if (kind.ending != ending)
      continue;
    if (auto checked = checkSpace(kind, volume, path); !checked)
      return checked;
    auto file = OutputFile::create(path);
    if (!file)
      return file.error();
    if (auto written = kind.write(volume, *file, options.progress); !written)
      return written;
    return file->commit();
  }
  return Error::input(
      "'" + path +
      "' is no kind of export that is known; it ends in .raw, .ply, .vox or .hvx, or of a page in .html");
}

} // namespace voxc
