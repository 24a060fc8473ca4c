// Reading and writing of .hvx headers; docs/hvx.md has the layout as a table.
#include "VolumeFile.h"

#include "Checksum.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>

namespace voxc {
namespace {

constexpr std::uint64_t kWordsAlignment = 4096;
constexpr std::uint32_t kVersion = 1;
constexpr std::uint32_t kByteOrder = 0x01020304;
constexpr std::uint64_t kMaxTextBytes = 1 << 20;
constexpr std::size_t kWordsBetweenPauses = std::size_t{1} << 14;

/// The fixed part of the header; little-endian, no padding.
struct Header {
  std::array<char, 8> magic = {'\x89', 'H', 'V', 'X', '\r', '\n', '\x1a', '\n'};
  std::uint32_t version = kVersion;
  std::uint32_t byteOrder = kByteOrder;
  std::uint64_t checksum = 0; ///< XXH3-64 of all other bytes of the file, in order.
  std::uint64_t wordCount = 0;
  std::uint64_t wordsOffset = 0; ///< In bytes; a multiple of kWordsAlignment.
  std::uint64_t voxels = 0;
  std::array<std::int32_t, 3> extent{};
  std::uint32_t irBytes = 0; ///< Of the canonical IR text, which follows the header.
  std::uint32_t provenanceBytes = 0;
  std::uint32_t reserved = 0;
  std::array<double, 12> voxelToModel{};
};
static_assert(sizeof(Header) == 168);

std::uint64_t checksumOf(std::span<const std::byte> head, std::span<const std::uint32_t> words,
                         const std::function<void()> &pause = {}) {
  constexpr std::size_t at = offsetof(Header, checksum);
  constexpr std::size_t after = at + sizeof(Header::checksum);
  Checksum checksum;
  checksum.add(head.data(), at);
  checksum.add(head.data() + after, head.size() - after);
  for (std::size_t begin = 0; begin < words.size(); begin += kWordsBetweenPauses) {
    const auto piece = words.subspan(begin, std::min(kWordsBetweenPauses, words.size() - begin));
    checksum.add(piece.data(), piece.size_bytes());
    if (pause)
      pause();
  }
  return checksum.digest();
}

std::string describeProblem(const Header &header, std::uint64_t fileBytes) {
  const std::uint64_t textBytes = std::uint64_t{header.irBytes} + header.provenanceBytes;
  if (header.version > kVersion)
    return "is of version " + std::to_string(header.version) + "; this voxc reads versions up to " +
           std::to_string(kVersion);
  if (header.version == 0 || header.byteOrder != kByteOrder)
    return "has a header that is damaged or of another byte order";
  if (textBytes > kMaxTextBytes || header.wordsOffset % kWordsAlignment != 0 ||
      header.wordsOffset < sizeof(Header) + textBytes)
    return "has a header that contradicts itself";
  if (header.wordsOffset > fileBytes || header.wordCount != (fileBytes - header.wordsOffset) / 4 ||
      (fileBytes - header.wordsOffset) % 4 != 0)
    return "is truncated or has surplus bytes: its header speaks of " + std::to_string(header.wordCount) +
           " words, but it has " + std::to_string(fileBytes) + " bytes in all";
  return {};
}

bool fitsFormat(const Header &header, const Format &format) {
  const Int3 extent = format.extent();
  for (int axis = 0; axis < 3; ++axis)
    if (header.extent[axis] < 0 || header.extent[axis] > extent[axis])
      return false;
  return true;
}

} // namespace

Expected<VolumeFileContents> parseVolumeFile(std::span<const std::byte> bytes, const std::string &name) {
  const auto broken = [&](const std::string &problem) { return Error::input("'" + name + "' " + problem); };
  Header header;
  const Header expected;
  if (bytes.size() >= sizeof(Header))
    std::memcpy(&header, bytes.data(), sizeof(Header));
  if (bytes.size() < sizeof(Header) || header.magic != expected.magic)
    return broken("is not a .hvx volume");
  if (const std::string problem = describeProblem(header, bytes.size()); !problem.empty())
    return broken(problem);

  const std::span words(reinterpret_cast<const std::uint32_t *>(bytes.data() + header.wordsOffset),
                        header.wordCount);
  if (checksumOf(bytes.first(header.wordsOffset), words) != header.checksum)
    return broken("is damaged: its checksum does not match its contents");

  const auto *text = reinterpret_cast<const char *>(bytes.data()) + sizeof(Header);
  Diagnostics diagnostics;
  Format format = parseIr(std::string_view(text, header.irBytes), diagnostics);
  if (diagnostics.hasErrors())
    return broken("names no valid format: " + diagnostics.all().front().message);
  if (format != storageFormat(format) || !fitsFormat(header, format))
    return broken("has a header that contradicts its format");
  VolumeInfo info{std::move(format),
                  {header.extent[0], header.extent[1], header.extent[2]},
                  {header.voxelToModel},
                  header.voxels,
                  std::string(text + header.irBytes, header.provenanceBytes)};
  return VolumeFileContents{std::move(info), words};
}

std::uint64_t volumeWordsOffset(const VolumeInfo &info) {
  const std::size_t textEnd = sizeof(Header) + printIr(info.format).size() + info.provenance.size();
  return (textEnd + kWordsAlignment - 1) / kWordsAlignment * kWordsAlignment;
}

std::string volumeFileHeader(const VolumeInfo &info, std::span<const std::uint32_t> words,
                             const std::function<void()> &pause) {
  const std::string ir = printIr(info.format);
  Header header;
  header.wordCount = words.size();
  header.voxels = info.voxels;
  header.extent = {info.extent.x, info.extent.y, info.extent.z};
  header.irBytes = static_cast<std::uint32_t>(ir.size());
  header.provenanceBytes = static_cast<std::uint32_t>(info.provenance.size());
  header.voxelToModel = info.voxelToModel.rows;
  header.wordsOffset = volumeWordsOffset(info);

  std::string bytes(header.wordsOffset, '\0');
  std::memcpy(bytes.data(), &header, sizeof(Header));
  bytes.replace(sizeof(Header), ir.size(), ir);
  bytes.replace(sizeof(Header) + ir.size(), info.provenance.size(), info.provenance);
  header.checksum = checksumOf(std::as_bytes(std::span(bytes)), words, pause);
  std::memcpy(bytes.data() + offsetof(Header, checksum), &header.checksum, sizeof(header.checksum));
  return bytes;
}

} // namespace voxc
