// Fuzzes single pages of compressed .hvx files with right checksums, as who traces from a file reads them:
// they must be those of the whole file.
#include "Expect.h"
#include "RightChecksums.h"
#include "WordMutator.h"

#include "Volume/VolumeFile.h"
#include "voxc/Volume/PagedVolume.h"

#include <algorithm>

namespace {

using namespace voxc;
using fuzz::expect;

constexpr std::uint64_t kMostPages = 256;

/// The page as it is decoded alone; `whole` is its stream or null.
void usePage(const PagedVolume &file, std::size_t stream, std::uint64_t page, const Stream *whole) {
  const PagedStream &pages = file.streams()[stream];
  std::vector<std::byte> room(pages.bytesOf(page));
  const auto decoded = file.decode(stream, page, room);
  expect(decoded || !whole);
  if (whole)
    expect(std::ranges::equal(room, whole->bytes.subspan(page * pages.pageBytes, room.size())));
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
  return 0;
}
