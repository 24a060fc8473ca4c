// Reading tables of pages, and checking them against the file that they stand in.
#include "PageTable.h"

#include <bit>
#include <cstring>
#include <limits>

namespace voxc {
namespace {

constexpr std::uint32_t kSmallestPage = 1 << 12;
constexpr std::uint32_t kLargestPage = 1 << 20;

/// What the row says of a stream, as if every page were there.
Expected<PagedStream> streamOf(const StreamRow &row) {
  PagedStream stream{std::string(nameOf(row)), row.elementBytes, row.pageBytes};
  if (!isPageSize(row.pageBytes))
    return Error::input("has a stream '" + stream.name + "' whose pages have no possible size");
  if (row.elements > std::numeric_limits<std::uint64_t>::max() / row.elementBytes)
    return Error::input("has a stream '" + stream.name + "' that no file can hold");
  stream.bytes = row.elements * row.elementBytes;
  return stream;
}

} // namespace

bool isPageSize(std::uint32_t bytes) {
  return std::has_single_bit(bytes) && bytes >= kSmallestPage && bytes <= kLargestPage;
}

Expected<std::vector<StreamPages>> readPageTables(std::span<const StreamRow> rows, std::uint64_t tablesBegin,
                                                  std::uint64_t headBytes, std::span<const std::byte> file) {
  std::vector<StreamPages> streams;
  streams.reserve(rows.size());
  std::uint64_t end = tablesBegin;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (std::string problem = describeProblem(rows, i); !problem.empty())
      return Error::input(std::move(problem));
    auto stream = VOXC_TRY(streamOf(rows[i]));
    const std::uint64_t pages = stream.pages();
    if (pages > (headBytes - end) / sizeof(PageRow))
      return Error::input("has a stream '" + stream.name + "' of more pages than its head lists");
    StreamPages &read = streams.emplace_back(std::move(stream), rows[i].offset, std::vector<PageRow>(pages));
    if (pages > 0)
      std::memcpy(read.rows.data(), file.data() + end, pages * sizeof(PageRow));
    end += pages * sizeof(PageRow);
  }
  if (headBytes != wholePages(end))
    return Error::input("has a header that contradicts itself");
  return streams;
}

std::string describeProblem(std::span<const StreamPages> streams, std::uint64_t headBytes,
                            std::uint64_t fileBytes) {
  std::uint64_t end = headBytes;
  for (const auto &[stream, offset, rows] : streams) {
    if (offset != end)
      return "has a stream '" + stream.name + "' that does not lie where it must";
    for (std::uint64_t page = 0; page < rows.size(); ++page) {
      if (rows[page].end <= end || rows[page].end > fileBytes || rows[page].end - end > stream.bytesOf(page))
        return "has a page " + std::to_string(page) + " of stream '" + stream.name +
               "' that does not lie where it must";
      end = rows[page].end;
    }
  }
  return end == fileBytes ? "" : "has surplus bytes behind its streams";
}

} // namespace voxc
