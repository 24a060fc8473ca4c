// Reading, checking and writing the heads of .hvx files.
#include "VolumeHead.h"

#include "WordRecord.h"

#include <cstring>
#include <string_view>

namespace voxc {
namespace {

constexpr std::uint32_t kNewestVersion = kPagedVersion;
constexpr std::uint64_t kMaxTextBytes = 1 << 20;
/// What fragments begin with (docs/hvf.md).
constexpr std::string_view kFragmentMagic = "\x89HVF\r\n\x1a\n";

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

/// In version 3 the tables of pages follow the texts: how many rows they have, the table of streams says.
bool hasPossibleHead(const Header &header) {
  return header.version == kMappedVersion
             ? header.headBytes == wholePages(header.textEnd())
             : header.headBytes == wholePages(header.headBytes) && header.headBytes >= header.textEnd();
}

std::string describeProblemOfLater(const Header &header, std::uint64_t fileBytes) {
  if (header.fileBytes != fileBytes)
    return truncated(header.fileBytes, " bytes", fileBytes);
  if (header.streams == 0 || header.streams > kMostStreams || !hasPossibleHead(header) ||
      header.headBytes > fileBytes)
    return "has a header that contradicts itself";
  return {};
}

std::string describeProblem(const Header &header, std::uint64_t fileBytes) {
  if (header.version > kNewestVersion)
    return "is of version " + std::to_string(header.version) + "; this voxc reads versions up to " +
           std::to_string(kNewestVersion);
  if (header.version == 0 || header.byteOrder != Header{}.byteOrder)
    return "has a header that is damaged or of another byte order";
  if (std::uint64_t{header.irBytes} + header.provenanceBytes > kMaxTextBytes)
    return "has a header that contradicts itself";
  return header.version == 1 ? describeProblemOfVersion1(header, fileBytes)
                             : describeProblemOfLater(header, fileBytes);
}

bool fitsFormat(const Header &header, const Format &format) {
  const Int3 extent = format.extent();
  for (int axis = 0; axis < 3; ++axis)
    if (header.extent[axis] < 0 || header.extent[axis] > extent[axis])
      return false;
  return true;
}

template <typename T> std::string bytesOf(std::span<const T> values) {
  return {reinterpret_cast<const char *>(values.data()), values.size_bytes()};
}

} // namespace

Expected<Header> readHeader(std::span<const std::byte> file) {
  Header header;
  const Header expected;
  if (std::string_view(reinterpret_cast<const char *>(file.data()), file.size()).starts_with(kFragmentMagic))
    return Error::input("is a fragment of a volume; 'voxc merge' makes the volume of all its fragments");
  if (file.size() >= sizeof(Header))
    std::memcpy(&header, file.data(), sizeof(Header));
  if (file.size() < sizeof(Header) || header.magic != expected.magic)
    return Error::input("is not a .hvx volume");
  if (std::string problem = describeProblem(header, file.size()); !problem.empty())
    return Error::input(std::move(problem));
  return header;
}

std::vector<StreamRow> rowsOf(const Header &header, std::span<const std::byte> file) {
  if (header.version == 1) {
    const auto words = file.subspan(header.headBytes);
    return layOut(std::array{Stream{std::string(kWordStream), sizeof(std::uint32_t), words}},
                  header.headBytes);
  }
  std::vector<StreamRow> rows(header.streams);
  std::memcpy(rows.data(), file.data() + sizeof(Header), rows.size() * sizeof(StreamRow));
  return rows;
}

Expected<VolumeInfo> infoOf(const Header &header, std::span<const std::byte> file) {
  const auto *text = reinterpret_cast<const char *>(file.data()) + header.textOffset();
  Diagnostics diagnostics;
  Format format = parseIr(std::string_view(text, header.irBytes), diagnostics);
  if (diagnostics.hasErrors())
    return Error::input("names no valid format: " + diagnostics.all().front().message);
  if (format != storageFormat(format) || !fitsFormat(header, format))
    return Error::input("has a header that contradicts its format");
  VolumeInfo info;
  info.format = std::move(format);
  info.extent = {header.extent[0], header.extent[1], header.extent[2]};
  info.voxelToModel = transformOfRows(header.voxelToModel);
  info.voxels = header.voxels;
  readRecord({text + header.irBytes, header.provenanceBytes}, info);
  return info;
}

Header headerOf(const VolumeInfo &info, std::size_t streams) {
  Header header;
  header.voxels = info.voxels;
  header.extent = {info.extent.x, info.extent.y, info.extent.z};
  header.irBytes = static_cast<std::uint32_t>(printIr(info.format).size());
  header.provenanceBytes = static_cast<std::uint32_t>(textWithRecord(info).size());
  header.streams = static_cast<std::uint32_t>(streams);
  header.voxelToModel = voxc::rowsOf(info.voxelToModel);
  header.headBytes = wholePages(header.textEnd());
  return header;
}

void addAllButItself(Checksum &checksum, std::span<const std::byte> bytes) {
  constexpr std::size_t kAt = offsetof(Header, checksum);
  constexpr std::size_t kAfter = kAt + sizeof(Header::checksum);
  checksum.add(bytes.data(), kAt);
  checksum.add(bytes.data() + kAfter, bytes.size() - kAfter);
}

std::string headText(const Header &header, std::span<const StreamRow> rows, const VolumeInfo &info) {
  return bytesOf(std::span<const Header>(&header, 1)) + bytesOf(rows) + printIr(info.format) +
         textWithRecord(info);
}

void seal(std::string &head, std::uint64_t checksum) {
  std::memcpy(head.data() + offsetof(Header, checksum), &checksum, sizeof checksum);
}

} // namespace voxc
