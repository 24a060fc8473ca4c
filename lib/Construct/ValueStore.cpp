// From values to blocks, and to the words of the volume.
#include "ValueStore.h"

#include "NodeMap.h"

#include <algorithm>

namespace voxc {
namespace {

constexpr std::size_t kBlock = std::size_t{1} << kLog2ValueBlock;
/// Ranks are words.
constexpr std::uint64_t kMostBlocks = (std::uint64_t{1} << (32 - kLog2ValueBlock)) - 1;

} // namespace

bool ValueStore::keep(Expected<void> done) {
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
  const std::vector<std::uint32_t> block = encodeValueBlock(pending_);
  pending_.clear();
  if (begins_.size() == kMostBlocks)
    return nodes_.fail(Error::input("the volume has more than 2^32 voxels, the most whose values can stand "
                                    "apart; build it without values-apart"));
  Known &known = known_[NodeMap::hashOf(block) % kKnown];
  const auto old = blocks_.span().subspan(known.begin, known.words);
  if (!std::ranges::equal(old, block)) {
    known = {blocks_.size(), block.size()};
    if (!keep(blocks_.append(block)))
      return;
  }
  const auto begin = static_cast<std::uint32_t>(known.begin);
  keep(begins_.append({&begin, 1}));
}

void ValueStore::finish(WordStore &words, std::uint64_t maxWords) {
  if (!pending_.empty())
    encode();
  if (nodes_.failure())
    return;
  const std::uint64_t section = words.size();
  const std::uint64_t size = begins_.size() + blocks_.size() + 1;
  if (section + size > maxWords)
    return nodes_.fail(Error::input("the volume needs more than " + std::to_string(maxWords) +
                                    " words, the most that it may have: " + std::to_string(section) +
                                    " are written, and the values of its voxels take " +
                                    std::to_string(size) + "; a lower resolution would fit"));
  words.setHead(1, static_cast<std::uint32_t>(section));
  if (begins_.empty())
    return;
  for (std::uint32_t &begin : begins_.span())
    begin += static_cast<std::uint32_t>(begins_.size());
  if (!keep(words.append(begins_.span())) || !keep(words.append(blocks_.span())))
    return;
  const std::uint32_t last = 0;
  keep(words.append({&last, 1}));
}

} // namespace voxc
