// Mapping of input files, and output files that replace their target only when complete.
#include "voxc/Support/File.h"

#include "Support/Platform/File.h"
#include "Support/Platform/Mapping.h"
#include "Support/Platform/UnnamedFile.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>

namespace voxc {
namespace {

using platform::PathKind;

std::string reason() { return std::strerror(errno); }

/// Of a file that cannot be read. That it is not there is a fault of its name; the rest the machine lacks.
Error cannotRead(const std::string &path) {
  constexpr int kOfMachine[] = {EACCES, EPERM, EMFILE, ENFILE, ENOMEM, EIO};
  const bool isOfMachine = std::ranges::find(kOfMachine, errno) != std::end(kOfMachine);
  return {isOfMachine ? ErrorKind::Environment : ErrorKind::Input, "cannot read '" + path + "': " + reason()};
}

/// Closes a file on every way out.
struct OpenFile {
  int number;
  ~OpenFile() {
    if (number >= 0)
      platform::close(number);
  }
};

} // namespace

Expected<MappedFile> MappedFile::open(const std::string &path) {
  const OpenFile file{platform::openToRead(path)};
  const auto status = file.number < 0 ? std::nullopt : platform::statusOf(file.number);
  if (!status)
    return cannotRead(path);
  if (status->kind == PathKind::Folder)
    return Error::input("'" + path + "' is a directory; name a file");
  if (status->kind != PathKind::File)
    return Error::input("'" + path + "' is not a regular file");
  MappedFile mapped;
  mapped.size_ = static_cast<std::size_t>(status->bytes);
  if (mapped.size_ == 0)
    return mapped;
  mapped.data_ = platform::mapFile(file.number, mapped.size_);
  if (!mapped.data_)
    return Error::environment("cannot map '" + path + "': " + reason());
  return mapped;
}

MappedFile::~MappedFile() {
  if (data_)
    platform::unmapFile(bytes());
}

void MappedFile::letGo() const {
  if (data_)
    platform::letGo(bytes());
}

Expected<void> writeOver(std::span<const std::byte> at, std::span<const std::byte> bytes) {
  if (!platform::makeWritable(at))
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

Expected<bool> OutputFile::isRegularAt(const std::string &path) {
  const auto end = platform::followLinks(path);
  if (!end)
    return Error::environment("cannot write '" + path + "': " + reason());
  return !end->isOpen && platform::kindOf(path) != PathKind::Other;
}

Expected<OutputFile> OutputFile::create(const std::string &path) {
  const PathKind kind = platform::kindOf(path);
  if (kind == PathKind::Folder)
    return Error::input("'" + path + "' is a directory; name a file to write");
  OutputFile output;
  output.path_ = path;
  auto end = platform::followLinks(path);
  if (!end)
    return output.cannotWrite();
  output.target_ = std::move(end->path);
  // A pipe or a device is written to, never replaced by a file; so is what is open already.
  output.replaces_ = kind != PathKind::Other && !end->isOpen;
  if (!output.open() || (output.replaces_ && kind == PathKind::File &&
                         !platform::takeAccessOf(output.target_, output.descriptor())))
    return output.cannotWrite();
  return output;
}

bool OutputFile::open() {
  int file =
      replaces_ ? platform::openUnnamed(target_, platform::Access::Ordinary) : platform::openToWrite(target_);
  if (replaces_ && (file < 0 ? platform::hasNoUnnamed(errno) : !platform::canBeNamed(file))) {
    if (file >= 0)
      platform::close(file);
    temporary_ = target_;
    file = platform::openNew(temporary_, platform::Access::Ordinary);
    if (file < 0)
      temporary_.clear();
  }
  file_ = file < 0 ? nullptr : platform::streamTo(file);
  return file_ != nullptr;
}

OutputFile::OutputFile(OutputFile &&other) noexcept
    : path_(std::move(other.path_)), target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})), replaces_(other.replaces_),
      file_(std::exchange(other.file_, nullptr)) {}

OutputFile::~OutputFile() {
  if (file_)
    std::fclose(file_);
  if (!temporary_.empty())
    platform::removeFile(temporary_);
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
  if (std::fflush(file_) != 0 ||
      !platform::writeAt(descriptor(), {static_cast<const std::byte *>(data), size}, offset))
    return cannotWrite();
  return {};
}

int OutputFile::descriptor() const { return platform::fileOf(file_); }

Expected<void> OutputFile::commit() {
  if (std::fflush(file_) != 0 || (replaces_ && !platform::writeThrough(descriptor())))
    return cannotWrite();
  const bool isNamed = !replaces_ || (temporary_.empty() ? platform::giveName(descriptor(), target_)
                                                         : platform::renameOver(temporary_, target_));
  if (!isNamed)
    return cannotWrite();
  temporary_.clear();
  if (std::fclose(std::exchange(file_, nullptr)) != 0)
    return cannotWrite();
  return {};
}

Expected<std::string> readTextFile(const std::string &path) {
  auto file = VOXC_TRY(MappedFile::open(path));
  return std::string(reinterpret_cast<const char *>(file.bytes().data()), file.bytes().size());
}

Expected<void> writeFile(const std::string &path, std::string_view bytes) {
  auto output = VOXC_TRY(OutputFile::create(path));
  VOXC_TRY(output.write(bytes.data(), bytes.size()));
  return output.commit();
}

} // namespace voxc
