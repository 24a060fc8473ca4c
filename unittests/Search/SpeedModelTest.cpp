// Models of speed: they are found from what they make, keep to their prior where nothing is known, and are
// never below 0.
#include "voxc/Search/SpeedModel.h"

#include <gtest/gtest.h>

#include <random>

namespace voxc {
namespace {

RayCost randomCost(std::mt19937 &random) {
  std::uniform_real_distribution<double> some(1, 20);
  RayCost cost;
  cost.turns = some(random);
  cost.waits = cost.turns * (1 + some(random) / 10);
  cost.words = some(random);
  cost.layers = some(random);
  cost.marches = some(random);
  cost.switches = some(random);
  cost.lines = some(random);
  cost.packetLayers = cost.layers * (1 + some(random) / 10);
  cost.packetTrees = some(random);
  cost.packetSwitches = cost.switches * (1 + some(random) / 10);
  cost.colours = some(random) / 20;
  cost.levels = 1 + random() % 4;
  cost.probes = some(random);
  cost.binned = random() % 2;
  return cost;
}

std::vector<SpeedSample> samplesOf(const SpeedModel &model, int count) {
  std::mt19937 random(5);
  std::vector<SpeedSample> samples;
  for (int i = 0; i < count; ++i) {
    const SpeedTerms terms = speedTerms(randomCost(random), std::uint64_t{1} << (12 + i % 16));
    samples.push_back({terms, model.predict(terms)});
  }
  return samples;
}

TEST(SpeedModel, FindsTheModelThatMadeTheSamples) {
  const SpeedModel made = defaultSpeedModel("cpu");
  const SpeedModel found = fitSpeedModel(samplesOf(made, 200));
  for (const SpeedSample &sample : samplesOf(made, 50))
    EXPECT_NEAR(found.predict(sample.terms) / sample.nanoseconds, 1, 0.01);
}

TEST(SpeedModel, KeepsToItsPriorWithoutSamples) {
  const SpeedModel &prior = defaultSpeedModel("llvmpipe");
  const SpeedModel found = fitSpeedModel({}, prior);
  for (std::size_t i = 0; i < kSpeedTerms; ++i)
    EXPECT_NEAR(found.nanoseconds[i], prior.nanoseconds[i], 1e-9);
}

TEST(SpeedModel, FewSamplesMoveThePrior) {
  SpeedModel twice = defaultSpeedModel("cpu");
  for (double &part : twice.nanoseconds)
    part *= 2;
  const SpeedModel found = fitSpeedModel(samplesOf(twice, 8), defaultSpeedModel("cpu"));
  for (const SpeedSample &sample : samplesOf(twice, 8))
    EXPECT_NEAR(found.predict(sample.terms) / sample.nanoseconds, 1, 0.1);
}

TEST(SpeedModel, NoPartIsBelowZero) {
  std::vector<SpeedSample> samples = samplesOf(defaultSpeedModel("cpu"), 40);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i].nanoseconds *= i % 2 == 0 ? 0.3 : 3;
  for (const double part : fitSpeedModel(samples).nanoseconds)
    EXPECT_GE(part, 0);
}

} // namespace
} // namespace voxc
