// Growth of the words of a volume, and their way to the file.
#include "WordStore.h"

#include <algorithm>
#include <cstring>

namespace voxc {
namespace {

constexpr std::uint64_t kSmallestStep = std::uint64_t{1} << 20;
constexpr std::uint64_t kLargestStep = std::uint64_t{64} << 20;
/// Words are flushed in pieces of this size, and so are copied in pieces too.
constexpr std::uint64_t kFlushedBytes = std::uint64_t{4} << 20;
constexpr std::uint64_t kPieceWords = kFlushedBytes / sizeof(std::uint32_t);

/// Copies by pieces for which compilers and C libraries take moves of vectors: for larger ones they may have
/// the processor repeat a single instruction, which takes some five times as long where both sides lie alike
/// in their pages.
void copyWords(std::span<const std::uint32_t> words, std::uint32_t *to) {
  constexpr std::size_t kPiece = 16;
  for (; words.size() >= kPiece; words = words.subspan(kPiece), to += kPiece)
    std::memcpy(to, words.data(), kPiece * sizeof(std::uint32_t));
  for (const std::uint32_t word : words)
    *to++ = word;
}

} // namespace

Expected<WordStore> WordStore::create(const std::shared_ptr<WorkingMemory> &memory, Flush flush,
                                      std::uint64_t mostWords) {
  WordStore store(memory);
  store.flush_ = std::move(flush);
  store.flushedBegin_ = store.flushedEnd_ = WorkingMemory::pageBytes();
  VOXC_TRY(store.begin(memory->reserve(mostWords * sizeof(std::uint32_t))));
  return store;
}

Expected<WordStore> WordStore::createShared(const std::shared_ptr<WorkingMemory> &memory,
                                            std::uint64_t mostWords) {
  WordStore store(memory);
  VOXC_TRY(store.begin(memory->reserveShared(mostWords * sizeof(std::uint32_t))));
  return store;
}

Expected<void> WordStore::begin(Expected<MemoryBlock> block) {
  if (!block)
    return block.error();
  block_ = std::move(*block);
  const std::uint32_t root = 0;
  return append({&root, 1});
}

Expected<void> WordStore::append(std::span<const std::uint32_t> words) {
  while (!words.empty()) {
    const auto piece = words.first(std::min<std::uint64_t>(words.size(), kPieceWords));
    if (bytes() + piece.size_bytes() > block_.size())
      VOXC_TRY(makeRoom(piece.size()));
    copyWords(piece, this->words() + size_);
    size_ += piece.size();
    words = words.subspan(piece.size());
    if (!words.empty())
      memory_->relieve(2 * piece.size_bytes());
  }
  return {};
}

Expected<void> WordStore::skip(std::uint64_t words) {
  if (bytes() + words * sizeof(std::uint32_t) > block_.size())
    VOXC_TRY(makeRoom(words));
  size_ += words;
  return {};
}

Expected<void> WordStore::makeRoom(std::uint64_t words) {
  if (flush_)
    VOXC_TRY(flushComplete());
  const std::uint64_t needed = bytes() + words * sizeof(std::uint32_t) - block_.size();
  const std::uint64_t step = std::clamp(block_.size(), kSmallestStep, flush_ ? kFlushedBytes : kLargestStep);
  const std::uint64_t more = std::max(needed, step);
  return flush_ ? memory_->extendInMemory(block_, more) : memory_->extend(block_, more);
}

Expected<void> WordStore::flushComplete() {
  const std::uint64_t end = bytes() / WorkingMemory::pageBytes() * WorkingMemory::pageBytes();
  if (end <= flushedEnd_)
    return {};
  VOXC_TRY(flush_(block_, flushedEnd_, end - flushedEnd_));
  flushedEnd_ = end;
  return {};
}

} // namespace voxc
