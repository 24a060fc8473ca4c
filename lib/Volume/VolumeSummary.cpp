// Reading the heads of .hvx files alone.
#include "voxc/Volume/VolumeSummary.h"

#include "VolumeHead.h"

#include "voxc/Support/File.h"
#include "voxc/Volume/PagedVolume.h"

namespace voxc {
namespace {

Expected<VolumeSummary> summarizePaged(std::span<const std::byte> file, const std::string &path) {
  const auto paged = VOXC_TRY(PagedVolume::read(file, nullptr, path));
  VolumeSummary summary{paged.info(), {}};
  for (const PagedStream &stream : paged.streams())
    summary.streams.push_back(
        {stream.name, stream.elementBytes, stream.bytes, stream.storedBytes, stream.pageBytes});
  return summary;
}

/// The errors follow the file's name.
Expected<VolumeSummary> summarizeMapped(const Header &header, std::span<const std::byte> file) {
  const auto rows = rowsOf(header, file);
  if (std::string problem = describeProblem(rows, header.headBytes, file.size()); !problem.empty())
    return Error::input(std::move(problem));
  auto info = VOXC_TRY(infoOf(header, file));
  VolumeSummary summary{std::move(info), {}};
  for (const StreamRow &row : rows) {
    const std::uint64_t bytes = row.elements * row.elementBytes;
    summary.streams.push_back({std::string(nameOf(row)), row.elementBytes, bytes, bytes});
  }
  return summary;
}

} // namespace

std::uint64_t VolumeSummary::bytes() const {
  std::uint64_t bytes = 0;
  for (const StreamSummary &stream : streams)
    bytes += stream.bytes;
  return bytes;
}

std::uint64_t VolumeSummary::storedBytes() const {
  std::uint64_t bytes = 0;
  for (const StreamSummary &stream : streams)
    bytes += stream.storedBytes;
  return bytes;
}

Expected<VolumeSummary> summarizeVolume(const std::string &path) {
  const auto file = VOXC_TRY(MappedFile::open(path));
  const auto broken = [&](const Error &error) { return Error::input("'" + path + "' " + error.message); };
  const auto header = readHeader(file.bytes());
  if (!header)
    return broken(header.error());
  if (header->version == kPagedVersion)
    return summarizePaged(file.bytes(), path);
  auto summary = summarizeMapped(*header, file.bytes());
  return summary ? std::move(summary) : broken(summary.error());
}

} // namespace voxc
