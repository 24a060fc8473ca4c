// From values to blocks, and to the words of the volume.
#include "ValueStore.h"

#include "NodeMap.h"

#include "voxc/Layout/PaletteBlocks.h"
#include "voxc/Layout/ValueBlocks.h"

#include <algorithm>
#include <functional>

namespace voxc {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << kLog2ValueBlock;
/// Ranks are words.
constexpr std::uint64_t kMostBlocks = (std::uint64_t{1} << (32 - kLog2ValueBlock)) - 1;

} // namespace

ValueStore::ValueStore(NodeStore &nodes, VoxelFacts facts, const std::shared_ptr<WorkingMemory> &memory)
    : nodes_(nodes), code_(kindOf(facts.payload).code), blocks_(memory), begins_(memory), known_(kKnown) {
  if (kindOf(facts.payload).mostBits > 0)
    palette_.emplace(std::size_t{1} << facts.payloadBits);
}

bool ValueStore::keep(const Expected<void> &done) {
  if (!done)
    nodes_.fail(done.error());
  return static_cast<bool>(done);
}

void ValueStore::put(std::span<const std::uint32_t> values) {
  while (!values.empty() && !nodes_.failure()) {
    const auto piece = values.first(std::min(values.size(), kBlock - pending_.size()));
    pending_.insert(pending_.end(), piece.begin(), piece.end());
    values = values.subspan(piece.size());
    if (pending_.size() == kBlock)
      encode();
  }
}

void ValueStore::encode() {
  if (code_)
    std::ranges::transform(pending_, pending_.begin(), code_);
  if (palette_)
    encodeIndices();
  else
    keepBlock(encodeValueBlock(pending_), 0);
  pending_.clear();
}

/// A block of one colour is told by the colour's number; others by where they begin, above all such numbers.
void ValueStore::encodeIndices() {
  for (std::uint32_t &value : pending_) {
    const auto number = palette_->numberOf(value);
    if (!number)
      return nodes_.fail(
          Error::input("the voxels have more colours than the " + std::to_string(palette_->colours().size()) +
                       " that the format states; build it without palette, or with a larger one"));
    value = *number;
  }
  if (std::ranges::adjacent_find(pending_, std::not_equal_to()) == pending_.end())
    tell(pending_.front());
  else
    keepBlock(encodeIndexBlock(pending_), kMostPaletteColours);
}

void ValueStore::append(WordStore &words, std::span<const std::uint32_t> more) {
  if (!nodes_.failure())
    keep(words.append(more));
}

void ValueStore::keepBlock(std::span<const std::uint32_t> block, std::uint64_t before) {
  Known &known = known_[NodeMap::hashOf(block) % kKnown];
  const auto old = blocks_.span().subspan(known.begin, known.words);
  if (!std::ranges::equal(old, block)) {
    known = {blocks_.size(), block.size()};
    if (!keep(blocks_.append(block)))
      return;
  }
  tell(known.begin + before);
}

/// Of the next block.
void ValueStore::tell(std::uint64_t begin) {
  if (begins_.size() == kMostBlocks || begin >> 32 != 0)
    return nodes_.fail(Error::input("the volume has more than 2^32 voxels, the most whose values can stand "
                                    "apart; build it without values-apart"));
  const auto word = static_cast<std::uint32_t>(begin);
  keep(begins_.append({&word, 1}));
}

/// Makes entries of what tells blocks.
void ValueStore::packTable(std::uint64_t colours, int bits) {
  const std::uint64_t tableWords = (begins_.size() * static_cast<std::uint64_t>(bits) + 31) / 32;
  for (std::uint32_t &begin : begins_.span())
    begin = static_cast<std::uint32_t>(
        1 + (begin < kMostPaletteColours ? begin : begin - kMostPaletteColours + colours + tableWords));
  packEntries(begins_.span(), bits);
}

void ValueStore::finish(WordStore &words, std::uint64_t maxWords) {
  if (!pending_.empty())
    encode();
  if (nodes_.failure())
    return;
  const std::uint64_t colours = palette_ ? palette_->colours().size() : 0;
  const int entryBits = palette_ ? entryBitsOf(colours, begins_.size(), blocks_.size()) : 32;
  const std::uint64_t tableWords = (begins_.size() * static_cast<std::uint64_t>(entryBits) + 31) / 32;
  const std::uint64_t section = words.size();
  const std::uint64_t size = (palette_ ? 1 + colours : 0) + tableWords + blocks_.size() + 1;
  if (entryBits > 32 || section + size > maxWords)
    return nodes_.fail(Error::input("the volume needs more than " + std::to_string(maxWords) +
                                    " words, the most that it may have: " + std::to_string(section) +
                                    " are written, and the values of its voxels take " +
                                    std::to_string(size) + "; a lower resolution would fit"));
  words.setHead(1, static_cast<std::uint32_t>(section));
  if (begins_.empty())
    return;
  if (palette_) {
    packTable(colours, entryBits);
    append(words, paletteHead(palette_->colours(), entryBits));
  } else {
    for (std::uint32_t &begin : begins_.span())
      begin += static_cast<std::uint32_t>(begins_.size());
  }
  append(words, begins_.span().first(tableWords));
  append(words, blocks_.span());
  const std::uint32_t last = 0;
  append(words, {&last, 1});
}

} // namespace voxc
