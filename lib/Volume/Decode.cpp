// Reading a volume's voxels back: one at a time, or all of them as uniform cubes.
#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <utility>

namespace voxc {
namespace {

/// Passes the cells of each level on to the next, and those of the last to the caller.
class Decoder final : public SubVolumeVisitor {
public:
  using Emit = std::function<void(const Cube &, std::uint32_t)>;

  Decoder(const Volume &volume, const Emit &emit)
      : format_(volume.format()), words_(volume.words()), emit_(emit) {}

  void subVolume(std::size_t level, Int3 low, std::uint32_t offset) {
    const Frame above = std::exchange(frame_, {level, low, format_.log2CellSide(level)});
    format_.levels[level].kind->walk(words_, format_.levels[level], offset, *this);
    frame_ = above;
  }

  bool enterNode(std::uint32_t, int) override { return true; }

  void cells(const Cube &cube, std::uint32_t value) override {
    const Frame frame = frame_;
    const Int3 low = frame.low + cube.low * (1 << frame.log2CellSide);
    if (frame.level + 1 == format_.levels.size())
      return emit_({low, cube.log2Side}, value);
    if (cube.log2Side == 0)
      subVolume(frame.level + 1, low, value);
    else
      everyCell(cube, frame, value);
  }

private:
  struct Frame {
    std::size_t level = 0;
    Int3 low;
    int log2CellSide = 0;
  };

  /// A leaf high in a tree: all cells under it have the same sub-volume.
  void everyCell(const Cube &cube, const Frame &frame, std::uint32_t value) {
    const std::uint64_t cells = std::uint64_t{1} << (3 * cube.log2Side);
    for (std::uint64_t code = 0; code < cells; ++code)
      subVolume(frame.level + 1, frame.low + (cube.low + mortonCell(code)) * (1 << frame.log2CellSide),
                value);
  }

  const Format &format_;
  WordReader words_;
  const Emit &emit_;
  Frame frame_;
};

} // namespace

void decode(const Volume &volume, const std::function<void(const Cube &, std::uint32_t)> &cube) {
  if (volume.words()[0] != 0)
    Decoder(volume, cube).subVolume(0, {}, volume.words()[0]);
}

Lookup Volume::lookup(Int3 voxel) const {
  const Format &format = this->format();
  if (!contains(format.extent(), voxel))
    return {};
  const WordReader words(this->words());
  std::uint32_t value = words[0];
  const Int3 log2 = format.log2Extent();
  Lookup found{value, std::min({log2.x, log2.y, log2.z})};
  Int3 low;
  for (std::size_t i = 0; i < format.levels.size() && value != 0; ++i) {
    const int log2CellSide = format.log2CellSide(i);
    const Level &level = format.levels[i];
    const Int3 cell = (voxel - low) >> log2CellSide;
    found = level.kind->lookup(words, level, value, cell);
    found.log2Side += log2CellSide;
    value = found.value;
    low = low + cell * (1 << log2CellSide);
  }
  return found;
}

} // namespace voxc
