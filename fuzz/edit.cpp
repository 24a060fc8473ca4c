// Fuzzes what an edit does with a volume that was found sound: cubes that stay are taken out of it and joined
// again, and cubes that change are read with the edits on top. The file has right checksums. How many voxels
// a cube has is not asked: of words that two levels share as no build does it, the proof of the whole finds
// that.
#include "Expect.h"
#include "RightChecksums.h"
#include "WordMutator.h"

#include "Construct/Nodes/WordStore.h"
#include "Construct/Parts/Extraction.h"
#include "Construct/Parts/PartBuilder.h"
#include "Source/CubeTools.h"
#include "Volume/VolumeFile.h"
#include "voxc/Source/Edit.h"
#include "voxc/Source/Sources.h"

#include <algorithm>
#include <array>
#include <memory>

namespace {

using namespace voxc;
using fuzz::expect;

constexpr int kLog2Part = 5;
constexpr int kMostParts = 12;

void readVoxels(VoxelSource &source, const Cube &cube) {
  static volatile std::uint32_t sink = 0;
  std::array<std::uint32_t, 512> words;
  const int log2Brick = std::min(cube.log2Side, 3);
  for (std::uint64_t i = 0; i < cellCount(cube.log2Side - log2Brick); ++i) {
    expect(static_cast<bool>(
        source.read({cube.low + mortonCell(i) * (1 << log2Brick), log2Brick}, words.data())));
    sink = sink ^ words[i % cellCount(log2Brick)];
  }
}

/// Fills the middle, clears a corner, and pastes the volume into itself.
std::unique_ptr<VoxelSource> edited(const std::shared_ptr<const Volume> &volume) {
  const Int3 extent = volume->info().extent;
  const Int3 half = extent >> 1;
  auto source = makeEditedSource(
      volume, {{half >> 1, half, 0xff102030, nullptr}, {{}, half, 0, nullptr}, {{}, extent, 0, volume}});
  expect(static_cast<bool>(source));
  return std::move(*source);
}

/// What an edit may hand on as one part; larger ones are left out for time.
bool isSmall(const Cube &cube) { return cube.log2Side <= kLog2Part + 1; }

void takeApart(const std::shared_ptr<const Volume> &volume) {
  const Layout &layout = volume->layout();
  const auto memory = WorkingMemory::create(std::uint64_t{64} << 20);
  auto words = WordStore::create(memory);
  expect(static_cast<bool>(words));
  NodeStore store(std::move(*words), layout, memory);
  Splice splice(layout, store);
  Extraction extraction(volume->words(), layout);
  const auto source = makeVolumeSource(volume);
  const auto after = edited(volume);
  const PartGrid grid = PartGrid::of(volume->info().extent, layout, kLog2Part);
  PartSequence parts(grid, 0, grid.count(), [&](const Cube &cube) { return source->empty(cube); });
  int left = kMostParts;
  while (const auto cube = parts.next()) {
    if (left-- == 0 || !isSmall(*cube))
      return;
    Fragment fragment = extraction.cube(cube->low, cube->log2Side);
    readVoxels(*after, *cube);
    if (!store.failure())
      splice.join(fragment);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::vector<std::byte> bytes = fuzz::withRightChecksums(data, size);
  if (auto volume = readVolumeFile(bytes, nullptr, "a.hvx"))
    takeApart(std::make_shared<const Volume>(std::move(*volume)));
  return 0;
}
