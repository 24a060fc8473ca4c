// Puts the checksums of a .hvx file right, as a hostile file's would be: what a fuzzer changes must get
// behind them.
#pragma once

#include "Volume/PageTable.h"
#include "Volume/VolumeHead.h"

#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

namespace voxc::fuzz {

/// Of the pages of a compressed file, as far as its tables can be read.
inline void putPageChecksumsRight(const Header &header, std::span<std::byte> bytes) {
  const auto tables = readPageTables(rowsOf(header, bytes), header.textEnd(), header.headBytes, bytes);
  if (!tables || !describeProblem(*tables, header.headBytes, bytes.size()).empty())
    return;
  std::byte *row = bytes.data() + header.textEnd();
  for (const StreamPages &stream : *tables)
    for (std::uint64_t page = 0; page < stream.rows.size(); ++page, row += sizeof(PageRow)) {
      Checksum checksum;
      const auto stored = stream.stored(bytes, page);
      checksum.add(stored.data(), stored.size());
      const PageRow right{stream.rows[page].end, checksum.digest()};
      std::memcpy(row, &right, sizeof right);
    }
}

/// Of a file of any version whose header can be read; else nothing changes.
inline void putChecksumsRight(std::span<std::byte> bytes) {
  const auto header = readHeader(bytes);
  if (!header)
    return;
  const bool isPaged = header->version == kPagedVersion;
  if (isPaged)
    putPageChecksumsRight(*header, bytes);
  Checksum checksum;
  addAllButItself(checksum, isPaged ? bytes.first(header->headBytes) : bytes);
  const std::uint64_t digest = checksum.digest();
  std::memcpy(bytes.data() + offsetof(Header, checksum), &digest, sizeof digest);
}

/// A fuzzer's bytes as such a file.
inline std::vector<std::byte> withRightChecksums(const unsigned char *data, std::size_t size) {
  const auto *begin = reinterpret_cast<const std::byte *>(data);
  std::vector<std::byte> bytes(begin, begin + size);
  putChecksumsRight(bytes);
  return bytes;
}

} // namespace voxc::fuzz
