// The words of a volume while it is built: appended at the end, read anywhere.
#pragma once

#include "voxc/Support/WorkingMemory.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace voxc {

/// Words at addresses that never change, in memory or in a file. The first is kept for the root's offset.
class WordStore {
public:
  /// Adds memory to the block in which the words lie.
  using Extend = std::function<Expected<void>(MemoryBlock &block, std::uint64_t bytes)>;

  /// Words in working memory, or where `extend` says. Error: `Environment`.
  static Expected<WordStore> create(const std::shared_ptr<WorkingMemory> &memory, Extend extend = {});

  std::uint64_t size() const { return size_; }
  const std::uint32_t *data() const { return reinterpret_cast<const std::uint32_t *>(block_.data()); }
  std::span<const std::uint32_t> span() const { return {data(), size_}; }

  /// Appends words; the caller has seen to it that there are at most 2^32 in all. Error: `Environment`.
  Expected<void> append(std::span<const std::uint32_t> words);
  void setRoot(std::uint32_t offset) { mutableData()[0] = offset; }
  /// Forgets all words but the first; keeps the memory.
  void clear() { size_ = 1; }

  /// The memory itself; the store is empty afterwards.
  MemoryBlock take() { return std::move(block_); }

private:
  WordStore() = default;
  std::uint32_t *mutableData() { return reinterpret_cast<std::uint32_t *>(block_.data()); }

  MemoryBlock block_;
  Extend extend_;
  std::uint64_t size_ = 0;
};

} // namespace voxc
