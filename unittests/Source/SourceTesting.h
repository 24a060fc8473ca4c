// What tests of sources share: reading a whole source in the way a builder does, small volumes, and files
// that disappear.
#pragma once

#include "NewFolder.h"
#include "voxc/Source/VoxelSource.h"
#include "voxc/Volume/Volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace voxc {

/// A folder that is removed with everything in it.
class TemporaryFolder {
public:
  TemporaryFolder() : path_(test::newFolder("voxc-test").string()) {}
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;

  /// The path of a file of this name, with this content.
  std::string file(const std::string &name, const std::string &content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }
  std::string path(const std::string &name) const { return path_ + "/" + name; }
  /// Number of files in the folder.
  long count() const { return std::distance(std::filesystem::directory_iterator(path_), {}); }

private:
  std::string path_;
};

/// Voxels by their Morton code.
using Voxels = std::map<std::uint64_t, std::uint32_t>;

/// A volume of one raw grid, no larger than it must be to hold the extent.
inline Volume denseVolume(const Voxels &voxels, Int3 extent, const Transform &voxelToModel = {}) {
  VolumeInfo info;
  std::string format = "R(";
  for (int axis = 0; axis < 3; ++axis)
    format +=
        std::to_string(std::bit_width(static_cast<unsigned>(extent[axis] - 1))) + (axis < 2 ? "," : ")");
  info.format = *parseFormat(format);
  info.extent = extent;
  info.voxels = voxels.size();
  info.voxelToModel = voxelToModel;
  const Int3 size = info.format.extent();
  std::vector<std::uint32_t> words(1 + static_cast<std::size_t>(size.x * size.y * size.z));
  words[0] = voxels.empty() ? 0 : 1;
  for (const auto &[code, word] : voxels) {
    const Int3 cell = mortonCell(code);
    words[1 + static_cast<std::size_t>(cell.x + size.x * (cell.y + size.y * cell.z))] = word;
  }
  return Volume(info, words);
}

/// Adds the voxels of a cube, asked for as a builder does. Errors: the source's.
inline Expected<void> collect(VoxelSource &source, const Cube &cube, Voxels &voxels) {
  if (source.empty(cube))
    return {};
  if (cube.log2Side > 3) {
    const int half = cube.log2Side - 1;
    for (std::uint64_t child = 0; child < 8; ++child)
      if (auto done = collect(source, {cube.low + mortonCell(child) * (1 << half), half}, voxels); !done)
        return done;
    return {};
  }
  std::array<std::uint32_t, 512> words;
  if (auto done = source.read(cube, words.data()); !done)
    return done;
  for (std::uint64_t i = 0; i < std::uint64_t{1} << 3 * cube.log2Side; ++i)
    if (words[i] != 0)
      voxels[mortonCode(cube.low) + i] = words[i];
  return {};
}

/// All voxels of a source, which has no errors.
inline Voxels voxelsOf(VoxelSource &source) {
  const Int3 extent = source.extent();
  int log2Side = 0;
  while (1 << log2Side < std::max({extent.x, extent.y, extent.z}))
    ++log2Side;
  Voxels voxels;
  const Expected<void> done = collect(source, {{}, log2Side}, voxels);
  EXPECT_TRUE(done) << done.error().message;
  return voxels;
}

} // namespace voxc
