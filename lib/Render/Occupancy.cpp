// Which voxels around a place are not empty, read once a brick.
#include "Occupancy.h"

namespace voxc {

namespace {

constexpr int kLog2Brick = 2;
constexpr int kBrick = 1 << kLog2Brick;
/// Bricks that a neighbourhood reaches into, on an axis.
constexpr int kAcross = (kNeighbours + 2 * (kBrick - 1)) / kBrick;

/// Bricks that are kept before all are forgotten: 48 MiB or so.
constexpr std::size_t kMostBricks = std::size_t{1} << 20;

} // namespace

std::uint64_t Occupancy::readBrick(Int3 at) const {
  const Int3 low = at * kBrick;
  const ShapeCube first = reader_.at(low);
  if (first.log2Side >= kLog2Brick)
    return first.isFull ? ~std::uint64_t{0} : 0;
  return reader_.brick(low);
}

std::uint64_t Occupancy::brick(Int3 at) {
  if (!contains(reader_.extent(), at * kBrick))
    return 0;
  const auto [place, isNew] = bricks_.try_emplace(mortonCode(at), 0);
  if (isNew)
    place->second = readBrick(at);
  return place->second;
}

Neighbourhood Occupancy::around(Int3 middle) {
  if (bricks_.size() > kMostBricks)
    bricks_.clear();
  const Int3 low = middle - Int3{kReach, kReach, kReach};
  const Int3 first = low >> kLog2Brick;
  std::array<std::uint64_t, kAcross * kAcross * kAcross> bricks;
  for (int i = 0; i < kAcross * kAcross * kAcross; ++i)
    bricks[std::size_t(i)] = brick(first + Int3{i % kAcross, i / kAcross % kAcross, i / (kAcross * kAcross)});

  const Int3 shift = low - first * kBrick;
  Neighbourhood rows;
  for (int z = 0; z < kNeighbours; ++z)
    for (int y = 0; y < kNeighbours; ++y) {
      const int inY = y + shift.y;
      const int inZ = z + shift.z;
      const int row = (inY % kBrick) * kBrick + (inZ % kBrick) * kBrick * kBrick;
      const int base = kAcross * (inY / kBrick + kAcross * (inZ / kBrick));
      std::uint64_t bits = 0;
      for (int i = 0; i < kAcross; ++i)
        bits |= (bricks[std::size_t(base + i)] >> row & 0xf) << (kBrick * i);
      rows[std::size_t(y + kNeighbours * z)] = std::uint16_t(bits >> shift.x & ((1u << kNeighbours) - 1));
    }
  return rows;
}

} // namespace voxc
