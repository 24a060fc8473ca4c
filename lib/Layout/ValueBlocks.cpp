// Encoding, decoding and checking blocks of values.
#include "voxc/Layout/ValueBlocks.h"

#include "BlockContents.h"
#include "Fields.h"

#include <algorithm>
#include <array>
#include <bit>

namespace voxc {
namespace {

constexpr std::uint64_t kHeadWords = 2;
constexpr int kMostIndexBits = kLog2ValueBlock;

constexpr int kDifferencesBit = 16;
constexpr int kRunsBit = 17;
constexpr int kIndexShift = 18;
constexpr int kItemsShift = 24;

using Channels = std::array<std::uint32_t, 4>;

std::uint32_t byte(std::uint32_t value) { return value & 0xff; }
std::uint32_t channel(std::uint32_t value, int i) { return byte(value >> 8 * i); }

/// R and B as their differences from G.
Channels toDifferences(std::uint32_t value) {
  const std::uint32_t g = channel(value, 1);
  return {byte(channel(value, 0) - g), g, byte(channel(value, 2) - g), channel(value, 3)};
}

/// How the channels of a set of values are told.
struct Coding {
  bool differences = false;
  Channels least{};
  std::array<int, 4> bits{};

  int itemBits() const { return bits[0] + bits[1] + bits[2] + bits[3]; }

  std::uint32_t item(std::uint32_t value) const {
    const Channels channels =
        differences ? toDifferences(value)
                    : Channels{channel(value, 0), channel(value, 1), channel(value, 2), channel(value, 3)};
    std::uint32_t item = 0;
    for (int i = 0, at = 0; i < 4; at += bits[i++])
      if (bits[i] > 0)
        item |= byte(channels[i] - least[i]) << at;
    return item;
  }
};

/// The least and the greatest of one channel; `signedly`: as a difference, from -255 to 255.
void cover(std::span<const std::uint32_t> values, int i, bool signedly, Coding &coding) {
  int least = 255;
  int greatest = -255;
  for (const std::uint32_t value : values) {
    const int from = signedly ? static_cast<int>(channel(value, 1)) : 0;
    const int told = static_cast<int>(channel(value, i)) - from;
    least = std::min(least, told);
    greatest = std::max(greatest, told);
  }
  // Modulo 256, no difference takes more than a byte.
  coding.bits[i] = std::min(static_cast<int>(std::bit_width(static_cast<unsigned>(greatest - least))), 8);
  coding.least[i] = static_cast<std::uint32_t>(least) & 0xff;
}

Coding codingOf(std::span<const std::uint32_t> values) {
  std::array<Coding, 2> codings;
  for (int differences = 0; differences < 2; ++differences) {
    Coding &coding = codings[differences];
    coding.differences = differences != 0;
    for (int i = 0; i < 4; ++i)
      cover(values, i, coding.differences && i % 2 == 0 && i < 3, coding);
  }
  return codings[1].itemBits() < codings[0].itemBits() ? codings[1] : codings[0];
}

/// The head of a block, read.
struct Head {
  Head(const WordReader &words, std::uint64_t at) : least(words[at]), word(words[at + 1]) {}

  int bits(int i) const { return static_cast<int>(word >> 4 * i & 15); }
  int itemBits() const { return bits(0) + bits(1) + bits(2) + bits(3); }
  bool differences() const { return (word >> kDifferencesBit & 1) != 0; }
  bool runs() const { return (word >> kRunsBit & 1) != 0; }
  int indexBits() const { return static_cast<int>(word >> kIndexShift & 15); }
  std::uint64_t itemsAt() const { return word >> kItemsShift; }
  std::uint64_t indicesAt() const { return kHeadWords + (runs() ? kRunWords : 0); }

  std::uint32_t least;
  std::uint32_t word;
};

std::uint32_t valueOfItem(const Head &head, std::uint32_t item) {
  Channels channels{};
  for (int i = 0; i < 4; ++i) {
    channels[i] = byte(channel(head.least, i) + (item & ((1u << head.bits(i)) - 1)));
    item >>= head.bits(i);
  }
  if (head.differences()) {
    channels[0] = byte(channels[0] + channels[1]);
    channels[2] = byte(channels[2] + channels[1]);
  }
  return channels[0] | channels[1] << 8 | channels[2] << 16 | channels[3] << 24;
}

/// True if so many items of a block may be values, of which 0 is none. Where the least alpha is not 0, none
/// is.
bool areValues(const WordReader &words, std::uint64_t at, std::uint64_t items) {
  const Head head(words, at);
  const std::uint32_t alpha = channel(head.least, 3);
  if (alpha != 0 && alpha + (1u << head.bits(3)) <= 256)
    return true;
  for (std::uint64_t i = 0; i < items; ++i)
    if (valueOfItem(head, readField(words, at + head.itemsAt(), i, head.itemBits())) == 0)
      return false;
  return true;
}

/// True if a block of `count` values is whole and within the words. `mayBeZero`: 0 is a value.
bool isBlock(WordReader &words, std::uint64_t at, std::uint64_t count, bool mayBeZero) {
  if (!words.require(at, kHeadWords, "a block of values"))
    return false;
  const Head head(words, at);
  for (int i = 0; i < 4; ++i)
    if (head.bits(i) > 8)
      return false;
  if (head.indexBits() > kMostIndexBits || !words.require(at, head.itemsAt() + 1, "a block of values"))
    return false;
  if (head.runs() && (words[at + kHeadWords] & 1) == 0)
    return false;
  const std::uint64_t indices = head.runs() ? runsBegun(words, at + kHeadWords, count) : count;
  if (head.itemsAt() != head.indicesAt() + wordsOfFields(indices, head.indexBits()))
    return false;
  std::uint64_t items = indices;
  if (head.indexBits() > 0) {
    items = 0;
    for (std::uint64_t i = 0; i < indices; ++i)
      items =
          std::max<std::uint64_t>(items, readField(words, at + head.indicesAt(), i, head.indexBits()) + 1);
  }
  return words.require(at, head.itemsAt() + wordsOfFields(items, head.itemBits()) + 1, "a block of values") &&
         (mayBeZero || areValues(words, at, items));
}

} // namespace

std::vector<std::uint32_t> encodeValueBlock(std::span<const std::uint32_t> values) {
  const BlockContents contents = contentsOf(values);
  const Coding coding = codingOf(contents.palette);
  const int itemBits = coding.itemBits();
  const int indexBits = static_cast<int>(std::bit_width(contents.palette.size() - 1));
  const std::array<std::uint64_t, 4> costs = {
      wordsOfFields(values.size(), itemBits), kRunWords + wordsOfFields(contents.runs.size(), itemBits),
      wordsOfFields(values.size(), indexBits) + wordsOfFields(contents.palette.size(), itemBits),
      kRunWords + wordsOfFields(contents.runs.size(), indexBits) +
          wordsOfFields(contents.palette.size(), itemBits)};
  const auto best = static_cast<unsigned>(std::ranges::min_element(costs) - costs.begin());
  const bool hasRuns = (best & 1) != 0;
  const bool hasPalette = (best & 2) != 0;

  std::vector<std::uint32_t> words = {0, 0};
  if (hasRuns)
    words.insert(words.end(), contents.mask.begin(), contents.mask.end());
  const std::span<const std::uint32_t> told = hasRuns ? std::span(contents.runs) : values;
  BitWriter writer(words);
  if (hasPalette)
    for (const std::uint32_t value : told)
      writer.write(contents.indexOf(value), indexBits);
  writer.align();
  const std::uint64_t itemsAt = words.size();
  for (const std::uint32_t value : hasPalette ? std::span<const std::uint32_t>(contents.palette) : told)
    writer.write(coding.item(value), itemBits);
  writer.align();
  for (int i = 0; i < 4; ++i) {
    words[0] |= coding.least[i] << 8 * i;
    words[1] |= static_cast<std::uint32_t>(coding.bits[i]) << 4 * i;
  }
  words[1] |= static_cast<std::uint32_t>(coding.differences) << kDifferencesBit |
              static_cast<std::uint32_t>(hasRuns) << kRunsBit |
              static_cast<std::uint32_t>(hasPalette ? indexBits : 0) << kIndexShift |
              static_cast<std::uint32_t>(itemsAt) << kItemsShift;
  return words;
}

std::uint32_t valueOfRank(const WordReader &words, std::uint64_t section, std::uint64_t rank) {
  const std::uint64_t at = section + words[section + (rank >> kLog2ValueBlock)];
  const Head head(words, at);
  std::uint64_t i = rank & (kValueBlock - 1);
  if (head.runs())
    i = runsBegun(words, at + kHeadWords, i + 1) - 1;
  if (head.indexBits() > 0)
    i = readField(words, at + head.indicesAt(), i, head.indexBits());
  return valueOfItem(head, readField(words, at + head.itemsAt(), i, head.itemBits()));
}

void checkValues(WordReader &words, std::uint64_t section, std::uint64_t voxels, bool mayBeZero) {
  const std::uint64_t blocks = (voxels + kValueBlock - 1) >> kLog2ValueBlock;
  if (!words.require(section, blocks, "the values of the voxels"))
    return;
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const std::uint64_t at = section + words[section + block];
    const std::uint64_t count = std::min(kValueBlock, voxels - block * kValueBlock);
    if (words[section + block] < blocks || !isBlock(words, at, count, mayBeZero))
      return words.fail("block " + std::to_string(block) + " of the values is broken");
  }
}

} // namespace voxc
