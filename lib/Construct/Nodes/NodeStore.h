// Where construction puts words: the words themselves, which of them may be shared, and grids being filled.
#pragma once

#include "NodeMap.h"
#include "ReferenceCount.h"
#include "WordStore.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/Layout/Layout.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace voxc {

/// One thing that was put into a store, in the order of time: enough to do it again elsewhere.
struct BlockRecord {
  enum Kind : std::uint32_t { Append, Intern, Forget, InternLeaf };

  Kind kind;
  std::uint32_t level;
  std::uint64_t words; ///< How many; 0 of Forget.

  bool operator==(const BlockRecord &) const = default;
};

/// A cell of a hashed grid: its number, its value.
struct KeptCell {
  std::uint32_t cell;
  std::uint32_t value;
};

/// The words of a volume or of a part of one. The first failure is kept, and nothing is done after it.
class NodeStore {
public:
  /// Levels are numbered from 1. The blocks of an indexed one stand in an array: append and intern give their
  /// numbers, from 1 on. The others begin where references can lead to.
  NodeStore(WordStore words, const Layout &layout, std::shared_ptr<WorkingMemory> memory);

  /// Fails at more words than this, in place of the most that offsets can reach.
  void limit(std::uint64_t maxWords) { maxWords_ = std::min(maxWords, layout_.maxWords()); }

  /// The array of indexed blocks, from number 0 on, which is none; empty without.
  std::span<const std::uint32_t> array() const { return array_.span(); }

  /// Notes in `log` what is really written, from now on; null ends that.
  void logTo(std::vector<BlockRecord> *log) { log_ = log; }

  /// Adds zeros up to where a reference can lead to. What does not fit any more fails later.
  void align();

  /// What leads to the words, which are new or, if interned, may have been there. 1 after a failure.
  Ref append(unsigned level, std::span<const std::uint32_t> words);
  Ref intern(unsigned level, std::span<const std::uint32_t> words) {
    return intern(level, words, NodeMap::hashOf(words));
  }
  /// The same with the hash of the words.
  Ref intern(unsigned level, std::span<const std::uint32_t> words, std::uint32_t hash);
  Ref internLeaf(unsigned level, std::uint32_t value);
  /// Interns what is there already and was not interned before: a node, or the word of a leaf.
  void adopt(unsigned level, std::span<const std::uint32_t> words, Ref place);
  void adoptLeaf(unsigned level, std::uint32_t value, Ref place);
  /// What leads to a leaf that was interned before, if it was; 1 after a failure.
  std::optional<Ref> knownLeaf(unsigned level, std::uint32_t value);
  /// The same, and 0 where there is none.
  Ref leafAt(unsigned level, std::uint32_t value) {
    return at(level).leaves.find(NodeMap::hashOf(value)).value_or(0);
  }
  /// Brings near what `intern` of these words will look at: all of a few, in turn, and then their nodes.
  /// Returns their hash.
  std::uint32_t fetch(unsigned level, std::span<const std::uint32_t> words);
  void fetchNode(unsigned level, std::uint32_t hash);
  /// The same for `knownLeaf`.
  void fetchLeaf(unsigned level, std::uint32_t value) { at(level).leaves.fetch(NodeMap::hashOf(value)); }
  /// Tells that these words will soon be interned, which brings near where the search for them begins; and
  /// that no more are told of for now, which brings near what lies there. Neither changes anything.
  void announce(unsigned level, std::span<const std::uint32_t> words);
  void endAnnouncing(unsigned level);
  void forget(unsigned level);
  /// Gives back what finding words takes: nothing is interned any more.
  void forgetAll();

  /// Zeroed memory for the one grid that a level fills at a time; null after a failure.
  std::uint32_t *allocate(unsigned level, std::uint64_t count);
  void release(unsigned level);

  /// Cells of the one hashed grid that a level fills at a time, with their values.
  void keep(unsigned level, std::uint32_t cell, std::uint32_t value);
  std::span<const KeptCell> kept(unsigned level) { return at(level).kept.span(); }
  void drop(unsigned level);

  /// Lets the memory be kept within its bound, after so many words of a grid were touched.
  void pause(std::uint64_t words) { memory_->relieve(words * sizeof(std::uint32_t)); }

  /// Empties everything for another part; keeps the memory.
  void clear();

  void fail(Error error);
  const std::optional<Error> &failure() const { return failure_; }
  /// Goes on after a failure: what was put before it stays.
  std::optional<Error> takeFailure() { return std::exchange(failure_, std::nullopt); }

  WordStore &words() { return words_; }
  const WordStore &words() const { return words_; }
  /// What each level has come to; without shared nodes if references are not counted.
  std::vector<LevelReport> report() const;
  /// Counts references from now on, of which a report tells.
  void countReferences() { references_.emplace(layout_); }

private:
  struct Level {
    Level(const std::shared_ptr<WorkingMemory> &memory, int log2Unit)
        : leaves(memory, log2Unit), nodes(memory, log2Unit), kept(memory) {}

    NodeMap leaves;
    NodeMap nodes;
    ScratchArray<KeptCell> kept;
    MemoryBlock grid;
    std::uint64_t gridWords = 0; ///< 0: no grid is being filled.
    LevelReport report;
  };

  Level &at(unsigned level) { return levels_[level - 1]; }
  /// Where the blocks of a level lie.
  std::span<const std::uint32_t> written(unsigned level) const {
    return level == indexedLevel_ ? array_.span() : words_.span();
  }
  Ref put(unsigned level, std::span<const std::uint32_t> words);
  void note(BlockRecord::Kind kind, unsigned level, std::uint64_t words);
  void relieve();
  Error tooManyWords(unsigned level) const;
  bool fits(unsigned level, std::uint64_t words);
  void beginArray();
  std::uint32_t appendToArray(unsigned level, std::span<const std::uint32_t> words);
  Ref remember(BlockRecord::Kind kind, NodeMap &map, std::uint32_t hash, unsigned level,
               std::span<const std::uint32_t> words);

  Layout layout_;
  std::shared_ptr<WorkingMemory> memory_;
  WordStore words_;
  std::uint64_t maxWords_;
  unsigned indexedLevel_ = 0; ///< 0: none.
  int numberBits_ = 0;
  ScratchArray<std::uint32_t> array_;
  std::vector<Level> levels_;
  std::vector<BlockRecord> *log_ = nullptr;
  std::optional<ReferenceCount> references_;
  std::optional<Error> failure_;
  std::array<std::uint32_t, 64> announced_{}; ///< Hashes; of a brick there are no more.
  std::size_t announcedCount_ = 0;
  std::uint64_t interned_ = 0; ///< Calls so far.
};

} // namespace voxc
