// Exporting decoded voxels: the table of kinds, dense grids and points.
#include "voxc/Source/Export.h"

#include "Mesh/PathEnding.h"
#include "Source/CubeTools.h"
#include "Source/VoxWriter.h"
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
Expected<void> writeGrid(const Volume &volume, OutputFile &file) {
  const Int3 extent = volume.info().extent;
  std::vector<std::uint32_t> row(static_cast<std::size_t>(extent.x));
  for (Int3 cell; cell.z < extent.z; ++cell.z)
    for (cell.y = 0; cell.y < extent.y; ++cell.y) {
      readRow(volume, cell, row);
      if (auto written = file.write(row.data(), row.size() * sizeof row[0]); !written)
        return written;
    }
  return {};
}

/// Refuses a grid that does not fit on the disk before filling it.
Expected<void> checkGridSize(const Volume &volume, const std::string &path) {
  const Int3 extent = volume.info().extent;
  const std::uint64_t cells = static_cast<std::uint64_t>(extent.x) * static_cast<std::uint64_t>(extent.y) *
                              static_cast<std::uint64_t>(extent.z);
  std::error_code unknown;
  const auto space = std::filesystem::space(std::filesystem::absolute(path).parent_path(), unknown);
  if (unknown || cells <= space.available / 4)
    return {};
  return Error::environment("a grid of " + std::to_string(cells) + " cells of 4 bytes does not fit beside '" +
                            path + "', where " + std::to_string(space.available) + " bytes are free");
}

struct PlyPoint {
  std::int32_t position[3];
  std::uint32_t colour;
};
static_assert(sizeof(PlyPoint) == 16);

Expected<void> writePoints(const Volume &volume, OutputFile &file) {
  std::uint64_t count = 0;
  forEachVoxel(volume, [&](Int3, std::uint32_t) { ++count; });
  const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(count) +
                             "\nproperty int x\nproperty int y\nproperty int z\nproperty uchar red\n"
                             "property uchar green\nproperty uchar blue\nproperty uchar alpha\nend_header\n";
  Expected<void> result = file.write(header.data(), header.size());
  forEachVoxel(volume, [&](Int3 voxel, std::uint32_t word) {
    const PlyPoint point{{voxel.x, voxel.y, voxel.z}, word};
    if (result)
      result = file.write(&point, sizeof point);
  });
  return result;
}

Expected<void> fitsAnywhere(const Volume &, const std::string &) { return {}; }

struct ExportKind {
  std::string_view ending;
  Expected<void> (*check)(const Volume &volume, const std::string &path);
  Expected<void> (*write)(const Volume &volume, OutputFile &file);
};

constexpr std::array<ExportKind, 3> kKinds{{{".raw", checkGridSize, writeGrid},
                                            {".ply", fitsAnywhere, writePoints},
                                            {".vox", fitsAnywhere, writeMagicaVoxel}}};

} // namespace

Expected<void> exportVoxels(const Volume &volume, const std::string &path) {
  const std::string ending = pathEnding(path);
  for (const ExportKind &kind : kKinds) {
    if (kind.ending != ending)
      continue;
    if (auto checked = kind.check(volume, path); !checked)
      return checked;
    auto file = OutputFile::create(path);
    if (!file)
      return file.error();
    if (auto written = kind.write(volume, *file); !written)
      return written;
    return file->commit();
  }
  return Error::input("'" + path + "' is no kind of export that is known; it ends in .raw, .ply or .vox");
}

} // namespace voxc
