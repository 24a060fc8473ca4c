// Fuzzes the attributes of .hvx files with right checksums: each that is found has an element for each voxel,
// voxels have numbers of their own, and attributes that are added and dropped leave the others as they are.
#include "Expect.h"
#include "RightChecksums.h"
#include "WordMutator.h"

#include "Volume/VolumeFile.h"
#include "voxc/Volume/Attributes.h"

#include <algorithm>
#include <memory>

namespace {

using namespace voxc;
using fuzz::expect;

constexpr std::uint64_t kMostVoxels = 1 << 16;

/// Every voxel that is visited has the next number, or where levels count voxels one of its own.
void useNumbers(const Volume &volume, const Stream &attribute) {
  static volatile std::uint8_t sink = 0;
  std::uint64_t left = kMostVoxels;
  const auto visit = [&](Int3 voxel, std::uint64_t number) {
    expect(number < volume.info().voxels && number < attribute.elements());
    expect(volume.lookup(voxel).value != 0);
    sink = sink ^ std::to_integer<std::uint8_t>(attribute.bytes[number * attribute.elementBytes]);
    return --left > 0;
  };
  expect(visitVoxels(volume, visit) || left == 0);
}

bool hasSameStream(const Volume &volume, const Stream &stream) {
  const Stream *const same = volume.findStream(stream.name);
  return same && same->elementBytes == stream.elementBytes && std::ranges::equal(same->bytes, stream.bytes);
}

void addAndDrop(const std::shared_ptr<const Volume> &volume) {
  auto elements = zeroElements(*volume, 3, kMostVoxels);
  if (!elements)
    return;
  auto added = withAttribute(volume, {"added", 3, std::move(*elements)});
  expect(added || volume->streams().size() == 64);
  if (!added)
    return;
  const auto larger = std::make_shared<const Volume>(std::move(*added));
  for (const Stream &stream : volume->streams())
    expect(stream.name == "added" || hasSameStream(*larger, stream));
  const auto dropped = withoutAttribute(larger, "added");
  expect(dropped && !dropped->findStream("added"));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::vector<std::byte> bytes = fuzz::withRightChecksums(data, size);
  auto read = readVolumeFile(bytes, nullptr, "a.hvx");
  if (!read)
    return 0;
  const auto volume = std::make_shared<const Volume>(std::move(*read));
  for (const Stream &stream : volume->streams())
    if (const Stream *const attribute = findAttribute(*volume, stream.name))
      useNumbers(*volume, *attribute);
  addAndDrop(volume);
  return 0;
}
