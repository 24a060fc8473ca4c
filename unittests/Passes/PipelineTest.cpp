// The manager of passes, over either IR.
#include "voxc/Passes/Pass.h"
#include "voxc/Plan/Plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voxc {

/// An IR that is a word.
struct Letters {
  std::string text;
  bool operator==(const Letters &) const = default;
};

template <> struct IrTraits<Letters> {
  static constexpr std::string_view kName = "word";
  static void verify(const Letters &ir, Diagnostics &diagnostics) {
    if (ir.text.empty())
      diagnostics.error({}, "it has no letter");
  }
  static std::string print(const Letters &ir) { return ir.text; }
  static std::vector<SourceRange> changedParts(const Letters &, const Letters &after) {
    return {{0, after.text.size()}};
  }
  static Error errorAt(const Letters &ir, const Diagnostics &diagnostics) {
    return toError(diagnostics, ir.text, "word");
  }
};

namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Names = std::vector<std::string>;

PassManager<Letters> doubleThenDrop() {
  PassManager<Letters> manager;
  manager.add("double", [](Letters &ir, Diagnostics &) { ir.text += ir.text; });
  manager.add("keep", [](Letters &, Diagnostics &diagnostics) { diagnostics.note({}, "all is well"); });
  manager.add("drop", [](Letters &ir, Diagnostics &) { ir.text.clear(); });
  manager.add("never", [](Letters &ir, Diagnostics &) { ir.text = "never"; });
  return manager;
}

TEST(PassManager, TellsWhatEachPassDoes) {
  Names lines;
  PipelineOptions options{.verifyEach = false};
  options.beforeEach = [&](std::string_view pass, PrintedIr ir) {
    lines.push_back("before " + std::string(pass) + " " + ir());
    return pass != "never";
  };
  options.afterEach = [&](const PassReport &report, PrintedIr ir) {
    lines.push_back("after " + std::string(report.pass) + " " + ir() + (report.changed ? "" : report.why) +
                    std::to_string(report.changedParts.size()));
  };
  Letters ir{"a"};
  ASSERT_TRUE(doubleThenDrop().run(ir, options));
  EXPECT_THAT(lines,
              ElementsAre("before double a", "after double aa1", "before keep aa",
                          "after keep aaall is well0", "before drop aa", "after drop 1", "before never "));
}

TEST(PassManager, StopsAtTheFirstWrongIr) {
  Letters ir{"a"};
  std::size_t errors = 0;
  PipelineOptions options;
  options.onErrors = [&](const Diagnostics &diagnostics) { errors += diagnostics.all().size(); };
  const auto passed = doubleThenDrop().run(ir, options);
  ASSERT_FALSE(passed);
  EXPECT_EQ(passed.error().message, "the pass drop left a wrong word, a defect of voxc: it has no letter");
  EXPECT_EQ(passed.error().kind, ErrorKind::Environment);
  EXPECT_EQ(errors, 1u);
  EXPECT_EQ(ir.text, "");
}

TEST(PassManager, StopsAtAnErrorOfAPassAndTellsItsPlace) {
  PassManager<Letters> manager;
  manager.add("refuse", [](Letters &, Diagnostics &diagnostics) { diagnostics.error({1, 2}, "no b"); });
  manager.add("never", [](Letters &ir, Diagnostics &) { ir.text = "never"; });
  Letters ir{"abc"};
  const auto passed = manager.run(ir, {});
  ASSERT_FALSE(passed);
  EXPECT_EQ(passed.error().message, "word:1:2: error: no b\n  abc\n   ^");
  EXPECT_EQ(ir.text, "abc");
}

TEST(PassText, HasTheNumberOfAPassByItsName) {
  EXPECT_EQ(*passText("merge-grids"), "merge-grids");
  EXPECT_EQ(*passText("merge-grids{}"), "merge-grids");
  EXPECT_EQ(*passText("palette"), "palette{bits=8}");
  EXPECT_EQ(*passText("palette{}"), "palette{bits=8}");
  EXPECT_EQ(*passText("palette=4"), "palette{bits=4}");
  EXPECT_EQ(*passText(*passText("palette=4")), "palette{bits=4}");
}

TEST(PassText, IsRefusedWithWhatWouldBeRight) {
  const auto problemOf = [](const char *text) { return passText(text).error().message; };
  EXPECT_THAT(problemOf("palette{bit=4}"), HasSubstr("takes the option bits=N, found 'bit=4'"));
  EXPECT_THAT(problemOf("palette{bits}"), HasSubstr("takes the option bits=N, found 'bits'"));
  EXPECT_THAT(problemOf("palette{bits=4"), HasSubstr("'{bits=4' has no '}'"));
  EXPECT_THAT(problemOf("palette{bits=40}"), HasSubstr("takes a number from 1 to 16, not '40'"));
  EXPECT_THAT(problemOf("palette{bits=4 deep=2}"), HasSubstr("not '4 deep=2'"));
  EXPECT_THAT(problemOf("occupancy{bits=4}"), HasSubstr("takes no options, found 'bits=4'"));
  EXPECT_THAT(problemOf("occupancy=4"), HasSubstr("takes no number, found '4'"));
  EXPECT_THAT(problemOf("pallete{bits=4}"), HasSubstr("is no pass; the passes are"));
}

TEST(PlanPipeline, RunsThosePassesThatAreGiven) {
  const Format format = *parseFormat("R(1^3) G(0) M(2^3) M(2^3)");
  Names run;
  PipelineOptions options;
  options.afterEach = [&](const PassReport &report, PrintedIr) { run.emplace_back(report.pass); };
  std::optional<Plan> plan = lowerToPlan(format, {}, options);
  ASSERT_TRUE(plan);
  const PlanPass *const chosen[] = {findPlanPass("choose-descents"), findPlanPass("choose-traversal")};
  ASSERT_TRUE(runPlanPasses(*plan, chosen, options));
  EXPECT_THAT(run, ElementsAre("lower", "choose-descents", "choose-traversal"));
  EXPECT_EQ(plan->traversals[1].descent, Descent::Single);
  EXPECT_EQ(findPlanPass("lower"), nullptr);
}

} // namespace
} // namespace voxc
