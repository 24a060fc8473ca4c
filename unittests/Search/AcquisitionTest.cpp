// Frontiers, what measurements teach, and what is measured next.
#include "voxc/Search/Acquisition.h"
#include "voxc/Search/Explore.h"
#include "voxc/Search/SampleRays.h"
#include "voxc/Search/SceneSource.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace voxc {
namespace {

TEST(Frontier, ItsAreaIsThatBelowItsStairs) {
  Frontier frontier(1024);
  EXPECT_EQ(frontier.area(), 0);
  frontier.add({.bytes = 256, .nanoseconds = 500}); // 2 Mrays/s over 2 octaves.
  EXPECT_NEAR(frontier.area(), 4, 1e-12);
  frontier.add({.bytes = 512, .nanoseconds = 100}); // 8 more over one.
  EXPECT_NEAR(frontier.area(), 12, 1e-12);
  frontier.add({.bytes = 600, .nanoseconds = 200}); // Beaten.
  EXPECT_NEAR(frontier.area(), 12, 1e-12);
  EXPECT_EQ(frontier.speedAt(255), 0);
  EXPECT_NEAR(frontier.speedAt(400), 2, 1e-12);
  EXPECT_NEAR(frontier.speedAt(1e9), 10, 1e-12);
}

TEST(Frontier, WhatIsTooLargeOrTooSlowIsOfNoUse) {
  Frontier frontier(1024, 3);
  EXPECT_EQ(frontier.gain({.bytes = 2048, .nanoseconds = 100}), 0);
  EXPECT_EQ(frontier.gain({.bytes = 512, .nanoseconds = 500}), 0);
  EXPECT_NEAR(frontier.gain({.bytes = 512, .nanoseconds = 100}), 7, 1e-12);
}

TEST(Frontier, GainIsWhatTheAreaGrowsBy) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> octave(5, 12), time(50, 1000);
  Frontier frontier(2048);
  for (int i = 0; i < 200; ++i) {
    const SizeTime point{std::exp2(octave(random)), time(random)};
    const double before = frontier.area(), gain = frontier.gain(point);
    frontier.add(point);
    EXPECT_NEAR(frontier.area(), before + gain, 1e-9);
  }
}

Composition grid(int side) { return {.levels = {{0, side}, {4, 9 - side}}, .choices = {}}; }

TEST(SpeedCorrection, WithoutSamplesNothingIsKnown) {
  const auto estimate = SpeedCorrection().at(grid(4));
  EXPECT_EQ(estimate.error, 0);
  EXPECT_GT(estimate.deviation, 0.1);
}

TEST(SpeedCorrection, WhatWasMeasuredIsKnownAndWhatIsAlikeGuessed) {
  const SpeedCorrection correction({{grid(2), 0.3}, {grid(7), -0.2}});
  EXPECT_NEAR(correction.at(grid(2)).error, 0.3, 0.05);
  EXPECT_NEAR(correction.at(grid(7)).error, -0.2, 0.05);
  EXPECT_LT(correction.at(grid(2)).deviation, 0.05);
  const auto between = correction.at(grid(3));
  EXPECT_GT(between.error, 0);
  EXPECT_GT(between.deviation, correction.at(grid(2)).deviation);
}

/// A scene of which all is known, and a device that is as the model says, but for some kinds of levels.
class AcquisitionTest : public testing::Test {
protected:
  AcquisitionTest()
      : colours_(*SceneDag::build(**makeBuiltinSource("terrain", 64), {.detail = SceneDag::Detail::Colours})),
        dag_(colours_.shape()) {
    const std::vector<Ray> rays = sampleCamera(frameExtent({64, 64, 64}, 160, 96), 128);
    rays_ = {{"camera", rays}, {"bounced", sampleBounces(dag_, rays, rays.size(), 1)}};
  }

  Explored explored(const ExploreOptions &options = {}) const {
    const CandidateTraits traits{.visible = true};
    FormatPredictor predictor({dag_});
    return explore(predictor, candidatesFor(6, traits), traits, rays_, defaultSpeedModel("cpu"), {}, options);
  }

  static std::vector<double> timesOn(const PredictedFormat &format) {
    const bool isSlow = format.candidate.text.find("M(") != std::string::npos;
    std::vector<double> times;
    for (std::size_t set = 0; set < format.costs.size(); ++set)
      times.push_back((isSlow ? 1.6 : 1.0) *
                      defaultSpeedModel("cpu").predict(speedTerms(format.costs[set], format.bytes())));
    return times;
  }

  SceneDag colours_, dag_;
  std::vector<RaySet> rays_;
};

TEST_F(AcquisitionTest, ExploringFindsWhatNoSeedIs) {
  const Explored found = explored({.mostFormats = 1500});
  EXPECT_GT(found.rated, 300u);
  std::set<std::string> known;
  for (const PredictedFormat &format : found.formats)
    EXPECT_TRUE(known.insert(printIr(format.candidate.format)).second) << printIr(format.candidate.format);
  const auto seeds =
      *predictFormats({dag_}, candidatesFor(6, {.visible = true}), rays_, defaultSpeedModel("cpu"), {});
  Frontier ofSeeds(1e6), ofAll(1e6);
  for (const PredictedFormat &format : seeds)
    ofSeeds.add({static_cast<double>(format.bytes()), format.time()});
  for (const PredictedFormat &format : found.formats)
    ofAll.add({static_cast<double>(format.bytes()), format.time()});
  EXPECT_GT(ofAll.area(), ofSeeds.area());
}

TEST_F(AcquisitionTest, ExploringIsTheSameEachTime) {
  const Explored first = explored({.mostFormats = 400}), second = explored({.mostFormats = 400});
  ASSERT_EQ(first.formats.size(), second.formats.size());
  for (std::size_t i = 0; i < first.formats.size(); ++i)
    EXPECT_EQ(first.formats[i].candidate.text, second.formats[i].candidate.text);
}

TEST_F(AcquisitionTest, FewMeasurementsFindTheFrontier) {
  Explored found = explored({.mostFormats = 1000});
  double largest = 0;
  for (const PredictedFormat &format : found.formats)
    largest = std::max(largest, static_cast<double>(format.bytes()));
  Frontier best(largest);
  for (const PredictedFormat &format : found.formats) {
    const auto times = timesOn(format);
    best.add({static_cast<double>(format.bytes()), (times[0] + times[1]) / 2});
  }
  const std::size_t all = found.formats.size();
  Acquisition acquisition(std::move(found.formats), defaultSpeedModel("cpu"), {.mostBytes = largest});
  std::size_t measured = 0;
  for (auto batch = acquisition.next(4, 0.0005); !batch.empty(); batch = acquisition.next(4, 0.0005)) {
    for (const std::size_t i : batch) {
      ASSERT_TRUE(acquisition.isOpen(i));
      acquisition.take(i, timesOn(acquisition.formats()[i]));
      ++measured;
    }
    acquisition.learn();
  }
  EXPECT_GE(acquisition.frontier().area(), 0.98 * best.area());
  EXPECT_LT(measured, all / 2);
}

TEST_F(AcquisitionTest, WhatIsDroppedIsNotAskedForAgain) {
  Acquisition acquisition(explored({.mostFormats = 100}).formats, defaultSpeedModel("cpu"),
                          {.mostBytes = 1e9});
  const auto first = acquisition.next(1, 0);
  ASSERT_EQ(first.size(), 1u);
  acquisition.drop(first[0]);
  const auto rest = acquisition.next(1000, 0);
  EXPECT_EQ(std::ranges::count(rest, first[0]), 0);
}

TEST_F(AcquisitionTest, TheGraphIsASourceOfTheSameVoxels) {
  const auto source = makeSceneSource(colours_, {64, 64, 64}, {});
  const auto terrain = *makeBuiltinSource("terrain", 64);
  std::vector<std::uint32_t> mine(512), theirs(512);
  for (int z = 0; z < 64; z += 8)
    for (int y = 0; y < 64; y += 8)
      for (int x = 0; x < 64; x += 8) {
        const Cube cube{{x, y, z}, 3};
        ASSERT_TRUE(source->read(cube, mine.data()));
        ASSERT_TRUE(terrain->read(cube, theirs.data()));
        EXPECT_EQ(mine, theirs);
        EXPECT_EQ(source->empty(cube),
                  std::ranges::all_of(mine, [](std::uint32_t word) { return word == 0; }));
      }
  EXPECT_FALSE(source->empty({{0, 0, 0}, 9}));
  EXPECT_TRUE(source->empty({{512, 0, 0}, 9}));
}

} // namespace
} // namespace voxc
