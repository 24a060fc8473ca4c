// Files and encodings of NRRD samples.
#include "Input/Dense/NrrdData.h"

#include "Input/Dense/ByteStream.h"
#include "Support/Text.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace voxc {

namespace {

using Cells = ScratchArray<std::byte>;

/// Takes lines off the front; false if there are fewer.
bool skipLines(std::span<const std::byte> &bytes, std::uint64_t lines) {
  for (; lines > 0; --lines) {
    const auto end = std::find(bytes.begin(), bytes.end(), std::byte{'\n'});
    if (end == bytes.end())
      return false;
    bytes = bytes.subspan(static_cast<std::size_t>(end - bytes.begin()) + 1);
  }
  return true;
}

std::unique_ptr<ByteStream> streamOf(const NrrdHeader &header, std::span<const std::byte> data) {
  switch (header.encoding) {
  case NrrdEncoding::Raw:
    return makeRawStream(data);
  case NrrdEncoding::Gzip:
    return makeGzipStream(data);
  case NrrdEncoding::Bzip2:
    return makeBzip2Stream(data);
  case NrrdEncoding::Text:
    return makeTextStream(data, header.layout.type);
  case NrrdEncoding::Hex:
    return makeHexStream(data);
  }
  return nullptr;
}

/// Bytes that stand before the samples of a file that has `size` of them. Digits skip bytes of the file
/// itself, as what they stand for begins nowhere else.
Expected<std::uint64_t> skipOf(const NrrdHeader &header, std::span<const std::byte> data, std::uint64_t size,
                               const InputOptions &options) {
  // A few bytes of bzip2 stand for days of work.
  constexpr std::uint64_t kMost = std::uint64_t{1} << 30;
  if (header.byteSkip > static_cast<std::int64_t>(kMost))
    return Error::input("its byte skip of " + std::to_string(header.byteSkip) +
                        " is too large; compressed data may skip " + std::to_string(kMost));
  if (header.byteSkip >= 0)
    return static_cast<std::uint64_t>(header.byteSkip);
  const auto all = VOXC_TRY(countBytes(*streamOf(header, data), size + kMost, options.progress));
  return all - std::min(size, all);
}

/// The samples as they lie in the file.
Expected<NrrdData> mapSamples(const NrrdHeader &header, std::span<const std::byte> data,
                              std::shared_ptr<const WatchedFile> file) {
  const std::uint64_t skip = header.byteSkip >= 0 ? static_cast<std::uint64_t>(header.byteSkip)
                                                  : data.size() - std::min(header.bytes, data.size());
  if (skip > data.size() || header.bytes > data.size() - skip)
    return Error::input("its data have " + std::to_string(data.size()) + " bytes, but it needs " +
                        std::to_string(header.bytes) + " behind a skip of " + std::to_string(skip));
  NrrdData samples{data.data() + skip, std::move(file), {}};
  if (const std::uint64_t behind = data.size() - skip - header.bytes; behind != 0)
    samples.warnings.push_back(countedAre(behind, "byte") + " left out, which lie behind the samples");
  return samples;
}

/// Appends the samples of one file.
Expected<void> appendFile(const NrrdHeader &header, std::span<const std::byte> data, std::uint64_t size,
                          const InputOptions &options, Cells &cells, std::vector<std::string> &warnings) {
  const bool isDigits = header.encoding == NrrdEncoding::Text || header.encoding == NrrdEncoding::Hex;
  if (isDigits && static_cast<std::uint64_t>(header.byteSkip) > data.size())
    return Error::input("its data end within the " + std::to_string(header.byteSkip) +
                        " bytes that it skips");
  const auto skip =
      VOXC_TRY(isDigits ? Expected<std::uint64_t>(std::uint64_t{0}) : skipOf(header, data, size, options));
  if (isDigits)
    data = data.subspan(static_cast<std::size_t>(header.byteSkip));
  const auto stream = streamOf(header, data);
  if (skip > stream->mostBytes())
    return Error::input("its data cannot have the " + std::to_string(skip) + " bytes that it skips");
  VOXC_TRY(skipBytes(*stream, skip, options.progress));
  VOXC_TRY(appendBytes(*stream, size, cells, *options.memory, options.progress));
  // Of many files that all have more, once is enough.
  if (warnings.empty())
    warnings = saysBehind(*stream);
  return {};
}

} // namespace

Expected<NrrdData> readNrrdData(const NrrdHeader &header, std::shared_ptr<const WatchedFile> file,
                                std::span<const std::byte> behind, const std::string &folder,
                                const InputOptions &options) {
  const std::size_t files = std::max<std::size_t>(header.dataFiles.size(), 1);
  Cells cells(options.memory);
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < files; ++i) {
    std::span<const std::byte> data = behind;
    if (!header.dataFiles.empty()) {
      file = VOXC_TRY(WatchedFile::open(std::filesystem::path(folder) / header.dataFiles[i], options.memory));
      data = file->bytes();
    }
    if (!skipLines(data, header.lineSkip))
      return Error::input("its data have fewer lines than it skips");
    if (files == 1 && header.encoding == NrrdEncoding::Raw)
      return mapSamples(header, data, std::move(file));
    VOXC_TRY(appendFile(header, data, header.bytes / files, options, cells, warnings));
  }
  const std::byte *const samples = cells.data();
  return NrrdData{samples, std::make_shared<const Cells>(std::move(cells)), std::move(warnings)};
}

} // namespace voxc
