// A dense grid of words, in memory or from a file.
#include "voxc/Source/Sources.h"

#include "Source/CubeTools.h"
#include "Source/OccupancyPyramid.h"

#include <algorithm>
#include <bit>
#include <fstream>
#include <utility>

namespace voxc {

namespace {

class GridSource final : public VoxelSource {
public:
  GridSource(Int3 extent, std::vector<std::uint32_t> words)
      : extent_(extent), words_(std::move(words)), occupancy_(extent) {
    const std::uint32_t *word = words_.data();
    for (Int3 cell; cell.z < extent.z; ++cell.z)
      for (cell.y = 0; cell.y < extent.y; ++cell.y)
        for (cell.x = 0; cell.x < extent.x; ++cell.x)
          if (*word++ != 0)
            occupancy_.mark(cell);
  }

  Int3 extent() const override { return extent_; }

  bool empty(const Cube &cube) override {
    if (isOutside(cube, extent_))
      return true;
    if (cube.log2Side >= OccupancyPyramid::kLog2Brick)
      return occupancy_.empty(cube);
    bool empty = true;
    forEachCell(cube, [&](std::uint64_t, Int3 cell) { empty = empty && word(cell) == 0; });
    return empty;
  }

  void read(const Cube &cube, std::uint32_t *words) override {
    forEachCell(cube, [&](std::uint64_t index, Int3 cell) { words[index] = word(cell); });
  }

private:
  std::uint32_t word(Int3 cell) const {
    if (!contains(extent_, cell))
      return 0;
    const auto row = static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(extent_.y) +
                     static_cast<std::size_t>(cell.y);
    return words_[row * static_cast<std::size_t>(extent_.x) + static_cast<std::size_t>(cell.x)];
  }

  Int3 extent_;
  std::vector<std::uint32_t> words_;
  OccupancyPyramid occupancy_;
};

std::string toText(Int3 extent) {
  return std::to_string(extent.x) + "x" + std::to_string(extent.y) + "x" + std::to_string(extent.z);
}

bool isValid(Int3 extent) {
  constexpr int kMaxExtent = 1 << kMaxLog2Extent;
  return std::min({extent.x, extent.y, extent.z}) >= 1 &&
         std::max({extent.x, extent.y, extent.z}) <= kMaxExtent;
}

} // namespace

std::unique_ptr<VoxelSource> makeGridSource(Int3 extent, std::vector<std::uint32_t> words) {
  return std::make_unique<GridSource>(extent, std::move(words));
}

Expected<std::unique_ptr<VoxelSource>> loadGridSource(Int3 extent, const std::string &path) {
  if (!isValid(extent))
    return Error::input("a grid of " + toText(extent) +
                        " cells is not possible: each axis takes 1 to 2097152");
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file)
    return Error::input("'" + path + "' cannot be read");
  // At most 2^63 words: this fits, their bytes may not.
  const std::uint64_t count = static_cast<std::uint64_t>(extent.x) * static_cast<std::uint64_t>(extent.y) *
                              static_cast<std::uint64_t>(extent.z);
  const auto bytes = static_cast<std::uint64_t>(std::max<std::streamoff>(file.tellg(), 0));
  if (bytes % 4 != 0 || bytes / 4 != count)
    return Error::input("'" + path + "' has " + std::to_string(bytes) + " bytes, but a grid of " +
                        toText(extent) + " cells has " + std::to_string(count) + " words of 4 bytes");

  static_assert(std::endian::native == std::endian::little, "words are read as they lie in the file");
  std::vector<std::uint32_t> words(count);
  file.seekg(0);
  if (!file.read(reinterpret_cast<char *>(words.data()), static_cast<std::streamsize>(bytes)))
    return Error::input("'" + path + "' cannot be read to its end");
  return makeGridSource(extent, std::move(words));
}

} // namespace voxc
