// Building volumes in C.
#include "C/BuildOptions.h"
#include "C/CallersInput.h"
#include "C/FormatHandle.h"
#include "Source/GridExtent.h"
#include "voxc/IR/Attribute.h"
#include "voxc/Source/Sources.h"

#include <algorithm>
#include <limits>

using namespace voxc;
using namespace voxc::c;

namespace {

/// Builds an opened source; `provenance` is what the input says of itself.
Expected<void> build(const voxc_format *format, VoxelSource &source, const voxc_build_options &given,
                     std::shared_ptr<WorkingMemory> memory, const Progress &progress,
                     const std::string &provenance, voxc_volume **volume) {
  const auto constructor = VOXC_TRY(Constructor::compile(format->format));
  BuildOptions options = buildOptionsOf(given, progress);
  options.provenance = textOr(given.provenance, provenance.c_str());
  options.memory = std::move(memory);
  auto built = VOXC_TRY(constructor.build(source, options));
  *volume = new voxc_volume(std::move(built.volume));
  return {};
}

Expected<void> build(const voxc_format *format, VoxelSource &source, const voxc_build_options *options,
                     voxc_volume **volume) {
  const auto given = VOXC_TRY(optionsOf(options));
  const CallersProgress progress(given.progress);
  return build(format, source, given, memoryOf(given), progress.get(), "", volume);
}

/// As far as a list of places reaches; of the last place that there is, one cell less, too far in any case.
Int3 extentOf(const std::int32_t *places, std::uint64_t count) {
  const auto behind = [](std::int32_t place) {
    return std::min(place, std::numeric_limits<std::int32_t>::max() - 1) + 1;
  };
  Int3 extent{1, 1, 1};
  for (const std::int32_t *place = places; place != places + 3 * count; place += 3)
    extent = {std::max(extent.x, behind(place[0])), std::max(extent.y, behind(place[1])),
              std::max(extent.z, behind(place[2]))};
  return extent;
}

/// Sorts a list of voxels; of several at one place the last counts.
Expected<std::vector<CodedVoxel>> sorted(const std::int32_t *places, const std::uint32_t *words,
                                         std::uint64_t count, Int3 extent) {
  std::vector<CodedVoxel> voxels;
  voxels.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const Int3 place{places[3 * i], places[3 * i + 1], places[3 * i + 2]};
    if (place.x < 0 || place.y < 0 || place.z < 0 || place.x >= extent.x || place.y >= extent.y ||
        place.z >= extent.z)
      return Error::input("voxel " + std::to_string(i) + " lies at " + std::to_string(place.x) + ", " +
                          std::to_string(place.y) + ", " + std::to_string(place.z) +
                          ", outside of an extent of " + extentText(extent));
    voxels.push_back({mortonCode(place), words[i]});
  }
  std::ranges::stable_sort(voxels, {}, &CodedVoxel::code);
  const auto last = std::unique(voxels.rbegin(), voxels.rend(),
                                [](const CodedVoxel &a, const CodedVoxel &b) { return a.code == b.code; });
  voxels.erase(voxels.begin(), last.base());
  std::erase_if(voxels, [](const CodedVoxel &voxel) { return voxel.word == 0; });
  return voxels;
}

} // namespace

voxc_error *voxc_build_grid(const voxc_format *format, const uint32_t *words, const int32_t extent[3],
                            const voxc_build_options *options, voxc_volume **volume) {
  return guarded([&]() -> Expected<void> {
    const Int3 size{extent[0], extent[1], extent[2]};
    VOXC_TRY(checkGridExtent(size));
    const std::uint64_t count = std::uint64_t(size.x) * size.y * size.z;
    return build(format, *makeGridSource(size, {words, words + count}), options, volume);
  });
}

voxc_error *voxc_build_voxels(const voxc_format *format, const int32_t *places, const uint32_t *words,
                              uint64_t count, const int32_t *extent, const voxc_build_options *options,
                              voxc_volume **volume) {
  return guarded([&]() -> Expected<void> {
    const Int3 size = extent ? Int3{extent[0], extent[1], extent[2]} : extentOf(places, count);
    VOXC_TRY(checkGridExtent(size));
    auto voxels = VOXC_TRY(sorted(places, words, count, size));
    return build(format, *makeSortedSource(size, std::move(voxels)), options, volume);
  });
}

voxc_error *voxc_build_source(const voxc_format *format, const voxc_source *source,
                              const voxc_build_options *options, voxc_volume **volume) {
  return guarded([&]() -> Expected<void> {
    const voxc_source given = *source;
    const Int3 size{given.extent[0], given.extent[1], given.extent[2]};
    VOXC_TRY(checkGridExtent(size));
    std::function<bool(const Cube &)> empty;
    if (given.is_empty)
      empty = [given](const Cube &cube) {
        return given.is_empty(given.user, cube.low.x, cube.low.y, cube.low.z, std::int32_t(cube.side())) != 0;
      };
    const auto voxel = [given](Int3 cell) { return given.voxel(given.user, cell.x, cell.y, cell.z); };
    return build(format, *makeFunctionSource(size, voxel, empty), options, volume);
  });
}

voxc_error *voxc_build_input(const voxc_format *format, const char *input,
                             const voxc_input_options *input_options, const voxc_build_options *options,
                             voxc_volume **volume) {
  return guarded([&]() -> Expected<void> {
    const auto given = VOXC_TRY(optionsOf(options));
    const auto read = VOXC_TRY(optionsOf(input_options));
    const CallersProgress progress(given.progress);
    auto asked = VOXC_TRY(CallersInput::of(input, read));
    if (hasLabels(format->format) && asked.arguments().colourMap.empty())
      asked.arguments().colourMap = "labels";
    const auto memory = memoryOf(given);
    auto opened = VOXC_TRY(asked.open(format->format.extent(), given.threads, memory, progress.get()));
    VOXC_TRY(build(format, *opened.source, given, memory, progress.get(), opened.provenance, volume));
    if ((*volume)->volume->info().voxels == 0)
      asked.warn("the volume is empty: the input has no voxel" +
                 std::string(read.bounds ? " within --bounds" : ""));
    return {};
  });
}
