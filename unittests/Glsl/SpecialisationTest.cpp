// Passes that make a kernel for a plan out of leaves for all plans, each on a few lines.
#include "PassTesting.h"

#include "Glsl/Verify.h"

#include <gtest/gtest.h>

namespace voxc::glsl {
namespace {

std::string inlined(std::string_view text) {
  return after(text, [](Module &module) { inlineValues(module); });
}

TEST(InlineValues, PutsArgumentsInPlaceOfParameters) {
  EXPECT_EQ(inlined("INLINE uint place(uint begin, uint offset) { return begin + offset; }\n"
                    "uint f(uint a) { return place(a, a + 1u) * 2u; }\n"),
            "uint f(uint a) { return (a + a + 1u) * 2u; }\n");
}

TEST(InlineValues, KeepsVariablesThatAreCalledAsParameters) {
  EXPECT_EQ(inlined("INLINE uint less(uint a, uint b) { return a - b; }\n"
                    "uint f(uint a, uint b) { return less(b, a); }\n"),
            "uint f(uint a, uint b) { return b - a; }\n");
  EXPECT_EQ(inlined("INLINE uint less(uint a, uint b) { return a - b; }\n"
                    "uint f(uint a) { return less(a & 1u, a); }\n"),
            "uint f(uint a) { return (a & 1u) - a; }\n");
}

TEST(InlineValues, GoesOnWithWhatTookThePlace) {
  EXPECT_EQ(inlined("INLINE uint twice(uint a) { return 2u * a; }\n"
                    "INLINE uint same(uint a) { return a; }\n"
                    "uint f(uint a) { return same(twice(same(a))); }\n"),
            "uint f(uint a) { return 2u * a; }\n");
}

TEST(InlineValues, ComputesWithNumbers) {
  EXPECT_EQ(inlined("INLINE int upper(int a, int at) { return at < 2 ? a >> (2 - at) : a << (at - 2); }\n"
                    "int f(int a) { return upper(a, 0) | upper(a, 5) | upper(a, 2); }\n"),
            "int f(int a) { return a >> 2 | a << 3 | a; }\n");
}

std::string unrolled(std::string_view text) {
  return after(text, [](Module &module) { unroll(module, {{"DEPTH", "3"}}); });
}

TEST(Unroll, PutsTurnsOneBehindTheOther) {
  EXPECT_EQ(unrolled("int f(int a) {\n"
                     "  // Down.\n"
                     "  [[unroll]] for (int i = DEPTH - 1; i >= 0; i--)\n"
                     "    if (a > i)\n      a = a * i + DEPTH;\n"
                     "  return a;\n}\n"),
            "int f(int a) {\n"
            "  // Down.\n"
            "  if (a > 2)\n    a = a * 2 + DEPTH;\n"
            "  if (a > 1)\n    a = a + DEPTH;\n"
            "  if (a > 0)\n    a = a * 0 + DEPTH;\n"
            "  return a;\n}\n");
  EXPECT_EQ(unrolled("void f(inout int a) {\n  [[unroll]] for (int i = 0; i < 2; i++)\n    a += i;\n}\n"),
            "void f(inout int a) {\n  a += 0;\n  a += 1;\n}\n");
}

TEST(Unroll, LeavesLoopsThatCountOtherwise) {
  const std::string text =
      "int f(int a) {\n  [[unroll]] for (int i = 0; i < a; i++)\n    a--;\n  return a;\n}\n";
  EXPECT_EQ(unrolled(text), text);
  auto module = parse(text);
  ASSERT_TRUE(module);
  const auto verified = verify(*module);
  ASSERT_FALSE(verified);
  EXPECT_EQ(verified.error().message, "f: 'i < a' has no bounds that are numbers, in a loop to unroll");
}

TEST(ShareArrays, GivesEachInvocationAColumn) {
  EXPECT_EQ(after("// path[i] is a node.\n"
                  "uint seek_level_2(uint root) {\n"
                  "  uint path[DEPTH + 1];\n"
                  "  path[DEPTH] = root;\n"
                  "  return path[path[0]];\n}\n",
                  [](Module &module) { shareArrays(module, "path"); }),
            "// path[i] is a node.\n"
            "shared uint path_level_2[DEPTH + 1][gl_WorkGroupSize.x];\n"
            "\n"
            "uint seek_level_2(uint root) {\n"
            "  path_level_2[DEPTH][gl_LocalInvocationIndex] = root;\n"
            "  return path_level_2[path_level_2[0][gl_LocalInvocationIndex]][gl_LocalInvocationIndex];\n}\n");
}

TEST(Lead, PutsWhatItNeedsBeforeIt) {
  const std::string text = "struct Ray {\n  int ahead;\n};\n"
                           "const int FAR = 9;\n"
                           "int load(int at) { return at + FAR; }\n"
                           "// The format.\n"
                           "int f(const Ray ray) { return load(ray.ahead); }\n"
                           "// The rest.\n"
                           "int main() { return f(Ray(1)); }\n";
  EXPECT_EQ(after(text,
                  [](Module &module) {
                    for (Declaration &declaration : module.declarations)
                      declaration.leads = declaration.name == "f";
                    lead(module);
                  }),
            "struct Ray {\n  int ahead;\n};\n"
            "\n// What follows behind the format.\n"
            "int load(int at);\n"
            "// The format.\n"
            "int f(const Ray ray) { return load(ray.ahead); }\n"
            "const int FAR = 9;\n"
            "int load(int at) { return at + FAR; }\n"
            "// The rest.\n"
            "int main() { return f(Ray(1)); }\n");
}

std::string used(std::string_view text) {
  return after(text, [](Module &module) { dropUnused(module, {"main"}); });
}

TEST(DropUnused, TellsOverloadsApart) {
  EXPECT_EQ(used("int f(int a, int b) { return a + b; }\n"
                 "int f(int a) { return f(a, 1); }\n"
                 "int f(int a, int b, int c) { return a + b + c; }\n"
                 "int main(int a) { return f(a); }\n"),
            "int f(int a, int b) { return a + b; }\n"
            "int f(int a) { return f(a, 1); }\n"
            "int main(int a) { return f(a); }\n");
}

TEST(DropUnused, TakesAwayParametersThatAreOnlyHandedOn) {
  EXPECT_EQ(used("void g(inout int a, int b, inout int unread) { a += b; }\n"
                 "void f(inout int a, inout int unread) { g(a, 1, unread); }\n"
                 "int main(int a) {\n  int unread = 0;\n  f(a, unread);\n  return a;\n}\n"),
            "void g(inout int a, int b) { a += b; }\n"
            "void f(inout int a) { g(a, 1); }\n"
            "int main(int a) {\n  f(a);\n  return a;\n}\n");
}

TEST(DropUnused, TakesAwayCallsThatDoNothing) {
  EXPECT_EQ(used("void g(inout int a) {}\n"
                 "void f(inout int a) { g(a); }\n"
                 "int main(int a) {\n  f(a);\n  barrier();\n  return a;\n}\n"),
            "int main(int a) {\n  barrier();\n  return a;\n}\n");
}

TEST(DropUnused, KeepsCallsThatWriteWhatStandsElsewhere) {
  const std::string text = "void store(int a) { hit_words[a] = 1u; }\n"
                           "void count() { words_read++; }\n"
                           "void main(int a) {\n  store(a);\n  count();\n}\n";
  EXPECT_EQ(used(text), text);
}

std::string foldedAlike(std::string_view text) {
  return after(text, [](Module &module) { fold(module, {{"ALIKE", "true"}, {"COUNTS", "false"}}); });
}

TEST(Fold, ReturnsWhatWasOnlyNamed) {
  EXPECT_EQ(foldedAlike("int f(int a) {\n  int b = a; // Why.\n  if (COUNTS)\n    b++;\n  return b;\n}\n"),
            "int f(int a) {\n  return a; // Why.\n}\n");
  EXPECT_EQ(foldedAlike("int f(int a) {\n  int b = a;\n  return a;\n}\n"),
            "int f(int a) {\n  int b = a;\n  return a;\n}\n");
}

TEST(Fold, ChoosesNothingBetweenZeroAndZero) {
  EXPECT_EQ(foldedAlike("uint f(uint a) { return a == 0u ? 0u : ALIKE ? a : 1u; }\n"),
            "uint f(uint a) { return a; }\n");
  const std::string other = "uint f(uint a) { return a == 0u ? 1u : a; }\n";
  EXPECT_EQ(foldedAlike(other), other);
}

TEST(Fold, TakesBracesFromWhatShrank) {
  EXPECT_EQ(foldedAlike("int f(int a) {\n  if (a > 0) {\n    if (COUNTS)\n      a++;\n    return a;\n  }\n  "
                        "return 0;\n}\n"),
            "int f(int a) {\n  if (a > 0)\n    return a;\n  return 0;\n}\n");
  const std::string braced = "int f(int a) {\n  if (a > 0) {\n    return a;\n  }\n  return 0;\n}\n";
  EXPECT_EQ(foldedAlike(braced), braced);
}

} // namespace
} // namespace voxc::glsl
