// The directory at the end of a ZIP archive.
#include "Input/Dense/ZipFile.h"

#include <algorithm>
#include <optional>

namespace voxc {

namespace {

/// A little-endian number of so many bytes; nothing if it is not all there.
std::optional<std::uint64_t> numberAt(std::span<const std::byte> bytes, std::uint64_t at, std::size_t count) {
  if (at > bytes.size() || count > bytes.size() - at)
    return std::nullopt;
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < count; ++i)
    number |= std::to_integer<std::uint64_t>(bytes[at + i]) << 8 * i;
  return number;
}

constexpr std::uint64_t kEndMark = 0x06054b50, kEntryMark = 0x02014b50, kFileMark = 0x04034b50;
constexpr std::uint64_t kEndBytes = 22, kEntryBytes = 46, kFileBytes = 30;
constexpr std::uint64_t kIn64 = 0xffffffff; ///< The number stands in 64 bits behind the name.

/// Where the end of the directory begins: a comment may follow it.
std::optional<std::uint64_t> findEnd(std::span<const std::byte> bytes) {
  constexpr std::uint64_t kMostComment = 65535;
  for (std::uint64_t back = kEndBytes;
       back <= std::min<std::uint64_t>(bytes.size(), kEndBytes + kMostComment); ++back)
    if (numberAt(bytes, bytes.size() - back, 4) == kEndMark)
      return bytes.size() - back;
  return std::nullopt;
}

/// What an entry of the directory says; sizes that are too large for it are in an extra field.
struct Entry {
  std::uint64_t flags, method, packed, size, nameBytes, extraBytes, commentBytes, offset;
};

std::optional<Entry> entryAt(std::span<const std::byte> bytes, std::uint64_t at) {
  const auto number = [&](std::uint64_t offset, std::size_t count) {
    return numberAt(bytes, at + offset, count).value_or(0);
  };
  if (numberAt(bytes, at, 4) != kEntryMark || !numberAt(bytes, at + kEntryBytes - 4, 4))
    return std::nullopt;
  Entry entry{number(8, 2),  number(10, 2), number(20, 4), number(24, 4),
              number(28, 2), number(30, 2), number(32, 2), number(42, 4)};
  // The extra field of 64 bits has those of size, packed size and offset that did not fit, in this order.
  for (std::uint64_t extra = 0; extra + 4 <= entry.extraBytes;) {
    const std::uint64_t begin = kEntryBytes + entry.nameBytes + extra;
    std::uint64_t next = begin + 4;
    for (std::uint64_t *const wide : {&entry.size, &entry.packed, &entry.offset})
      if (number(begin, 2) == 1 && *wide == kIn64) {
        *wide = number(next, 8);
        next += 8;
      }
    extra += 4 + number(begin + 2, 2);
  }
  return entry;
}

} // namespace

std::unique_ptr<ByteStream> ZippedFile::open() const {
  return isDeflated ? makeDeflateStream(stored) : makeRawStream(stored);
}

Expected<std::vector<ZippedFile>> listZip(std::span<const std::byte> bytes) {
  const auto end = findEnd(bytes);
  if (!end)
    return Error::input("it is no archive, or is cut short");
  const std::uint64_t count = numberAt(bytes, *end + 10, 2).value_or(0);
  std::uint64_t at = numberAt(bytes, *end + 16, 4).value_or(0);
  std::vector<ZippedFile> files;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto entry = entryAt(bytes, at);
    const auto nameBytes = entry ? numberAt(bytes, entry->offset + 26, 2) : std::nullopt;
    const auto extraBytes = entry ? numberAt(bytes, entry->offset + 28, 2) : std::nullopt;
    if (!extraBytes || numberAt(bytes, entry->offset, 4) != kFileMark ||
        entry->nameBytes > bytes.size() - at - kEntryBytes)
      return Error::input("its directory leads out of it");
    const std::uint64_t begin = entry->offset + kFileBytes + *nameBytes + *extraBytes;
    if (begin > bytes.size() || entry->packed > bytes.size() - begin)
      return Error::input("its directory leads out of it");
    const auto *const name = reinterpret_cast<const char *>(bytes.data()) + at + kEntryBytes;
    const bool isPlain = (entry->flags & 1) == 0 && (entry->method == 0 || entry->method == 8);
    if (isPlain)
      files.push_back(
          {std::string(name, entry->nameBytes), bytes.subspan(begin, entry->packed), entry->method == 8});
    at += kEntryBytes + entry->nameBytes + entry->extraBytes + entry->commentBytes;
  }
  return files;
}

} // namespace voxc
