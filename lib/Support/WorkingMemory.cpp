// Blocks in memory or in an unnamed scratch file, and what keeps the process within its bound.
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <fcntl.h>
#include <mutex>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

namespace voxc {
namespace {

/// Calls of `relieve` between two looks at the process.
constexpr unsigned kCallsBetweenLooks = 64;

std::string reason() { return std::strerror(errno); }

std::uint64_t pageBytes() {
  static const auto bytes = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  return bytes;
}

std::uint64_t wholePages(std::uint64_t bytes) {
  return (bytes + pageBytes() - 1) / pageBytes() * pageBytes();
}

std::string megabytes(std::uint64_t bytes) { return std::to_string((bytes >> 20) + 1) + " MiB"; }

std::string scratchFolderOr(std::string chosen) {
  if (!chosen.empty())
    return chosen;
  const char *temporary = std::getenv("TMPDIR");
  return temporary && *temporary ? temporary : "/var/tmp";
}

/// A file without a name, so that nothing is left of it however the process ends.
int openUnnamed(const std::string &folder) {
  const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
  if (file >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL))
    return file;
  std::string path = folder + "/voxc-scratch.XXXXXX";
  const int named = ::mkostemp(path.data(), O_CLOEXEC);
  if (named >= 0)
    ::unlink(path.c_str());
  return named;
}

/// Bytes of this process that are in memory now; 0 where the system does not tell.
class ResidentSize {
public:
  ResidentSize() : file_(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC)) {}
  ~ResidentSize() {
    if (file_ >= 0)
      ::close(file_);
  }
  ResidentSize(const ResidentSize &) = delete;
  ResidentSize &operator=(const ResidentSize &) = delete;

  std::uint64_t now() const {
    std::array<char, 128> text{};
    if (file_ < 0 || ::pread(file_, text.data(), text.size() - 1, 0) <= 0)
      return 0;
    const std::string_view numbers(text.data());
    const std::size_t blank = std::min(numbers.find(' '), numbers.size() - 1);
    std::uint64_t pages = 0;
    std::from_chars(numbers.data() + blank + 1, numbers.data() + numbers.size(), pages);
    return pages * pageBytes();
  }

private:
  int file_;
};

} // namespace

struct WorkingMemory::State {
  std::string scratchFolder;
  ResidentSize resident;
  std::uint64_t limit = 0; ///< Of the resident size of the whole process.
  std::atomic<unsigned> calls{0};

  mutable std::mutex mutex; ///< Guards what follows.
  std::uint64_t inMemory = 0;
  int file = -1;
  std::uint64_t fileEnd = 0;
  std::uint64_t inFile = 0;
  std::uint64_t filePeak = 0;
  std::vector<std::span<const std::byte>> watched; ///< Mapped: their pages can be brought back.
};

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

Expected<MemoryBlock> WorkingMemory::allocate(std::uint64_t bytes) {
  const std::lock_guard lock(state_->mutex);
  const std::uint64_t size = wholePages(std::max<std::uint64_t>(bytes, 1));
  if (size < bytes)
    return Error::environment("no machine has the memory for " + std::to_string(bytes) + " bytes");
  const bool fits = size <= bound_ && state_->inMemory + size <= bound_ / 4 * 3;
  auto block = fits ? allocateInMemory(size) : allocateInFile(size);
  if (block)
    block->owner_ = shared_from_this();
  return block;
}

Expected<MemoryBlock> WorkingMemory::allocateInMemory(std::uint64_t bytes) {
  void *address = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (address == MAP_FAILED)
    return Error::environment("cannot get " + megabytes(bytes) + " of memory: " + reason());
  state_->inMemory += bytes;
  MemoryBlock block;
  block.data_ = static_cast<std::byte *>(address);
  block.size_ = bytes;
  return block;
}

Expected<MemoryBlock> WorkingMemory::allocateInFile(std::uint64_t bytes) {
  const auto failed = [&](int why) {
    return Error::environment("cannot get " + megabytes(bytes) + " of scratch space in '" +
                              state_->scratchFolder + "': " + std::strerror(why));
  };
  if (state_->file < 0)
    state_->file = openUnnamed(state_->scratchFolder);
  if (state_->file < 0)
    return failed(errno);
  // Room is taken now: a full disk found out later, by a write to the mapping, would end the process.
  const auto offset = static_cast<off_t>(state_->fileEnd);
  if (const int why = ::posix_fallocate(state_->file, offset, static_cast<off_t>(bytes)))
    return failed(why);
  void *address = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, state_->file, offset);
  if (address == MAP_FAILED)
    return failed(errno);
  state_->fileEnd += bytes;
  state_->inFile += bytes;
  state_->filePeak = std::max(state_->filePeak, state_->inFile);
  MemoryBlock block;
  block.data_ = static_cast<std::byte *>(address);
  block.size_ = bytes;
  block.fileOffset_ = offset;
  state_->watched.push_back({block.data_, bytes});
  return block;
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
  ::munmap(block.data_, block.size_);
  const std::lock_guard lock(state_->mutex);
  if (block.fileOffset_ < 0) {
    state_->inMemory -= block.size_;
    return;
  }
  std::erase_if(state_->watched, [&](const auto &span) { return span.data() == block.data_; });
  state_->inFile -= block.size_;
  // Where the system cannot punch holes the room is given back at the end.
  ::fallocate(state_->file, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, block.fileOffset_,
              static_cast<off_t>(block.size_));
}

void WorkingMemory::watch(std::span<const std::byte> mapped) {
  const std::lock_guard lock(state_->mutex);
  state_->watched.push_back(mapped);
}

void WorkingMemory::unwatch(std::span<const std::byte> mapped) {
  const std::lock_guard lock(state_->mutex);
  std::erase_if(state_->watched, [&](const auto &span) { return span.data() == mapped.data(); });
}

void WorkingMemory::relieve() {
  if (state_->calls.fetch_add(1, std::memory_order_relaxed) % kCallsBetweenLooks == 0)
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

MemoryBlock::MemoryBlock(MemoryBlock &&other) noexcept
    : owner_(std::move(other.owner_)), data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)), fileOffset_(other.fileOffset_) {}

MemoryBlock &MemoryBlock::operator=(MemoryBlock &&other) noexcept {
  std::swap(owner_, other.owner_);
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  std::swap(fileOffset_, other.fileOffset_);
  return *this;
}

} // namespace voxc
