// The head of a .hvx file (docs/hvx.md): the header, the table of streams and the texts, of all versions.
#pragma once

#include "Checksum.h"
#include "StreamTable.h"

#include "voxc/Support/Error.h"
#include "voxc/Volume/Volume.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace voxc {

/// Streams as they are, to be mapped.
inline constexpr std::uint32_t kMappedVersion = 2;
/// Streams in compressed pages.
inline constexpr std::uint32_t kPagedVersion = 3;

/// The fixed part of the head; little-endian, no padding. The table of streams follows, then the texts.
struct Header {
  std::array<char, 8> magic = {'\x89', 'H', 'V', 'X', '\r', '\n', '\x1a', '\n'};
  std::uint32_t version = kMappedVersion;
  std::uint32_t byteOrder = 0x01020304;
  std::uint64_t checksum =
      0; ///< XXH3-64 of all other bytes, in order: of the file; in version 3 of the head.
  std::uint64_t fileBytes = 0; ///< Of the whole file. In version 1 the number of words.
  std::uint64_t headBytes = 0; ///< Of all before the first stream: whole pages.
  std::uint64_t voxels = 0;
  std::array<std::int32_t, 3> extent{};
  std::uint32_t irBytes = 0;
  std::uint32_t provenanceBytes = 0; ///< And the record of words behind it.
  std::uint32_t streams = 0; ///< Rows of the table. Version 1 has none: all that follows the head is words.
  std::array<double, 12> voxelToModel{};

  std::uint64_t textOffset() const { return sizeof(Header) + streams * sizeof(StreamRow); }
  std::uint64_t textEnd() const { return textOffset() + irBytes + provenanceBytes; }
};
static_assert(sizeof(Header) == 168);

/// The header of a file, checked against the file's size. The error follows the file's name.
Expected<Header> readHeader(std::span<const std::byte> file);

/// The table of a file whose header was found right; for version 1 the one that it would have.
std::vector<StreamRow> rowsOf(const Header &header, std::span<const std::byte> file);

/// What the header and its texts, which lie in the file, say of the volume. The error follows the file's
/// name.
Expected<VolumeInfo> infoOf(const Header &header, std::span<const std::byte> file);

/// The header of a file of a volume with so many streams, but for the checksum and the bytes of the file.
Header headerOf(const VolumeInfo &info, std::size_t streams);

/// The bytes of a file, or of its head, but those of the checksum itself.
void addAllButItself(Checksum &checksum, std::span<const std::byte> bytes);

/// The header, the table and the texts, without what fills the head up.
std::string headText(const Header &header, std::span<const StreamRow> rows, const VolumeInfo &info);

/// Puts the checksum into the head.
void seal(std::string &head, std::uint64_t checksum);

} // namespace voxc
