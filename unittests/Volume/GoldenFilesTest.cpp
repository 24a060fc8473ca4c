// Files that earlier versions of voxc have written stay readable: Golden/v1 holds some of version 1, each
// made by
//
//   voxc build FORMAT builtin:SCENE PASSES -o NAME.hvx
//
// of commit d909103, with the formats, scenes and passes of the table below.
#include "VolumeTesting.h"

#include "voxc/Input/Input.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace voxc {
namespace {

struct GoldenFile {
  const char *name;
  const char *format; ///< As IR: the passes are its attributes.
  const char *scene;
  Int3 extent;
  std::uint64_t voxels;
  std::size_t words;
  Int3 someVoxel;
  Lookup found; ///< What lies there.
};

constexpr GoldenFile kFiles[] = {
    {"dag",
     "format { level 1: raw(1^3) level 2: svdag(3) dedup=level }",
     "menger:9",
     {9, 9, 9},
     400,
     278,
     {2, 0, 0},
     {0xff60aace, 0}},
    {"empty", "format { level 1: svdag(3) }", "empty", {8, 8, 8}, 0, 1, {4, 4, 4}, {0, 3}},
    {"grids",
     "format { level 1: raw(1, 0, 2) level 2: distance(1^3, 3) share=level }",
     "terrain",
     {4, 2, 8},
     45,
     137,
     {0, 0, 4},
     {0xff385270, 0}},
    {"mixed",
     "format { level 1: distance(1^3, 6) level 2: svdag(1) level 3: svo(1) }",
     "shell",
     {8, 8, 8},
     144,
     505,
     {3, 2, 0},
     {0xff407088, 0}},
    {"octree",
     "format { level 1: svo(1) level 2: svo(3) }",
     "dust:13",
     {13, 13, 13},
     26,
     175,
     {2, 9, 5},
     {0xff5bdeec, 0}},
};

class GoldenFiles : public test::VolumeFile, public ::testing::WithParamInterface<GoldenFile> {
protected:
  static std::string path() {
    return std::string(VOXC_UNITTESTS_DIR "/Volume/Golden/v1/") + GetParam().name + ".hvx";
  }
  static Expected<Volume> loadOld() { return Volume::load(path()); }
};

TEST_P(GoldenFiles, SayWhatTheyHold) {
  const GoldenFile &golden = GetParam();
  const auto volume = loadOld();
  ASSERT_TRUE(volume) << volume.error().message;
  EXPECT_EQ(volume->format(), *parseFormat(golden.format));
  EXPECT_EQ(volume->info().extent, golden.extent);
  EXPECT_EQ(volume->info().voxels, golden.voxels);
  EXPECT_EQ(volume->info().provenance.rfind(std::string("builtin=") + golden.scene, 0), 0u);
  EXPECT_EQ(volume->words().size(), golden.words);
  const Lookup found = volume->lookup(golden.someVoxel);
  EXPECT_EQ(found.value, golden.found.value);
  EXPECT_EQ(found.log2Side, golden.found.log2Side);
}

TEST_P(GoldenFiles, HoldTheVoxelsOfTheirScene) {
  const auto volume = loadOld();
  ASSERT_TRUE(volume) << volume.error().message;
  const Int3 extent = volume->format().extent();
  const auto scene = openInput(std::string("builtin:") + GetParam().scene, {.formatExtent = extent});
  ASSERT_TRUE(scene) << scene.error().message;
  for (Int3 c; c.z < extent.z; ++c.z)
    for (c.y = 0; c.y < extent.y; ++c.y)
      for (c.x = 0; c.x < extent.x; ++c.x) {
        std::uint32_t word = 0;
        ASSERT_TRUE(scene->source->read({c, 0}, &word));
        ASSERT_EQ(volume->lookup(c).value, word) << c.x << "," << c.y << "," << c.z;
      }
}

TEST_P(GoldenFiles, AreWrittenAsTheNewestVersion) {
  const auto old = loadOld();
  ASSERT_TRUE(old) << old.error().message;
  const std::string bytes = saved(*old);
  EXPECT_EQ(bytes[8], 2);
  EXPECT_EQ(bytes.size(), readTextFile(path())->size());
  const auto now = Volume::load(path_);
  ASSERT_TRUE(now) << now.error().message;
  EXPECT_EQ(now->format(), old->format());
  EXPECT_EQ(now->info().extent, old->info().extent);
  EXPECT_EQ(now->info().voxels, old->info().voxels);
  EXPECT_EQ(now->info().provenance, old->info().provenance);
  EXPECT_TRUE(std::ranges::equal(now->words(), old->words()));
}

TEST_P(GoldenFiles, AreRefusedIfTheyAreDamaged) {
  const std::string whole = *readTextFile(path());
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string broken = whole;
    broken[at] ^= static_cast<char>(1 << at % 8);
    ASSERT_NE(errorOf(broken), "no error") << "byte " << at;
  }
  for (std::size_t length = 0; length < whole.size(); length += length < 400 ? 1 : 61)
    ASSERT_NE(errorOf(whole.substr(0, length)), "no error") << length;
}

TEST_P(GoldenFiles, HaveHeadersThatAreNotBelieved) {
  const std::string whole = *readTextFile(path());
  for (std::size_t at = 0; at < whole.find("builtin="); ++at)
    for (int bit = 0; bit < 8; ++bit) {
      std::string broken = whole;
      broken[at] ^= static_cast<char>(1 << bit);
      broken = test::sealed(broken);
      const auto volume = load(broken);
      EXPECT_TRUE(!volume || decode(*volume, [](const Cube &, std::uint32_t) { return true; }));
    }
}

INSTANTIATE_TEST_SUITE_P(Version1, GoldenFiles, ::testing::ValuesIn(kFiles),
                         [](const auto &file) { return std::string(file.param.name); });

} // namespace
} // namespace voxc
