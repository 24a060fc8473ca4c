// Text to a tree and back: the same text, whatever the language can say.
#include "Glsl/Parse.h"
#include "Glsl/Print.h"

#include <gtest/gtest.h>

namespace voxc::glsl {
namespace {

std::string again(std::string_view text) {
  const auto module = parse(text);
  return module ? print(*module) : module.error().message;
}

void expectSame(std::string_view text) { EXPECT_EQ(again(text), text); }

TEST(RoundTrip, KeepsDeclarations) {
  expectSame("#version 460\n"
             "\n"
             "// Voxels along each axis.\n"
             "const ivec3 VOLUME_SIZE = ivec3(64, 64, 8);\n"
             "layout(local_size_x = 64) in;\n"
             "layout(constant_id = 2) const bool COUNT_WORDS = false;\n"
             "uint words_read = 0u;\n"
             "layout(std430, set = 0, binding = 0) readonly restrict buffer Words { uint words[]; };\n"
             "shared uint path[DEPTH + 1][gl_WorkGroupSize.x];\n"
             "\n"
             "struct Gap {\n"
             "  int log2_side;\n"
             "  int count; // Along an axis.\n"
             "};\n");
}

TEST(RoundTrip, KeepsStatements) {
  expectSame("uint found(uint node, out bool leaf) {\n"
             "  uint path[4], high = 0u;\n"
             "  precise float t = 1.5f;\n"
             "  for (int i = 0; i < 4; i++)\n"
             "    path[i] = node;\n"
             "  for (;;) {\n"
             "    // Down.\n"
             "    while (node != 0u && !leaf)\n"
             "      node = child(node, leaf); // Of one.\n"
             "    if (node == 0u)\n"
             "      break;\n"
             "    else if (leaf)\n"
             "      return node;\n"
             "    else {\n"
             "      high++;\n"
             "      continue;\n"
             "    }\n"
             "  }\n"
             "\n"
             "  return high;\n"
             "}\n");
}

TEST(RoundTrip, KeepsExpressions) {
  expectSame("int f(int a) { return a + (a & 3) * ~a << (a > 0 ? -a : a >= 7 ? 1 : 0) | v.xy[a % 2].x ^ g(a, "
             "0x7fu); }\n"
             "void g(inout Traversal traversal) { traversal.cell.x |= traversal.steps >> 31; }\n"
             "float h() { return 1e-30f + 2.5e3 - x; }\n");
}

/// Where a comment belongs to nothing, it stays where it is.
TEST(RoundTrip, KeepsComments) {
  expectSame("// Of the file.\n"
             "\n"
             "// Of a number.\n"
             "const int A = 1; // One.\n"
             "\n"
             "// Behind all.\n");
}

TEST(RoundTrip, PutsAFunctionInALineIfItFits) {
  EXPECT_EQ(again("int f() {\n  return 1;\n}\n"), "int f() { return 1; }\n");
  EXPECT_EQ(again("int f() {\n  return 1; // Why.\n}\n"), "int f() {\n  return 1; // Why.\n}\n");
}

TEST(RoundTrip, FillsCommentsThatAreTooLong) {
  const std::string longOne(100, 'a');
  EXPECT_EQ(again("// " + longOne + " and a few words more than fit.\n// The rest.\n//     code\nint a;\n"),
            "// " + longOne + " and a few words\n// more than fit. The rest.\n//     code\nint a;\n");
}

/// Parentheses that a pass has not put there are put by the printer.
TEST(RoundTrip, PutsParenthesesWhereTheyAreNeeded) {
  using Kind = Expression::Kind;
  const Expression a = {Kind::Name, "a"}, sum = {Kind::Binary, "+", {a, a}};
  EXPECT_EQ(print(Expression{Kind::Binary, "*", {sum, a}}), "(a + a) * a");
  EXPECT_EQ(print(Expression{Kind::Binary, "-", {a, sum}}), "a - (a + a)");
  EXPECT_EQ(print(Expression{Kind::Binary, "-", {sum, a}}), "a + a - a");
  EXPECT_EQ(print(Expression{Kind::Member, "x", {sum}}), "(a + a).x");
  EXPECT_EQ(print(Expression{Kind::Prefix, "-", {sum}}), "-(a + a)");
}

TEST(RoundTrip, SaysWhatIsWrong) {
  EXPECT_EQ(again("int f() {\n  return 1\n}\n"), "line 3: found '}' where ';' would be right");
  EXPECT_EQ(again("int f() { return 1; "), "line 1: found the end where a value would be right");
  EXPECT_EQ(again("int a = @;"), "line 1: found '@', which is no part of the language");
  EXPECT_EQ(again("int f(int) {}"), "line 1: found ')' where a name would be right");
  EXPECT_EQ(again("int a = 1 + // One.\n  2;\n"),
            "line 2: found '2' where a comment behind the end of a statement "
            "would be right");
}

} // namespace
} // namespace voxc::glsl
