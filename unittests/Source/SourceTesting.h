// What tests of sources share: reading a whole source in the way a builder does, and files that disappear.
#pragma once

#include "voxc/Source/VoxelSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace voxc {

/// A folder that is removed with everything in it.
class TemporaryFolder {
public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "voxc-test-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
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

inline void collect(VoxelSource &source, const Cube &cube, Voxels &voxels) {
  if (source.empty(cube))
    return;
  if (cube.log2Side > 3) {
    const int half = cube.log2Side - 1;
    for (std::uint64_t child = 0; child < 8; ++child)
      collect(source, {cube.low + mortonCell(child) * (1 << half), half}, voxels);
    return;
  }
  std::array<std::uint32_t, 512> words;
  source.read(cube, words.data());
  for (std::uint64_t i = 0; i < std::uint64_t{1} << 3 * cube.log2Side; ++i)
    if (words[i] != 0)
      voxels[mortonCode(cube.low) + i] = words[i];
}

/// All voxels of a source, asked for as a builder does.
inline Voxels voxelsOf(VoxelSource &source) {
  const Int3 extent = source.extent();
  int log2Side = 0;
  while (1 << log2Side < std::max({extent.x, extent.y, extent.z}))
    ++log2Side;
  Voxels voxels;
  collect(source, {{}, log2Side}, voxels);
  return voxels;
}

} // namespace voxc
