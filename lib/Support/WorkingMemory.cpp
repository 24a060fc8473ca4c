// Blocks in memory or in an unnamed scratch file, and what keeps the process within its bound.
#include "voxc/Support/WorkingMemory.h"

#include "Support/Platform/File.h"
#include "Support/Platform/Mapping.h"
#include "Support/Platform/Memory.h"
#include "Support/Platform/Pages.h"
#include "Support/Platform/ScratchFile.h"

#include <atomic>
#include <cerrno>
#include <mutex>
#include <vector>

namespace voxc {
namespace {

/// Bytes touched between two looks at the process.
constexpr std::uint64_t kBytesBetweenLooks = std::uint64_t{8} << 20;
/// Zeros that are left out of a file: fewer are not worth a call.
constexpr std::uint64_t kSmallestHole = std::uint64_t{64} << 10;

std::string reason() { return std::strerror(errno); }

std::uint64_t roundedUp(std::uint64_t bytes) {
  const std::uint64_t page = WorkingMemory::pageBytes();
  return (bytes + page - 1) / page * page;
}

std::string megabytes(std::uint64_t bytes) { return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB"; }

/// Addresses are reserved for the most that may be, and memory is taken as it is used.
Error lackOfAddresses(std::uint64_t bytes) {
  std::string text = "cannot reserve addresses for " + std::to_string(bytes) + " bytes";
  if (const auto most = platform::mostAddresses())
    text += ": a limit allows this process " + std::to_string(*most) +
            "; 'ulimit -v unlimited' raises it (memory is only taken as it is used, and --memory bounds it), "
            "and a build with --threads 1 and --max-bytes asks for fewer";
  return Error::environment(std::move(text));
}

Error cannotWrite(std::uint64_t bytes, int why) {
  return Error::environment("cannot write another " + megabytes(bytes) + ": " + std::strerror(why) +
                            (why == ENOSPC ? "; name a file on a disk that has room" : ""));
}

bool areZero(std::span<const std::byte> bytes) {
  return bytes.front() == std::byte{0} && std::memcmp(bytes.data(), bytes.data() + 1, bytes.size() - 1) == 0;
}

/// Writes bytes to where a file has none yet. Pieces without anything are left out, and stay holes: large
/// grids are mostly empty. False on an error, with `errno`.
bool writeWithHoles(int file, std::span<const std::byte> bytes, std::uint64_t offset) {
  const std::uint64_t end = offset + bytes.size();
  while (!bytes.empty()) {
    const auto piece = bytes.first(std::min<std::uint64_t>(bytes.size(), kSmallestHole));
    if (!areZero(piece) && !platform::writeAt(file, piece, offset))
      return false;
    bytes = bytes.subspan(piece.size());
    offset += piece.size();
  }
  return platform::extendTo(file, end);
}

} // namespace

struct WorkingMemory::State {
  explicit State(std::string scratchFolder) : scratch(std::move(scratchFolder)) {}

  platform::ResidentSize resident;
  std::uint64_t limit = 0; ///< Of the resident size of the whole process.
  std::atomic<std::uint64_t> touched{0};

  mutable std::mutex mutex; ///< Guards what follows.
  std::uint64_t inMemory = 0;
  platform::ScratchFile scratch;
  std::uint64_t inFile = 0;
  std::uint64_t filePeak = 0;
  std::vector<std::span<const std::byte>> watched; ///< Mapped: their pages can be brought back.
};

std::uint64_t WorkingMemory::pageBytes() { return platform::pageBytes(); }

std::shared_ptr<WorkingMemory> WorkingMemory::create(std::uint64_t bound, std::string scratchFolder) {
  return std::shared_ptr<WorkingMemory>(new WorkingMemory(bound, std::move(scratchFolder)));
}

std::shared_ptr<WorkingMemory> WorkingMemory::createDefault() {
  return create(platform::physicalMemory() / 4);
}

WorkingMemory::WorkingMemory(std::uint64_t bound, std::string scratchFolder)
    : bound_(bound), state_(std::make_unique<State>(scratchFolder.empty() ? platform::scratchFolder()
                                                                          : std::move(scratchFolder))) {
  state_->limit = state_->resident.now() + bound;
}

WorkingMemory::~WorkingMemory() = default;

std::uint64_t WorkingMemory::scratchPeak() const {
  const std::lock_guard lock(state_->mutex);
  return state_->filePeak;
}

Expected<MemoryBlock> WorkingMemory::reserve(std::uint64_t most) {
  const std::uint64_t bytes = roundedUp(std::max<std::uint64_t>(most, 1));
  std::byte *const address = bytes < most ? nullptr : platform::reserve(bytes);
  if (!address)
    return lackOfAddresses(most);
  MemoryBlock block;
  block.owner_ = shared_from_this();
  block.data_ = address;
  block.reserved_ = bytes;
  return block;
}

Expected<MemoryBlock> WorkingMemory::allocate(std::uint64_t bytes) {
  auto block = VOXC_TRY(reserve(bytes));
  VOXC_TRY(extend(block, block.reserved_));
  return block;
}

Expected<void> WorkingMemory::extend(MemoryBlock &block, std::uint64_t bytes) {
  const std::uint64_t size = std::min(roundedUp(bytes), block.reserved_ - block.size_);
  const std::lock_guard lock(state_->mutex);
  if (block.file_ >= 0)
    return addShared(block, size);
  const bool fits = size <= bound_ && state_->inMemory + size <= bound_ / 4 * 3;
  return fits ? addMemory(block, size) : addScratch(block, size);
}

Expected<void> WorkingMemory::extendInMemory(MemoryBlock &block, std::uint64_t bytes) {
  const std::lock_guard lock(state_->mutex);
  return addMemory(block, std::min(roundedUp(bytes), block.reserved_ - block.size_));
}

Expected<void> WorkingMemory::addMemory(MemoryBlock &block, std::uint64_t bytes) {
  if (!platform::addMemory(block.data_ + block.size_, bytes))
    return Error::environment("cannot get " + megabytes(bytes) + " of memory: " + reason());
  state_->inMemory += bytes;
  block.inMemory_ += bytes;
  block.size_ += bytes;
  return {};
}

Expected<MemoryBlock> WorkingMemory::reserveShared(std::uint64_t most) {
  const std::uint64_t bytes = roundedUp(std::max<std::uint64_t>(most, 1));
  if (bytes < most)
    return lackOfAddresses(most);
  const int shared = platform::openShared(bytes);
  if (shared < 0)
    return Error::environment("cannot get shared memory: " + reason());
  MemoryBlock block;
  block.data_ = platform::reserveShared(shared, bytes);
  if (!block.data_) {
    platform::closeShared(shared);
    return lackOfAddresses(most);
  }
  block.owner_ = shared_from_this();
  block.reserved_ = bytes;
  block.file_ = shared;
  return block;
}

Expected<void> WorkingMemory::addShared(MemoryBlock &block, std::uint64_t bytes) {
  if (!platform::addShared(block.data_, bytes, block.file_, block.size_))
    return Error::environment("cannot get " + megabytes(bytes) + " of memory: " + reason());
  state_->inMemory += bytes;
  block.inMemory_ += bytes;
  block.size_ += bytes;
  return {};
}

Expected<MemoryBlock> WorkingMemory::view(const MemoryBlock &block, std::uint64_t bytes) {
  const std::uint64_t size = roundedUp(bytes);
  std::byte *const address = platform::viewShared(block.file_, size);
  if (!address)
    return lackOfAddresses(size);
  MemoryBlock view;
  view.owner_ = shared_from_this();
  view.data_ = address;
  view.size_ = view.reserved_ = size;
  return view;
}

Expected<void> WorkingMemory::addScratch(MemoryBlock &block, std::uint64_t bytes) {
  std::byte *const end = block.data_ + block.size_;
  const std::uint64_t offset = state_->scratch.end();
  if (const int why = state_->scratch.extend(end, bytes); why != 0)
    return Error::environment("cannot get " + megabytes(bytes) + " of scratch space in '" +
                              state_->scratch.folder() + "': " + std::strerror(why));
  block.extents_.push_back({offset, bytes});
  block.size_ += bytes;
  state_->watched.push_back({end, bytes});
  state_->inFile += bytes;
  state_->filePeak = std::max(state_->filePeak, state_->inFile);
  return {};
}

Expected<void> WorkingMemory::flush(MemoryBlock &block, std::uint64_t begin, std::uint64_t bytes, int file,
                                    std::uint64_t offset) {
  std::byte *const pages = block.data_ + begin;
  if (!writeWithHoles(file, {pages, bytes}, offset))
    return cannotWrite(bytes, errno);
  const std::lock_guard lock(state_->mutex);
  if (!platform::replaceByFile(pages, bytes, file, offset))
    return Error::environment("cannot map what was written: " + reason());
  state_->watched.push_back({pages, bytes});
  state_->inMemory -= bytes;
  block.inMemory_ -= bytes;
  return {};
}

Expected<void> WorkingMemory::resize(MemoryBlock &block, std::uint64_t bytes) {
  auto resized = VOXC_TRY(allocate(bytes));
  constexpr std::uint64_t kStep = std::uint64_t{1} << 20;
  const std::uint64_t kept = std::min(bytes, block.size_);
  for (std::uint64_t done = 0; done < kept; done += kStep) {
    std::memcpy(resized.data_ + done, block.data_ + done, std::min(kStep, kept - done));
    relieveNow();
  }
  block = std::move(resized);
  return {};
}

void WorkingMemory::release(MemoryBlock &block) {
  platform::release(block.data_, block.reserved_);
  if (block.file_ >= 0)
    platform::closeShared(block.file_);
  const std::lock_guard lock(state_->mutex);
  state_->inMemory -= block.inMemory_;
  std::erase_if(state_->watched, [&](const auto &span) {
    return span.data() >= block.data_ && span.data() < block.data_ + block.reserved_;
  });
  for (const MemoryBlock::Extent &extent : block.extents_) {
    state_->inFile -= extent.bytes;
    state_->scratch.giveBack(extent.offset, extent.bytes);
  }
}

void WorkingMemory::watch(std::span<const std::byte> mapped) {
  const std::lock_guard lock(state_->mutex);
  state_->watched.push_back(mapped);
}

void WorkingMemory::unwatch(std::span<const std::byte> mapped) {
  const std::lock_guard lock(state_->mutex);
  std::erase_if(state_->watched, [&](const auto &span) { return span.data() == mapped.data(); });
}

void WorkingMemory::relieve(std::uint64_t touchedBytes) {
  const std::uint64_t before = state_->touched.fetch_add(touchedBytes, std::memory_order_relaxed);
  if (before / kBytesBetweenLooks != (before + touchedBytes) / kBytesBetweenLooks)
    relieveNow();
}

void WorkingMemory::relieveNow() {
  if (state_->resident.now() <= state_->limit)
    return;
  const std::lock_guard lock(state_->mutex);
  for (const auto &span : state_->watched)
    if (!span.empty())
      platform::letGo(span);
}

MemoryBlock::~MemoryBlock() {
  if (data_)
    owner_->release(*this);
}

MemoryBlock::MemoryBlock(MemoryBlock &&other) noexcept { *this = std::move(other); }

MemoryBlock &MemoryBlock::operator=(MemoryBlock &&other) noexcept {
  std::swap(owner_, other.owner_);
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  std::swap(reserved_, other.reserved_);
  std::swap(inMemory_, other.inMemory_);
  std::swap(extents_, other.extents_);
  std::swap(file_, other.file_);
  return *this;
}

} // namespace voxc
