// Fuzzes single pages of compressed .hvx files with right checksums, as who traces from a file reads them:
// they must be those of the whole file, and shapes read by pages must be those of the volume. Where the words
// lead nowhere shapes mean nothing, but are told.
#include "Expect.h"
#include "RightChecksums.h"
#include "WordMutator.h"

#include "Volume/VolumeFile.h"
#include "voxc/Volume/PagedVolume.h"
#include "voxc/Volume/ShapeReader.h"

#include <algorithm>

namespace {

using namespace voxc;
using fuzz::expect;

constexpr std::uint64_t kMostPages = 256;
constexpr std::uint64_t kShelfBytes = 64 * 4096;
constexpr int kLooks = 7; ///< On each axis.

/// The page as it is decoded alone; `whole` is its stream or null.
void usePage(const PagedVolume &file, std::size_t stream, std::uint64_t page, const Stream *whole) {
  const PagedStream &pages = file.streams()[stream];
  std::vector<std::byte> room(pages.bytesOf(page));
  const auto decoded = file.decode(stream, page, room);
  expect(decoded || !whole);
  if (whole)
    expect(std::ranges::equal(room, whole->bytes.subspan(page * pages.pageBytes, room.size())));
}

/// `sound`: the volume, if its words were proved, or null.
void useShapes(const PagedVolume &file, const Volume *sound) {
  const ShapeReader shapes(file, std::make_shared<PageShelf>(kShelfBytes));
  const Int3 extent = file.info().format.extent();
  for (int i = 0; i < kLooks * kLooks * kLooks; ++i) {
    const Int3 step = {i % kLooks, i / kLooks % kLooks, i / (kLooks * kLooks)};
    const auto along = [&](int axis) {
      return static_cast<int>(std::int64_t{extent[axis]} * step[axis] / (kLooks - 1));
    };
    const Int3 voxel = {along(0), along(1), along(2)};
    const ShapeCube cube = shapes.at(voxel);
    if (sound)
      expect(cube.isFull == (sound->lookup(voxel).value != 0));
  }
  expect(!sound || !shapes.problem());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::vector<std::byte> bytes = fuzz::withRightChecksums(data, size);
  const auto file = PagedVolume::read(bytes, nullptr, "a.hvx");
  if (!file)
    return 0;
  const auto volume = readVolumeFile(bytes, nullptr, "a.hvx", {.trusted = true});
  expect(!volume || volume->streams().size() == file->streams().size());
  for (std::size_t stream = 0; stream < file->streams().size(); ++stream) {
    const std::uint64_t pages = file->streams()[stream].pages();
    for (std::uint64_t page = 0; page < std::min(pages, kMostPages); ++page)
      usePage(*file, stream, page, volume ? &volume->streams()[stream] : nullptr);
    std::vector<std::byte> none;
    expect(!file->decode(stream, pages, none));
  }
  const auto sound = readVolumeFile(bytes, nullptr, "a.hvx", {});
  useShapes(*file, sound ? &*sound : nullptr);
  return 0;
}
