// Opening NRRD volumes.
#include "Input/Openers/Openers.h"

#include "Input/Dense/DenseVolume.h"
#include "Input/Dense/GzipReader.h"
#include "Input/Dense/NrrdHeader.h"
#include "voxc/Support/Stopwatch.h"

#include <filesystem>
#include <utility>

namespace voxc {

namespace {

using File = std::shared_ptr<const WatchedFile>;

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

/// The samples as they lie in the file.
Expected<void> mapSamples(DenseVolume &volume, const NrrdHeader &header, std::span<const std::byte> data,
                          std::uint64_t size, File file) {
  const std::uint64_t skip = header.byteSkip >= 0 ? static_cast<std::uint64_t>(header.byteSkip)
                                                  : data.size() - std::min(size, data.size());
  if (skip > data.size() || size > data.size() - skip)
    return Error::input("its data have " + std::to_string(data.size()) + " bytes, but it needs " +
                        std::to_string(size) + " behind a skip of " + std::to_string(skip));
  volume.samples = data.data() + skip;
  volume.storage = std::move(file);
  return {};
}

/// What is left out before the samples of compressed data.
Expected<void> skipBytes(GzipReader &reader, std::int64_t count) {
  constexpr std::int64_t kMost = std::int64_t{1} << 24;
  if (count > kMost)
    return Error::input("its byte skip of " + std::to_string(count) +
                        " is too large; compressed data may skip " + std::to_string(kMost));
  std::vector<std::byte> skipped(static_cast<std::size_t>(count));
  return reader.read(skipped);
}

Expected<void> inflateSamples(DenseVolume &volume, const NrrdHeader &header, std::span<const std::byte> data,
                              std::uint64_t size, const InputOptions &options) {
  GzipReader reader(data);
  if (auto skipped = skipBytes(reader, header.byteSkip); !skipped)
    return skipped;
  auto inflated = reader.read(size, options.memory, options.progress);
  if (!inflated)
    return inflated.error();
  volume.samples = (*inflated)->data();
  volume.storage = std::move(*inflated);
  return {};
}

Expected<DenseVolume> readVolume(const std::string &path, const InputOptions &options) {
  auto file = WatchedFile::open(path, options.memory);
  if (!file)
    return file.error();
  std::string_view text = (*file)->text();
  const auto header = readNrrdHeader(text);
  if (!header)
    return Error::input("'" + path + "' is not a usable NRRD file: " + header.error().message);
  std::span<const std::byte> data = std::as_bytes(std::span(text));
  if (!header->dataFile.empty()) {
    file = WatchedFile::open(std::filesystem::path(path).parent_path() / header->dataFile, options.memory);
    if (!file)
      return file.error();
    data = (*file)->bytes();
  }
  const auto broken = [&](const Error &error) {
    return error.kind != ErrorKind::Input
               ? error
               : Error::input("'" + path + "' is not a usable NRRD file: " + error.message);
  };
  if (!skipLines(data, header->lineSkip))
    return broken(Error::input("its data have fewer lines than it skips"));
  const auto size = sampleBytes(header->extent, header->layout);
  if (!size)
    return broken(size.error());
  DenseVolume volume;
  volume.extent = header->extent;
  volume.layout = header->layout;
  volume.sampleToModel = header->sampleToModel;
  const auto found = header->isGzip ? inflateSamples(volume, *header, data, *size, options)
                                    : mapSamples(volume, *header, data, *size, std::move(*file));
  if (!found)
    return broken(found.error());
  return volume;
}

} // namespace

Expected<Input> openNrrd(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto volume = readVolume(path, options);
  if (!volume)
    return volume.error();
  auto input = makeInput(std::move(*volume), options);
  if (input)
    input->loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
