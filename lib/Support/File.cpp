// Mapping of input files, and output files that replace their target only when complete.
#include "voxc/Support/File.h"

#include "UnnamedFile.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace voxc {
namespace {

std::string reason() { return std::strerror(errno); }

/// Closes a descriptor on every way out.
struct Descriptor {
  int value;
  ~Descriptor() {
    if (value >= 0)
      ::close(value);
  }
};

/// The type bits of what stands at `path`, or 0 if nothing does.
mode_t typeOf(const std::string &path) {
  struct stat status{};
  return ::stat(path.c_str(), &status) == 0 ? status.st_mode & S_IFMT : 0;
}

/// Permissions before the process's mask.
constexpr mode_t kOrdinary = 0666;

/// mkstemp makes a file private; the final file shall have the permissions of an ordinary one.
void makeOrdinary(int descriptor) {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor, kOrdinary & ~mask);
}

} // namespace

Expected<MappedFile> MappedFile::open(const std::string &path) {
  // A pipe that no one writes to would be waited for.
  Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  struct stat status{};
  if (file.value < 0 || ::fstat(file.value, &status) != 0)
    return Error::input("cannot read '" + path + "': " + reason());
  if (S_ISDIR(status.st_mode))
    return Error::input("'" + path + "' is a directory; name a file");
  if (!S_ISREG(status.st_mode))
    return Error::input("'" + path + "' is not a regular file");
  MappedFile mapped;
  mapped.size_ = static_cast<std::size_t>(status.st_size);
  if (mapped.size_ == 0)
    return mapped;
  void *address = ::mmap(nullptr, mapped.size_, PROT_READ, MAP_PRIVATE, file.value, 0);
  if (address == MAP_FAILED)
    return Error::environment("cannot map '" + path + "': " + reason());
  mapped.data_ = static_cast<const std::byte *>(address);
  return mapped;
}

MappedFile::~MappedFile() {
  if (data_)
    ::munmap(const_cast<std::byte *>(data_), size_);
}

void MappedFile::letGo() const {
  if (data_)
    ::madvise(const_cast<std::byte *>(data_), size_, MADV_DONTNEED);
}

Expected<void> writeOver(std::span<const std::byte> at, std::span<const std::byte> bytes) {
  const auto page = static_cast<std::uintptr_t>(::sysconf(_SC_PAGESIZE));
  const auto address = reinterpret_cast<std::uintptr_t>(at.data());
  const std::uintptr_t begin = address / page * page;
  auto *const pages = reinterpret_cast<void *>(begin);
  // Mappings are private: what is written to is a copy.
  if (::mprotect(pages, address + at.size() - begin, PROT_READ | PROT_WRITE) != 0)
    return Error::environment("cannot write to memory: " + reason());
  std::memcpy(const_cast<std::byte *>(at.data()), bytes.data(), bytes.size());
  return {};
}

MappedFile::MappedFile(MappedFile &&other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}

MappedFile &MappedFile::operator=(MappedFile &&other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  return *this;
}

Expected<OutputFile> OutputFile::create(const std::string &path) {
  const mode_t type = typeOf(path);
  if (type == S_IFDIR)
    return Error::input("'" + path + "' is a directory; name a file to write");
  OutputFile output;
  output.path_ = path;
  // A pipe or a device is written to, never replaced by a file.
  output.replaces_ = type == 0 || type == S_IFREG;
  if (!output.open())
    return output.cannotWrite();
  return output;
}

bool OutputFile::open() {
  int file =
      replaces_ ? openUnnamed(folderOf(path_), kOrdinary) : ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  if (replaces_ && (file < 0 ? hasNoUnnamed(errno) : !canBeNamed(file))) {
    if (file >= 0)
      ::close(file);
    temporary_ = path_ + ".XXXXXX";
    file = ::mkostemp(temporary_.data(), O_CLOEXEC);
    if (file < 0)
      temporary_.clear();
    else
      makeOrdinary(file);
  }
  file_ = file < 0 ? nullptr : ::fdopen(file, "wb");
  return file_ != nullptr;
}

OutputFile::OutputFile(OutputFile &&other) noexcept
    : path_(std::move(other.path_)), temporary_(std::exchange(other.temporary_, {})),
      replaces_(other.replaces_), file_(std::exchange(other.file_, nullptr)) {}

OutputFile::~OutputFile() {
  if (file_)
    std::fclose(file_);
  if (!temporary_.empty())
    ::unlink(temporary_.c_str());
}

Error OutputFile::cannotWrite() const {
  return Error::environment("cannot write '" + path_ + "': " + reason());
}

Expected<void> OutputFile::write(const void *data, std::size_t size) {
  if (size > 0 && std::fwrite(data, 1, size, file_) != size)
    return cannotWrite();
  return {};
}

Expected<void> OutputFile::rewrite(std::uint64_t offset, const void *data, std::size_t size) {
  if (std::fflush(file_) != 0)
    return cannotWrite();
  const auto *rest = static_cast<const std::byte *>(data);
  while (size > 0) { // A disk that fills up, or a limit, may take a part before it refuses the rest.
    const ssize_t written = ::pwrite(descriptor(), rest, size, static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
      return cannotWrite();
    rest += written;
    size -= static_cast<std::size_t>(written);
    offset += static_cast<std::uint64_t>(written);
  }
  return {};
}

Expected<void> OutputFile::commit() {
  if (std::fflush(file_) != 0 || (replaces_ && ::fdatasync(descriptor()) != 0))
    return cannotWrite();
  const bool isNamed =
      !replaces_ || (temporary_.empty() ? giveName(descriptor(), path_)
                                        : std::rename(temporary_.c_str(), path_.c_str()) == 0);
  if (!isNamed)
    return cannotWrite();
  temporary_.clear();
  if (std::fclose(std::exchange(file_, nullptr)) != 0)
    return cannotWrite();
  return {};
}

Expected<std::string> readTextFile(const std::string &path) {
  auto file = MappedFile::open(path);
  if (!file)
    return file.error();
  return std::string(reinterpret_cast<const char *>(file->bytes().data()), file->bytes().size());
}

Expected<void> writeFile(const std::string &path, std::string_view bytes) {
  auto output = OutputFile::create(path);
  if (!output)
    return output.error();
  if (auto written = output->write(bytes.data(), bytes.size()); !written)
    return written.error();
  return output->commit();
}

} // namespace voxc
