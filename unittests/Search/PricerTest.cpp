// Predicted words are built words: of every line of the golden list, and of random formats of random scenes.
#include "GoldenWords.h"
#include "TestLength.h"
#include "testing/RandomFormat.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/Search/Pricer.h"
#include "voxc/Search/SceneValues.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace voxc {
namespace {

int side(const Format &format) { return longest(format.log2Extent()); }

/// What equal cubes are, for the trees of a layout.
SceneDag::Detail detailOf(const Layout &layout) {
  return kindOf(layout.payload).varies && layout.values == Values::InPlace ? SceneDag::Detail::Colours
                                                                           : SceneDag::Detail::Shape;
}

SceneDag dagOf(VoxelSource &source, int log2Side, SceneDag::Detail detail) {
  auto dag = SceneDag::build(source, {.detail = detail, .log2Side = log2Side});
  EXPECT_TRUE(dag) << dag.error().message;
  return std::move(*dag);
}

/// The scenes of the list, each with its price tables.
class Scenes {
public:
  Pricer &pricer(const std::string &scene, const Format &format) {
    const Int3 extent = format.extent();
    Entry &entry = entries_[{scene, extent.x, extent.y, extent.z}];
    if (!entry.pricer) {
      auto source = test::openScene(scene, format.extent());
      EXPECT_TRUE(source) << source.error().message;
      entry.dag = std::make_unique<SceneDag>(dagOf(**source, side(format), SceneDag::Detail::Colours));
      entry.pricer = std::make_unique<Pricer>(*entry.dag);
    }
    return *entry.pricer;
  }

private:
  struct Entry {
    std::unique_ptr<SceneDag> dag;
    std::unique_ptr<Pricer> pricer;
  };
  std::map<std::tuple<std::string, int, int, int>, Entry> entries_; ///< Scenes fill the format's extent.
};

TEST(Pricer, GoldenWords) {
  Scenes scenes;
  int compared = 0;
  for (const std::string &line : test::linesOf(test::kGoldenWords)) {
    const auto golden = test::parseGolden(line);
    if (!golden)
      continue;
    const auto format = test::formatOf(*golden);
    ASSERT_TRUE(format) << format.error().message;
    const auto price = scenes.pricer(golden->scene, *format).price(layoutOf(*format));
    ASSERT_TRUE(price) << price.error().message;
    EXPECT_EQ(price->words(), golden->words) << line;
    ++compared;
  }
  EXPECT_GT(compared, 500);
}

/// Blobs of few colours on a grid of few places, so that there is much to share and uniform cubes of many
/// sizes.
std::unique_ptr<VoxelSource> randomScene(std::mt19937 &random, int log2Side) {
  const int edge = 1 << log2Side;
  std::vector<std::uint32_t> words(std::size_t{1} << 3 * log2Side);
  for (int blob = test::pick(random, 1, 30); blob > 0; --blob) {
    const int log2Blob = test::pick(random, 0, log2Side);
    const int step = 1 << log2Blob;
    const Int3 low =
        Int3{test::pick(random, 0, (edge >> log2Blob) - 1), test::pick(random, 0, (edge >> log2Blob) - 1),
             test::pick(random, 0, (edge >> log2Blob) - 1)} *
        step;
    const auto colour = static_cast<std::uint32_t>(test::pick(random, 0, 2)) * 0xff00101fu;
    const int every = test::pick(random, 1, 2);
    for (int z = 0; z < step; z += every)
      for (int y = 0; y < step; y += every)
        for (int x = 0; x < step; x += every)
          words[static_cast<std::size_t>((low.x + x) + edge * ((low.y + y) + edge * (low.z + z)))] = colour;
  }
  return makeGridSource({edge, edge, edge}, std::move(words));
}

/// A graph, and the words of the values of voxels where they stand apart.
std::pair<SceneDag, SceneValues::Cheapest> look(VoxelSource &source, int log2Side, const Layout &layout) {
  auto values = SceneValues::create(WorkingMemory::createDefault());
  EXPECT_TRUE(values) << values.error().message;
  auto dag =
      SceneDag::build(source, {.detail = detailOf(layout),
                               .log2Side = log2Side,
                               .look = [&](std::span<const std::uint32_t> cells) { values->add(cells); }});
  EXPECT_TRUE(dag) << dag.error().message;
  const auto cheapest = values->finish();
  EXPECT_TRUE(cheapest) << cheapest.error().message;
  return {std::move(*dag), *cheapest};
}

TEST(Pricer, RandomFormats) {
  std::mt19937 random(15);
  const int kFormats = test::rounds(40);
  for (int i = 0; i < kFormats; ++i) {
    const int log2Side = test::pick(random, 3, 6);
    const Format format = test::randomFormat(random, log2Side);
    const Layout layout = layoutOf(format);
    const auto constructor = Constructor::compile(format);
    ASSERT_TRUE(constructor) << constructor.error().message;
    for (int scene = 0; scene < 4; ++scene) {
      const auto source = randomScene(random, log2Side);
      const Int3 extent = format.extent();
      const auto fits = extent.x >= 1 << log2Side && extent.y >= 1 << log2Side && extent.z >= 1 << log2Side;
      if (!fits)
        continue;
      const auto [dag, values] = look(*source->view(), side(format), layout);
      const bool isCheapest = (layout.payload == Payload::Palette) == (values.paletteBits > 0);
      if (layout.values == Values::Apart && !isCheapest)
        continue; // Those of another payload are not counted.
      const auto price = Pricer(dag).price(layout, values.words);
      ASSERT_TRUE(price) << price.error().message;
      const auto built = constructor->build(*source->view());
      ASSERT_TRUE(built) << built.error().message;
      const auto words = static_cast<double>(built->volume.words().size());
      EXPECT_NEAR(static_cast<double>(price->words()), words, price->exact ? 0 : words / 2)
          << printIr(format) << " scene " << scene;
    }
  }
}

} // namespace
} // namespace voxc
