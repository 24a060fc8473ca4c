// Opening NumPy arrays, alone (.npy) or several in an archive (.npz).
#include "Input/Openers/Openers.h"

#include "Input/Dense/ByteStream.h"
#include "Input/Dense/NpyHeader.h"
#include "Input/Dense/VolumeChoice.h"
#include "Input/Dense/ZipFile.h"
#include "Input/Openers/OpenDense.h"
#include "Support/Text.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace voxc {

namespace {

using Cells = ScratchArray<std::byte>;

std::string shapeText(const NpyHeader &header) {
  std::string text = "(";
  for (std::size_t i = 0; i < header.shape.size(); ++i)
    text += (i == 0 ? "" : ", ") + std::to_string(header.shape[i]);
  return text + ")";
}

/// The axes of an array: z, y, x of a volume, before them volumes, behind them the channels of colours.
Expected<DenseVolume> volumeOf(const NpyHeader &header, const InputOptions &options, std::uint64_t &bytes,
                               std::int64_t &offset) {
  const std::size_t count = header.shape.size();
  std::vector<std::int64_t> steps(count);
  auto step = static_cast<std::int64_t>(byteSize(header.layout.type));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t axis = header.isFortran ? i : count - 1 - i;
    const std::uint64_t size = header.shape[axis];
    if (size == 0 || size > (std::uint64_t{1} << 60) / static_cast<std::uint64_t>(step))
      return Error::input("its shape " + shapeText(header) + " has no value, or more than any file");
    steps[axis] = step;
    step *= static_cast<std::int64_t>(size);
  }
  bytes = static_cast<std::uint64_t>(step);
  DenseVolume volume;
  volume.layout = header.layout;
  std::size_t end = count;
  const bool hasChannels = count >= 4 && (header.shape.back() == 3 || header.shape.back() == 4) &&
                           header.layout.type == SampleType::Uint8 && options.volume == 0;
  if (hasChannels) {
    volume.channels = static_cast<int>(header.shape[--end]);
    volume.channelStep = steps[end];
  }
  volume.extent = {1, 1, 1};
  volume.steps = {step, step, step};
  for (int axis = 0; axis < 3 && end > 0; ++axis) {
    volume.extent[axis] =
        static_cast<std::int32_t>(std::min<std::uint64_t>(header.shape[--end], (1 << kMaxLog2Extent) + 1));
    volume.steps[static_cast<std::size_t>(axis)] = steps[end];
  }
  std::uint64_t volumes = 1;
  for (std::size_t axis = 0; axis < end; ++axis)
    volumes *= header.shape[axis];
  auto number = VOXC_TRY(chooseVolume(volumes, options, volume.warnings));
  offset = 0;
  while (end-- > 0) {
    offset += static_cast<std::int64_t>(number % header.shape[end]) * steps[end];
    number /= header.shape[end];
  }
  VOXC_TRY(sampleBytes(volume.extent, volume.layout));
  return volume;
}

Expected<DenseVolume> readArray(std::span<const std::byte> whole, std::unique_ptr<ByteStream> stream,
                                std::shared_ptr<const WatchedFile> file, const InputOptions &options) {
  // The front of what is packed is read twice.
  std::vector<std::byte> front(kMostNpyHeader);
  auto count = VOXC_TRY(stream->readSome(front));
  const auto header = VOXC_TRY(readNpyHeader(std::span(front).first(count)));
  std::uint64_t bytes = 0;
  std::int64_t offset = 0;
  auto volume = VOXC_TRY(volumeOf(header, options, bytes, offset));
  if (!whole.empty()) {
    if (header.dataOffset > whole.size() || bytes > whole.size() - header.dataOffset)
      return Error::input("its array of shape " + shapeText(header) + " takes " + std::to_string(bytes) +
                          " bytes, but there are " + std::to_string(whole.size() - header.dataOffset));
    if (const std::uint64_t behind = whole.size() - header.dataOffset - bytes; behind != 0)
      volume.warnings.push_back(countedAre(behind, "byte") + " left out, which lie behind the array");
    volume.samples = whole.data() + header.dataOffset + offset;
    volume.storage = std::move(file);
    return volume;
  }
  Cells cells(options.memory);
  const std::uint64_t here = std::min<std::uint64_t>(count - header.dataOffset, bytes);
  VOXC_TRY(cells.append(std::span(std::as_const(front)).subspan(header.dataOffset, here)));
  VOXC_TRY(appendBytes(*stream, bytes - here, cells, *options.memory, options.progress));
  const bool hasMore = count - header.dataOffset > bytes;
  for (std::string &sentence :
       hasMore ? std::vector<std::string>{"more is packed behind the array, and is left out"}
               : saysBehind(*stream))
    volume.warnings.push_back(std::move(sentence));
  volume.samples = cells.data() + offset;
  volume.storage = std::make_shared<const Cells>(std::move(cells));
  return volume;
}

/// The name of an array, by which `--grid` takes it.
std::string nameOf(const ZippedFile &file) {
  return file.name.substr(0, file.name.size() - (file.name.ends_with(".npy") ? 4 : 0));
}

/// Which array of an archive is taken: that of `--grid`, else the first of three axes or more.
Expected<std::size_t> choose(const std::vector<ZippedFile> &files, const InputOptions &options,
                             std::vector<std::string> &warnings) {
  std::optional<std::size_t> chosen;
  std::string others;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string name = nameOf(files[i]);
    std::vector<std::byte> front(kMostNpyHeader);
    const auto count = files[i].open()->readSome(front);
    const auto header =
        count ? readNpyHeader(std::span(front).first(*count)) : Expected<NpyHeader>(count.error());
    const bool isVolume = header && header->shape.size() >= 3;
    if (!chosen && (options.grid.empty() ? isVolume : name == options.grid))
      chosen = i;
    else
      others += (others.empty() ? "" : ", ") + name + (header ? " " + shapeText(*header) : "");
  }
  if (!chosen)
    return Error::input((options.grid.empty() ? std::string("it has no array of three axes")
                                              : "it has no array '" + options.grid + "'") +
                        (others.empty() ? "" : "; there are " + others));
  if (options.grid.empty() && !others.empty())
    warnings.push_back("the array '" + nameOf(files[*chosen]) + "' is taken, and left out are " +
                       others.substr(0, 400) + " (--grid NAME takes one of them)");
  return *chosen;
}

/// One array of an archive.
Expected<DenseVolume> readArchive(std::shared_ptr<const WatchedFile> file, const InputOptions &options) {
  const std::span<const std::byte> bytes = file->bytes();
  const auto files = VOXC_TRY(listZip(bytes));
  std::vector<std::string> warnings;
  const auto chosen = VOXC_TRY(choose(files, options, warnings));
  const ZippedFile &array = files[chosen];
  auto volume = readArray(array.isDeflated ? std::span<const std::byte>() : array.stored, array.open(),
                          std::move(file), options);
  if (volume)
    volume->warnings.insert(volume->warnings.begin(), warnings.begin(), warnings.end());
  return volume;
}

} // namespace

Expected<Input> openNumpy(const std::string &path, const InputOptions &options) {
  return openDense(path, "NumPy", options, [&](std::shared_ptr<const WatchedFile> file) {
    if (lowerCase(path).ends_with(".npz"))
      return readArchive(std::move(file), options);
    const std::span<const std::byte> bytes = file->bytes();
    return readArray(bytes, makeRawStream(bytes), std::move(file), options);
  });
}

} // namespace voxc
