// Candidates, the frontier, and which format is chosen.
#include "voxc/Search/Suggest.h"
#include "voxc/Search/SampleRays.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace voxc {
namespace {

TEST(Candidates, AllHaveTheSizeAndDiffer) {
  for (const int side : {1, 2, 3, 5, 9, 12, 21}) {
    std::set<std::string> texts;
    const auto candidates = candidatesFor(side, {});
    for (const Candidate &candidate : candidates) {
      EXPECT_EQ(maxComponent(candidate.format.log2Extent()), side) << candidate.text;
      EXPECT_TRUE(texts.insert(printIr(candidate.format)).second) << printIr(candidate.format);
    }
    EXPECT_GE(candidates.size(), 2u) << side;
  }
}

TEST(Candidates, PassesAreThoseThatApply) {
  const auto candidate =
      makeCandidate("G(6)", {.paletteBits = 5, .visible = true}, {.grids = SmallGrids::Numbered});
  ASSERT_TRUE(candidate) << candidate.error().message;
  EXPECT_EQ(std::ranges::count(candidate->passes, "palette=5"), 1);
  EXPECT_EQ(std::ranges::count(candidate->passes, "octant-distances"), 0);
  EXPECT_EQ(std::ranges::count(candidate->passes, "short-pointers=20"), 0);
  const auto constant = makeCandidate("D(4^3, 15) M(2^3)", {.oneColour = true}, {});
  ASSERT_TRUE(constant) << constant.error().message;
  EXPECT_EQ(std::ranges::count(constant->passes, "constant-colour"), 1);
  EXPECT_FALSE(makeCandidate("Q(6)", {}, {}));
}

TEST(Candidates, SmallGridsStandAsIsChosen) {
  for (const SmallGrids grids : {SmallGrids::Pointed, SmallGrids::Numbered, SmallGrids::ByOctants}) {
    const auto candidate = makeCandidate("R(2^3) M(2^3) M(2^3)", {.pointerBits = 11}, {.grids = grids});
    ASSERT_TRUE(candidate) << candidate.error().message;
    EXPECT_EQ(std::ranges::count(candidate->passes, "short-pointers=11"), grids != SmallGrids::Pointed);
    EXPECT_EQ(std::ranges::count(candidate->passes, "octant-masks"), grids == SmallGrids::ByOctants);
    EXPECT_EQ(choicesOf(candidate->passes), FormatChoices{.grids = grids});
  }
}

TEST(Candidates, ThoseToEditCanBeEdited) {
  const auto apart = makeCandidate("G(6)", {.paletteBits = 5}, {});
  ASSERT_TRUE(apart) << apart.error().message;
  const std::string text = printIr(apart->format);
  EXPECT_TRUE(makeCandidate(text, {}, {})) << text;
  const auto edited = makeCandidate(text, {.editable = true}, {});
  ASSERT_FALSE(edited);
  EXPECT_NE(edited.error().message.find("cannot be edited: values stand apart"), std::string::npos)
      << edited.error().message;
  EXPECT_TRUE(makeCandidate("G(6)", {.editable = true}, {}));
}

class SuggestTest : public testing::Test {
protected:
  SuggestTest() : dag_(*SceneDag::build(**makeBuiltinSource("terrain", 64), {})) {
    const std::vector<Ray> rays = sampleCamera(frameExtent({64, 64, 64}, 160, 96), 256);
    EXPECT_EQ(rays.size(), 256u);
    rays_ = {{"camera", rays}, {"bounced", sampleBounces(dag_, rays, rays.size(), 1)}};
  }

  std::vector<PredictedFormat> predict(const Wish &wish) const {
    return *predictFormats({dag_}, candidatesFor(6, {.visible = true}), rays_, defaultSpeedModel("cpu"),
                           wish);
  }

  SceneDag dag_;
  std::vector<RaySet> rays_;
};

TEST_F(SuggestTest, BouncesBeginWhereRaysHit) {
  ASSERT_EQ(rays_[1].rays.size(), 256u);
  for (const Ray &ray : rays_[1].rays)
    for (const float place : ray.origin)
      EXPECT_TRUE(place > 0 && place < 64);
}

TEST_F(SuggestTest, TheFrontierIsWhatNothingBeats) {
  const auto rated = predict({});
  const auto frontier = frontierOf(rated);
  for (std::size_t i = 0; i < rated.size(); ++i) {
    const bool beaten = std::ranges::any_of(rated, [&](const PredictedFormat &other) {
      return other.bytes() <= rated[i].bytes() && other.time() < rated[i].time();
    });
    EXPECT_FALSE(frontier[i] && beaten) << rated[i].candidate.text;
  }
  EXPECT_GT(std::ranges::count(frontier, true), 1);
}

TEST_F(SuggestTest, WishesAreKept) {
  const auto rated = predict({});
  const auto smallest = *choose(rated, {.objective = Wish::Objective::Smallest});
  const auto fastest = *choose(rated, {.objective = Wish::Objective::Fastest});
  const auto balanced = *choose(rated, {});
  for (const PredictedFormat &format : rated) {
    EXPECT_LE(rated[smallest].bytes(), format.bytes());
    EXPECT_LE(rated[fastest].time(), format.time() * 1.001);
  }
  EXPECT_TRUE(frontierOf(rated)[balanced]);
  for (const PredictedFormat &format : predict({.maxBytes = 4096}))
    EXPECT_LE(format.bytes(), 4096u);
  EXPECT_FALSE(choose({}, {}));
}

TEST_F(SuggestTest, GridsByOctantsAreSmallerAndTakeLonger) {
  std::vector<Candidate> candidates;
  for (const SmallGrids grids : {SmallGrids::Numbered, SmallGrids::ByOctants})
    candidates.push_back(
        *makeCandidate("M(2^3) M(2^3) M(2^3)", {.oneColour = true, .pointerBits = 12}, {.grids = grids}));
  const auto rated = *predictFormats({dag_}, std::move(candidates), rays_, defaultSpeedModel("cpu"), {});
  ASSERT_EQ(rated.size(), 2u);
  EXPECT_LT(rated[1].bytes(), rated[0].bytes());
  EXPECT_GT(rated[1].time(), 1.1 * rated[0].time());
}

TEST_F(SuggestTest, ColoursInPlaceNeedTheirGraph) {
  const auto in = [](const std::vector<PredictedFormat> &rated, const char *text) {
    return std::ranges::find(rated, text, [](const PredictedFormat &format) {
             return format.candidate.text;
           }) != rated.end();
  };
  EXPECT_FALSE(in(predict({}), "S(6)"));
  const SceneDag colours =
      *SceneDag::build(**makeBuiltinSource("terrain", 64), {.detail = SceneDag::Detail::Colours});
  const auto rated =
      *predictFormats({dag_, &colours}, candidatesFor(6, {}), rays_, defaultSpeedModel("cpu"), {});
  EXPECT_TRUE(in(rated, "S(6)"));
}

} // namespace
} // namespace voxc
