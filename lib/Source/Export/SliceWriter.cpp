// Slices as PNG pictures, one for each z.
#include "Source/Export/NumberedFiles.h"
#include "Source/Export/VoxelVisit.h"
#include "Source/Export/Writers.h"

#include <png.h>

#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace voxc {

namespace {

/// What a reader takes, too.
constexpr std::int64_t kMostCells = std::int64_t{1} << 26;

Expected<std::vector<std::byte>> encode(const std::vector<std::uint32_t> &words, Int3 extent) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(extent.x);
  image.height = static_cast<png_uint_32>(extent.y);
  image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::vector<std::byte> bytes(size);
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, words.data(), 0, nullptr))
    return Error::environment(std::string("a slice cannot be encoded: ") + image.message);
  bytes.resize(size);
  return bytes;
}

/// The picture of a slice. `words` are its cells, to be used again.
Expected<std::string> sliceOf(const Volume &volume, std::int32_t z, std::vector<std::uint32_t> &words) {
  const Int3 extent = volume.info().extent;
  const auto width = static_cast<std::size_t>(extent.x);
  for (std::int32_t y = 0; y < extent.y; ++y)
    readRow(volume, {0, y, z}, std::span(words).subspan(static_cast<std::size_t>(y) * width, width));
  const auto bytes = encode(words, extent);
  if (!bytes)
    return bytes.error();
  return std::string(reinterpret_cast<const char *>(bytes->data()), bytes->size());
}

} // namespace

Expected<void> writeSlices(const Volume &volume, const std::string &path, const ExportOptions &options,
                           Exported &exported) {
  const Int3 extent = volume.info().extent;
  const auto pattern = NumberedPath::parse(path);
  if (!pattern && extent.z != 1)
    return Error::usage("'" + path + "' is one picture, but the volume has " + std::to_string(extent.z) +
                        " slices; write %04d where the number of each shall stand");
  if (std::int64_t{extent.x} * extent.y > kMostCells)
    return Error::input("a slice of " + std::to_string(extent.x) + "x" + std::to_string(extent.y) +
                        " cells is too large for a picture; it may have 2^26");
  std::optional<NumberedFiles> files;
  if (pattern)
    files.emplace(*pattern);
  std::vector<std::uint32_t> words(static_cast<std::size_t>(extent.x) * static_cast<std::size_t>(extent.y));
  for (std::int32_t z = 0; z < extent.z; ++z) {
    if (options.save.progress.stopped())
      return Error::interrupted();
    options.save.progress.at("write", static_cast<double>(z) / extent.z);
    const auto slice = sliceOf(volume, z, words);
    if (!slice)
      return slice.error();
    if (auto written = files ? files->add(*slice) : writeFile(path, *slice); !written)
      return written;
  }
  exported.files = static_cast<std::uint64_t>(extent.z);
  return files ? files->finish() : Expected<void>();
}

} // namespace voxc
