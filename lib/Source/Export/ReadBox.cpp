// Boxes of a volume, cube by cube.
#include "Source/Export/VoxelVisit.h"

#include "Volume/Decode.h"

#include <algorithm>
#include <array>
#include <vector>

namespace voxc {

namespace {

class BoxReader {
public:
  BoxReader(const Volume &volume, Int3 low, Int3 high, std::span<std::uint32_t> words)
      : volume_(volume), low_(low), high_(high), words_(words) {}

  /// Row by row of bricks along x; what the volume keeps as one is looked up once.
  void run() {
    std::ranges::fill(words_, 0u);
    for (std::int32_t z = low_.z & -kCubeAtOnce; z < high_.z; z += kCubeAtOnce)
      for (std::int32_t y = low_.y & -kCubeAtOnce; y < high_.y; y += kCubeAtOnce)
        for (std::int32_t x = low_.x & -kCubeAtOnce; x < high_.x;) {
          const Lookup found = volume_.lookup({x, y, z});
          const std::int64_t side = std::int64_t{1} << std::max(found.log2Side, kLog2CubeAtOnce);
          const std::int64_t end = std::min<std::int64_t>((x & -side) + side, high_.x);
          if (found.log2Side < kLog2CubeAtOnce)
            copy({x, y, z});
          else if (found.value != 0)
            fill({x, y, z}, static_cast<std::int32_t>(end), found.value);
          x = static_cast<std::int32_t>(end);
        }
  }

private:
  std::uint32_t *row(std::int32_t x, std::int32_t y, std::int32_t z) {
    const auto width = std::int64_t{high_.x} - low_.x, height = std::int64_t{high_.y} - low_.y;
    return &words_[static_cast<std::size_t>(x - low_.x + width * (y - low_.y + height * (z - low_.z)))];
  }

  /// Calls `visit(y, z)` for the rows of the box that a brick has part in.
  template <typename Visit> void forEachRow(Int3 brick, Visit visit) {
    for (std::int32_t z = std::max(brick.z, low_.z); z < std::min(brick.z + kCubeAtOnce, high_.z); ++z)
      for (std::int32_t y = std::max(brick.y, low_.y); y < std::min(brick.y + kCubeAtOnce, high_.y); ++y)
        visit(y, z);
  }

  void fill(Int3 brick, std::int32_t end, std::uint32_t word) {
    const std::int32_t first = std::max(brick.x, low_.x);
    forEachRow(brick,
               [&](std::int32_t y, std::int32_t z) { std::fill_n(row(first, y, z), end - first, word); });
  }

  void copy(Int3 brick) {
    std::array<std::uint32_t, std::size_t{kCubeAtOnce} * kCubeAtOnce * kCubeAtOnce> words;
    readCube(volume_, {brick, kLog2CubeAtOnce}, words.data());
    const std::int32_t first = std::max(brick.x, low_.x), end = std::min(brick.x + kCubeAtOnce, high_.x);
    forEachRow(brick, [&](std::int32_t y, std::int32_t z) {
      std::uint32_t *to = row(first, y, z);
      for (std::int32_t x = first; x < end; ++x)
        to[x - first] = words[mortonCode(Int3{x, y, z} - brick)];
    });
  }

  const Volume &volume_;
  Int3 low_;
  Int3 high_;
  std::span<std::uint32_t> words_;
};

} // namespace

void readBox(const Volume &volume, Int3 low, Int3 high, std::span<std::uint32_t> words) {
  BoxReader(volume, low, high, words).run();
}

Expected<void> forEachRun(const Volume &volume, const Progress &progress,
                          FunctionRef<Expected<void>(std::span<const std::uint32_t>)> visit) {
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
      if (progress.stopped())
        return Error::interrupted();
      const Int3 high{extent.x, std::min(low.y + rows, extent.y), std::min(low.z + layers, extent.z)};
      const Int3 size = high - low;
      const auto box =
          std::span(words).first(static_cast<std::size_t>(std::int64_t{size.x} * size.y * size.z));
      readBox(volume, low, high, box);
      VOXC_TRY(visit(box));
    }
  return {};
}

} // namespace voxc
