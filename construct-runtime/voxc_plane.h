// voxc_plane.h: L1 distances within a plane of a grid, a byte each, so that processors take many at a time.
// In place of sweeps from cell to cell, each cell looks 1, 2, 4 cells and so on to both sides, as far as
// distances reach: every way is a sum of such steps. Around a plane and its rows lies what lowers nothing.
#pragma once

#include "voxc_grid.h"

namespace voxc::construct {

template <GridShape kShape, uint32_t kReach> class PlaneDistances {
public:
  // Small enough for the stack, and for sums of bytes.
  static constexpr bool kFits = kShape.x + kShape.y <= 12 && kReach < 128;

  PlaneDistances() {
    for (uint64_t i = 0; i < sizeof now_; ++i)
      now_[i] = next_[i] = kReach;
  }

  // Calls `set(slot, distance)` for each slot of a plane, those that are not 0 having distance 0.
  template <typename Set> void measure(uint32_t *plane, uint64_t slot_words, const Set &set) {
    for (uint64_t y = 0; y < kHeight; ++y)
      for (uint64_t x = 0; x < kWidth; ++x)
        now_[kMargin + y * kStride + x] = plane[slot_words * (y * kWidth + x)] == 0 ? kReach : 0;
    uint8_t *now = now_, *next = next_;
    const auto step = [&](uint64_t begin, uint64_t end, uint64_t apart, uint64_t cells) {
      lower(next + begin, now + begin, end - begin, apart, cells);
    };
    const auto swap = [&] {
      uint8_t *const lowered = next;
      next = now;
      now = lowered;
    };
    for (uint64_t cells = 1; cells <= last_step(kShape.x); cells *= 2, swap())
      for (uint64_t row = kMargin; row < kMargin + kCells; row += kStride)
        step(row, row + kWidth, cells, cells);
    for (uint64_t cells = 1; cells <= last_step(kShape.y); cells *= 2, swap())
      step(kMargin, kMargin + kCells, cells * kStride, cells);
    for (uint64_t y = 0; y < kHeight; ++y)
      for (uint64_t x = 0; x < kWidth; ++x)
        set(plane + slot_words * (y * kWidth + x), now[kMargin + y * kStride + x]);
  }

private:
  using uint8_t = unsigned char;

  // The longest step along an axis; 0 where there is a single cell, or none is within reach.
  static constexpr uint64_t last_step(int log2_cells) {
    const uint64_t cells = uint64_t{1} << log2_cells, most = (cells < kReach ? cells : kReach) - 1;
    uint64_t step = 0;
    for (uint64_t told = 0; told < most; told += step)
      step = step == 0 ? 1 : 2 * step;
    return step;
  }

  static constexpr uint64_t kWidth = uint64_t{1} << kShape.x, kHeight = uint64_t{1} << kShape.y;
  static constexpr uint64_t kStride = kWidth + last_step(kShape.x), kCells = kStride * kHeight;
  static constexpr uint64_t kMargin = kStride * last_step(kShape.y) + last_step(kShape.x);

  // Lowers `count` distances by those so many bytes apart, which are so many cells away.
  static void lower(uint8_t *__restrict to, const uint8_t *__restrict from, uint64_t count, uint64_t apart,
                    uint64_t cells) {
    for (uint64_t i = 0; i < count; ++i) {
      const uint8_t before = from[i - apart], behind = from[i + apart];
      const auto beside = static_cast<uint8_t>((before < behind ? before : behind) + cells);
      to[i] = from[i] < beside ? from[i] : beside;
    }
  }

  uint8_t now_[kMargin + kCells + kMargin];
  uint8_t next_[kMargin + kCells + kMargin];
};

} // namespace voxc::construct
