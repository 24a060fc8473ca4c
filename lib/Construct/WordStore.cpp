// Growth of the words of a volume, in steps that grow with it.
#include "WordStore.h"

#include <algorithm>

namespace voxc {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{16} << 30;
constexpr std::uint64_t kSmallestStep = std::uint64_t{1} << 20;
constexpr std::uint64_t kLargestStep = std::uint64_t{64} << 20;

} // namespace

Expected<WordStore> WordStore::create(const std::shared_ptr<WorkingMemory> &memory, Extend extend) {
  WordStore store;
  store.extend_ = extend ? std::move(extend) : [memory](MemoryBlock &block, std::uint64_t bytes) {
    return memory->extend(block, bytes);
  };
  auto block = memory->reserve(kMostBytes);
  if (!block)
    return block.error();
  store.block_ = std::move(*block);
  const std::uint32_t root = 0;
  if (auto appended = store.append({&root, 1}); !appended)
    return appended.error();
  return store;
}

Expected<void> WordStore::append(std::span<const std::uint32_t> words) {
  const std::uint64_t needed = (size_ + words.size()) * sizeof(std::uint32_t);
  if (needed > block_.size()) {
    const std::uint64_t step = std::clamp(block_.size(), kSmallestStep, kLargestStep);
    if (auto extended = extend_(block_, std::max(needed - block_.size(), step)); !extended)
      return extended;
  }
  std::copy(words.begin(), words.end(), mutableData() + size_);
  size_ += words.size();
  return {};
}

} // namespace voxc
