// Opening NIfTI volumes, compressed or not.
#include "Input/Openers/Openers.h"

#include "Input/Dense/DenseVolume.h"
#include "Input/Dense/GzipReader.h"
#include "Input/Dense/NiftiHeader.h"
#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace voxc {

namespace {

using File = std::shared_ptr<const WatchedFile>;

Expected<DenseVolume> volumeOf(const NiftiHeader &header) {
  DenseVolume volume;
  volume.extent = header.extent;
  volume.layout = header.layout;
  volume.slope = header.slope;
  volume.intercept = header.intercept;
  volume.sampleToModel = header.sampleToModel;
  if (header.volumes > 1)
    volume.warnings.push_back("it holds " + std::to_string(header.volumes) +
                              " volumes; the first of them is taken");
  return volume;
}

Expected<DenseVolume> readMapped(File file) {
  const std::span<const std::byte> bytes = file->bytes();
  const auto header = readNiftiHeader(bytes);
  if (!header)
    return header.error();
  const auto size = sampleBytes(header->extent, header->layout);
  if (!size)
    return size.error();
  if (header->dataOffset > bytes.size() || *size > bytes.size() - header->dataOffset)
    return Error::input("it has " + std::to_string(bytes.size()) + " bytes, but its samples take " +
                        std::to_string(*size) + " behind byte " + std::to_string(header->dataOffset));
  auto volume = volumeOf(*header);
  volume->samples = bytes.data() + header->dataOffset;
  volume->storage = std::move(file);
  return volume;
}

Expected<DenseVolume> readCompressed(const File &file, const InputOptions &options) {
  GzipReader reader(file->bytes());
  // Both versions begin with their size, and the shorter one may end before the longer would.
  std::vector<std::byte> front(348);
  if (auto read = reader.read(front); !read)
    return read.error();
  std::uint64_t begin = front.size();
  if (!readNiftiHeader(front)) {
    front.resize(NiftiHeader::kMaxBytes);
    if (auto read = reader.read(std::span(front).subspan(begin)); !read)
      return read.error();
    begin = front.size();
  }
  const auto header = readNiftiHeader(front);
  if (!header)
    return header.error();
  const auto size = sampleBytes(header->extent, header->layout);
  if (!size)
    return size.error();
  std::vector<std::byte> notes(header->dataOffset - begin);
  if (auto read = reader.read(notes); !read)
    return read.error();
  auto inflated = reader.read(*size, options.memory, options.progress);
  if (!inflated)
    return inflated.error();
  auto volume = volumeOf(*header);
  volume->samples = (*inflated)->data();
  volume->storage = std::move(*inflated);
  return volume;
}

} // namespace

Expected<Input> openNifti(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto file = WatchedFile::open(path, options.memory);
  if (!file)
    return file.error();
  auto volume = isGzip((*file)->bytes()) ? readCompressed(*file, options) : readMapped(std::move(*file));
  if (!volume && volume.error().kind == ErrorKind::Input)
    return Error::input("'" + path + "' is not a usable NIfTI file: " + volume.error().message);
  if (!volume)
    return volume.error();
  // The format says so: +x is right, +y is front, +z is up.
  InputOptions upright = options;
  upright.zUp |= options.isAutomatic && !options.isUpKnown;
  auto input = makeInput(std::move(*volume), upright);
  if (input)
    input->loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
