// The order in which choices are written means nothing.
#include "voxc/Passes/Pass.h"

#include "TestLength.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace voxc {
namespace {

constexpr const char *kFormats[] = {"R(2^3) G(3)",          "G(5)",          "S(2) D(1^3, 3) G(2)",
                                    "R(1^3) M(2^3) M(2^3)", "M(2^3) M(2^3)", "D(3^3, 15) M(2^3)",
                                    "R(4^3) R(2^3)",        "H(3^3) M(2^3)", "D(5^3, 6)"};

/// Every choice, with the numbers of some.
std::vector<std::string> choices() {
  std::vector<std::string> names;
  for (const Pass &pass : passes()) {
    if (pass.rewrites)
      continue;
    names.emplace_back(pass.name);
    if (pass.number)
      names.push_back(std::string(pass.name) + "=" + std::to_string(pass.number->least + 4));
  }
  return names;
}

/// What passes make of a format: its text and its digest, or an error.
std::string outcomeOf(const char *text, const std::vector<std::string> &names) {
  Format format = *parseFormat(text);
  if (const auto passed = runPasses(format, names); !passed)
    return passed.error().message;
  return printIr(format) + std::to_string(storageDigest(format));
}

TEST(PassOrder, OfTwoChoicesMeansNothing) {
  const std::vector<std::string> names = choices();
  for (const char *format : kFormats)
    for (const std::string &a : names)
      for (const std::string &b : names)
        EXPECT_EQ(outcomeOf(format, {a, b}), outcomeOf(format, {b, a})) << format << " " << a << " " << b;
}

TEST(PassOrder, OfManyChoicesMeansNothing) {
  std::mt19937 random(41);
  const std::vector<std::string> all = choices();
  int applied = 0;
  for (int set = 0; set < 1000 * test::rounds(1); ++set) {
    const char *const format = kFormats[random() % std::size(kFormats)];
    std::vector<std::string> names;
    std::ranges::copy_if(all, std::back_inserter(names),
                         [&](const std::string &) { return random() % 5 == 0; });
    const std::string expected = outcomeOf(format, names);
    applied += expected.starts_with("format");
    for (int order = 0; order < 4; ++order) {
      std::ranges::shuffle(names, random);
      EXPECT_EQ(outcomeOf(format, names), expected) << format;
    }
  }
  EXPECT_GT(applied, 300);
}

TEST(PassOrder, RewritesKeepTheirs) {
  Format split = *parseFormat("R(4^3)"), back = split;
  ASSERT_TRUE(runPasses(split, std::vector<std::string>{"share-grids", "merge-grids", "split-grids"}));
  ASSERT_TRUE(runPasses(back, std::vector<std::string>{"share-grids", "split-grids", "merge-grids"}));
  EXPECT_EQ(printIr(split), "format {\n  level 1: raw(2, 2, 2)\n  level 2: raw(2, 2, 2) share=level\n}\n");
  EXPECT_EQ(printIr(back), "format {\n  level 1: raw(4, 4, 4)\n}\n");
}

TEST(PassOrder, WhatChangesNothingSaysWhy) {
  Format format = *parseFormat("R(1^3) G(4)");
  std::vector<std::string> missed;
  PipelineOptions options;
  options.afterEach = [&](const PassReport &report, PrintedIr) {
    if (!report.changed)
      missed.push_back(std::string(report.pass) + ": " + report.why);
  };
  for (const Pass &pass : passes())
    (void)runPasses(format, std::vector{std::string(pass.name)}, options); // Some are errors here.
  EXPECT_FALSE(missed.empty());
  for (const std::string &line : missed)
    EXPECT_GT(line.size(), line.find(": ") + 10) << line;
}

TEST(CanonicalFormat, SharingOnTheFirstLevelChangesNoDigest) {
  const auto shared =
      parseFormat("format { level 1: raw(2, 2, 2) share=level level 2: svdag(3) dedup=level }");
  const auto plain = parseFormat("format { level 1: raw(2, 2, 2) level 2: svdag(3) dedup=level }");
  const auto apart = parseFormat("format { level 1: raw(2, 2, 2) level 2: svdag(3) }");
  EXPECT_EQ(storageDigest(*shared), storageDigest(*plain));
  EXPECT_NE(storageDigest(*plain), storageDigest(*apart));
}

} // namespace
} // namespace voxc
