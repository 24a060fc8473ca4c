// Memory for large work within a stated bound: what does not fit lies in one scratch file.
#pragma once

#include "voxc/Support/Error.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace voxc {

class WorkingMemory;

/// Zeroed memory of a `WorkingMemory`, given back on destruction.
class MemoryBlock {
public:
  MemoryBlock() = default;
  ~MemoryBlock();
  MemoryBlock(MemoryBlock &&) noexcept;
  MemoryBlock &operator=(MemoryBlock &&) noexcept;

  std::byte *data() const { return data_; }
  /// Bytes that may be used.
  std::uint64_t size() const { return size_; }

private:
  friend class WorkingMemory;

  /// A range of the scratch file.
  struct Extent {
    std::uint64_t offset;
    std::uint64_t bytes;
  };

  std::shared_ptr<WorkingMemory> owner_;
  std::byte *data_ = nullptr;
  std::uint64_t size_ = 0;
  std::uint64_t reserved_ = 0; ///< Bytes of addresses, at least `size_`.
  std::uint64_t inMemory_ = 0;
  std::vector<Extent> extents_;
  int file_ = -1; ///< Of shared memory: what has it.
};

/// A bound on the memory of a piece of work, and the memory itself.
///
/// Blocks lie in ordinary memory until they would take more than three quarters of the bound. Further ones
/// are mapped from a scratch file, which has no name and so is gone whatever ends the process. `relieve`
/// keeps the process within the bound: it lets go of the pages of the scratch file and of mapped input
/// files, which the system can bring back. All members may be called by several threads.
class WorkingMemory : public std::enable_shared_from_this<WorkingMemory> {
public:
  /// `bound`: bytes that may be resident beyond those of this moment. `scratchFolder`: where the scratch file
  /// is made when it is needed; "" is $TMPDIR or /var/tmp.
  static std::shared_ptr<WorkingMemory> create(std::uint64_t bound, std::string scratchFolder = {});
  /// The same with a quarter of the machine's memory.
  static std::shared_ptr<WorkingMemory> createDefault();
  ~WorkingMemory();

  std::uint64_t bound() const { return bound_; }
  /// Bytes of the scratch file that have been in use at once.
  std::uint64_t scratchPeak() const;

  /// Zeroed memory. Errors: `Environment`, no memory or no room for the scratch file.
  Expected<MemoryBlock> allocate(std::uint64_t bytes);
  /// Makes a block larger or smaller, which may move it; what is added is zero. On an error it stays as it
  /// was.
  Expected<void> resize(MemoryBlock &block, std::uint64_t bytes);

  /// A block of no size that can be extended in place to `most` bytes.
  Expected<MemoryBlock> reserve(std::uint64_t most);
  /// Adds whole pages of zeroed memory, at least `bytes`, to a reserved block.
  Expected<void> extend(MemoryBlock &block, std::uint64_t bytes);
  /// The same, but never from the scratch file: for pages that are soon flushed.
  Expected<void> extendInMemory(MemoryBlock &block, std::uint64_t bytes);
  /// Writes whole pages of a block that `extendInMemory` gave to another file, open for reading and writing,
  /// at `offset` (whole pages) where it has nothing yet, and maps them from there: from now on they can only
  /// be read. Zeros become holes of the file. Error: `Environment`.
  Expected<void> flush(MemoryBlock &block, std::uint64_t begin, std::uint64_t bytes, int file,
                       std::uint64_t offset);
  /// The same as `reserve` of memory of which `view` gives further mappings. It never lies in the scratch
  /// file.
  Expected<MemoryBlock> reserveShared(std::uint64_t most);
  /// The first `bytes` of such a block at other addresses. What is written there is seen there alone; what is
  /// written to the block is seen there too, but for pages that were written to. Error: no addresses.
  Expected<MemoryBlock> view(const MemoryBlock &block, std::uint64_t bytes);
  /// Bytes of a page.
  static std::uint64_t pageBytes();

  /// Adds a mapped file to what `relieve` may let go of, until `unwatch`.
  void watch(std::span<const std::byte> mapped);
  void unwatch(std::span<const std::byte> mapped);

  /// Looks, for every few megabytes that were touched, whether the process is over the bound, and if so lets
  /// go of what can be brought back. Costs nanoseconds; `touchedBytes`: since the last call, about.
  void relieve(std::uint64_t touchedBytes = std::uint64_t{128} << 10);

private:
  friend class MemoryBlock;
  struct State;

  explicit WorkingMemory(std::uint64_t bound, std::string scratchFolder);
  Expected<void> addMemory(MemoryBlock &block, std::uint64_t bytes);
  Expected<void> addShared(MemoryBlock &block, std::uint64_t bytes);
  Expected<void> addScratch(MemoryBlock &block, std::uint64_t bytes);
  void release(MemoryBlock &block);
  void relieveNow();

  std::uint64_t bound_;
  std::unique_ptr<State> state_;
};

/// A growing array of plain values in a `WorkingMemory`.
template <typename T> class ScratchArray {
  static_assert(std::is_trivially_copyable_v<T>);

public:
  explicit ScratchArray(std::shared_ptr<WorkingMemory> memory) : memory_(std::move(memory)) {}

  std::uint64_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T *data() { return reinterpret_cast<T *>(block_.data()); }
  const T *data() const { return reinterpret_cast<const T *>(block_.data()); }
  T &operator[](std::uint64_t i) { return data()[i]; }
  const T &operator[](std::uint64_t i) const { return data()[i]; }
  std::span<T> span() { return {data(), size_}; }
  std::span<const T> span() const { return {data(), size_}; }

  /// Sets the number of values; new ones are zero. Errors: as `WorkingMemory::allocate`.
  Expected<void> resize(std::uint64_t size) {
    if (size * sizeof(T) > block_.size())
      VOXC_TRY(grow(size));
    if (size < size_)
      std::memset(static_cast<void *>(data() + size), 0, (size_ - size) * sizeof(T));
    size_ = size;
    return {};
  }

  Expected<void> append(std::span<const T> values) {
    if (values.empty())
      return {};
    const std::uint64_t size = size_ + values.size();
    if (size * sizeof(T) > block_.size())
      VOXC_TRY(grow(size));
    std::memcpy(static_cast<void *>(data() + size_), values.data(), values.size_bytes());
    size_ = size;
    return {};
  }
  Expected<void> push(const T &value) { return append({&value, 1}); }

private:
  static constexpr std::uint64_t kSmallestBytes = std::uint64_t{1} << 16;

  Expected<void> grow(std::uint64_t size) {
    const std::uint64_t wanted = std::max(size * sizeof(T), block_.size() + block_.size() / 2);
    const std::uint64_t bytes = std::max(wanted, kSmallestBytes);
    if (block_.data())
      return memory_->resize(block_, bytes);
    block_ = VOXC_TRY(memory_->allocate(bytes));
    return {};
  }

  std::shared_ptr<WorkingMemory> memory_;
  MemoryBlock block_;
  std::uint64_t size_ = 0;
};

} // namespace voxc
