// Predicted words are built words: of the paper's formats and of random ones, with storage passes, over the
// four models of the paper and random small scenes.
#include "ComparedScene.h"
#include "Mesh/SharedModels.h"
#include "SharedFolder.h"
#include "Source/SourceTesting.h"
#include "TestLength.h"
#include "testing/RandomFormat.h"

#include "voxc/Input/Input.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <random>

namespace voxc {
namespace {

using test::ComparedScene;

/// log2 of the voxels along a side of the scenes that random formats hold; those of the paper hold the
/// largest.
constexpr int kLeastSide = 3, kMostSide = 6;

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

/// The four models of the paper, as they lie beside the checkout.
struct Model {
  const char *file;
  std::optional<std::array<double, 6>> bounds = {};
};
const Model kModels[] = {{"sponza/sponza.obj"},
                         {"san_miguel.glb", {{-20, -0.2, -3.5, 27, 11, 13}}},
                         {"buddha_100k.ply"},
                         {"hairball_standin_small.ply"}};

std::unique_ptr<VoxelSource> openModel(const Model &model, const std::string &folder) {
  const std::string path = unpackedModel(model.file, folder);
  if (path.empty())
    return nullptr;
  const int edge = 1 << kMostSide;
  auto input =
      openInput(path, {.resolution = edge, .formatExtent = {edge, edge, edge}, .bounds = model.bounds});
  EXPECT_TRUE(input) << input.error().message;
  return input ? std::move(input->source) : nullptr;
}

/// The scene at half its resolution.
std::unique_ptr<VoxelSource> halved(VoxelSource &source) {
  const Int3 extent = {(source.extent().x + 1) / 2, (source.extent().y + 1) / 2, (source.extent().z + 1) / 2};
  std::vector<std::uint32_t> words(static_cast<std::size_t>(extent.x * extent.y * extent.z));
  for (const auto &[code, word] : voxelsOf(source)) {
    const Int3 cell = mortonCell(code >> 3);
    words[static_cast<std::size_t>(cell.x + extent.x * (cell.y + extent.y * cell.z))] = word;
  }
  return makeGridSource(extent, std::move(words));
}

class SizeModelScenes : public testing::Test {
protected:
  static constexpr int kRandomScenes = 10;
  static constexpr int kScenes = kRandomScenes + static_cast<int>(std::size(kModels));

  /// Reads the models, and makes random scenes, in each size down to 2^`leastSide` voxels a side.
  void makeScenes(int leastSide) {
    for (const Model &model : kModels) {
      auto source = openModel(model, folder_.path(""));
      hasModels_ = hasModels_ && source;
      for (int side = kMostSide; source && side >= leastSide; --side) {
        scenes_[side].emplace_back(model.file, *source);
        source = halved(*source);
      }
    }
    for (int side = leastSide; side <= kMostSide; ++side)
      for (int i = 0; i < kRandomScenes; ++i)
        scenes_[side].emplace_back("random scene " + std::to_string(i), *randomScene(random_, side));
  }

  /// Of how many scenes exactly the predicted words were built.
  static int compare(const Format &format, std::span<ComparedScene> scenes) {
    const auto constructor = Constructor::compile(format);
    EXPECT_TRUE(constructor) << constructor.error().message << "\n" << printIr(format);
    int compared = 0;
    for (ComparedScene &scene : scenes)
      compared += constructor && scene.compare(format, *constructor) ? 1 : 0;
    return compared;
  }

  /// What a search would make of the format for any of the scenes, with small grids of each kind.
  void compareCandidates(const std::string &text, std::span<ComparedScene> scenes) {
    const int scene = test::pick(random_, 0, static_cast<int>(scenes.size()) - 1);
    const auto chosen = scenes.subspan(static_cast<std::size_t>(scene), 1);
    std::optional<Format> before;
    for (const SmallGrids grids : {SmallGrids::Pointed, SmallGrids::Numbered, SmallGrids::ByOctants}) {
      const auto candidate = makeCandidate(text, chosen.front().traits(), {.grids = grids});
      ASSERT_TRUE(candidate) << candidate.error().message;
      if (before != candidate->format)
        compare(candidate->format, chosen);
      before = candidate->format;
    }
  }

  /// A random format; values apart are mostly numbers of colours, which these scenes have few of.
  Format randomFormat(int log2Side) {
    Format format = test::randomFormat(random_, log2Side);
    Diagnostics diagnostics;
    if (layoutOf(format).values == Values::Apart && random_() % 4 != 0)
      findPass("palette")->run(format, diagnostics, 16);
    return format;
  }

  TemporaryFolder folder_;
  std::mt19937 random_{15};
  std::map<int, std::vector<ComparedScene>> scenes_; ///< By log2 of their side.
  bool hasModels_ = true;
};

#define VOXC_SKIP_REST_WITHOUT_MODELS()                                                                      \
  if (!hasModels_)                                                                                           \
  GTEST_SKIP() << "some of the paper's models are not beside the checkout, the other scenes were compared"

TEST_F(SizeModelScenes, PapersFormats) {
  makeScenes(kMostSide);
  std::vector<ComparedScene> &scenes = scenes_.at(kMostSide);
  int formats = 0, compared = 0;
  for (const char *list : {"paper-512.txt", "paper-2048.txt"}) {
    std::ifstream file(test::sharedFolder() + "/formats/" + list);
    if (!file)
      GTEST_SKIP() << "the paper's format lists are not beside the checkout";
    for (std::string line; std::getline(file, line); ++formats) {
      const std::string text = line.substr(line.find('\t') + 1);
      const auto format = parseFormat(text);
      ASSERT_TRUE(format) << format.error().message;
      compared += compare(*format, scenes);
      compared += compare(test::withRandomPasses(random_, *format), scenes);
      compareCandidates(text, scenes);
    }
  }
  EXPECT_EQ(formats, 40);
  EXPECT_GT(compared, 40 * kRandomScenes);
  VOXC_SKIP_REST_WITHOUT_MODELS();
}

TEST_F(SizeModelScenes, RandomFormats) {
  makeScenes(kLeastSide);
  const int kFormats = test::rounds(100);
  int exact = 0, compared = 0;
  for (int drawn = 0; exact < kFormats && drawn < 10 * kFormats; ++drawn) {
    const int side = test::pick(random_, kLeastSide, kMostSide);
    const Format format = randomFormat(side);
    const bool isExact = scenes_.at(side).front().claimsExactness(format);
    // Of the others a few will do: they may take less or more.
    if (!isExact && drawn % 16 != 0)
      continue;
    compared += compare(format, scenes_.at(side));
    exact += isExact ? 1 : 0;
  }
  EXPECT_EQ(exact, kFormats);
  EXPECT_GT(compared, kFormats * kRandomScenes / 2);
  VOXC_SKIP_REST_WITHOUT_MODELS();
}

} // namespace
} // namespace voxc
