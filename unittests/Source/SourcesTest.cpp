// Every source: what it reads and what it calls empty agree, in any order and outside its extent.
#include "SourceTesting.h"

#include "voxc/Input/Input.h"
#include "voxc/Source/Sources.h"

#include <random>

namespace voxc {
namespace {

/// Reads the cube voxel by voxel and as a whole; `empty` must not deny what is there.
void expectConsistent(VoxelSource &source, const Cube &cube) {
  std::array<std::uint32_t, 512> words;
  ASSERT_TRUE(source.read(cube, words.data()));
  bool any = false;
  for (std::uint64_t i = 0; i < std::uint64_t{1} << 3 * cube.log2Side; ++i) {
    const Int3 cell = cube.low + mortonCell(i);
    std::uint32_t word = 0;
    ASSERT_TRUE(source.read({cell, 0}, &word));
    ASSERT_EQ(word, words[i]) << cell.x << " " << cell.y << " " << cell.z;
    if (word != 0) {
      ASSERT_TRUE(contains(source.extent(), cell));
      ASSERT_FALSE(source.empty({cell, 0}));
    }
    any = any || word != 0;
  }
  for (int log2Side = cube.log2Side; any && log2Side <= 8; ++log2Side) {
    const Int3 low = (cube.low >> log2Side) * (1 << log2Side);
    ASSERT_FALSE(source.empty({low, log2Side}));
  }
}

void expectConsistent(VoxelSource &source) {
  std::mt19937 random(1);
  const Int3 extent = source.extent();
  for (int i = 0; i < 400; ++i) {
    const int log2Side = static_cast<int>(random() % 4);
    Int3 low;
    for (int axis = 0; axis < 3; ++axis)
      low[axis] = static_cast<int>(random() % static_cast<unsigned>(extent[axis] + 8)) >> log2Side
                                                                                              << log2Side;
    expectConsistent(source, {low, log2Side});
  }
}

TEST(Sources, BuiltinScenesAreConsistent) {
  for (const BuiltinScene &scene : builtinScenes())
    for (const int side : {1, 2, 7, 64, 100}) {
      SCOPED_TRACE(std::string(scene.name) + " " + std::to_string(side));
      expectConsistent(*scene.make(side));
    }
}

/// Asking in Morton order with `empty` finds no less than reading everything.
TEST(Sources, EmptyHidesNoVoxelOfBuiltinScenes) {
  for (const BuiltinScene &scene : builtinScenes()) {
    SCOPED_TRACE(scene.name);
    constexpr int kSide = 72;
    const auto source = scene.make(kSide);
    std::size_t count = 0;
    for (std::uint64_t block = 0; block < 4096; ++block) {
      std::array<std::uint32_t, 512> words;
      ASSERT_TRUE(source->read({mortonCell(block) * 8, 3}, words.data()));
      count += 512 - static_cast<std::size_t>(std::count(words.begin(), words.end(), 0u));
    }
    EXPECT_EQ(voxelsOf(*source).size(), count);
  }
}

TEST(Sources, SimpleScenesHaveTheirVoxels) {
  const auto count = [](const char *name, int side) {
    return voxelsOf(**makeBuiltinSource(name, side)).size();
  };
  EXPECT_EQ(count("full", 9), 729u);
  EXPECT_EQ(count("empty", 9), 0u);
  EXPECT_EQ(count("voxel", 9), 1u);
  EXPECT_EQ(count("corners", 9), 8u);
  EXPECT_EQ(count("corners", 1), 1u);
  EXPECT_EQ(count("checker", 4), 32u);
  EXPECT_EQ(count("menger", 27), 8000u);
}

TEST(Sources, ShellIsOneVoxelThickAndTouchesTheFaces) {
  const auto source = *makeBuiltinSource("shell", 32);
  std::vector<std::uint64_t> row;
  for (const auto &[code, word] : voxelsOf(*source))
    if (const Int3 cell = mortonCell(code); cell.y == 16 && cell.z == 16)
      row.push_back(static_cast<std::uint64_t>(cell.x));
  EXPECT_EQ(row, (std::vector<std::uint64_t>{0, 31}));
}

TEST(Sources, UnknownSceneNamesTheKnownOnes) {
  const auto source = makeBuiltinSource("terain", 8);
  ASSERT_FALSE(source);
  EXPECT_NE(source.error().message.find("terrain"), std::string::npos);
  EXPECT_FALSE(makeBuiltinSource("full", 0));
  EXPECT_FALSE(makeBuiltinSource("full", (1 << 21) + 1));
}

TEST(Sources, HugeScenesAnswerAtOnce) {
  for (const BuiltinScene &scene : builtinScenes()) {
    const auto source = scene.make(1 << 21);
    EXPECT_FALSE(scene.name != "empty" && source->empty({{}, 21})) << scene.name;
    std::uint32_t word = 0;
    EXPECT_TRUE(source->read({{1 << 20, 1 << 20, (1 << 21) - 1}, 0}, &word));
  }
}

TEST(Sources, GridIsConsistentAndComplete) {
  std::mt19937 random(2);
  const Int3 extent{37, 5, 70};
  std::vector<std::uint32_t> words(37 * 5 * 70);
  for (int i = 0; i < 40; ++i)
    words[random() % words.size()] = static_cast<std::uint32_t>(random()) | 1;
  const auto source = makeGridSource(extent, words);
  expectConsistent(*source);
  const Voxels voxels = voxelsOf(*source);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto n = static_cast<int>(i);
    const auto found = voxels.find(mortonCode({n % 37, n / 37 % 5, n / 37 / 5}));
    EXPECT_EQ(found == voxels.end() ? 0 : found->second, words[i]);
  }
}

TEST(Sources, GridFindsAVoxelInItsFarCorner) {
  for (const Int3 extent : {Int3{70, 1, 1}, Int3{1, 65, 2}, Int3{9, 9, 9}, Int3{1, 1, 1}}) {
    std::vector<std::uint32_t> words(static_cast<std::size_t>(extent.x * extent.y * extent.z));
    words.back() = 5;
    const auto source = makeGridSource(extent, words);
    EXPECT_EQ(voxelsOf(*source), (Voxels{{mortonCode(extent - Int3{1, 1, 1}), 5}}));
    EXPECT_FALSE(source->empty({{}, 10}));
  }
}

TEST(Sources, SortedVoxelsComeBackInAnyOrder) {
  std::mt19937 random(3);
  Voxels voxels;
  for (int i = 0; i < 500; ++i)
    voxels[random() % (std::uint64_t{1} << 18)] = static_cast<std::uint32_t>(random()) | 1;
  std::vector<CodedVoxel> list;
  for (const auto &[code, word] : voxels)
    list.push_back({code, word});
  const auto source = makeSortedSource({64, 64, 64}, list);
  EXPECT_EQ(voxelsOf(*source), voxels);
  expectConsistent(*source);
  EXPECT_EQ(voxelsOf(*source), voxels);
}

TEST(Sources, VolumeIsConvertedVoxelByVoxel) {
  const auto format = parseFormat("R(2, 2, 2) R(1, 1, 1)");
  ASSERT_TRUE(format);
  // Word 0: the root at 9; one cell of 2 x 2 x 2 voxels at 1, which the root's cell (1, 0, 0) points to.
  std::vector<std::uint32_t> words{9, 0, 7, 0, 0, 0, 0, 0, 8};
  words.resize(9 + 64);
  words[9 + 1] = 1;
  VolumeInfo info;
  info.format = *format;
  info.extent = {8, 8, 8};
  const auto source = makeVolumeSource(std::make_shared<const Volume>(info, words));
  EXPECT_EQ(voxelsOf(*source), (Voxels{{mortonCode({3, 0, 0}), 7}, {mortonCode({3, 1, 1}), 8}}));
  EXPECT_TRUE(source->empty({{4, 4, 4}, 1}));
  expectConsistent(*source);
}

} // namespace
} // namespace voxc
