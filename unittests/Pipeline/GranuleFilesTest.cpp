// Volumes whose references count granules, in files and in parts.
#include "GranuleTesting.h"

#include "voxc/Construct/Split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include <sys/stat.h>

namespace voxc {
namespace {

using namespace test;

class GranuleFiles : public ::testing::Test {
protected:
  GranuleFiles() : folder_(std::filesystem::path(::testing::TempDir()) / "voxc-granules") {
    std::filesystem::create_directories(folder_);
  }
  ~GranuleFiles() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string &name) const { return (folder_ / name).string(); }

  static void expectSameWords(const Volume &volume, const Expected<Volume> &other) {
    ASSERT_TRUE(other) << other.error().message;
    const std::string what = printIr(volume.format());
    ASSERT_TRUE(std::ranges::equal(volume.words(), other->words())) << what;
  }

  std::filesystem::path folder_;
};

TEST_F(GranuleFiles, AreTheSameInPartsAndCompressed) {
  for (const char *words : {"2", "16"})
    for (const Format &format : formatsWith(words)) {
      const HardScene scene = sceneOf(format, 6);
      const auto constructor = Constructor::compile(format);
      ASSERT_TRUE(constructor) << constructor.error().message;
      const auto built = constructor->build(*scene.source());
      ASSERT_TRUE(built) << built.error().message;
      const Volume &volume = built->volume;
      std::vector<std::string> apart;
      std::vector<std::string> split;
      for (const std::uint64_t i : {0u, 1u}) {
        apart.push_back(path("built" + std::to_string(i)));
        split.push_back(path("split" + std::to_string(i)));
        ASSERT_TRUE(constructor->buildFragment(*scene.source(), i, 2, apart.back()));
        ASSERT_TRUE(splitVolume(volume, i, 2, split.back()));
      }
      for (const auto &paths : {apart, split}) {
        auto merged = constructor->merge(paths);
        ASSERT_TRUE(merged) << merged.error().message;
        expectSameWords(volume, std::move(merged->volume));
      }
      ASSERT_TRUE(volume.save(path("small.hvx"), {.compress = true}));
      expectSameWords(volume, Volume::load(path("small.hvx")));
    }
}

TEST_F(GranuleFiles, OfFarNodesFallIntoTheSameParts) {
  for (const Format &format : formatsWith("2")) {
    const std::uint64_t empty = layoutOf(format).maxWords() / 4 * 3;
    const HardScene scene = sceneOf(format, 5);
    const auto near = build(format, scene);
    const auto far = build(format, scene, empty);
    ASSERT_TRUE(near && far);
    ASSERT_TRUE(splitVolume(*far, 0, 1, path("far.hvf")));
    auto merged = Constructor::compile(format)->merge({path("far.hvf")});
    ASSERT_TRUE(merged) << merged.error().message;
    expectSameWords(*near, std::move(merged->volume));
  }
}

TEST_F(GranuleFiles, HaveHolesWhereTheirWordsAreEmpty) {
  const Format format = withGranule(*parseFormat("R(2^3) G(3)"), "2");
  const HardScene scene = sceneOf(format, 6);
  constexpr std::uint64_t kEmpty = std::uint64_t{1} << 28;
  const auto built = build(format, scene, kEmpty, path("far.hvx"));
  ASSERT_TRUE(built) << built.error().message;
  const auto loaded = Volume::load(path("far.hvx"));
  expectSameWords(*built, loaded);
  EXPECT_GT(std::filesystem::file_size(path("far.hvx")), 4 * kEmpty);
  struct stat status{};
  ASSERT_EQ(::stat(path("far.hvx").c_str(), &status), 0);
  EXPECT_LT(status.st_blocks * 512, std::int64_t{1} << 20) << "bytes that the file takes";
}

} // namespace
} // namespace voxc
