// Kernels by choices that no format leads to, from the text of a plan: all hit what those that passes choose
// do.
#include "testing/HardScenes.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Oracle/VerifyRays.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Trace/Tracer.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voxc {
namespace {

struct OtherChoice {
  const char *name;
  void (*make)(Plan &plan);
};

constexpr OtherChoice kOtherChoices[] = {
    {"speculative", [](Plan &plan) { plan.speculative = !plan.speculative; }},
    {"span-faces",
     [](Plan &plan) {
       plan.spanFaces = plan.spanFaces == SpanFaces::Step ? SpanFaces::Lookup : SpanFaces::Step;
     }},
    {"compare",
     [](Plan &plan) { plan.compare = plan.compare == Compare::Bits ? Compare::Numbers : Compare::Bits; }},
    {"packet-width",
     [](Plan &plan) {
       plan.packetWidth = plan.packetWidth == PacketWidth::Wide ? PacketWidth::Narrow : PacketWidth::Wide;
     }},
    {"defers-values", [](Plan &plan) { plan.defersValues = !plan.defersValues; }},
    {"reads-values",
     [](Plan &plan) { plan.traversals.back().readsValues = !plan.traversals.back().readsValues; }},
    {"voxel-steps",
     [](Plan &plan) { plan.traversals.back().voxelSteps = !plan.traversals.back().voxelSteps; }},
};

struct Place {
  const char *format;
  std::vector<std::string> passes;
  const char *query = "closest";
};

using Hits = std::vector<Hit>;
/// Compiles a plan and traces with it.
using TraceBy = std::function<Expected<Hits>(const Plan &)>;

class PlannedKernels : public ::testing::TestWithParam<Place> {
protected:
  void SetUp() override {
    format_ = parseFormat(GetParam().format);
    ASSERT_TRUE(format_);
    ASSERT_TRUE(runPasses(*format_, GetParam().passes));
    format_->setAttribute(kQueryAttribute, GetParam().query);
    const auto scenes = test::hardScenes(format_->extent());
    auto built = Constructor::compile(*format_)->build(*scenes.back().source());
    ASSERT_TRUE(built) << built.error().message;
    volume_ = std::make_unique<Volume>(std::move(built->volume));
    rays_ = verifyRays(format_->extent(), 4000, 41);
  }

  Expected<Hits> traced(Expected<std::unique_ptr<Tracer>> tracer) const {
    if (!tracer)
      return tracer.error();
    Hits hits(rays_.size());
    if (const auto report = (*tracer)->trace(rays_, hits); !report)
      return report.error();
    return hits;
  }

  /// The kernel of each other choice that the rules leave, read back from its text, hits the same.
  void expectTheSameHits(const PlanOptions &options, const TraceBy &trace) const {
    const Plan chosen = *makePlan(*format_, options);
    const Expected<Hits> expected = trace(chosen);
    ASSERT_TRUE(expected) << expected.error().message;
    for (const OtherChoice &choice : kOtherChoices) {
      Plan other = chosen;
      choice.make(other);
      const Expected<Plan> read = parseFinishedPlan(printPlan(other), choice.name);
      if (!read)
        continue; // The rules leave no choice here.
      ++tried_;
      const Expected<Hits> hits = trace(*read);
      ASSERT_TRUE(hits) << choice.name << ": " << hits.error().message;
      EXPECT_EQ(std::memcmp(hits->data(), expected->data(), rays_.size() * sizeof(Hit)), 0)
          << printPlan(other);
    }
  }

  Expected<Format> format_ = Error::input("");
  std::unique_ptr<Volume> volume_;
  std::vector<Ray> rays_;
  mutable int tried_ = 0;
};

/// Those of this processor take seconds to compile.
class PlannedCpuKernels : public PlannedKernels {};

TEST_P(PlannedCpuKernels, HitTheSame) {
  expectTheSameHits(kCpuPlan, [&](const Plan &plan) -> Expected<Hits> {
    const Expected<CpuKernel> kernel = compileCpuKernel(plan, {.start = CpuStart::Fast});
    return kernel ? traced(createCpuTracer(*kernel, *volume_, 2)) : kernel.error();
  });
  EXPECT_GT(tried_, 1);
}

TEST_P(PlannedKernels, HitTheSame) {
  auto device = Device::open("llvmpipe");
  if (!device)
    GTEST_SKIP() << "there is no llvmpipe device";
  const DeviceInfo &info = device->info();
  expectTheSameHits({.loops = info.loops, .arithmetic = info.arithmetic},
                    [&](const Plan &plan) -> Expected<Hits> {
                      const Expected<Kernel> kernel = compileKernel(plan);
                      return kernel ? traced(createTracer(*device, *kernel, *volume_)) : kernel.error();
                    });
  EXPECT_GT(tried_, 1);
}

const Place kDirect = {"D(3^3, 15) M(2^3)", {"octant-distances", "direct-traversal"}};
const Place kApart = {"R(2^3) M(3^3)", {"values-apart"}};

INSTANTIATE_TEST_SUITE_P(Places, PlannedCpuKernels, ::testing::Values(kDirect, kApart));
INSTANTIATE_TEST_SUITE_P(Places, PlannedKernels,
                         ::testing::Values(kDirect, kApart, Place{"R(1^3) G(2) M(2^3)", {"direct-traversal"}},
                                           Place{"H(2^3) R(2^3)", {}}, Place{"R(2^3) G(3)", {}, "any"}));

} // namespace
} // namespace voxc
