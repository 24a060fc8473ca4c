// The tables of pages in a compressed .hvx file (docs/hvx.md): where each page of each stream lies.
#pragma once

#include "StreamTable.h"

#include "voxc/Volume/PagedVolume.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace voxc {

/// A row of a table; little-endian, no padding. A page begins where the one before it ends.
struct PageRow {
  std::uint64_t end = 0;      ///< In bytes from the beginning of the file.
  std::uint64_t checksum = 0; ///< XXH3-64 of the page as it is stored.
};
static_assert(sizeof(PageRow) == 16);

/// A stream, and its pages in the file.
struct StreamPages {
  PagedStream stream;
  std::uint64_t offset = 0; ///< Of the first page.
  std::vector<PageRow> rows;

  /// The page as the file stores it.
  std::span<const std::byte> stored(std::span<const std::byte> file, std::uint64_t page) const {
    const std::uint64_t begin = page == 0 ? offset : rows[page - 1].end;
    return file.subspan(begin, rows[page].end - begin);
  }
};

/// Whether pages may have so many bytes: a power of two, 4 KiB to 1 MiB.
bool isPageSize(std::uint32_t bytes);

/// Reads the tables, which begin at `tablesBegin` and end in the head. Nothing is allocated for pages that
/// have no row there. The error follows the file's name.
Expected<std::vector<StreamPages>> readPageTables(std::span<const StreamRow> rows, std::uint64_t tablesBegin,
                                                  std::uint64_t headBytes, std::span<const std::byte> file);

/// What is wrong with where the pages lie, or nothing: each has one byte at least and no more than it has
/// decoded, and they follow each other from the end of the head to that of the file. "has ...", to follow the
/// file's name.
std::string describeProblem(std::span<const StreamPages> streams, std::uint64_t headBytes,
                            std::uint64_t fileBytes);

} // namespace voxc
