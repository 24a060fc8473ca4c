// Broken lines: they fit, and say the same.
#include "Glsl/Wrap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

namespace voxc::glsl {
namespace {

/// Without blanks and line ends, and without the marks of comments.
std::string contentOf(std::string_view text) {
  std::string content;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text.substr(i).starts_with("//"))
      ++i;
    else if (text[i] != ' ' && text[i] != '\n')
      content += text[i];
  return content;
}

std::size_t maxComponent(const std::string &text) {
  std::istringstream lines(text);
  std::size_t most = 0;
  for (std::string line; std::getline(lines, line);)
    most = std::max(most, line.size());
  return most;
}

std::string repeated(const std::string &part, int count) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += part;
  return text;
}

TEST(Wrap, ShortLinesStayAsTheyAre) {
  const std::string text = "int f(int a) { return a; }\n\n  int b = f(1); // One.\n// Two.\n";
  EXPECT_EQ(wrapped(text), text);
}

TEST(Wrap, LongLinesAreBrokenAndSayTheSame) {
  for (const std::string &line :
       {"int f(" + repeated("const int &name, ", 12) + "int last) {",
        "  x = " + repeated("(a * b) + ", 30) + "c;", "    return " + repeated("is_so(a) && ", 20) + "b;",
        "// " + repeated("word ", 60) + "end.", "  // " + repeated("word ", 60) + "end.",
        "int g(" + repeated("int a, ", 8) + "int b) { return " + repeated("value(a) + ", 6) + "b; }"}) {
    const std::string text = wrapped(line + "\n");
    EXPECT_LE(maxComponent(text), 120u) << text;
    EXPECT_GT(std::ranges::count(text, '\n'), 1) << text;
    EXPECT_EQ(contentOf(text), contentOf(line));
  }
}

TEST(Wrap, CommentsBehindCodeGoAbove) {
  const std::string code = "  float t = " + repeated("lesser(a, b) + ", 6) + "c;";
  EXPECT_EQ(wrapped(code + " // Of negative ones, none.\n"), "  // Of negative ones, none.\n" + code + "\n");
  const std::string comment = wrapped("  // " + repeated("word ", 60) + "\n");
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.starts_with("  // ")) << line;
}

TEST(Wrap, LinesOfThePreprocessorStay) {
  const std::string text =
      "#define LONG(a, b) " + repeated("a + b + ", 30) + "\\\n  " + repeated("b, ", 60) + "\n";
  EXPECT_EQ(wrapped(text), text);
}

} // namespace
} // namespace voxc::glsl
