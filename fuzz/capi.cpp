// Fuzzes volumes in C: a file with right checksums is loaded, asked for all that it has, changed, saved and
// loaded again. The first twelve bytes are where voxels are read.
#include "Expect.h"
#include "FuzzedFile.h"
#include "RightChecksums.h"
#include "WordMutator.h"

#include <voxc-c/runtime.h>

#include <algorithm>
#include <array>

namespace {

using voxc::fuzz::expect;
using Place = std::array<std::int32_t, 3>;

constexpr Place kSize = {9, 3, 2};
constexpr std::uint64_t kMostVoxels = 1 << 16;

/// Whether a call did what it should; its error has words.
bool succeeds(voxc_error *error) {
  if (!error)
    return true;
  expect(voxc_error_message(error)[0] != '\0' && voxc_error_get_kind(error) != 0);
  voxc_error_free(error);
  return false;
}

voxc_volume *load(const std::string &path) {
  voxc_load_options options = VOXC_LOAD_OPTIONS;
  options.threads = 1;
  options.most_cubes = 1 << 16;
  voxc_volume *volume = nullptr;
  const bool isLoaded = succeeds(voxc_volume_load(path.c_str(), &options, &volume));
  expect(isLoaded == (volume != nullptr));
  return volume;
}

/// A box holds what its voxels are, one by one.
void readBox(const voxc_volume *volume, const Place &low) {
  std::array<std::uint32_t, 9 * 3 * 2> words;
  expect(succeeds(voxc_volume_read(volume, low.data(), kSize.data(), words.data())));
  Place extent;
  voxc_volume_extent(volume, extent.data());
  for (std::int32_t i = 0; i < std::int32_t(words.size()); ++i) {
    const std::array<std::int64_t, 3> at = {std::int64_t{low[0]} + i % kSize[0],
                                            std::int64_t{low[1]} + i / kSize[0] % kSize[1],
                                            std::int64_t{low[2]} + i / kSize[0] / kSize[1]};
    bool isInside = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      isInside &= at[axis] >= 0 && at[axis] < extent[axis];
    const Place voxel = {std::int32_t(at[0]), std::int32_t(at[1]), std::int32_t(at[2])};
    expect(words[std::size_t(i)] == (isInside ? voxc_volume_lookup(volume, voxel.data()) : 0));
  }
}

void changeAndSave(const voxc_volume *volume, const std::string &path) {
  const std::uint64_t voxels = voxc_volume_voxels(volume);
  if (voxels > kMostVoxels)
    return;
  const std::vector<std::byte> elements(2 * voxels);
  voxc_volume *changed = nullptr;
  if (!succeeds(voxc_volume_with_attribute(volume, "added", 2, elements.data(), &changed)))
    return;
  expect(succeeds(voxc_volume_save(changed, path.c_str(), voxels % 2 == 0)));
  voxc_volume *const again = load(path);
  std::uint32_t bytes = 0;
  std::uint64_t count = 0, sameCount = 0;
  expect(again && voxc_volume_attribute(again, "added", &bytes) && bytes == 2);
  const std::uint32_t *const words = voxc_volume_words(volume, &count);
  const std::uint32_t *const same = voxc_volume_words(again, &sameCount);
  expect(std::equal(words, words + count, same, same + sameCount));
  voxc_volume_free(again);
  voxc_volume_free(changed);
}

void use(const voxc_volume *volume, const Place &low, const std::string &path) {
  std::array<double, 12> rows;
  voxc_volume_to_model(volume, rows.data());
  expect(voxc_volume_format(volume)[0] != '\0' && voxc_volume_provenance(volume) &&
         voxc_volume_bytes(volume) >= 4);
  std::uint32_t bytes = 0;
  expect(!voxc_volume_attribute(volume, "words", &bytes));
  readBox(volume, low);
  Place middle;
  voxc_volume_extent(volume, middle.data());
  for (std::int32_t &x : middle)
    x = std::max(x / 2 - 4, 0);
  readBox(volume, middle);
  changeAndSave(volume, path);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  Place low;
  if (size < sizeof low)
    return 0;
  std::memcpy(low.data(), data, sizeof low);
  const std::vector<std::byte> bytes = voxc::fuzz::withRightChecksums(data + sizeof low, size - sizeof low);
  const std::string path =
      voxc::fuzz::folder().write("a.hvx", {reinterpret_cast<const char *>(bytes.data()), bytes.size()});
  if (voxc_volume *const volume = load(path)) {
    use(volume, low, voxc::fuzz::folder().write("b.hvx", ""));
    voxc_volume_free(volume);
  }
  return 0;
}
