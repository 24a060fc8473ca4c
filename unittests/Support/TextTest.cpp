// Words, lines and numbers of text.
#include "Support/Text.h"
#include "voxc/Support/ShellWord.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace voxc {
namespace {

TEST(Text, Numbers) {
  EXPECT_EQ(parseNumber("0.1"), 0.1);
  EXPECT_EQ(parseNumber("+1e3"), 1000.0);
  EXPECT_EQ(parseNumber("-.5"), -0.5);
  EXPECT_EQ(parseNumber("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parseNumber("-1e999"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(parseNumber("1e-999"), 0.0);
  EXPECT_TRUE(std::isnan(*parseNumber("nan")));
  for (const char *word : {"", "+", "-", "+-1", "1x", "0x10", "1,5", "e5"})
    EXPECT_FALSE(parseNumber(word)) << word;
}

TEST(Text, WholeNumbers) {
  EXPECT_EQ(parseInteger("-7"), -7);
  EXPECT_EQ(parseInteger("+7"), 7);
  for (const char *word : {"", "1.0", "99999999999999999999", "7/8"})
    EXPECT_FALSE(parseInteger(word)) << word;
}

TEST(Text, Counts) {
  EXPECT_EQ(counted(0, "point"), "0 points");
  EXPECT_EQ(counted(1, "point"), "1 point");
  EXPECT_EQ(countedAre(1, "page"), "1 page is");
  EXPECT_EQ(countedAre(12, "page"), "12 pages are");
}

TEST(Text, Words) {
  std::string_view text = "  a\tbc\r\n d";
  EXPECT_EQ(takeWord(text), "a");
  EXPECT_EQ(takeWord(text), "bc");
  EXPECT_EQ(takeWord(text), "d");
  EXPECT_EQ(takeWord(text), "");
  EXPECT_EQ(trimmed(" a b \r"), "a b");
  EXPECT_EQ(trimmed(" \t"), "");
}

TEST(Text, WordsOfAShellAreQuoted) {
  EXPECT_EQ(shellWord("/a/b-1.hvx"), "/a/b-1.hvx");
  EXPECT_EQ(shellWord("a b.hvx"), "'a b.hvx'");
  EXPECT_EQ(shellWord("it's"), "'it'\\''s'");
  EXPECT_EQ(shellWord(""), "''");
}

TEST(Text, Lines) {
  TextLines lines("a\r\nb \\\nc\\\r\n d\n\nlast\\");
  std::vector<std::string> all;
  std::vector<std::uint64_t> numbers;
  while (const auto line = lines.next()) {
    all.emplace_back(*line);
    numbers.push_back(lines.number());
  }
  EXPECT_EQ(all, (std::vector<std::string>{"a", "b  c  d", "", "last "}));
  EXPECT_EQ(numbers, (std::vector<std::uint64_t>{1, 4, 5, 6}));
}

} // namespace
} // namespace voxc
