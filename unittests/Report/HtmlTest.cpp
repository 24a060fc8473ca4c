// HTML as text, and figures as words.
#include "report/Html.h"

#include <gtest/gtest.h>

namespace voxc::report {
namespace {

TEST(Html, EscapesTextAndAttributes) {
  EXPECT_EQ(textTag("b", {{"title", "\"<&>"}}, "<script>&"),
            "<b title=\"&quot;&lt;&amp;&gt;\">&lt;script&gt;&amp;</b>");
  EXPECT_EQ(tag("td", {}, ""), "<td></td>");
}

TEST(Html, FillsTemplatesOnce) {
  const std::string text = fill("section/frontier.html", {{"content", "{{content}} {{other}}"}});
  EXPECT_NE(text.find("<div class=\"rounds\">{{content}} {{other}}</div>"), std::string::npos);
  EXPECT_EQ(fill("section/frontier.html", {}).find("{{"), std::string::npos);
  EXPECT_EQ(fill("no such file", {}), "");
}

TEST(Html, TellsNumbersWithThreeDigits) {
  EXPECT_EQ(numberText(0), "0");
  EXPECT_EQ(numberText(0.03124), "0.0312");
  EXPECT_EQ(numberText(4.7361), "4.74");
  EXPECT_EQ(numberText(99.95), "100.0");
  EXPECT_EQ(numberText(12345.6), "12346");
  EXPECT_EQ(numberText(1e300).size(), 301u);
}

TEST(Html, TellsCountsSizesAndShares) {
  EXPECT_EQ(countText(0), "0");
  EXPECT_EQ(countText(999), "999");
  EXPECT_EQ(countText(1440000), "1,440,000");
  EXPECT_EQ(bytesText(512), "512 B");
  EXPECT_EQ(bytesText(12.5 * 1024 * 1024), "12.5 MiB");
  EXPECT_EQ(bytesText(5e15), "4547 TiB");
  EXPECT_EQ(percentText(0.0234), "2.3 %");
  EXPECT_EQ(plural(1, "format"), "1 format");
  EXPECT_EQ(plural(1000, "format"), "1,000 formats");
}

} // namespace
} // namespace voxc::report
