// How many references lead to the blocks of each level of a volume.
#pragma once

#include "voxc/Layout/Layout.h"
#include "voxc/Layout/WordReader.h"

#include <cstdint>
#include <vector>

namespace voxc {

/// Counts references as the blocks that hold them are written, so that a volume has the same count by
/// whatever threads and parts it is built. Levels whose blocks are not shared are left out.
class ReferenceCount {
public:
  /// The layout outlives this.
  explicit ReferenceCount(const Layout &layout) : layout_(layout), counts_(layout.strata.size() + 1) {}

  /// A node of strata[index], or records of siblings, of so many words.
  void addNode(std::size_t index, const WordReader &words, std::uint64_t at, std::uint64_t count);
  /// The word of a leaf.
  void addLeaf(std::size_t index) { addValue(index); }

  /// Of `blocks` that strata[index] has, how many times another reference led to one already.
  std::uint64_t sharedOf(std::size_t index, std::uint64_t blocks) const;

private:
  bool isShared(std::size_t index) const {
    return index < layout_.strata.size() && layout_.strata[index].sharing != Sharing::None;
  }
  void addValue(std::size_t index) { counts_[index + 1] += layout_.holdsVoxels(index) ? 0 : 1; }
  void addRecords(std::size_t index, const WordReader &words, std::uint64_t at, std::uint64_t count);

  const Layout &layout_;
  std::vector<std::uint64_t> counts_;
};

} // namespace voxc
