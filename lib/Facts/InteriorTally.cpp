// Interior voxels by shifting bits of bricks, and by handing faces from brick to brick.
#include "InteriorTally.h"

#include "Mix.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace voxc {

namespace {

constexpr std::uint64_t kAll = ~std::uint64_t{0};
constexpr std::uint64_t kSmallestTable = 1024;

enum class Side { Low, High };

/// The voxels of a brick on one of its faces. The order of the 64 bits depends on the axis alone.
std::uint64_t faceOf(const Slices &slices, int axis, Side side) {
  if (axis == 2)
    return slices[side == Side::High ? 7 : 0];
  std::uint64_t face = 0;
  for (unsigned z = 0; z < 8; ++z)
    face |= axis == 0 ? (slices[z] >> (side == Side::High ? 7 : 0) & kColumnBits) << z
                      : (slices[z] >> (side == Side::High ? 56 : 0) & kRowBits) << 8 * z;
  return face;
}

/// Takes away the bits on a face whose neighbours beyond it are not in `neighbours`.
void restrictFace(Slices &slices, int axis, Side side, std::uint64_t neighbours) {
  if (axis == 2) {
    slices[side == Side::High ? 7 : 0] &= neighbours;
    return;
  }
  const unsigned shift = side == Side::Low ? 0 : axis == 0 ? 7 : 56;
  const std::uint64_t where = axis == 0 ? kColumnBits : kRowBits;
  for (unsigned z = 0; z < 8; ++z) {
    const std::uint64_t kept = axis == 0 ? neighbours >> z & kColumnBits : neighbours >> 8 * z & kRowBits;
    slices[z] &= ~(where << shift) | kept << shift;
  }
}

/// Voxels whose neighbours in the brick are there, as if all was full beyond.
Slices erode(const Slices &s) {
  Slices inner;
  for (unsigned z = 0; z < 8; ++z)
    inner[z] = s[z] & (s[z] << 1 | kColumnBits) & (s[z] >> 1 | kColumnBits << 7) & (s[z] << 8 | kRowBits) &
               (s[z] >> 8 | kRowBits << 56) & (z > 0 ? s[z - 1] : kAll) & (z < 7 ? s[z + 1] : kAll);
  return inner;
}

/// The neighbour of a brick one step along an axis.
Int3 neighbour(Int3 brick, int axis, int step) {
  brick[axis] += step;
  return brick;
}

/// When the last upper neighbour of a brick comes, if it comes.
std::uint64_t lastNeighbour(std::uint64_t code) {
  const Int3 brick = mortonCell(code);
  std::uint64_t last = 0;
  for (int axis = 0; axis < 3; ++axis)
    last = std::max(last, mortonCode(neighbour(brick, axis, 1)));
  return last;
}

} // namespace

Expected<void> InteriorTally::add(const Brick &brick) {
  const Int3 place = brick.low >> Brick::kLog2Side;
  Waiting waiting{mortonCode(place) + 1, erode(brick.slices), {}, 0};
  for (int axis = 0; axis < 3; ++axis) {
    waiting.faces[static_cast<unsigned>(axis)] = faceOf(brick.slices, axis, Side::High);
    Waiting *lower = place[axis] > 0 ? find(mortonCode(neighbour(place, axis, -1)) + 1) : nullptr;
    restrictFace(waiting.candidates, axis, Side::Low, lower ? lower->faces[static_cast<unsigned>(axis)] : 0);
    if (!lower)
      continue;
    restrictFace(lower->candidates, axis, Side::High, faceOf(brick.slices, axis, Side::Low));
    lower->met |= 1u << axis;
  }
  memory_->relieve(4 * sizeof waiting);
  if ((waiting.faces[0] | waiting.faces[1] | waiting.faces[2]) != 0)
    return insert(waiting);
  flush(waiting);
  return {};
}

std::uint64_t InteriorTally::finish() {
  for (const Waiting &brick : table_.span())
    if (brick.key != 0)
      flush(brick);
  table_ = ScratchArray<Waiting>(memory_);
  used_ = 0;
  return interior_;
}

/// Counts a brick for which all is known: a neighbour that has not come is empty.
void InteriorTally::flush(Waiting brick) {
  for (int axis = 0; axis < 3; ++axis)
    if ((brick.met >> axis & 1) == 0)
      restrictFace(brick.candidates, axis, Side::High, 0);
  interior_ += countBits(brick.candidates);
}

InteriorTally::Waiting *InteriorTally::find(std::uint64_t key) {
  if (table_.empty())
    return nullptr;
  const std::uint64_t mask = table_.size() - 1;
  for (std::uint64_t at = mix(key) & mask; table_[at].key != 0; at = (at + 1) & mask)
    if (table_[at].key == key)
      return &table_[at];
  return nullptr;
}

Expected<void> InteriorTally::insert(const Waiting &brick) {
  if (2 * (used_ + 1) > table_.size())
    VOXC_TRY(sweep(brick.key - 1));
  place(brick);
  return {};
}

void InteriorTally::place(const Waiting &brick) {
  const std::uint64_t mask = table_.size() - 1;
  std::uint64_t at = mix(brick.key) & mask;
  while (table_[at].key != 0)
    at = (at + 1) & mask;
  table_[at] = brick;
  ++used_;
}

/// Counts the bricks whose neighbours have all come or been passed by, and makes room for others. `now`: the
/// brick that has come last.
Expected<void> InteriorTally::sweep(std::uint64_t now) {
  const auto waits = [now](const Waiting &brick) {
    return brick.key != 0 && lastNeighbour(brick.key - 1) > now;
  };
  const auto left = static_cast<std::uint64_t>(std::ranges::count_if(table_.span(), waits));
  ScratchArray<Waiting> next(memory_);
  VOXC_TRY(next.resize(std::max(kSmallestTable, std::bit_ceil(4 * left))));
  std::swap(table_, next);
  used_ = 0;
  for (const Waiting &brick : next.span()) {
    if (waits(brick))
      place(brick);
    else if (brick.key != 0)
      flush(brick);
  }
  return {};
}

} // namespace voxc
