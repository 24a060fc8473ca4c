// Simulated costs are those of kernels: look-ups as they count them, words nearly so.
#include "testing/RandomFormat.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Search/RayCostModel.h"
#include "voxc/Source/Sources.h"
#include "voxc/Trace/CpuKernel.h"

#include <gtest/gtest.h>

#include <random>

namespace voxc {
namespace {

constexpr int kLog2Side = 6;

/// From everywhere around and inside, to everywhere.
std::vector<Ray> raysOf(int count) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-20, 84);
  std::vector<Ray> rays;
  for (int i = 0; i < count; ++i) {
    Ray ray{{place(random), place(random), place(random)}, {}};
    for (int axis = 0; axis < 3; ++axis)
      ray.direction[axis] = place(random) - ray.origin[axis];
    rays.push_back(ray);
  }
  return rays;
}

/// What a kernel of this processor counts, a ray.
double counted(const Format &format, const Volume &volume, std::span<const Ray> rays, bool words) {
  const auto kernel = compileCpuKernel(format, {.countWords = words});
  EXPECT_TRUE(kernel) << kernel.error().message;
  auto tracer = createCpuTracer(*kernel, volume, 1);
  std::vector<Hit> hits(rays.size());
  const auto report = (*tracer)->trace(rays, hits, {.countSteps = !words, .countWords = words});
  EXPECT_TRUE(report) << report.error().message;
  double sum = 0;
  for (const Hit &hit : hits)
    sum += hit.steps;
  return sum / static_cast<double>(hits.size());
}

struct Case {
  const char *format;
  std::vector<std::string> passes;
};

class RayCostModelTest : public testing::TestWithParam<Case> {};

TEST_P(RayCostModelTest, CountsWhatKernelsCount) {
  Format format = *parseFormat(GetParam().format);
  std::vector<std::string> passes = GetParam().passes;
  passes.insert(passes.begin(), "occupancy"); // No words of colours.
  ASSERT_TRUE(runPasses(format, passes));
  auto source = *makeBuiltinSource("terrain", 1 << kLog2Side);
  const auto constructor = Constructor::compile(format);
  ASSERT_TRUE(constructor) << constructor.error().message;
  const auto built = constructor->build(*source);
  ASSERT_TRUE(built) << built.error().message;
  const auto dag = SceneDag::build(*source, {});
  ASSERT_TRUE(dag) << dag.error().message;
  const auto rays = raysOf(1600);
  const auto plan = makePlan(format, kCpuPlan);
  ASSERT_TRUE(plan) << plan.error().message;
  const RayCost cost = modelRayCost(*dag, rays, *plan);
  const double lookups = counted(format, built->volume, rays, false);
  const double words = counted(format, built->volume, rays, true);
  EXPECT_NEAR(cost.lookups / lookups, 1, 0.001) << cost.lookups << " of " << lookups;
  // Kernels count a word again that they ask for twice in one look-up.
  EXPECT_NEAR(cost.words / words, 0.95, 0.15) << cost.words << " of " << words;
  EXPECT_GE(cost.waits, cost.turns);
  EXPECT_GE(cost.packetLayers, cost.layers);
  EXPECT_LE(cost.packetLayers, cost.layers * static_cast<double>(kSimulatedPacket));
  EXPECT_GE(cost.packetSwitches, cost.switches);
  EXPECT_LE(cost.packetSwitches, cost.switches * static_cast<double>(kSimulatedPacket));
  EXPECT_EQ(cost.packetTrees > 0, cost.layers > 0);
  EXPECT_LE(cost.lines, cost.words);
  EXPECT_EQ(cost.probes > 0, std::string(GetParam().format).find('H') != std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, RayCostModelTest,
    testing::Values(Case{"R(6^3)", {}}, Case{"R(3^3) R(3^3)", {}}, Case{"D(6^3, 6)", {}},
                    Case{"D(3^3, 6) D(3^3, 6)", {}}, Case{"D(3^3, 6) R(3^3)", {"df-packing"}},
                    Case{"D(4^3, 15) M(2^3)", {"octant-distances", "df-packing"}},
                    Case{"D(2^3, 15) M(2^3) M(2^3)", {"octant-distances", "df-packing"}}, Case{"G(6)", {}},
                    Case{"S(6)", {}}, Case{"R(3^3) G(3)", {}}, Case{"R(3^3) S(3)", {}},
                    Case{"G(4, 2) M(2^3)", {}}, Case{"G(6, 2)", {}}, Case{"G(6)", {"restart-sv"}},
                    Case{"S(2) G(4)", {"unroll-sv"}}, Case{"R(2^3) G(2) R(2^3)", {"direct-traversal"}},
                    Case{"D(3^3, 6) G(3)", {"direct-traversal"}}, Case{"R(2^3) H(4^3)", {}},
                    Case{"M(4^3) M(2^3)", {}}, Case{"M(3^3) R(3^3)", {}}, Case{"R(1^3) M(5^3)", {}},
                    Case{"R(3^3) D(3^3, 6)", {"flat-traversal"}},
                    Case{"R(2^3) M(2^3) M(2^3)", {"share-grids", "short-pointers"}},
                    Case{"M(2^3) M(2^3) M(2^3)", {"share-grids", "short-pointers", "octant-masks"}}),
    [](const auto &test) {
      std::string name = test.param.format;
      for (const std::string &pass : test.param.passes)
        name += "_" + pass;
      std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
      return name;
    });

} // namespace
} // namespace voxc
