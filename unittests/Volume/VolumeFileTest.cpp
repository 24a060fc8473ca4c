// The .hvx file and its loader, which trusts nothing.
#include "VolumeTesting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>

namespace voxc {
namespace {

using ::testing::HasSubstr;

using test::VolumeFile;

TEST_F(VolumeFile, RoundTrips) {
  const Volume saved = small();
  ASSERT_TRUE(saved.save(path_));
  const auto loaded = Volume::load(path_);
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_EQ(loaded->format(), saved.format());
  EXPECT_EQ(loaded->info().extent, saved.info().extent);
  EXPECT_EQ(loaded->info().voxelToModel, saved.info().voxelToModel);
  EXPECT_EQ(loaded->info().voxels, 1u);
  EXPECT_EQ(loaded->info().provenance, "resolution=2");
  EXPECT_TRUE(std::ranges::equal(loaded->words(), saved.words()));
  EXPECT_EQ(loaded->lookup({1, 0, 0}).value, 9u);
  EXPECT_EQ(loaded->lookup({0, 0, 0}).value, 0u);
  EXPECT_EQ(loaded->lookup({2, 0, 0}).value, 0u);
}

TEST_F(VolumeFile, HasOneJournalBehindAllLinks) {
  EXPECT_EQ(journalPathOf(path_), path_ + ".journal");
  EXPECT_EQ(journalPathOf("v.hvx"), "v.hvx.journal");
  ASSERT_TRUE(small().save(path_));
  std::error_code failure;
  std::filesystem::create_symlink("volume.hvx", folder_ / "link.hvx", failure);
  if (failure)
    GTEST_SKIP() << "no links can be made here";
  EXPECT_EQ(journalPathOf((folder_ / "link.hvx").string()), path_ + ".journal");
  // Also while nothing is there: a volume that is written by that name is made where it leads.
  std::filesystem::create_symlink("none.hvx", folder_ / "early.hvx", failure);
  EXPECT_EQ(journalPathOf((folder_ / "early.hvx").string()), (folder_ / "none.hvx").string() + ".journal");
}

/// A file of version 2 stays what it is, byte for byte.
TEST_F(VolumeFile, IsWrittenAsEver) {
  const auto golden = readTextFile(VOXC_UNITTESTS_DIR "/Volume/Golden/v2/small.hvx");
  ASSERT_TRUE(golden) << golden.error().message;
  EXPECT_EQ(saved(small()), *golden);
}

TEST_F(VolumeFile, NoticesEveryFlippedBit) {
  const std::string whole = saved(small());
  std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
  const auto put = [&](std::size_t at, char byte) {
    file.seekp(static_cast<std::streamoff>(at));
    file.put(byte);
    file.flush();
  };
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      put(at, static_cast<char>(whole[at] ^ 1 << bit));
      ASSERT_FALSE(Volume::load(path_)) << "byte " << at << ", bit " << bit;
    }
    put(at, whole[at]);
  }
  EXPECT_TRUE(Volume::load(path_));
}

TEST_F(VolumeFile, NoticesEveryLength) {
  const std::string whole = saved(small());
  for (std::size_t length = 0; length < whole.size(); length += length < 200 ? 1 : 61)
    ASSERT_NE(errorOf(whole.substr(0, length)), "no error") << length;
  EXPECT_THAT(errorOf(whole + "more"), HasSubstr("surplus"));
  EXPECT_THAT(errorOf(""), HasSubstr("not a .hvx volume"));
}

TEST_F(VolumeFile, LeavesTheOldFileIfItCannotBeWritten) {
  EXPECT_FALSE(small().save(folder_.string()));
  EXPECT_FALSE(small().save((folder_ / "none" / "v.hvx").string()));
}

std::string structureOf(const char *format, std::vector<std::uint32_t> words) {
  const auto checked = checkStructure(*parseFormat(format), words);
  return checked ? "sound" : checked.error().message;
}

TEST(Structure, AcceptsWhatBuildersWrite) {
  EXPECT_EQ(structureOf("G(1)", {2, 9, 0x0202, 1}), "sound");
  EXPECT_EQ(structureOf("R(1,0,0)", {1, 0, 5}), "sound");
  EXPECT_EQ(structureOf("R(1,0,0)", {0}), "sound");
}

TEST(Structure, RefusesWhatWouldLeadAstray) {
  EXPECT_THAT(structureOf("R(1,0,0)", {}), HasSubstr("1 to 2^32 words"));
  EXPECT_THAT(structureOf("R(1,0,0)", {2, 0, 5}), HasSubstr("a grid at word 2 needs 2 words"));
  EXPECT_THAT(structureOf("R(1,0,0)", {0, 0, 5}), HasSubstr("word 0"));
  EXPECT_THAT(structureOf("G(1)", {9, 9, 0x0202, 1}), HasSubstr("leads to word 9"));
  EXPECT_THAT(structureOf("G(1)", {2, 9, 0x0202, 7}), HasSubstr("a leaf at word 7"));
  EXPECT_THAT(structureOf("G(1)", {2, 9, 0x0202}), HasSubstr("a node at word 2 needs 2 words"));
  EXPECT_THAT(structureOf("G(1)", {2, 9, 0x0002, 1}), HasSubstr("not a leaf"));
  EXPECT_THAT(structureOf("G(2)", {1, 0x0203, 1, 1}), HasSubstr("broken"));
  EXPECT_THAT(structureOf("G(1)", {2, 9, 0x0302, 1}), HasSubstr("leaf that is empty"));
  EXPECT_THAT(structureOf("G(1)", {2, 0, 0x0202, 1}), HasSubstr("empty or malformed"));
  EXPECT_THAT(structureOf("S(1)", {3, 9, 1, 1, 0x0202}), HasSubstr("empty or malformed"));
  EXPECT_THAT(structureOf("S(1)", {3, 9, 0, 0xffffffff, 0xffff}), HasSubstr("a leaf"));
  EXPECT_THAT(structureOf("D(1,0,0,3)", {1, 9, 1, 0, 1}), HasSubstr("has a distance"));
  EXPECT_THAT(structureOf("D(1,0,0,3)", {1, 9, 0, 0, 4}), HasSubstr("outside 1..3"));
  EXPECT_THAT(structureOf("R(1,0,0) R(0^3)", {1, 3, 99, 7}), HasSubstr("leads to word 99"));
  // A leaf at word 0 is what a kernel takes for empty.
  EXPECT_THAT(structureOf("G(1)", {1, 0x0101, 0}), HasSubstr("empty or malformed"));
}

TEST(Structure, RefusesWhatWouldLeadAstrayInWideAndMaskedNodes) {
  EXPECT_EQ(structureOf("G(2,2)", {2, 9, 2, 0, 2, 0, 1}), "sound");
  EXPECT_THAT(structureOf("G(2,2)", {2, 9, 2, 0, 2, 0}), HasSubstr("needs 5 words"));
  EXPECT_THAT(structureOf("G(2,2)", {2, 9, 2, 0, 2}), HasSubstr("needs 4 words"));
  EXPECT_THAT(structureOf("G(2,2)", {2, 9, 2, 0, 2, 2, 1}), HasSubstr("leaf that is empty"));
  EXPECT_THAT(structureOf("G(2,2)", {2, 9, 2, 0, 0, 0, 1}), HasSubstr("not a leaf"));
  EXPECT_EQ(structureOf("M(1^3)", {1, 0x81, 5, 6}), "sound");
  EXPECT_THAT(structureOf("M(1^3)", {1, 0x81, 5}), HasSubstr("needs 3 words"));
  EXPECT_THAT(structureOf("M(1^3)", {1, 0x101, 5, 6}), HasSubstr("no meaning"));
  EXPECT_THAT(structureOf("M(1^3)", {1, 0, 5}), HasSubstr("no child"));
  EXPECT_THAT(structureOf("M(3,2,2)", {1, 1, 0, 1, 2, 0, 2, 0, 2, 5, 6}), HasSubstr("counts other children"));
}

TEST(Structure, RefusesWhatNoProbeFinds) {
  EXPECT_EQ(structureOf("H(1^3)", {1, 1, 1, 0, 7, 0, 0}), "sound");
  EXPECT_THAT(structureOf("H(1^3)", {1, 1, 1, 0, 7, 0}), HasSubstr("needs 6 words"));
  EXPECT_THAT(structureOf("H(1^3)", {1, 1, 1, 8, 7, 0, 0}), HasSubstr("no probe finds")); // No such cell.
  EXPECT_THAT(structureOf("H(1^3)", {1, 1, 1, 0, 7, 3, 0}),
              HasSubstr("no probe finds")); // A free entry of a cell.
  EXPECT_THAT(structureOf("H(1^3)", {1, 1, 1, 0, 0, 0, 7}),
              HasSubstr("no probe finds")); // Not where it is sought.
  EXPECT_THAT(structureOf("H(1^3)", {1, 1, 2, 0, 7, 0, 8}), HasSubstr("no probe finds")); // Twice.
  EXPECT_THAT(structureOf("H(1^3)", {1, 1, 0, 0, 7, 0, 0}), HasSubstr("no probe finds")); // No probes.
  EXPECT_THAT(structureOf("H(1^3)", {1, 1, 1, 0, 0, 0, 0}), HasSubstr("or none"));
  EXPECT_THAT(structureOf("H(1^3)", {1, 40, 1, 0, 7, 0, 0}), HasSubstr("lie outside"));
}

TEST(Structure, CountsVoxelsHoweverTheyAreShared) {
  const auto count = [](const char *format, std::vector<std::uint32_t> words) {
    const auto voxels = checkStructure(*parseFormat(format), words);
    return voxels ? *voxels : 0;
  };
  EXPECT_EQ(count("R(1,0,0)", {1, 0, 5}), 1u);
  EXPECT_EQ(count("G(1)", {2, 9, 0x0202, 1}), 1u);
  // A leaf under the root is 4^3 voxels.
  EXPECT_EQ(count("G(3)", {2, 9, 0x0202, 1}), 64u);
  // Nodes of all heights that have the same child twice.
  EXPECT_EQ(count("G(5)", {12, 9, 0x0101, 1, 1, 2, 3, 4, 4, 3, 6, 6, 3, 9, 9}), 8u);
  EXPECT_EQ(count("G(4) G(1)", {12, 2, 0x0101, 9, 0x0101, 1, 3, 4, 4, 3, 6, 6, 3, 9, 9}), 8u);
}

TEST(Structure, RefusesGridsThatHoldNothing) {
  EXPECT_THAT(structureOf("R(1,0,0)", {1, 0, 0}), HasSubstr("holds no voxel"));
  EXPECT_THAT(structureOf("R(1,0,0) R(0^3)", {2, 0, 1, 0}), HasSubstr("holds no voxel"));
  EXPECT_THAT(structureOf("D(1,0,0,3)", {1, 0, 3, 0, 3}), HasSubstr("holds no voxel"));
}

TEST_F(VolumeFile, CountsItsVoxels) {
  Volume lying = small();
  VolumeInfo info = lying.info();
  info.voxels = 2;
  ASSERT_TRUE(Volume(info, {2, 9, 0x0202, 1}).save(path_));
  const auto loaded = Volume::load(path_);
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message, HasSubstr("holds 1 voxels, but its header says 2"));
  EXPECT_TRUE(Volume::load(path_, {.trusted = true}));
}

/// 8 leaves high in an upper tree stand for 2^60 grids of one voxel each: no one may decode them all.
Volume vast(std::uint64_t stated) {
  VolumeInfo info;
  info.format = *parseFormat("G(20) R(1^3)");
  info.extent = info.format.extent();
  info.voxels = stated;
  return Volume(std::move(info), {10, 0, 7, 0, 0, 0, 0, 0, 0, 1, 0xffff, 9, 9, 9, 9, 9, 9, 9, 9});
}

TEST(Decode, EndsWhenItIsTold) {
  const Volume volume = vast(std::uint64_t{1} << 60);
  ASSERT_EQ(*checkStructure(volume.format(), volume.words()), std::uint64_t{1} << 60);
  int cubes = 0;
  EXPECT_TRUE(decode(volume, [&](const Cube &, std::uint32_t) { return ++cubes < 5; }));
  EXPECT_EQ(cubes, 5);
  const std::atomic<bool> stop = true;
  const auto decoded = decode(volume, [&](const Cube &, std::uint32_t) { return true; }, {{}, &stop});
  ASSERT_FALSE(decoded);
  EXPECT_EQ(decoded.error().kind, ErrorKind::Interrupted);
}

TEST_F(VolumeFile, DecodesToNoMoreCubesThanItMay) {
  ASSERT_TRUE(vast(std::uint64_t{1} << 60).save(path_));
  const auto volume = Volume::load(path_, {.mostCubes = 1000});
  ASSERT_TRUE(volume) << volume.error().message;
  std::uint64_t cubes = 0;
  const auto decoded = decode(*volume, [&](const Cube &, std::uint32_t) { return ++cubes > 0; });
  EXPECT_EQ(cubes, 1000u);
  ASSERT_FALSE(decoded);
  EXPECT_THAT(decoded.error().message, HasSubstr("more than 1000 cubes of voxels, the limit (--max-cubes"));
}

TEST(Decode, FindsNoMoreVoxelsThanTheHeaderSays) {
  const auto decoded = decode(vast(1000), [](const Cube &, std::uint32_t) { return true; });
  ASSERT_FALSE(decoded);
  EXPECT_THAT(decoded.error().message, HasSubstr("more voxels than the 1000"));
}

TEST(Structure, EndsQuicklyWhateverTheFileTiesTogether) {
  // 20 nodes, each of eight pointers to the next: 8^20 paths, but few nodes.
  std::vector<std::uint32_t> words = {0};
  std::uint32_t child = 1;
  words.push_back(5);
  for (int height = 1; height <= 20; ++height) {
    const auto node = static_cast<std::uint32_t>(words.size());
    words.push_back(height == 1 ? 0xffff : 0x00ff);
    words.insert(words.end(), 8, child);
    child = node;
  }
  words[0] = child;
  EXPECT_EQ(structureOf("G(20)", words), "sound");
  // Grids that overlap would make a small file ask for much work.
  std::vector<std::uint32_t> grids(1 + 512 + 4096 + 512, 1);
  grids[0] = 1;
  for (std::uint32_t i = 0; i < 512; ++i)
    grids[1 + i] = 513 + i;
  EXPECT_THAT(structureOf("R(3^3) R(4^3)", grids), HasSubstr("overlap"));
}

} // namespace
} // namespace voxc
