// The numbers of a box's blocks, one after the other.
#include "Input/Minecraft/BlockScene.h"

#include "Support/Text.h"

#include <string>

namespace voxc {

namespace {

Error tooFew(const BlockRegion &region) {
  return Error::input("its box of " + std::to_string(region.size[0]) + "x" + std::to_string(region.size[1]) +
                      "x" + std::to_string(region.size[2]) + " blocks has " +
                      std::to_string(region.data.size()) + " bytes of numbers, which are too few");
}

/// Seven bits a byte, at most five bytes; false at the end, or where there are more.
bool takeVarint(std::span<const std::byte> &data, std::uint64_t &number) {
  number = 0;
  for (unsigned shift = 0; shift < 35 && !data.empty(); shift += 7) {
    const auto byte = std::to_integer<std::uint64_t>(data.front());
    data = data.subspan(1);
    number |= (byte & 0x7f) << shift;
    if ((byte & 0x80) == 0)
      return true;
  }
  return false;
}

std::uint64_t longAt(std::span<const std::byte> data, std::uint64_t index) {
  std::uint64_t value = 0;
  for (const std::byte byte : data.subspan(static_cast<std::size_t>(8 * index), 8))
    value = value << 8 | std::to_integer<std::uint64_t>(byte);
  return value;
}

std::uint64_t packedAt(std::span<const std::byte> data, unsigned bits, std::uint64_t index) {
  const std::uint64_t first = index * bits, at = first / 64, shift = first % 64;
  std::uint64_t value = longAt(data, at) >> shift;
  if (shift + bits > 64)
    value |= longAt(data, at + 1) << (64 - shift);
  return value & ((std::uint64_t{1} << bits) - 1);
}

} // namespace

std::uint32_t BlockRegion::storedAt(std::size_t block) const {
  const auto low = std::to_integer<std::uint32_t>(data[block]);
  const auto pair = more.empty() ? 0 : std::to_integer<std::uint32_t>(more[block / 2]);
  const auto kind = kinds.empty() ? 0 : std::to_integer<std::uint32_t>(kinds[block]) & 15;
  return ((block % 2 == 0 ? pair & 15 : pair >> 4) << 8 | low) << 4 | kind;
}

std::uint32_t BlockRegion::numberAt(std::size_t block) const {
  constexpr std::uint32_t kPlant = 175, kUpper = 8; // The upper block says where it looks.
  const auto isHalf = [](std::uint32_t number, std::uint32_t half) {
    return number >> 4 == kPlant && (number & kUpper) == half;
  };
  const std::uint32_t number = storedAt(block);
  if (!isHalf(number, kUpper))
    return number;
  const auto layer = static_cast<std::size_t>(size[0] * size[2]);
  const std::uint32_t below = block < layer ? 0 : storedAt(block - layer);
  return isHalf(below, 0) ? below : number & ~kUpper;
}

Expected<void> BlockRegion::forEachBlock(
    const Progress &progress,
    FunctionRef<void(const std::array<std::int64_t, 3> &cell, std::uint32_t word)> visit) const {
  // At most 20 bits times 2^40 blocks.
  if (coding == BlockCoding::Packed && data.size() / 8 < (count() * bits + 63) / 64)
    return tooFew(*this);
  std::span<const std::byte> rest = data;
  std::uint64_t index = 0;
  std::array<std::int64_t, 3> cell{};
  for (cell[1] = 0; cell[1] < size[1]; ++cell[1])
    for (cell[2] = 0; cell[2] < size[2]; ++cell[2])
      for (cell[0] = 0; cell[0] < size[0]; ++cell[0], ++index) {
        if (index % kBlocksBetweenLooks == 0 && progress.stopped())
          return Error::interrupted();
        std::uint64_t number = 0;
        if (coding == BlockCoding::Varint && !takeVarint(rest, number))
          return tooFew(*this);
        if (coding == BlockCoding::Packed)
          number = packedAt(data, bits, index);
        if (coding == BlockCoding::Bytes)
          number = numberAt(static_cast<std::size_t>(index));
        if (number >= words.size())
          return Error::input("a block has the number " + std::to_string(number) +
                              ", but those of the palette end at " + std::to_string(words.size() - 1));
        const std::uint32_t word = words[static_cast<std::size_t>(number)];
        if (word == kNoBlock)
          return Error::input("a block has the number " + std::to_string(number) +
                              ", which its palette gives to no kind");
        if (word != 0)
          visit(cell, word);
      }
  return {};
}

} // namespace voxc
