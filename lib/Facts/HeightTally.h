// Counting aligned cubes that are not empty, full, or of one colour, at every height.
#pragma once

#include "Brick.h"

#include "voxc/Facts/Facts.h"

#include <array>
#include <cstdint>
#include <span>

namespace voxc {

/// The colour of a cube: none if it is empty, the word of all its voxels, or mixed.
class Tone {
public:
  Tone() = default;
  explicit Tone(std::uint32_t word) : value_(word) {}

  bool isOne() const { return value_ != 0 && value_ != kMixed; }
  /// The colour of two cubes together.
  Tone operator|(Tone other) const {
    if (other.value_ == 0 || other.value_ == value_)
      return *this;
    if (value_ != 0)
      other.value_ = kMixed;
    return other;
  }

private:
  static constexpr std::uint64_t kMixed = std::uint64_t{1} << 32; ///< No word.
  std::uint64_t value_ = 0;
};

/// A cube: how many voxels it has, and their colour.
struct Filling {
  std::uint64_t voxels = 0;
  Tone tone;
};

class HeightTally {
public:
  /// Counts a brick that is not empty and the cubes of which it is made.
  Filling ofBrick(const Brick &brick);
  /// Counts a cube of this height, 4 or more, made of eight.
  Filling ofChildren(std::span<const Filling, 8> children, int height);

  const HeightFacts &facts(int height) const { return heights_[static_cast<std::size_t>(height)]; }

private:
  void add(const Filling &cube, int height);

  std::array<HeightFacts, kMaxLog2Extent + 1> heights_{};
};

} // namespace voxc
