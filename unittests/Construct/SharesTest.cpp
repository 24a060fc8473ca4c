// Fragments say what they hold and that they are whole, and merges hold them to it.
#include "Source/SourceTesting.h"

#include "Volume/Checksum.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Source/Sources.h"
#include "voxc/Support/File.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

namespace voxc {
namespace {

using ::testing::HasSubstr;

// Places in the header of docs/hvf.md.
constexpr std::size_t kVersionAt = 8;
constexpr std::size_t kHeadChecksumAt = 16;
constexpr std::size_t kPartsAt = 24;
constexpr std::size_t kEndAt = 56;
constexpr std::size_t kLookedAt = 64;
constexpr std::size_t kVoxelsAt = 72;
constexpr std::size_t kHeaderBytes = 200;

class Shares : public ::testing::Test {
protected:
  static constexpr const char *kFormat = "R(1^3) G(6)";

  std::string path(int i) const { return folder_.path(std::to_string(i)); }

  /// Builds the cubes [begin, end) of the 8 that there are.
  void build(int i, std::uint64_t count, std::uint64_t begin, std::uint64_t end) {
    const auto report =
        constructor_.buildFragment(*scene_, FragmentShare{std::uint64_t(i), count, begin, end}, path(i));
    ASSERT_TRUE(report) << report.error().message;
  }

  std::string problemOfMerge(std::uint64_t count) const {
    std::vector<std::string> paths;
    for (int i = 0; i < int(count); ++i)
      paths.push_back(path(i));
    const auto merged = constructor_.merge(paths);
    return merged ? "" : merged.error().message;
  }

  /// Adds to a number of the header, and puts the checksum right.
  void change(int i, std::size_t at, std::int64_t by) const {
    std::string bytes = *readTextFile(path(i));
    std::uint64_t number = 0;
    const std::size_t size = at == kVersionAt ? 4 : 8;
    std::memcpy(&number, bytes.data() + at, size);
    number += static_cast<std::uint64_t>(by);
    std::memcpy(bytes.data() + at, &number, size);
    std::memset(bytes.data() + kHeadChecksumAt, 0, 8);
    Checksum checksum;
    checksum.add(bytes.data() + kHeaderBytes, bytes.size() - kHeaderBytes);
    checksum.add(bytes.data(), kHeaderBytes);
    const std::uint64_t digest = checksum.digest();
    std::memcpy(bytes.data() + kHeadChecksumAt, &digest, 8);
    ASSERT_TRUE(writeFile(path(i), bytes));
  }

  TemporaryFolder folder_;
  std::unique_ptr<VoxelSource> scene_ = *makeBuiltinSource("terrain", 128);
  Constructor constructor_ = std::move(*Constructor::compile(*parseFormat(kFormat)));
};

TEST_F(Shares, ThatCoverTheVolumeMakeIt) {
  build(0, 3, 0, 3);
  build(1, 3, 3, 3);
  build(2, 3, 3, 8);
  EXPECT_EQ(problemOfMerge(3), "");
  const auto share = checkFragment(path(2));
  ASSERT_TRUE(share);
  EXPECT_EQ(*share, (FragmentShare{2, 3, 3, 8}));
}

TEST_F(Shares, WithAGapOrAnOverlapAreRefused) {
  build(0, 2, 0, 3);
  build(1, 2, 4, 8);
  EXPECT_THAT(problemOfMerge(2), HasSubstr("ends at cube 3 of the volume"));
  EXPECT_THAT(problemOfMerge(2), HasSubstr("there is a gap between them"));
  build(0, 2, 0, 5);
  EXPECT_THAT(problemOfMerge(2), HasSubstr("they overlap"));
}

TEST_F(Shares, ThatEndBeforeTheVolumeAreRefused) {
  build(0, 1, 0, 7);
  EXPECT_THAT(problemOfMerge(1), HasSubstr("the cubes 0 to 7 of a volume of 8"));
  build(0, 1, 1, 8);
  EXPECT_THAT(problemOfMerge(1), HasSubstr("the cubes 1 to 8 of a volume of 8"));
}

TEST_F(Shares, WereLookedAtAsAWhole) {
  build(0, 1, 0, 8);
  change(0, kLookedAt, -1);
  EXPECT_THAT(problemOfMerge(1), HasSubstr("is not whole: of its 8 cubes 7 were looked at"));
  EXPECT_FALSE(checkFragment(path(0)));
}

TEST_F(Shares, HaveThePartsAndVoxelsThatTheirHeadSays) {
  for (const auto &[at, by] : {std::pair{kVoxelsAt, 1}, {kVoxelsAt, -1}, {kPartsAt, 1}, {kPartsAt, -1}}) {
    build(0, 1, 0, 8);
    change(0, at, by);
    EXPECT_THAT(problemOfMerge(1), HasSubstr("is broken")) << at << " " << by;
    EXPECT_FALSE(constructor_.joinFragments({path(0)}, {0, 1, 0, 8}, path(1))) << at << " " << by;
  }
}

TEST_F(Shares, EndWithinTheVolume) {
  build(0, 1, 0, 8);
  change(0, kEndAt, 1);
  change(0, kLookedAt, 1);
  EXPECT_THAT(problemOfMerge(1), HasSubstr("a share of cubes that its volume does not have"));
}

TEST_F(Shares, AreOfTheirOwnCubes) {
  build(0, 2, 0, 3);
  build(1, 2, 3, 8);
  // The first one says that it ends a cube earlier than its parts.
  change(0, kEndAt, -1);
  change(0, kLookedAt, -1);
  change(1, kEndAt - 8, -1);
  change(1, kLookedAt, 1);
  EXPECT_THAT(problemOfMerge(2), HasSubstr("its parts are not in order"));
}

TEST_F(Shares, EndWithATrailer) {
  build(0, 1, 0, 8);
  const std::string bytes = *readTextFile(path(0));
  ASSERT_TRUE(writeFile(path(0), bytes + "more"));
  EXPECT_THAT(problemOfMerge(1), HasSubstr("is not whole: it does not end as a fragment does"));
  ASSERT_TRUE(writeFile(path(0), std::string_view(bytes).substr(0, bytes.size() - 16)));
  EXPECT_THAT(problemOfMerge(1), HasSubstr("is not whole: it does not end as a fragment does"));
}

TEST_F(Shares, OfBeforeAreToBeBuiltAgain) {
  build(0, 1, 0, 8);
  change(0, kVersionAt, -1);
  EXPECT_THAT(problemOfMerge(1), HasSubstr("is of version 5, which an earlier voxc wrote"));
  EXPECT_THAT(problemOfMerge(1), HasSubstr("build it again with this voxc"));
  change(0, kVersionAt, -1);
  EXPECT_THAT(problemOfMerge(1), HasSubstr("could leave out voxels after an interruption"));
  EXPECT_THAT(problemOfMerge(1), HasSubstr("build it again with this voxc"));
}

TEST_F(Shares, OfSomeFragmentsMakeAVolumeOfTheirVoxels) {
  build(0, 3, 0, 2);
  build(1, 3, 2, 5);
  build(2, 3, 5, 8);
  auto all = constructor_.merge({path(0), path(1), path(2)});
  auto some = constructor_.mergeRun({path(1), path(2)});
  ASSERT_TRUE(all && some);
  const auto decoded = makeVolumeSource(std::make_shared<const Volume>(std::move(some->volume)));
  const auto whole = makeVolumeSource(std::make_shared<const Volume>(std::move(all->volume)));
  Voxels expected = voxelsOf(*whole);
  const std::uint64_t first = std::uint64_t{2} << 18; // Cubes of 64^3.
  std::erase_if(expected, [&](const auto &voxel) { return voxel.first < first; });
  EXPECT_FALSE(expected.empty());
  EXPECT_EQ(voxelsOf(*decoded), expected);
}

} // namespace
} // namespace voxc
