// The words of a volume while it is built: appended at the end, read anywhere.
#pragma once

#include "voxc/Support/WorkingMemory.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>

namespace voxc {

/// Words at addresses that never change, in working memory or, but for the last ones, in a file. The first is
/// kept for the root's offset, and one more is where the layout has a longer head.
class WordStore {
public:
  /// Writes pages of the block to where they shall stay, [begin, begin + bytes), and maps them from there.
  using Flush = std::function<Expected<void>(MemoryBlock &block, std::uint64_t begin, std::uint64_t bytes)>;

  /// Words in working memory, `mostWords` at most; if `flush` is given, they move there as they become
  /// complete. Error: `Environment`.
  static Expected<WordStore> create(const std::shared_ptr<WorkingMemory> &memory, Flush flush = {},
                                    std::uint64_t mostWords = std::uint64_t{1} << 32);

  /// Words of which there are views.
  static Expected<WordStore> createShared(const std::shared_ptr<WorkingMemory> &memory,
                                          std::uint64_t mostWords);
  /// All words as they are, at other addresses: words of the head may be others there. Of `createShared`.
  Expected<MemoryBlock> view() const { return memory_->view(block_, bytes()); }

  std::uint64_t size() const { return size_; }
  std::span<const std::uint32_t> span() const { return {words(), size_}; }
  /// Bytes [first, second) were flushed.
  std::pair<std::uint64_t, std::uint64_t> flushed() const { return {flushedBegin_, flushedEnd_}; }

  /// Appends words; the caller has seen to it that there are not too many in all. Error: `Environment`.
  Expected<void> append(std::span<const std::uint32_t> words);
  /// The same for so many zeros, which take memory only where they are flushed.
  Expected<void> skip(std::uint64_t words);
  /// The first page is never flushed.
  void setRoot(std::uint32_t offset) { setHead(0, offset); }
  void setHead(std::uint64_t word, std::uint32_t value) { words()[word] = value; }
  /// Words that are there, to be changed. Not of words that are flushed.
  std::uint32_t *at(std::uint64_t word) const { return words() + word; }
  /// Forgets all words but the first; keeps the memory. Not for words that are flushed.
  void clear() { size_ = 1; }

  /// The memory itself; the store is empty afterwards.
  MemoryBlock take() { return std::move(block_); }

private:
  Expected<void> begin(Expected<MemoryBlock> block);
  explicit WordStore(std::shared_ptr<WorkingMemory> memory) : memory_(std::move(memory)) {}
  std::uint32_t *words() const { return reinterpret_cast<std::uint32_t *>(block_.data()); }
  std::uint64_t bytes() const { return size_ * sizeof(std::uint32_t); }
  Expected<void> makeRoom(std::uint64_t words);
  Expected<void> flushComplete();

  std::shared_ptr<WorkingMemory> memory_;
  MemoryBlock block_;
  Flush flush_;
  std::uint64_t size_ = 0;
  std::uint64_t flushedBegin_ = 0;
  std::uint64_t flushedEnd_ = 0;
};

} // namespace voxc
