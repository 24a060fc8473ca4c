// Volumes in C.
#include "C/Handles.h"
#include "voxc/Volume/Attributes.h"
#include "voxc/Volume/Frames.h"

#include <algorithm>
#include <array>

using namespace voxc;
using namespace voxc::c;

namespace {

constexpr std::uint64_t kMostRead = std::uint64_t{1} << 40; ///< Voxels of a box.

/// Whether there can be a voxel at a place. A box may reach over the end of the numbers of places.
bool isPlace(const Volume &volume, const std::array<std::int64_t, 3> &place) {
  const Int3 extent = volume.info().extent;
  return place[0] >= 0 && place[0] < extent.x && place[1] >= 0 && place[1] < extent.y && place[2] >= 0 &&
         place[2] < extent.z;
}

/// Reads a row of a box: each look-up tells how far its value goes.
std::uint32_t *readRow(const Volume &volume, const std::array<std::int64_t, 3> &low, std::int32_t count,
                       std::uint32_t *words) {
  for (std::int32_t done = 0; done < count;) {
    const std::int64_t x = low[0] + done;
    const bool isInside = isPlace(volume, {x, low[1], low[2]});
    const Lookup found =
        isInside ? volume.lookup({std::int32_t(x), std::int32_t(low[1]), std::int32_t(low[2])}) : Lookup{};
    const std::int64_t side = isInside ? std::int64_t{1} << found.log2Side : 1;
    const std::int64_t run = std::min<std::int64_t>(side - (x & (side - 1)), count - done);
    words = std::fill_n(words, run, found.value);
    done += std::int32_t(run);
  }
  return words;
}

} // namespace

voxc_error *voxc_volume_load(const char *path, const voxc_load_options *options, voxc_volume **volume) {
  return guarded([&]() -> Expected<void> {
    const auto given = VOXC_TRY(optionsOf(options));
    const CallersProgress progress(given.progress);
    LoadOptions load{.trusted = given.trusted != 0, .threads = given.threads, .progress = progress.get()};
    load.frame = given.frame;
    if (given.most_cubes > 0)
      load.mostCubes = given.most_cubes;
    return handOver(Volume::load(path, load), volume);
  });
}

void voxc_volume_free(voxc_volume *volume) { delete volume; }

voxc_error *voxc_volume_save(const voxc_volume *volume, const char *path, int compress) {
  return guarded([&] { return volume->volume->save(path, {.compress = compress != 0}); });
}

uint64_t voxc_volume_digest(const voxc_volume *volume) { return volume->volume->storageDigest(); }

const char *voxc_volume_format(const voxc_volume *volume) { return volume->format.c_str(); }

const char *voxc_volume_ir(const voxc_volume *volume) { return volume->ir.c_str(); }

const char *voxc_volume_provenance(const voxc_volume *volume) {
  return volume->volume->info().provenance.c_str();
}

void voxc_volume_extent(const voxc_volume *volume, int32_t extent[3]) {
  const Int3 size = volume->volume->info().extent;
  extent[0] = size.x, extent[1] = size.y, extent[2] = size.z;
}

uint64_t voxc_volume_voxels(const voxc_volume *volume) { return volume->volume->info().voxels; }

uint64_t voxc_volume_frames(const voxc_volume *volume) {
  return std::max<std::size_t>(framesOf(*volume->volume).size(), 1);
}

uint64_t voxc_volume_bytes(const voxc_volume *volume) { return volume->volume->bytes(); }

const uint32_t *voxc_volume_words(const voxc_volume *volume, uint64_t *count) {
  const auto words = volume->volume->words();
  *count = words.size();
  return words.data();
}

const void *voxc_volume_attribute(const voxc_volume *volume, const char *name, uint32_t *element_bytes) {
  const Stream *const attribute = findAttribute(*volume->volume, name);
  if (!attribute)
    return {};
  *element_bytes = attribute->elementBytes;
  return attribute->bytes.data();
}

voxc_error *voxc_volume_with_attribute(const voxc_volume *volume, const char *name, uint32_t element_bytes,
                                       const void *elements, voxc_volume **result) {
  return guarded([&] {
    const auto *const first = static_cast<const std::byte *>(elements);
    // A size that is none is told by `withAttribute`, and nothing is read for it.
    const std::uint64_t bytes = element_bytes > 256 ? 0 : volume->volume->info().voxels * element_bytes;
    return handOver(withAttribute(volume->volume, {name, element_bytes, {first, first + bytes}}), result);
  });
}

void voxc_volume_to_model(const voxc_volume *volume, double rows[12]) {
  std::ranges::copy(rowsOf(volume->volume->info().voxelToModel), rows);
}

uint32_t voxc_volume_lookup(const voxc_volume *volume, const int32_t voxel[3]) {
  return volume->volume->lookup({voxel[0], voxel[1], voxel[2]}).value;
}

voxc_error *voxc_volume_read(const voxc_volume *volume, const int32_t low[3], const int32_t size[3],
                             uint32_t *words) {
  return guarded([&]() -> Expected<void> {
    std::uint64_t most = kMostRead;
    for (int axis = 0; axis < 3; ++axis) {
      if (size[axis] < 0 || std::uint64_t(size[axis]) > most)
        return Error::usage("a box that is read has sizes from 0 up, and at most 2^40 voxels");
      most /= std::max(size[axis], 1);
    }
    for (std::int32_t z = 0; z < size[2]; ++z)
      for (std::int32_t y = 0; y < size[1]; ++y)
        words = readRow(*volume->volume, {low[0], std::int64_t{low[1]} + y, std::int64_t{low[2]} + z},
                        size[0], words);
    return {};
  });
}
