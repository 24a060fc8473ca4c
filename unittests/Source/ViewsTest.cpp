// Views of sources: other readers of the same voxels, in other threads and in any order.
#include "SourceTesting.h"

#include "Source/BinnedVoxels.h"
#include "Source/ClippedSource.h"
#include "TestLength.h"

#include "voxc/Input/Input.h"
#include "voxc/Source/Sources.h"

#include <random>
#include <thread>

namespace voxc {
namespace {

/// Four views read at once what the source reads alone; the views may outlive it.
void expectViews(std::unique_ptr<VoxelSource> source) {
  const Voxels expected = voxelsOf(*source);
  std::vector<std::unique_ptr<VoxelSource>> views;
  for (int i = 0; i < 4; ++i) {
    views.push_back(source->view());
    ASSERT_TRUE(views.back());
    EXPECT_EQ(views.back()->extent(), source->extent());
    EXPECT_EQ(views.back()->voxelToModel(), source->voxelToModel());
  }
  source.reset();
  std::array<Voxels, 4> found;
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < 4; ++i)
    threads.emplace_back([&, i] { found[i] = voxelsOf(*views[i]); });
  for (std::thread &thread : threads)
    thread.join();
  for (const Voxels &voxels : found)
    EXPECT_EQ(voxels, expected);
}

TEST(Views, OfBuiltinScenes) {
  for (const BuiltinScene &scene : builtinScenes()) {
    SCOPED_TRACE(scene.name);
    expectViews(scene.make(40));
    expectViews(clip(scene.make(40), {17, 40, 40}));
  }
}

TEST(Views, OfFilesAndLists) {
  const TemporaryFolder folder;
  std::mt19937 random(9);
  std::string bytes(20 * 30 * 40 * 4, '\0');
  for (int i = 0; i < 500; ++i)
    bytes[random() % bytes.size()] = static_cast<char>(random() % 4);
  const std::string grid = folder.file("g.raw", bytes);
  std::string points = "ply\nformat ascii 1.0\nelement vertex 300\nproperty int x\nproperty int y\n"
                       "property int z\nend_header\n";
  for (int i = 0; i < 900; ++i)
    points += std::to_string(random() % 200) + " ";
  for (const std::string &name :
       {"grid:20x30x40:" + grid, "raw:20x30x40:uint32le:" + grid, folder.file("p.ply", points)}) {
    SCOPED_TRACE(name);
    auto input = openInput(name, {});
    ASSERT_TRUE(input) << input.error().message;
    expectViews(std::move(input->source));
  }
  VolumeInfo info;
  info.format = *parseFormat("R(1, 0, 0)");
  info.extent = {2, 1, 1};
  info.voxels = 1;
  expectViews(makeVolumeSource(std::make_shared<const Volume>(info, std::vector<std::uint32_t>{1, 0, 7})));
  expectViews(makeSortedSource({9, 9, 9}, {{3, 1}, {500, 2}}));
}

/// Any voxels, in an extent of any size: what a map says comes back, the first of several in one place.
TEST(BinnedVoxels, ComeBackWithinAnyExtentAndBound) {
  std::mt19937 random(4);
  for (int round = 0; round < test::rounds(12); ++round) {
    const std::array<int, 4> sides{3, 100, 8300, 1 << 21};
    const int side = sides[static_cast<std::size_t>(round % 4)];
    // A bound of nothing puts all into the scratch file.
    const auto memory = WorkingMemory::create(round % 2 == 0 ? 0 : 1 << 26);
    std::vector<std::pair<Int3, std::uint32_t>> list;
    Voxels expected;
    Int3 cell;
    for (std::uint32_t i = 1; i <= 3000; ++i) {
      // Often near the last one, or in the same place.
      for (int axis = 0; axis < 3; ++axis) {
        const int near = cell[axis] + static_cast<int>(random() % 7) - 3;
        cell[axis] =
            std::clamp(random() % 50 == 0 ? static_cast<int>(random() % static_cast<unsigned>(side)) : near,
                       0, side - 1);
      }
      list.emplace_back(cell, i);
      expected.try_emplace(mortonCode(cell), i);
    }
    auto voxels = BinnedVoxels::create({side, side, side}, memory);
    ASSERT_TRUE(voxels) << voxels.error().message;
    for (const auto &[at, word] : list)
      voxels->count(at);
    ASSERT_TRUE(voxels->allocate());
    for (const auto &[at, word] : list)
      voxels->place(at, word);
    const auto source = std::move(*voxels).finish();
    EXPECT_EQ(voxelsOf(*source), expected) << side;
    expectViews(source->view());
  }
}

} // namespace
} // namespace voxc
