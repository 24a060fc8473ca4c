// Reading a volume's voxels back: one at a time, or all of them as uniform cubes.
#include "Decode.h"

#include "voxc/Layout/SubVolume.h"
#include "voxc/Layout/Values.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace voxc {
namespace {

/// Passes the cells of each level on to the next, and those of the last to the caller.
class Decoder final : public SubVolumeVisitor {
public:
  Decoder(const Volume &volume, const NumberedVisit &visit, const Progress &progress)
      : layout_(volume.layout()), words_(layout_.reader(volume.words())), visit_(visit), progress_(progress),
        stated_(volume.info().voxels), mostCubes_(volume.mostCubes()) {}

  Expected<void> run() {
    subVolume(0, {}, 0, words_[0]);
    if (failure_)
      return *failure_;
    return {};
  }

  bool enterNode(std::uint64_t, int, Ranks) override { return !done(); }
  bool done() const override { return ended_; }

  void cells(const Cube &cube, std::uint32_t value, Ranks ranks) override {
    const Frame frame = frame_;
    const Int3 low = frame.low + cube.low * (1 << frame.log2CellSide);
    const std::uint64_t rank = frame.rank + ranks.first;
    if (!layout_.holdsVoxels(frame.level))
      everyCell(cube, frame, value, rank, ranks.count >> 3 * cube.log2Side);
    else if (layout_.ranksVoxels())
      valuesApart({low, cube.log2Side}, rank);
    else
      voxels({low, cube.log2Side}, layout_.hasOneColour() ? words_[1] : value, decoded_);
  }

private:
  struct Frame {
    std::size_t level = 0;
    Int3 low;
    std::uint64_t rank = 0; ///< Of its first voxel.
    int log2CellSide = 0;
  };

  void subVolume(std::size_t level, Int3 low, std::uint64_t rank, Ref ref) {
    const Frame above = std::exchange(frame_, {level, low, rank, layout_.strata[level].log2Cell});
    visitSubVolume(words_, layout_.strata[level], words_.wordOf(ref), *this);
    frame_ = above;
  }

  /// A cell, or a leaf high in a tree: all cells under it have the same sub-volume, of `voxels` each.
  void everyCell(const Cube &cube, const Frame &frame, std::uint32_t value, std::uint64_t rank,
                 std::uint64_t voxels) {
    const std::uint64_t cells = std::uint64_t{1} << (3 * cube.log2Side);
    for (std::uint64_t code = 0; code < cells && !ended_; ++code)
      subVolume(frame.level + 1, frame.low + (cube.low + mortonCell(code)) * (1 << frame.log2CellSide),
                rank + code * voxels, value);
  }

  /// Voxels of one shape and of values of their own, the first of them that of `rank`.
  void valuesApart(const Cube &cube, std::uint64_t rank) {
    const std::uint64_t count = std::uint64_t{1} << (3 * cube.log2Side);
    for (std::uint64_t code = 0; code < count && !ended_; ++code)
      voxels({cube.low + mortonCell(code), 0}, valueOfRank(words_, layout_.payload, rank + code),
             rank + code);
  }

  void voxels(const Cube &cube, std::uint32_t word, std::uint64_t number) {
    if (ended_)
      return;
    const std::uint64_t count = std::uint64_t{1} << (3 * cube.log2Side);
    decoded_ += count;
    if (decoded_ > stated_ || number > stated_ - count)
      fail(Error::input("the volume holds more voxels than the " + std::to_string(stated_) +
                        " that its header says"));
    else if (cubes_ == mostCubes_)
      fail(Error::input("the volume decodes to more than " + std::to_string(mostCubes_) +
                        " cubes of voxels, the limit (--max-cubes N sets another)"));
    else if (++cubes_ % kCubesBetweenLooks == 0 && progress_.stopped())
      fail(Error::interrupted());
    else if (!visit_(cube, word, number))
      ended_ = true;
  }

  void fail(Error error) {
    failure_ = std::move(error);
    ended_ = true;
  }

  static constexpr std::uint64_t kCubesBetweenLooks = 4096;

  const Layout &layout_;
  WordReader words_;
  const NumberedVisit &visit_;
  const Progress &progress_;
  std::uint64_t stated_;
  std::uint64_t mostCubes_;
  std::uint64_t decoded_ = 0;
  std::uint64_t cubes_ = 0;
  Frame frame_;
  bool ended_ = false;
  std::optional<Error> failure_;
};

} // namespace

Expected<void> decodeNumbered(const Volume &volume, const NumberedVisit &visit, const Progress &progress) {
  if (volume.words()[0] == 0)
    return {};
  return Decoder(volume, visit, progress).run();
}

Expected<void> decode(const Volume &volume, const DecodeVisit &visit, const Progress &progress) {
  return decodeNumbered(
      volume, [&](const Cube &cube, std::uint32_t word, std::uint64_t) { return visit(cube, word); },
      progress);
}

Lookup lookUpShape(const WordReader &words, const Layout &layout, Int3 voxel) {
  const Int3 log2 = layout.log2Extent();
  if (!contains({1 << log2.x, 1 << log2.y, 1 << log2.z}, voxel))
    return {};
  std::uint32_t value = words[0];
  Lookup found{value, std::min({log2.x, log2.y, log2.z})};
  Int3 low;
  std::uint64_t rank = 0;
  for (const Stratum &stratum : layout.strata) {
    if (value == 0)
      break;
    const Int3 cell = (voxel - low) >> stratum.log2Cell;
    found = lookUp(words, stratum, words.wordOf(value), cell);
    found.log2Side += stratum.log2Cell;
    found.rank += rank;
    rank = found.rank;
    value = found.value;
    low = low + cell * (1 << stratum.log2Cell);
  }
  return found;
}

Lookup Volume::lookup(Int3 voxel) const {
  const WordReader words = layout().reader(this->words());
  Lookup found = lookUpShape(words, layout(), voxel);
  if (found.value == 0)
    return found;
  return {valueOfVoxel(words, layout(), found.value, found.rank), layout().ranksVoxels() ? 0 : found.log2Side,
          found.rank};
}

} // namespace voxc
