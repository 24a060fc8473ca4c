// Counting the references of nodes.
#include "ReferenceCount.h"

#include "Layout/Masks.h"
#include "voxc/Layout/SlotKind.h"

namespace voxc {

void ReferenceCount::addNode(std::size_t index, const WordReader &words, std::uint64_t at,
                             std::uint64_t count) {
  const Stratum &stratum = layout_.strata[index];
  const bool ends = stratum.isGrid() && layout_.holdsVoxels(index);
  if (ends || (!isShared(index) && !isShared(index + 1)))
    return;
  if (stratum.hasRecords())
    return addRecords(index, words, at, count);
  stratum.slots->visit(words, stratum, at, [&](Int3, const Child &child) {
    const bool isBlock = !stratum.isGrid() && (!child.leaf || stratum.hasLeafWords());
    if (isBlock)
      ++counts_[index];
    else
      addValue(index);
  });
}

/// The masks of a record are 0 where its first word is a value.
void ReferenceCount::addRecords(std::size_t index, const WordReader &words, std::uint64_t at,
                                std::uint64_t count) {
  const std::uint64_t recordWords = 1 + MaskShape(layout_.strata[index]).words();
  for (std::uint64_t end = at + count; at < end; at += recordWords) {
    bool isValue = true;
    for (std::uint64_t i = 1; i < recordWords; ++i)
      isValue &= words[at + i] == 0;
    if (isValue)
      addValue(index);
  }
}

std::uint64_t ReferenceCount::sharedOf(std::size_t index, std::uint64_t blocks) const {
  const std::uint64_t references = counts_[index] + (index == 0 ? 1 : 0); // The root's.
  return isShared(index) && references > blocks && blocks > 0 ? references - blocks : 0;
}

} // namespace voxc
