// The words of a volume that is edited: new ones are added behind those that are there, and equal nodes are
// found among all. The grid of the first level, which nothing else leads to, may change where it is.
#pragma once

#include "Construct/Nodes/NodeStore.h"
#include "OldNodes.h"

#include "voxc/Construct/EditableVolume.h"

#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

class EditStore {
public:
  /// Words of a volume of this layout, which outlives this. Errors: no memory.
  static Expected<std::unique_ptr<EditStore>> create(std::span<const std::uint32_t> words,
                                                     const Layout &layout,
                                                     const std::shared_ptr<WorkingMemory> &memory);

  NodeStore &nodes() { return nodes_; }
  std::span<const std::uint32_t> words() const { return nodes_.words().span(); }
  Ref root() const { return words()[0]; }

  /// From now on no word changes that is there, but those of the head.
  void seal() { sealed_ = words().size(); }

  /// The words of a grid that a level changes: those that are there, or a copy. Null after a failure.
  std::uint32_t *open(unsigned level, Ref old, std::uint64_t count);
  /// Words of an open grid that are about to change.
  void touch(unsigned level, const std::uint32_t *words, std::uint64_t count);
  Ref close(unsigned level, bool shared);
  void abandon(unsigned level);

  /// Makes the changes since the last time those of the volume, whose root is now this; or undoes them.
  void commit(Ref root);
  void rollBack();
  /// Puts another root, and the one colour of all voxels where there is one.
  void setHead(Ref root, std::uint32_t colour);

  /// The words with another root, at other addresses. Error: no addresses.
  Expected<MemoryBlock> view(Ref root) const;

  /// The words that are others since the last call, in rising order, none of them twice.
  std::vector<WordRange> takeChanges();
  /// Makes them those of the next call again.
  void putBackChanges(std::span<const WordRange> changes);

private:
  struct OpenGrid {
    std::uint32_t *words = nullptr;
    std::uint64_t count = 0;
    Ref old = 0;
    bool inPlace = false;
  };
  /// Words as they were before they changed.
  struct Saved {
    std::uint64_t at;
    std::vector<std::uint32_t> words;
  };

  EditStore(WordStore words, const Layout &layout, const std::shared_ptr<WorkingMemory> &memory)
      : layout_(layout), nodes_(std::move(words), layout, memory), open_(layout.strata.size()) {}
  void noteDifferences(const Saved &saved);

  const Layout &layout_;
  NodeStore nodes_;
  std::uint64_t sealed_ = 0;
  std::uint64_t known_ = 0; ///< Words at the last `takeChanges`.
  std::vector<OpenGrid> open_;
  std::vector<Saved> saved_;
  std::vector<WordRange> changed_;
};

} // namespace voxc
