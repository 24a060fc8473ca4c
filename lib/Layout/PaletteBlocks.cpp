// Encoding, decoding and checking blocks of indices, and the table before them.
#include "voxc/Layout/PaletteBlocks.h"

#include "BlockContents.h"
#include "Fields.h"

#include <algorithm>
#include <array>
#include <bit>

namespace voxc {
namespace {

constexpr int kItemBitsShift = 16;
constexpr int kMaskBit = 21;
constexpr int kBeginsBit = 22;
constexpr int kCountShift = 24;
constexpr int kMostItemBits = 16;
constexpr int kBeginBits = kLog2ValueBlock;
/// A kernel looks for the run of a voxel in five steps.
constexpr std::uint64_t kMostBegins = 32;

constexpr std::uint32_t kColoursMask = (1u << 24) - 1;
constexpr int kEntryBitsShift = 24;

int bitsOfNumbers(std::uint64_t count) { return static_cast<int>(std::bit_width(count - 1)); }
std::uint64_t bitsOf(std::uint64_t fields, int bits) { return fields * static_cast<std::uint64_t>(bits); }

/// The head of a block, read, and what follows from it.
struct Head {
  Head(const WordReader &words, std::uint64_t at) : word(words[at]) {}

  std::uint32_t least() const { return word & 0xffff; }
  int itemBits() const { return static_cast<int>(word >> kItemBitsShift & 31); }
  bool hasMask() const { return (word >> kMaskBit & 1) != 0; }
  bool hasBegins() const { return (word >> kBeginsBit & 1) != 0; }
  bool hasPalette() const { return !hasBegins() && count() > 0; }
  /// Of the palette's items, or of the runs that begins tell.
  std::uint64_t count() const { return word >> kCountShift; }
  int numberBits() const { return bitsOfNumbers(count()); }
  std::uint64_t bitsAt() const { return 1 + (hasMask() ? kRunWords : 0); }
  std::uint64_t itemsBit() const { return hasBegins() ? bitsOf(count() - 1, kBeginBits) : 0; }
  std::uint64_t numbersBit() const { return bitsOf(count(), itemBits()); }

  std::uint32_t word;
};

std::uint64_t beginOf(const WordReader &words, std::uint64_t block, std::uint64_t run) {
  return readBits(words, block + 1, bitsOf(run - 1, kBeginBits), kBeginBits);
}

/// The run of voxel `i`, of a block whose begins tell runs: the last that begins at most there.
std::uint64_t runOf(const WordReader &words, std::uint64_t block, const Head &head, std::uint64_t i) {
  std::uint64_t run = 0;
  for (std::uint64_t step = kMostBegins / 2; step > 0; step /= 2)
    if (run + step < head.count() && beginOf(words, block, run + step) <= i)
      run += step;
  return run;
}

/// The index of voxel `i` of a block.
std::uint32_t indexIn(const WordReader &words, std::uint64_t block, std::uint64_t i) {
  const Head head(words, block);
  const std::uint64_t bits = block + head.bitsAt();
  if (head.hasMask())
    i = runsBegun(words, block + 1, i + 1) - 1;
  if (head.hasBegins())
    i = runOf(words, block, head, i);
  if (head.hasPalette())
    i = readBits(words, bits, head.numbersBit() + bitsOf(i, head.numberBits()), head.numberBits());
  return head.least() + readBits(words, bits, head.itemsBit() + bitsOf(i, head.itemBits()), head.itemBits());
}

/// One of the ways to tell a block.
struct Way {
  bool mask = false;
  bool begins = false;
  bool palette = false;
};

constexpr std::array<Way, 5> kWays = {{
    {},
    {.begins = true},
    {.palette = true},
    {.mask = true},
    {.mask = true, .palette = true},
}};

/// The words that a block takes behind its head.
std::uint64_t costOf(const Way &way, std::span<const std::uint32_t> indices, const BlockContents &contents,
                     int itemBits) {
  const std::uint64_t told = way.mask || way.begins ? contents.runs.size() : indices.size();
  const std::uint64_t items = way.palette ? contents.palette.size() : told;
  std::uint64_t bits = bitsOf(items, itemBits);
  if (way.palette)
    bits += bitsOf(told, bitsOfNumbers(items));
  if (way.begins)
    bits += bitsOf(told - 1, kBeginBits);
  return (way.mask ? kRunWords : 0) + wordsOfFields(bits, 1);
}

bool isOpen(const Way &way, const BlockContents &contents) {
  return !way.begins || contents.runs.size() <= kMostBegins;
}

/// Where the entries of a section stand, and what they lead to.
struct Table {
  Table(const WordReader &words, std::uint64_t section)
      : colours(words[section] & kColoursMask),
        entryBits(static_cast<int>(words[section] >> kEntryBitsShift)), at(section + 1 + colours) {}

  std::uint64_t colours;
  int entryBits;
  std::uint64_t at;
};

/// Checks the blocks of a section, those that come again only where they are remembered.
class Check {
public:
  Check(WordReader &words, std::uint64_t section, const Table &table)
      : words_(words), section_(section), table_(table) {}

  bool entry(std::uint64_t entry, std::uint64_t first, std::uint64_t voxels) {
    if (entry >= 1 && entry <= table_.colours)
      return true;
    if (entry < first || !words_.require(section_ + entry, 2, "a block of indices"))
      return false;
    if (voxels == kValueBlock) {
      std::uint64_t &known = known_[entry % known_.size()];
      if (known == entry)
        return true;
      known = entry;
    }
    return isBlock(section_ + entry, voxels);
  }

private:
  bool isBlock(std::uint64_t block, std::uint64_t voxels) {
    const Head head(words_, block);
    if (head.itemBits() > kMostItemBits || (head.hasMask() && head.hasBegins()))
      return false;
    if (head.hasBegins() && (head.count() == 0 || head.count() > kMostBegins))
      return false;
    // With its mask and the word behind it, which bits are read with.
    if (!words_.require(block, head.bitsAt() + 1, "a block of indices"))
      return false;
    if (head.hasMask() && (words_[block + 1] & 1) == 0)
      return false;
    const std::uint64_t told = head.hasMask() ? runsBegun(words_, block + 1, voxels) : voxels;
    const std::uint64_t bits = head.hasBegins()    ? head.itemsBit() + bitsOf(head.count(), head.itemBits())
                               : head.hasPalette() ? head.numbersBit() + bitsOf(told, head.numberBits())
                                                   : bitsOf(told, head.itemBits());
    if (!words_.require(block, head.bitsAt() + wordsOfFields(bits, 1) + 1, "a block of indices"))
      return false;
    for (std::uint64_t i = 0; i < voxels; ++i)
      if (!isItem(block, head, i))
        return false;
    return true;
  }

  /// Voxel `i` has an item of the palette, if there is one, and an index in the table.
  bool isItem(std::uint64_t block, const Head &head, std::uint64_t i) const {
    if (head.hasPalette()) {
      const std::uint64_t told = head.hasMask() ? runsBegun(words_, block + 1, i + 1) - 1 : i;
      const std::uint64_t first = head.numbersBit() + bitsOf(told, head.numberBits());
      if (readBits(words_, block + head.bitsAt(), first, head.numberBits()) >= head.count())
        return false;
    }
    return indexIn(words_, block, i) < table_.colours;
  }

  WordReader &words_;
  std::uint64_t section_;
  const Table &table_;
  std::array<std::uint64_t, 4096> known_{}; ///< Whole blocks that were checked last, by their offsets' ends.
};

} // namespace

std::vector<std::uint32_t> encodeIndexBlock(std::span<const std::uint32_t> indices) {
  const BlockContents contents = contentsOf(indices);
  const auto [least, greatest] = std::ranges::minmax(contents.palette);
  const int itemBits = static_cast<int>(std::bit_width(greatest - least));
  Way best;
  for (const Way &way : kWays)
    if (isOpen(way, contents) &&
        costOf(way, indices, contents, itemBits) < costOf(best, indices, contents, itemBits))
      best = way;

  const std::uint64_t count = best.palette ? contents.palette.size() : best.begins ? contents.runs.size() : 0;
  std::vector<std::uint32_t> words = {least | static_cast<std::uint32_t>(itemBits) << kItemBitsShift |
                                      static_cast<std::uint32_t>(best.mask) << kMaskBit |
                                      static_cast<std::uint32_t>(best.begins) << kBeginsBit |
                                      static_cast<std::uint32_t>(count) << kCountShift};
  if (best.mask)
    words.insert(words.end(), contents.mask.begin(), contents.mask.end());
  BitWriter writer(words);
  if (best.begins)
    for (const std::uint32_t begin : std::span(contents.begins).subspan(1))
      writer.write(begin, kBeginBits);
  const auto told = best.mask || best.begins ? std::span<const std::uint32_t>(contents.runs) : indices;
  for (const std::uint32_t index : best.palette ? std::span<const std::uint32_t>(contents.palette) : told)
    writer.write(index - least, itemBits);
  if (best.palette)
    for (const std::uint32_t index : told)
      writer.write(contents.indexOf(index), bitsOfNumbers(count));
  writer.align();
  return words;
}

std::vector<std::uint32_t> paletteHead(std::span<const std::uint32_t> colours, int entryBits) {
  std::vector<std::uint32_t> words = {static_cast<std::uint32_t>(colours.size()) |
                                      static_cast<std::uint32_t>(entryBits) << kEntryBitsShift};
  words.insert(words.end(), colours.begin(), colours.end());
  return words;
}

int entryBitsOf(std::uint64_t colours, std::uint64_t blocks, std::uint64_t blockWords) {
  const auto greatest = [&](int bits) {
    return colours + (blockWords == 0 ? 0 : wordsOfFields(blocks, bits) + blockWords);
  };
  int bits = 1;
  while (bits <= 32 && greatest(bits) >> bits != 0)
    ++bits;
  return bits;
}

std::uint64_t packEntries(std::span<std::uint32_t> entries, int bits) {
  // An entry's field ends at most in its own word, which has been read by then.
  std::uint64_t pending = 0;
  int count = 0;
  std::size_t words = 0;
  for (const std::uint32_t entry : entries) {
    pending |= std::uint64_t{entry} << count;
    count += bits;
    if (count < 32)
      continue;
    entries[words++] = static_cast<std::uint32_t>(pending);
    pending >>= 32;
    count -= 32;
  }
  if (count > 0)
    entries[words++] = static_cast<std::uint32_t>(pending);
  return words;
}

std::uint32_t colourOfRank(const WordReader &words, std::uint64_t section, std::uint64_t rank) {
  const Table table(words, section);
  const std::uint64_t entry = readField(words, table.at, rank >> kLog2ValueBlock, table.entryBits & 63);
  if (entry <= table.colours)
    return words[section + entry];
  return words[section + 1 + indexIn(words, section + entry, rank & (kValueBlock - 1))];
}

std::uint64_t paletteColours(const WordReader &words, std::uint64_t section) {
  return Table(words, section).colours;
}

void checkPalette(WordReader &words, std::uint64_t section, std::uint64_t voxels, std::uint64_t mostColours) {
  if (!words.require(section, 1, "the colours of the voxels"))
    return;
  const Table table(words, section);
  if (table.colours > mostColours || table.colours == 0 || table.entryBits < 1 || table.entryBits > 32)
    return words.fail("the table of colours has " + std::to_string(table.colours) + " and entries of " +
                      std::to_string(table.entryBits) + " bits; it may have 1 to " +
                      std::to_string(mostColours) + ", and entries of 1 to 32 bits");
  const std::uint64_t blocks = (voxels + kValueBlock - 1) >> kLog2ValueBlock;
  // Fields are read with the word behind them; bits of so many entries are more than 64 bits count.
  if (blocks > 32 * words.size() ||
      !words.require(section, 1 + table.colours + wordsOfFields(blocks, table.entryBits) + 1,
                     "the values of the voxels"))
    return words.fail("the values of the voxels lie outside");
  const std::uint64_t first = 1 + table.colours + wordsOfFields(blocks, table.entryBits);
  Check check(words, section, table);
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const std::uint64_t entry = readField(words, table.at, block, table.entryBits);
    if (!check.entry(entry, first, std::min(kValueBlock, voxels - block * kValueBlock)))
      return words.fail("block " + std::to_string(block) + " of the values is broken");
  }
  for (std::uint64_t i = 0; i < table.colours; ++i)
    if (words[section + 1 + i] == 0)
      return words.fail("colour " + std::to_string(i) + " of the table is the word 0, which is no voxel");
}

} // namespace voxc
