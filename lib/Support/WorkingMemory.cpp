// Blocks in memory or in an unnamed scratch file, and what keeps the process within its bound.
#include "voxc/Support/WorkingMemory.h"

#include "ResidentSize.h"
#include "UnnamedFile.h"

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <mutex>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace voxc {
namespace {

/// Bytes touched between two looks at the process.
constexpr std::uint64_t kBytesBetweenLooks = std::uint64_t{8} << 20;
/// Zeros that are left out of a file: fewer are not worth a call.
constexpr std::uint64_t kSmallestHole = std::uint64_t{64} << 10;
/// Blocks from here up ask for large pages.
constexpr std::uint64_t kLargePages = std::uint64_t{2} << 20;

std::string reason() { return std::strerror(errno); }

std::uint64_t wholePages(std::uint64_t bytes) {
  const std::uint64_t page = WorkingMemory::pageBytes();
  return (bytes + page - 1) / page * page;
}

std::string megabytes(std::uint64_t bytes) { return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB"; }

/// Addresses are reserved for the most that may be, and memory is taken as it is used.
Error lackOfAddresses(std::uint64_t bytes) {
  std::string text = "cannot reserve addresses for " + std::to_string(bytes) + " bytes";
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    text += ": a limit allows this process " + std::to_string(limit.rlim_cur) +
            "; 'ulimit -v unlimited' raises it (memory is only taken as it is used, and --memory bounds it)";
  return Error::environment(std::move(text));
}

Error cannotWrite(std::uint64_t bytes, int why) {
  return Error::environment("cannot write another " + megabytes(bytes) + ": " + std::strerror(why) +
                            (why == ENOSPC ? "; name a file on a disk that has room" : ""));
}

std::string scratchFolderOr(std::string chosen) {
  if (!chosen.empty())
    return chosen;
  const char *temporary = std::getenv("TMPDIR");
  return temporary && *temporary ? temporary : "/var/tmp";
}

/// The scratch file; where it must have a name, not for long.
int openScratch(const std::string &folder) {
  const int file = openUnnamed(folder, 0600);
  if (file >= 0 || !hasNoUnnamed(errno))
    return file;
  std::string path = folder + "/voxc-scratch.XXXXXX";
  const int named = ::mkostemp(path.data(), O_CLOEXEC);
  if (named >= 0)
    ::unlink(path.c_str());
  return named;
}

bool areZero(std::span<const std::byte> bytes) {
  return bytes.front() == std::byte{0} && std::memcmp(bytes.data(), bytes.data() + 1, bytes.size() - 1) == 0;
}

bool writeAll(int file, std::span<const std::byte> bytes, std::uint64_t offset) {
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written <= 0)
      return false;
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::uint64_t>(written);
  }
  return true;
}

/// Writes bytes to where a file has none yet. Pieces without anything are left out, and stay holes: large
/// grids are mostly empty. False on an error, with `errno`.
bool writeWithHoles(int file, std::span<const std::byte> bytes, std::uint64_t offset) {
  const std::uint64_t end = offset + bytes.size();
  while (!bytes.empty()) {
    const auto piece = bytes.first(std::min<std::uint64_t>(bytes.size(), kSmallestHole));
    if (!areZero(piece) && !writeAll(file, piece, offset))
      return false;
    bytes = bytes.subspan(piece.size());
    offset += piece.size();
  }
  struct stat status{};
  return ::fstat(file, &status) == 0 && (static_cast<std::uint64_t>(status.st_size) >= end ||
                                         ::ftruncate(file, static_cast<off_t>(end)) == 0);
}

} // namespace

struct WorkingMemory::State {
  std::string scratchFolder;
  ResidentSize resident;
  std::uint64_t limit = 0; ///< Of the resident size of the whole process.
  std::atomic<std::uint64_t> touched{0};

  mutable std::mutex mutex; ///< Guards what follows.
  std::uint64_t inMemory = 0;
  int file = -1;
  std::uint64_t fileEnd = 0;
  std::uint64_t inFile = 0;
  std::uint64_t filePeak = 0;
  std::vector<std::span<const std::byte>> watched; ///< Mapped: their pages can be brought back.
};

std::uint64_t WorkingMemory::pageBytes() {
  static const auto bytes = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  return bytes;
}

std::shared_ptr<WorkingMemory> WorkingMemory::create(std::uint64_t bound, std::string scratchFolder) {
  return std::shared_ptr<WorkingMemory>(new WorkingMemory(bound, std::move(scratchFolder)));
}

std::shared_ptr<WorkingMemory> WorkingMemory::createDefault() {
  return create(static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * pageBytes() / 4);
}

WorkingMemory::WorkingMemory(std::uint64_t bound, std::string scratchFolder)
    : bound_(bound), state_(std::make_unique<State>()) {
  state_->scratchFolder = scratchFolderOr(std::move(scratchFolder));
  state_->limit = state_->resident.now() + bound;
}

WorkingMemory::~WorkingMemory() {
  if (state_->file >= 0)
    ::close(state_->file);
}

std::uint64_t WorkingMemory::scratchPeak() const {
  const std::lock_guard lock(state_->mutex);
  return state_->filePeak;
}

Expected<MemoryBlock> WorkingMemory::reserve(std::uint64_t most) {
  const std::uint64_t bytes = wholePages(std::max<std::uint64_t>(most, 1));
  void *address = bytes < most
                      ? MAP_FAILED
                      : ::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (address == MAP_FAILED)
    return lackOfAddresses(most);
  MemoryBlock block;
  block.owner_ = shared_from_this();
  block.data_ = static_cast<std::byte *>(address);
  block.reserved_ = bytes;
  return block;
}

Expected<MemoryBlock> WorkingMemory::allocate(std::uint64_t bytes) {
  auto block = reserve(bytes);
  if (!block)
    return block;
  if (auto extended = extend(*block, block->reserved_); !extended)
    return extended.error();
  return block;
}

Expected<void> WorkingMemory::extend(MemoryBlock &block, std::uint64_t bytes) {
  const std::uint64_t size = std::min(wholePages(bytes), block.reserved_ - block.size_);
  const std::lock_guard lock(state_->mutex);
  if (block.file_ >= 0)
    return addShared(block, size);
  const bool fits = size <= bound_ && state_->inMemory + size <= bound_ / 4 * 3;
  return fits ? addMemory(block, size) : addScratch(block, size);
}

Expected<void> WorkingMemory::extendInMemory(MemoryBlock &block, std::uint64_t bytes) {
  const std::lock_guard lock(state_->mutex);
  return addMemory(block, std::min(wholePages(bytes), block.reserved_ - block.size_));
}

Expected<void> WorkingMemory::addMemory(MemoryBlock &block, std::uint64_t bytes) {
  if (::mprotect(block.data_ + block.size_, bytes, PROT_READ | PROT_WRITE) != 0)
    return Error::environment("cannot get " + megabytes(bytes) + " of memory: " + reason());
  // Tables are read at random: large pages spare much of the way to each.
  if (bytes >= kLargePages)
    ::madvise(block.data_ + block.size_, bytes, MADV_HUGEPAGE);
  state_->inMemory += bytes;
  block.inMemory_ += bytes;
  block.size_ += bytes;
  return {};
}

Expected<MemoryBlock> WorkingMemory::reserveShared(std::uint64_t most) {
  auto block = reserve(most);
  if (!block)
    return block;
  block->file_ = ::memfd_create("voxc", MFD_CLOEXEC);
  if (block->file_ < 0)
    return Error::environment("cannot get shared memory: " + reason());
  return block;
}

Expected<void> WorkingMemory::addShared(MemoryBlock &block, std::uint64_t bytes) {
  if (::ftruncate(block.file_, static_cast<off_t>(block.size_ + bytes)) != 0 ||
      ::mmap(block.data_ + block.size_, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, block.file_,
             static_cast<off_t>(block.size_)) == MAP_FAILED)
    return Error::environment("cannot get " + megabytes(bytes) + " of memory: " + reason());
  ::madvise(block.data_ + block.size_, bytes, MADV_HUGEPAGE);
  state_->inMemory += bytes;
  block.inMemory_ += bytes;
  block.size_ += bytes;
  return {};
}

Expected<MemoryBlock> WorkingMemory::view(const MemoryBlock &block, std::uint64_t bytes) {
  const std::uint64_t size = wholePages(bytes);
  void *const address = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE, block.file_, 0);
  if (address == MAP_FAILED)
    return lackOfAddresses(size);
  MemoryBlock view;
  view.owner_ = shared_from_this();
  view.data_ = static_cast<std::byte *>(address);
  view.size_ = view.reserved_ = size;
  return view;
}

Expected<void> WorkingMemory::addScratch(MemoryBlock &block, std::uint64_t bytes) {
  if (state_->file < 0)
    state_->file = openScratch(state_->scratchFolder);
  const auto offset = static_cast<off_t>(state_->fileEnd);
  // Room is taken now: a full disk found out later, by a write to the mapping, would end the process.
  int why = state_->file < 0 ? errno : ::posix_fallocate(state_->file, offset, static_cast<off_t>(bytes));
  std::byte *const end = block.data_ + block.size_;
  if (why == 0 &&
      ::mmap(end, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_FIXED, state_->file, offset) == MAP_FAILED)
    why = errno;
  if (why != 0)
    return Error::environment("cannot get " + megabytes(bytes) + " of scratch space in '" +
                              state_->scratchFolder + "': " + std::strerror(why));
  // Reading ahead would make large pages in the system's cache, which are dear to dirty a little at a time.
  ::madvise(end, bytes, MADV_RANDOM);
  block.extents_.push_back({state_->fileEnd, bytes});
  block.size_ += bytes;
  state_->watched.push_back({end, bytes});
  state_->fileEnd += bytes;
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
  if (::mmap(pages, bytes, PROT_READ, MAP_SHARED | MAP_FIXED, file, static_cast<off_t>(offset)) == MAP_FAILED)
    return Error::environment("cannot map what was written: " + reason());
  state_->watched.push_back({pages, bytes});
  state_->inMemory -= bytes;
  block.inMemory_ -= bytes;
  return {};
}

Expected<void> WorkingMemory::resize(MemoryBlock &block, std::uint64_t bytes) {
  auto resized = allocate(bytes);
  if (!resized)
    return resized.error();
  constexpr std::uint64_t kStep = std::uint64_t{1} << 20;
  const std::uint64_t kept = std::min(bytes, block.size_);
  for (std::uint64_t done = 0; done < kept; done += kStep) {
    std::memcpy(resized->data_ + done, block.data_ + done, std::min(kStep, kept - done));
    relieveNow();
  }
  block = std::move(*resized);
  return {};
}

void WorkingMemory::release(MemoryBlock &block) {
  ::munmap(block.data_, block.reserved_);
  if (block.file_ >= 0)
    ::close(block.file_);
  const std::lock_guard lock(state_->mutex);
  state_->inMemory -= block.inMemory_;
  std::erase_if(state_->watched, [&](const auto &span) {
    return span.data() >= block.data_ && span.data() < block.data_ + block.reserved_;
  });
  for (const MemoryBlock::Extent &extent : block.extents_) {
    state_->inFile -= extent.bytes;
    // Where the system cannot punch holes the room is given back at the end.
    ::fallocate(state_->file, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(extent.offset),
                static_cast<off_t>(extent.bytes));
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
  // Shared pages stay in the system's cache, and what was written to them is not lost.
  for (const auto &span : state_->watched)
    if (!span.empty())
      ::madvise(const_cast<std::byte *>(span.data()), span.size(), MADV_DONTNEED);
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
