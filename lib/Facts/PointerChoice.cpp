// From the different blocks of 4^3 to the bits of their numbers, of which 0 is none.
#include "voxc/Facts/PointerChoice.h"

#include <algorithm>
#include <bit>

namespace voxc {
namespace {

constexpr std::size_t kGridHeight = 2; // Of the sub-volumes that short pointers lead to,
constexpr int kLeastPointer = 8;       // and the bits that these have.
constexpr int kMostPointer = 24;

/// No more than these, but for one estimate in many millions: its standard error is a two-hundredth.
std::uint64_t mostOf(const DistinctCount &shapes) {
  return shapes.exact ? shapes.count : shapes.count + shapes.count / 20;
}

} // namespace

std::optional<int> choosePointerBits(const Facts &facts) {
  if (facts.repetition.size() < kGridHeight) // One block at most.
    return kLeastPointer;
  const std::uint64_t shapes = mostOf(facts.repetition[kGridHeight - 1].shapes);
  const int bits = std::max(static_cast<int>(std::bit_width(shapes)), kLeastPointer);
  return bits > kMostPointer ? std::nullopt : std::optional(bits);
}

} // namespace voxc
