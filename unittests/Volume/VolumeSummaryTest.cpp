// What the head of a file tells, and the record of words in it.
#include "VolumeTesting.h"

#include "voxc/Volume/VolumeSummary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace voxc {
namespace {

using ::testing::HasSubstr;

using test::VolumeFile;

Volume counted(Volume volume) {
  VolumeInfo info = volume.info();
  info.wordCounts = WordCounts{std::vector<std::uint64_t>(info.format.levels.size(), 0x1234567890abcdefu), 3};
  const auto words = volume.words();
  return Volume(std::move(info), {words.begin(), words.end()});
}

TEST_F(VolumeFile, TellsInItsHeadWhatItLoadsAs) {
  for (const bool compress : {false, true}) {
    const Volume volume = small();
    ASSERT_TRUE(volume.save(path_, {.compress = compress, .pageBytes = 4096}));
    const auto summary = summarizeVolume(path_);
    ASSERT_TRUE(summary) << summary.error().message;
    EXPECT_EQ(summary->info.format, volume.format());
    EXPECT_EQ(summary->info.provenance, volume.info().provenance);
    EXPECT_FALSE(summary->info.wordCounts);
    ASSERT_EQ(summary->streams.size(), 1u);
    EXPECT_EQ(summary->streams[0].name, "words");
    EXPECT_EQ(summary->bytes(), volume.bytes());
    EXPECT_EQ(summary->streams[0].elements(), volume.words().size());
    EXPECT_EQ(summary->streams[0].pages(), compress ? 1u : 0u);
    EXPECT_LE(summary->storedBytes(), volume.bytes());
  }
}

TEST_F(VolumeFile, KeepsTheRecordOfWords) {
  for (const bool compress : {false, true}) {
    const Volume volume = counted(small());
    ASSERT_TRUE(volume.save(path_, {.compress = compress}));
    const auto loaded = Volume::load(path_);
    ASSERT_TRUE(loaded) << loaded.error().message;
    EXPECT_EQ(loaded->info().provenance, volume.info().provenance);
    ASSERT_TRUE(loaded->info().wordCounts);
    EXPECT_EQ(loaded->info().wordCounts->levels, volume.info().wordCounts->levels);
    EXPECT_EQ(loaded->info().wordCounts->values, 3u);
    EXPECT_EQ(summarizeVolume(path_)->info.wordCounts->levels, volume.info().wordCounts->levels);
  }
}

/// Who writes such a line on his own gets it back.
TEST_F(VolumeFile, TakesNothingElseForTheRecord) {
  for (const char *text :
       {"\nwords=", "\nwords=12,34", "\nwords=000000000000000g,0000000000000000", "\nwords=0000000000000001",
        "\nwords=0000000000000001,0000000000000002,", "words=0000000000000001,0000000000000002"}) {
    VolumeInfo info = small().info();
    info.provenance = text;
    const Volume made = small();
    const auto words = made.words();
    ASSERT_TRUE(Volume(info, {words.begin(), words.end()}).save(path_));
    const auto summary = summarizeVolume(path_);
    ASSERT_TRUE(summary) << summary.error().message;
    EXPECT_EQ(summary->info.provenance, text);
    EXPECT_FALSE(summary->info.wordCounts) << text;
  }
}

TEST_F(VolumeFile, HasNoSummaryWhereItIsNone) {
  EXPECT_THAT(summarizeVolume(path_ + ".none").error().message, HasSubstr("No such file"));
  const std::string whole = saved(small());
  std::ofstream(path_, std::ios::binary) << whole.substr(0, whole.size() - 4);
  EXPECT_THAT(summarizeVolume(path_).error().message, HasSubstr("is truncated"));
  std::ofstream(path_, std::ios::binary) << "no volume at all";
  EXPECT_THAT(summarizeVolume(path_).error().message, HasSubstr("is not a .hvx volume"));
  std::ofstream(path_, std::ios::binary) << "\x89HVF\r\n\x1a\n";
  EXPECT_THAT(summarizeVolume(path_).error().message, HasSubstr("is a fragment of a volume; 'voxc merge'"));
}

} // namespace
} // namespace voxc
