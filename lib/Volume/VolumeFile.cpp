// Reading and writing the heads of .hvx files; docs/hvx.md has the layout as a table.
#include "VolumeFile.h"

#include "Checksum.h"
#include "StreamTable.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace voxc {
namespace {

constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint64_t kMaxTextBytes = 1 << 20;
constexpr std::size_t kBytesBetweenPauses = std::size_t{1} << 16;

/// The fixed part of the head; little-endian, no padding. The table of streams follows, then the texts.
struct Header {
  std::array<char, 8> magic = {'\x89', 'H', 'V', 'X', '\r', '\n', '\x1a', '\n'};
  std::uint32_t version = kVersion;
  std::uint32_t byteOrder = kByteOrder;
  std::uint64_t checksum = 0;  ///< XXH3-64 of all other bytes of the file, in order.
  std::uint64_t fileBytes = 0; ///< Of the whole file. In version 1 the number of words.
  std::uint64_t headBytes = 0; ///< Of all before the first stream: whole pages.
  std::uint64_t voxels = 0;
  std::array<std::int32_t, 3> extent{};
  std::uint32_t irBytes = 0;
  std::uint32_t provenanceBytes = 0;
  std::uint32_t streams = 0; ///< Rows of the table. Version 1 has none: all that follows the head is words.
  std::array<double, 12> voxelToModel{};

  std::uint64_t textOffset() const { return sizeof(Header) + streams * sizeof(StreamRow); }
  std::uint64_t textEnd() const { return textOffset() + irBytes + provenanceBytes; }
};
static_assert(sizeof(Header) == 168);

/// The bytes of a file, or of its head, but those of the checksum itself.
void addAllButItself(Checksum &checksum, std::span<const std::byte> bytes) {
  constexpr std::size_t kAt = offsetof(Header, checksum);
  constexpr std::size_t kAfter = kAt + sizeof(Header::checksum);
  checksum.add(bytes.data(), kAt);
  checksum.add(bytes.data() + kAfter, bytes.size() - kAfter);
}

void addStream(Checksum &checksum, std::span<const std::byte> bytes, const std::function<void()> &pause) {
  for (std::size_t begin = 0; begin < bytes.size(); begin += kBytesBetweenPauses) {
    checksum.add(bytes.data() + begin, std::min(kBytesBetweenPauses, bytes.size() - begin));
    if (pause)
      pause();
  }
}

std::string truncated(std::uint64_t stated, const char *what, std::uint64_t fileBytes) {
  return "is truncated or has surplus bytes: its header speaks of " + std::to_string(stated) + what +
         ", but it has " + std::to_string(fileBytes) + " bytes in all";
}

std::string describeProblemOfVersion1(const Header &header, std::uint64_t fileBytes) {
  if (header.streams != 0 || header.headBytes != wholePages(header.headBytes) ||
      header.headBytes < header.textEnd())
    return "has a header that contradicts itself";
  if (header.headBytes > fileBytes || header.fileBytes != (fileBytes - header.headBytes) / 4 ||
      (fileBytes - header.headBytes) % 4 != 0)
    return truncated(header.fileBytes, " words", fileBytes);
  return {};
}

std::string describeProblemOfVersion2(const Header &header, std::uint64_t fileBytes) {
  if (header.fileBytes != fileBytes)
    return truncated(header.fileBytes, " bytes", fileBytes);
  if (header.streams == 0 || header.streams > kMostStreams ||
      header.headBytes != wholePages(header.textEnd()) || header.headBytes > fileBytes)
    return "has a header that contradicts itself";
  return {};
}

std::string describeProblem(const Header &header, std::uint64_t fileBytes) {
  if (header.version > kVersion)
    return "is of version " + std::to_string(header.version) + "; this voxc reads versions up to " +
           std::to_string(kVersion);
  if (header.version == 0 || header.byteOrder != kByteOrder)
    return "has a header that is damaged or of another byte order";
  if (std::uint64_t{header.irBytes} + header.provenanceBytes > kMaxTextBytes)
    return "has a header that contradicts itself";
  return header.version == 1 ? describeProblemOfVersion1(header, fileBytes)
                             : describeProblemOfVersion2(header, fileBytes);
}

/// The table of a file whose header was found right; for version 1 the one that it would have.
std::vector<StreamRow> rowsOf(const Header &header, std::span<const std::byte> bytes) {
  if (header.version == 1) {
    const auto words = bytes.subspan(header.headBytes);
    return layOut(std::array{Stream{std::string(kWordStream), sizeof(std::uint32_t), words}},
                  header.headBytes);
  }
  std::vector<StreamRow> rows(header.streams);
  std::memcpy(rows.data(), bytes.data() + sizeof(Header), rows.size() * sizeof(StreamRow));
  return rows;
}

bool fitsFormat(const Header &header, const Format &format) {
  const Int3 extent = format.extent();
  for (int axis = 0; axis < 3; ++axis)
    if (header.extent[axis] < 0 || header.extent[axis] > extent[axis])
      return false;
  return true;
}

/// What the header and its texts, which lie in the file, say of the volume. The error follows the file's
/// name.
Expected<VolumeInfo> infoOf(const Header &header, std::span<const std::byte> bytes) {
  const auto *text = reinterpret_cast<const char *>(bytes.data()) + header.textOffset();
  Diagnostics diagnostics;
  Format format = parseIr(std::string_view(text, header.irBytes), diagnostics);
  if (diagnostics.hasErrors())
    return Error::input("names no valid format: " + diagnostics.all().front().message);
  if (format != storageFormat(format) || !fitsFormat(header, format))
    return Error::input("has a header that contradicts its format");
  return VolumeInfo{std::move(format),
                    {header.extent[0], header.extent[1], header.extent[2]},
                    transformOfRows(header.voxelToModel),
                    header.voxels,
                    std::string(text + header.irBytes, header.provenanceBytes)};
}

/// Follows every pointer, and counts the voxels.
Expected<void> checkWords(const Volume &volume, const std::string &name) {
  const auto voxels = checkStructure(volume.format(), volume.words());
  if (!voxels)
    return Error::input("'" + name + "': " + voxels.error().message);
  if (*voxels != volume.info().voxels)
    return Error::input("'" + name + "' holds " + std::to_string(*voxels) + " voxels, but its header says " +
                        std::to_string(volume.info().voxels));
  return {};
}

} // namespace

Expected<Volume> readVolumeFile(std::span<const std::byte> bytes, std::shared_ptr<const void> owner,
                                const std::string &name, bool trusted) {
  const auto broken = [&](const std::string &problem) { return Error::input("'" + name + "' " + problem); };
  Header header;
  const Header expected;
  if (bytes.size() >= sizeof(Header))
    std::memcpy(&header, bytes.data(), sizeof(Header));
  if (bytes.size() < sizeof(Header) || header.magic != expected.magic)
    return broken("is not a .hvx volume");
  if (const std::string problem = describeProblem(header, bytes.size()); !problem.empty())
    return broken(problem);
  const auto rows = rowsOf(header, bytes);
  if (const std::string problem = describeProblem(rows, header.headBytes, bytes.size()); !problem.empty())
    return broken(problem);
  Checksum checksum;
  addAllButItself(checksum, bytes);
  if (checksum.digest() != header.checksum)
    return broken("is damaged: its checksum does not match its contents");
  auto info = infoOf(header, bytes);
  if (!info)
    return broken(info.error().message);
  Volume volume(std::move(*info), streamsIn(bytes, rows), std::move(owner));
  if (!trusted)
    if (auto checked = checkWords(volume, name); !checked)
      return checked.error();
  return volume;
}

namespace {

Header headerOf(const VolumeInfo &info, std::size_t irBytes, std::size_t streams) {
  Header header;
  header.voxels = info.voxels;
  header.extent = {info.extent.x, info.extent.y, info.extent.z};
  header.irBytes = static_cast<std::uint32_t>(irBytes);
  header.provenanceBytes = static_cast<std::uint32_t>(info.provenance.size());
  header.streams = static_cast<std::uint32_t>(streams);
  header.voxelToModel = voxc::rowsOf(info.voxelToModel);
  header.headBytes = wholePages(header.textEnd());
  return header;
}

template <typename T> std::string bytesOf(std::span<const T> values) {
  return {reinterpret_cast<const char *>(values.data()), values.size_bytes()};
}

} // namespace

std::uint64_t volumeHeadBytes(const VolumeInfo &info, std::size_t streams) {
  return headerOf(info, printIr(info.format).size(), streams).headBytes;
}

std::string volumeFileHead(const VolumeInfo &info, std::span<const Stream> streams,
                           const std::function<void()> &pause) {
  const std::string ir = printIr(info.format);
  Header header = headerOf(info, ir.size(), streams.size());
  const auto rows = layOut(streams, header.headBytes);
  header.fileBytes = rows.back().offset + streams.back().bytes.size();
  std::string head =
      bytesOf(std::span<const Header>(&header, 1)) + bytesOf<StreamRow>(rows) + ir + info.provenance;
  head.resize(header.headBytes);

  Checksum checksum;
  addAllButItself(checksum, std::as_bytes(std::span(head)));
  std::uint64_t end = head.size();
  for (std::size_t i = 0; i < streams.size(); ++i) {
    const std::string padding(rows[i].offset - end, '\0');
    checksum.add(padding.data(), padding.size());
    addStream(checksum, streams[i].bytes, pause);
    end = rows[i].offset + streams[i].bytes.size();
  }
  header.checksum = checksum.digest();
  std::memcpy(head.data() + offsetof(Header, checksum), &header.checksum, sizeof(header.checksum));
  return head;
}

} // namespace voxc
