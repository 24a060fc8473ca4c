// Predicted words are built words: of every line of the golden list.
#include "GoldenWords.h"

#include "voxc/Search/SizeModel.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

namespace voxc {
namespace {

int side(const Format &format) { return maxComponent(format.log2Extent()); }

SceneDag dagOf(VoxelSource &source, int log2Side, SceneDag::Detail detail) {
  auto dag = SceneDag::build(source, {.detail = detail, .log2Side = log2Side});
  EXPECT_TRUE(dag) << dag.error().message;
  return std::move(*dag);
}

/// The scenes of the list, each with its price tables.
class Scenes {
public:
  SizeModel &sizeModel(const std::string &scene, const Format &format) {
    const Int3 extent = format.extent();
    Entry &entry = entries_[{scene, extent.x, extent.y, extent.z}];
    if (!entry.sizeModel) {
      auto source = test::openScene(scene, format.extent());
      EXPECT_TRUE(source) << source.error().message;
      entry.dag = std::make_unique<SceneDag>(dagOf(**source, side(format), SceneDag::Detail::Colours));
      entry.sizeModel = std::make_unique<SizeModel>(*entry.dag);
    }
    return *entry.sizeModel;
  }

private:
  struct Entry {
    std::unique_ptr<SceneDag> dag;
    std::unique_ptr<SizeModel> sizeModel;
  };
  std::map<std::tuple<std::string, int, int, int>, Entry> entries_; ///< Scenes fill the format's extent.
};

TEST(SizeModel, GoldenWords) {
  Scenes scenes;
  int compared = 0;
  for (const std::string &line : test::linesOf(test::kGoldenWords)) {
    const auto golden = test::parseGolden(line);
    if (!golden)
      continue;
    const auto format = test::formatOf(*golden);
    ASSERT_TRUE(format) << format.error().message;
    const auto price = scenes.sizeModel(golden->scene, *format).price(layoutOf(*format));
    ASSERT_TRUE(price) << price.error().message;
    EXPECT_EQ(price->words(), golden->words) << line;
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

} // namespace
} // namespace voxc
