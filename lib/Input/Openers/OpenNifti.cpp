// Opening NIfTI volumes and pairs of files, compressed or not.
#include "Input/Openers/Openers.h"

#include "Input/Dense/ByteStream.h"
#include "Input/Dense/GzipReader.h"
#include "Input/Dense/NiftiHeader.h"
#include "Input/Dense/Orientation.h"
#include "Input/Dense/VolumeChoice.h"
#include "Input/Openers/OpenDense.h"
#include "Support/Text.h"

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace voxc {

namespace {

using File = std::shared_ptr<const WatchedFile>;
using Cells = ScratchArray<std::byte>;

/// The endings of the two files of a pair, header and samples.
constexpr std::array<std::string_view, 2> kPair{".hdr", ".img"};

/// The path of the other file of a pair, which may be compressed where this is not. Nothing if neither is
/// there.
std::optional<std::string> partnerOf(const std::string &path, std::string_view ending) {
  std::string base = path;
  if (lowerCase(base).ends_with(".gz"))
    base.resize(base.size() - 3);
  const std::size_t dot = base.rfind('.');
  const bool isCapital = dot + 1 < base.size() && base[dot + 1] >= 'A' && base[dot + 1] <= 'Z';
  base.resize(dot);
  for (const char c : ending)
    base += isCapital && c >= 'a' ? static_cast<char>(c - 'a' + 'A') : c;
  std::error_code ignored;
  for (const char *const packed : {"", ".gz", ".GZ"})
    if (std::filesystem::exists(base + packed, ignored))
      return base + packed;
  return std::nullopt;
}

bool hasEnding(const std::string &path, std::string_view ending) {
  const std::string name = lowerCase(path);
  return name.ends_with(ending) || name.ends_with(std::string(ending) + ".gz");
}

std::unique_ptr<ByteStream> streamOf(const File &file) {
  return isGzip(file->bytes()) ? makeGzipStream(file->bytes()) : makeRawStream(file->bytes());
}

Expected<NiftiHeader> readHeader(const File &file, const std::string &path) {
  std::vector<std::byte> front(NiftiHeader::kMaxBytes);
  // Both versions begin with their size, and the shorter one may end before the longer would.
  const auto count = VOXC_TRY(streamOf(file)->readSome(front));
  front.resize(count);
  return readNiftiHeader(front, hasEnding(path, kPair[0]));
}

/// Opens the other file of a pair, that with the samples, and lists it.
Expected<File> openSamples(const std::string &path, const InputOptions &options,
                           std::vector<std::string> &files) {
  const auto samples = partnerOf(path, kPair[1]);
  if (!samples)
    return Error::input("its samples are in a file of its name that ends in .img, which is not there");
  files.push_back(*samples);
  return WatchedFile::open(*samples, options.memory);
}

/// Puts the samples of volume `number` into `volume`.
Expected<void> takeSamples(const NiftiHeader &header, std::uint64_t number, File file,
                           const InputOptions &options, DenseVolume &volume) {
  const auto size = VOXC_TRY(header.volumeBytes());
  if (number > (std::uint64_t{1} << 62) / size)
    return Error::input("its volumes are larger than any file");
  const std::uint64_t begin = header.dataOffset + number * size;
  const std::span<const std::byte> bytes = file->bytes();
  if (!isGzip(bytes)) {
    if (begin > bytes.size() || size > bytes.size() - begin)
      return Error::input("it has " + std::to_string(bytes.size()) + " bytes, but its samples take " +
                          std::to_string(size) + " behind byte " + std::to_string(begin));
    const std::uint64_t room = bytes.size() - header.dataOffset;
    if (header.volumes <= room / size && header.volumes * size < room)
      volume.warnings.push_back(countedAre(room - header.volumes * size, "byte") +
                                " left out, which lie behind the samples");
    volume.samples = bytes.data() + begin;
    volume.storage = std::move(file);
    return {};
  }
  const auto stream = makeGzipStream(bytes);
  if (begin > stream->mostBytes() || size > stream->mostBytes())
    return Error::input("its " + std::to_string(bytes.size()) + " compressed bytes cannot hold the " +
                        std::to_string(size) + " that its header speaks of");
  VOXC_TRY(skipBytes(*stream, begin, options.progress));
  Cells cells(options.memory);
  VOXC_TRY(appendBytes(*stream, size, cells, *options.memory, options.progress));
  if (number + 1 == header.volumes)
    for (std::string &sentence : saysBehind(*stream))
      volume.warnings.push_back(std::move(sentence));
  volume.samples = cells.data();
  volume.storage = std::make_shared<const Cells>(std::move(cells));
  return {};
}

Expected<DenseVolume> volumeOf(const NiftiHeader &header) {
  DenseVolume volume;
  volume.extent = header.extent;
  volume.layout = header.layout;
  volume.slope = header.slope;
  volume.intercept = header.intercept;
  volume.sampleToModel = header.sampleToModel;
  volume.unit = header.unit;
  volume.areLabels = header.areLabels;
  volume.channels = header.channels;
  const auto bytes = static_cast<std::int64_t>(byteSize(header.layout.type));
  const std::int64_t cell = header.arePlanes ? bytes : bytes * header.channels;
  const std::int64_t row = cell * header.extent.x;
  if (header.channels > 1)
    volume.steps = {cell, row, row * header.extent.y};
  volume.channelStep = header.arePlanes ? row * header.extent.y * header.extent.z : bytes;
  return volume;
}

Expected<DenseVolume> readVolume(File file, const std::string &path, const InputOptions &options) {
  const auto header = VOXC_TRY(readHeader(file, path));
  auto volume = volumeOf(header);
  volume->warnings = header.warnings;
  if (header.isPair)
    file = VOXC_TRY(openSamples(path, options, volume->files));
  const auto number = VOXC_TRY(chooseVolume(header.volumes, options, volume->warnings));
  VOXC_TRY(takeSamples(header, number, std::move(file), options, *volume));
  if (header.hasOrientation)
    orient(*volume);
  else if (options.isAutomatic)
    volume->notes.push_back(std::string(header.isAnalyze ? "an Analyze file" : "its header") +
                            " does not say how the axes lie; they are taken as right, front and up");
  return volume;
}

} // namespace

Expected<Input> openNifti(const std::string &path, const InputOptions &options) {
  const bool isImage = hasEnding(path, kPair[1]);
  const auto header = isImage ? partnerOf(path, kPair[0]) : std::optional(path);
  if (!header)
    return Error::input("'" + path + "' lacks its header, a file of its name that ends in .hdr");
  // The format says so: +x is right, +y is front, +z is up.
  InputOptions upright = options;
  upright.zUp |= options.isAutomatic && !options.isUpKnown;
  auto input = VOXC_TRY(openDense(*header, "NIfTI", upright, [&](std::shared_ptr<const WatchedFile> file) {
    return readVolume(std::move(file), *header, options);
  }));
  if (isImage)
    input.files = {*header};
  return input;
}

} // namespace voxc
