// Laying streams out in a file, and checking what a file says of its own.
#include "StreamTable.h"

#include <algorithm>
#include <string_view>

namespace voxc {
namespace {

constexpr std::uint64_t kPageBytes = 4096;
bool isLetter(char c) { return c >= 'a' && c <= 'z'; }

bool isInName(char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '-'; }

/// A name fills its row up with zeros, so that it can be written in one way only.
bool hasName(const StreamRow &row) {
  const std::string_view name = nameOf(row);
  return isStreamName(name) &&
         std::ranges::count(row.name, '\0') == static_cast<std::ptrdiff_t>(row.name.size() - name.size());
}

bool isWords(const StreamRow &row) {
  return nameOf(row) == kWordStream && row.elementBytes == sizeof(std::uint32_t);
}

} // namespace

bool isStreamName(std::string_view name) {
  return !name.empty() && name.size() < StreamRow{}.name.size() && isLetter(name.front()) &&
         std::ranges::all_of(name, isInName);
}

std::string_view nameOf(const StreamRow &row) {
  return {row.name.data(), static_cast<std::size_t>(std::ranges::find(row.name, '\0') - row.name.begin())};
}

std::uint64_t wholePages(std::uint64_t bytes) { return (bytes + kPageBytes - 1) / kPageBytes * kPageBytes; }

std::uint64_t placeOf(std::uint64_t bytes, std::uint64_t end) { return bytes == 0 ? end : wholePages(end); }

std::vector<StreamRow> layOut(std::span<const Stream> streams, std::uint64_t headBytes) {
  std::vector<StreamRow> rows;
  rows.reserve(streams.size());
  std::uint64_t end = headBytes;
  for (const Stream &stream : streams) {
    StreamRow &row = rows.emplace_back();
    stream.name.copy(row.name.data(), row.name.size() - 1);
    row.elementBytes = stream.elementBytes;
    row.elements = stream.elements();
    row.offset = placeOf(stream.bytes.size(), end);
    end = row.offset + stream.bytes.size();
  }
  return rows;
}

std::string describeProblem(std::span<const StreamRow> rows, std::size_t index) {
  const StreamRow &row = rows[index];
  if (index == 0 && !isWords(row))
    return "does not have its words first";
  if (index == 0 && row.elements == 0)
    return "has no words; even an empty volume has one";
  if (!hasName(row))
    return "has a stream without a name";
  const std::string stream = "stream '" + std::string(nameOf(row)) + "'";
  if (std::ranges::count(rows.first(index), nameOf(row), nameOf) > 0)
    return "has more than one " + stream;
  if (row.elementBytes == 0 || row.elementBytes > kMostElementBytes)
    return "has a " + stream + " whose elements have no possible size";
  return {};
}

std::string describeProblem(std::span<const StreamRow> rows, std::uint64_t headBytes,
                            std::uint64_t fileBytes) {
  std::uint64_t end = headBytes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const StreamRow &row = rows[i];
    if (std::string problem = describeProblem(rows, i); !problem.empty())
      return problem;
    const std::string stream = "stream '" + std::string(nameOf(row)) + "'";
    if (row.pageBytes != 0)
      return "has a " + stream + " in pages, which its version does not know";
    const std::uint64_t place = placeOf(row.elements, end);
    if (row.offset != place || place > fileBytes || row.elements > (fileBytes - place) / row.elementBytes)
      return "has a " + stream + " that does not lie where it must";
    end = place + row.elements * row.elementBytes;
  }
  return end == fileBytes ? "" : "has surplus bytes behind its streams";
}

std::vector<Stream> streamsIn(std::span<const std::byte> file, std::span<const StreamRow> rows) {
  std::vector<Stream> streams;
  streams.reserve(rows.size());
  for (const StreamRow &row : rows)
    streams.push_back({std::string(nameOf(row)), row.elementBytes,
                       file.subspan(row.offset, row.elements * row.elementBytes),
                       row.elements * row.elementBytes});
  return streams;
}

} // namespace voxc
