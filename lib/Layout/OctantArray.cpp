// Small grids by octants: writing, finding and checking them.
#include "voxc/Layout/OctantArray.h"

#include <bit>

namespace voxc {
namespace {

constexpr std::uint64_t kGroup = 16; ///< Grids of a group.
constexpr std::uint64_t kHeadWords = 1 + kGroup / 4;
/// Kernels tell the bits of an array by 32 bits.
constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 28;

/// Words of the heads of so many grids.
std::uint64_t headsOf(std::uint64_t grids) { return (grids + kGroup - 1) / kGroup + (grids + 3) / 4; }

std::uint32_t byteAt(const WordReader &words, std::uint64_t byte) {
  return words[byte / 4] >> 8 * (byte % 4) & 0xff;
}

std::uint64_t maskOf(std::span<const std::uint32_t> grids, std::uint64_t i) {
  return grids[2 * i] | std::uint64_t{grids[2 * i + 1]} << 32;
}

std::uint32_t octantsOf(std::uint64_t mask) {
  std::uint32_t octants = 0;
  for (int octant = 0; octant < 8; ++octant)
    octants |= (mask >> 8 * octant & 0xff) != 0 ? 1u << octant : 0;
  return octants;
}

std::uint64_t countOf(std::uint32_t octants) { return static_cast<std::uint64_t>(std::popcount(octants)); }

/// Puts words together of bytes.
class Bytes {
public:
  explicit Bytes(FunctionRef<void(std::uint32_t)> put) : put_(put) {}

  void add(std::uint32_t byte) {
    word_ |= byte << 8 * (count_++ % 4);
    if (count_ % 4 == 0)
      end();
  }
  /// Puts what is left of a word.
  void finish() {
    if (count_ % 4 != 0)
      end();
    count_ = 0;
  }

private:
  void end() {
    put_(word_);
    word_ = 0;
  }

  FunctionRef<void(std::uint32_t)> put_;
  std::uint32_t word_ = 0;
  std::uint64_t count_ = 0;
};

/// Where the head of a grid's group begins, and its place in the group.
struct Place {
  std::uint64_t head;
  std::uint64_t inGroup;
};

Place placeOf(std::uint64_t array, std::uint64_t number) {
  const std::uint64_t index = number - 1;
  return {array + index / kGroup * kHeadWords, index % kGroup};
}

} // namespace

std::uint64_t octantArrayWords(std::uint64_t grids, std::uint64_t octants) {
  return headsOf(grids) + (octants + 3) / 4;
}

void writeOctantArray(std::span<const std::uint32_t> grids, FunctionRef<void(std::uint32_t)> put) {
  const std::uint64_t count = grids.size() / 2;
  std::uint64_t cells = 4 * headsOf(count);
  Bytes bytes(put);
  for (std::uint64_t i = 0; i < count; ++i) {
    if (i % kGroup == 0) // The bytes of the group before are whole words.
      put(static_cast<std::uint32_t>(cells));
    const std::uint32_t octants = octantsOf(maskOf(grids, i));
    bytes.add(octants);
    cells += countOf(octants);
  }
  bytes.finish();
  for (std::uint64_t i = 0; i < count; ++i)
    for (int octant = 0; octant < 8; ++octant)
      if (const auto byte = static_cast<std::uint32_t>(maskOf(grids, i) >> 8 * octant & 0xff); byte != 0)
        bytes.add(byte);
  bytes.finish();
}

OctantGrid octantGrid(const WordReader &words, std::uint64_t array, std::uint64_t number) {
  const auto [head, inGroup] = placeOf(array, number);
  std::uint64_t cells = 4 * array + words[head];
  for (std::uint64_t i = 0; i < inGroup; ++i)
    cells += countOf(byteAt(words, 4 * (head + 1) + i));
  return {byteAt(words, 4 * (head + 1) + inGroup), cells};
}

bool checkOctantGrid(WordReader &words, std::uint64_t array, std::uint64_t number, bool ranked) {
  const auto [head, inGroup] = placeOf(array, number);
  if (!words.require(head, 2 + inGroup / 4, "the head of a group of grids"))
    return false;
  const OctantGrid grid = octantGrid(words, array, number);
  const std::uint64_t end = grid.cells + countOf(grid.octants);
  if (grid.octants == 0 || end > 4 * array + kMaxBytes) {
    words.fail(grid.octants == 0 ? "a node has no child" : "the cells of a grid lie outside of their array");
    return false;
  }
  if (!words.require(grid.cells / 4, (end - 1) / 4 - grid.cells / 4 + (ranked ? 2 : 1),
                     "the cells of a grid"))
    return false;
  for (std::uint64_t byte = grid.cells; byte < end; ++byte)
    if (byteAt(words, byte) == 0) {
      words.fail("a grid names an octant that is empty");
      return false;
    }
  return true;
}

std::uint64_t cellsOf(const WordReader &words, const OctantGrid &grid) {
  std::uint64_t mask = 0;
  std::uint64_t byte = grid.cells;
  for (int octant = 0; octant < 8; ++octant)
    if ((grid.octants >> octant & 1) != 0)
      mask |= std::uint64_t{byteAt(words, byte++)} << 8 * octant;
  return mask;
}

} // namespace voxc
