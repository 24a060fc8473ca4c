// Formats of a small scene, predicted and measured by the library alone.
#include "voxc/Measure/FormatTable.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/Passes/Pass.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <set>

namespace voxc {
namespace {

using testing::HasSubstr;

/// A ball in a cube of 32 voxels a side.
Expected<std::unique_ptr<VoxelSource>> openBall() {
  const auto voxel = [](Int3 cell) -> std::uint32_t {
    const Int3 from{cell.x - 16, cell.y - 16, cell.z - 16};
    return from.x * from.x + from.y * from.y + from.z * from.z <= 144 ? 0xff2040a0u : 0u;
  };
  return makeFunctionSource({32, 32, 32}, voxel);
}

std::uint64_t builtBytes(const FormatRow &row) {
  Format format = *parseFormat(row.format);
  EXPECT_TRUE(runPasses(format, row.passes));
  const auto source = openBall();
  const auto built = Constructor::compile(format)->build(**source);
  return built->volume.words().size() * sizeof(std::uint32_t);
}

/// Speeds that are learned go to a folder of this test's own.
class FormatTableTest : public testing::Test {
protected:
  void SetUp() override { ::setenv("XDG_CACHE_HOME", testing::TempDir().c_str(), 1); }
};

TEST_F(FormatTableTest, PredictsBytesToTheWord) {
  const auto table = suggestFormats(openBall, {.objective = "smallest", .device = "cpu"});
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_THAT(table->sets, testing::ElementsAre("camera", "bounced"));
  const auto smallest = std::ranges::min_element(table->rows, {}, &FormatRow::bytes);
  EXPECT_TRUE(smallest->isOnFrontier);
  EXPECT_EQ(std::ranges::count_if(table->rows, &FormatRow::isChosen), 1);
  EXPECT_EQ(std::ranges::find_if(table->rows, &FormatRow::isChosen)->bytes, smallest->bytes);
  for (const FormatRow &row : table->rows) {
    ASSERT_EQ(row.speeds.size(), 2u);
    EXPECT_GT(row.speeds[0].predicted, 0);
    EXPECT_EQ(row.speeds[0].measured, 0);
  }
  EXPECT_EQ(builtBytes(*smallest), smallest->bytes);
}

TEST_F(FormatTableTest, MeasuresFormatsOfAList) {
  const FormatQuestion question{.device = "cpu", .formats = {"G(5)", "R(5^3)"}, .seconds = 300, .threads = 1};
  const auto table = searchFormats(openBall, question);
  ASSERT_TRUE(table) << table.error().message;
  std::set<std::string> formats;
  for (const FormatRow &row : table->rows) {
    formats.insert(row.format);
    EXPECT_EQ(row.failure, "");
    EXPECT_EQ(row.bytes, builtBytes(row));
    ASSERT_EQ(row.speeds.size(), table->sets.size());
    for (const FormatSpeed &speed : row.speeds) {
      EXPECT_GT(speed.checkedRays, 0u);
      EXPECT_EQ(speed.wrongRays, 0u);
      EXPECT_EQ(speed.maxUlp, 0);
      EXPECT_GT(speed.slowest, 0);
      EXPECT_LE(speed.slowest, speed.measured);
      EXPECT_LE(speed.measured, speed.fastest);
    }
  }
  EXPECT_EQ(formats, (std::set<std::string>{"G(5)", "R(5^3)"}));
}

TEST_F(FormatTableTest, TakesRaysOfItsOwn) {
  std::vector<Ray> rays(16, Ray{{-1, 16.5f, 16.5f}, {1, 0, 0}});
  const auto table = suggestFormats(openBall, {.device = "cpu", .formats = {"S(5)"}, .rays = rays});
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_THAT(table->sets, testing::ElementsAre("rays"));
  rays.resize(7);
  const auto few = suggestFormats(openBall, {.device = "cpu", .rays = rays});
  ASSERT_FALSE(few);
  EXPECT_EQ(few.error().kind, ErrorKind::Usage);
  EXPECT_THAT(few.error().message, HasSubstr("8 or more"));
}

TEST_F(FormatTableTest, SaysWhatIsWrong) {
  const auto kindOf = [](const Expected<FormatTable> &table) {
    return table ? std::nullopt : std::optional(table.error().kind);
  };
  EXPECT_EQ(kindOf(suggestFormats(openBall, {.objective = "nicest"})), ErrorKind::Usage);
  EXPECT_EQ(kindOf(suggestFormats(openBall, {.formats = {"Q(5)"}})), ErrorKind::Input);
  EXPECT_EQ(kindOf(suggestFormats(openBall, {.maxBytes = 8, .device = "cpu"})), ErrorKind::Input);
  EXPECT_EQ(kindOf(searchFormats(openBall, {.device = "cpu", .precision = "rough"})), ErrorKind::Usage);
  EXPECT_EQ(kindOf(searchFormats(openBall, {.device = "no such device"})), ErrorKind::Environment);
  EXPECT_EQ(kindOf(searchFormats(openBall, {.device = "cpu", .seconds = 1e-9})), ErrorKind::Usage);
  const auto broken = [] { return Expected<std::unique_ptr<VoxelSource>>(Error::input("torn")); };
  EXPECT_EQ(suggestFormats(broken, {.device = "cpu"}).error().message, "torn");
  std::atomic<bool> stop = true;
  EXPECT_EQ(kindOf(searchFormats(openBall, {.device = "cpu"}, {.stop = &stop})), ErrorKind::Interrupted);
}

} // namespace
} // namespace voxc
