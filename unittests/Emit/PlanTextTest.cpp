// Code of plans that nobody made but whoever wrote their text: what is finished is printed, whole.
#include "TestLength.h"

#include "testing/RandomFormat.h"
#include "voxc/Emit/Emit.h"
#include "voxc/Plan/Plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace voxc {
namespace {

/// True if a template has left a hole, or an error about itself.
bool isBroken(std::string_view code) {
  if (code.find("${") != std::string_view::npos)
    return true;
  constexpr std::string_view kError = "#error ";
  constexpr std::string_view kAsked[] = {"#error define ", "#error \"two "}; // Of who uses a header wrongly.
  for (std::size_t at = code.find(kError); at != std::string_view::npos; at = code.find(kError, at + 1))
    if (std::ranges::none_of(kAsked, [&](std::string_view own) { return code.substr(at).starts_with(own); }))
      return true;
  return false;
}

/// How many targets a plan is printed for; construction is one.
int expectWholeCode(const Plan &plan) {
  int printed = 1;
  EXPECT_FALSE(isBroken(emitConstruct(plan))) << printPlan(plan);
  const auto expectWhole = [&](EmitTarget target, auto print) {
    if (!problemOf(plan, target).empty())
      return;
    ++printed;
    EXPECT_FALSE(isBroken(print())) << printPlan(plan);
  };
  expectWhole(EmitTarget::Device, [&] { return emitIntersect(plan); });
  expectWhole(EmitTarget::Processor, [&] { return emitIntersectCpp(plan, "kernel"); });
  expectWhole(EmitTarget::Functions, [&] { return emitHeader(plan, "name"); });
  expectWhole(EmitTarget::FirstHits, [&] { return emitHeader(plan, "name", HeaderLanguage::GlslEs); });
  return printed;
}

std::string changedText(std::mt19937 &random, std::string text) {
  for (int changes = test::pick(random, 1, 2); changes > 0; --changes) {
    const std::size_t at = random() % text.size();
    if (random() % 2)
      text.erase(at, 1 + random() % 12);
    else
      text.insert(at, 1, "0123456789()=,x {}\"\\"[random() % 20]);
  }
  return text;
}

TEST(PlanCode, IsWholeForEachFinishedPlan) {
  std::mt19937 random(41);
  const PlanOptions targets[] = {{}, kCpuPlan, kHeaderPlan};
  int finished = 0;
  for (int i = 0; i < test::rounds(400); ++i) {
    const Format format = test::randomFormat(random, 5);
    const std::string text = printPlan(*makePlan(format, targets[random() % 3]));
    const auto plan = parseFinishedPlan(random() % 8 == 0 ? text : changedText(random, text), "plan");
    finished += plan ? expectWholeCode(*plan) > 1 : 0;
  }
  EXPECT_GT(finished, test::rounds(400) / 16);
}

TEST(PlanCode, IsForTheTargetThatThePlanWasMadeFor) {
  const Format format = *parseFormat("R(2^3) G(3)");
  const EmitTarget targets[] = {EmitTarget::Device, EmitTarget::Processor, EmitTarget::Functions,
                                EmitTarget::FirstHits};
  const PlanOptions options[] = {{}, kCpuPlan, kHeaderPlan, kFirstHitPlan};
  for (std::size_t i = 0; i < std::size(targets); ++i)
    EXPECT_EQ(problemOf(*makePlan(format, options[i]), targets[i]), "") << i;
  EXPECT_EQ(problemOf(*makePlan(format), EmitTarget::Processor),
            "a kernel for this processor would be printed of a plan with packing=packets, loops=whole");
  EXPECT_NE(problemOf(*makePlan(format, kCpuPlan), EmitTarget::Device), "");
  EXPECT_NE(problemOf(*makePlan(format, kFirstHitPlan), EmitTarget::Functions), "") << "without bounds";
}

} // namespace
} // namespace voxc
