// Passes, each on a few lines.
#include "PassTesting.h"

#include "Glsl/Verify.h"

#include <gtest/gtest.h>

namespace voxc::glsl {
namespace {

TEST(AddPrefix, IsForWhatStandsOutermost) {
  EXPECT_EQ(after("const int SIDE = 4; // SIDE of a cube.\n"
                  "struct Gap {\n  int count;\n};\n"
                  "int twice(int count) { return SIDE * count; }\n"
                  "int of(const Gap gap) { return twice(gap.count); }\n",
                  [](Module &module) { addPrefix(module, "p_"); }),
            "const int p_SIDE = 4; // SIDE of a cube.\n"
            "struct p_Gap {\n  int count;\n};\n"
            "int p_twice(int count) { return p_SIDE * count; }\n"
            "int p_of(const p_Gap gap) { return p_twice(gap.count); }\n");
}

TEST(AddPrefix, LeavesMembersAndVariablesOfFunctions) {
  EXPECT_EQ(after("struct Exit {\n  bool passed;\n};\n"
                  "bool passed(Exit e) { return e.passed; }\n"
                  "bool p_all(Exit e) {\n  bool passed = passed(e);\n  return passed;\n}\n",
                  [](Module &module) { addPrefix(module, "p_"); }),
            "struct p_Exit {\n  bool passed;\n};\n"
            "bool p_passed(p_Exit e) { return e.passed; }\n"
            "bool p_all(p_Exit e) {\n  bool passed = p_passed(e);\n  return passed;\n}\n");
}

TEST(AddParameter, GoesToAllThatNeedIt) {
  EXPECT_EQ(after("uint load(uint at) { return at; }\n"
                  "uint first() { return load(0u); }\n"
                  "uint sum(uint a, uint b) { return a + b; }\n"
                  "uint twice(uint a) { return sum(first(), first()) + min(a, 1u); }\n",
                  [](Module &module) { addParameter(module, "load", {Passing::In, "Words", "volume"}); }),
            "uint load(Words volume, uint at) { return at; }\n"
            "uint first(Words volume) { return load(volume, 0u); }\n"
            "uint sum(uint a, uint b) { return a + b; }\n"
            "uint twice(Words volume, uint a) { return sum(first(volume), first(volume)) + min(a, 1u); }\n");
}

std::string folded(std::string_view text) {
  return after(text,
               [](Module &module) { fold(module, {{"WIDE", "true"}, {"DEEP", "false"}, {"STRIDE", "1"}}); });
}

TEST(Fold, TakesTheBranchThatIsKnown) {
  EXPECT_EQ(folded("int f(int a) {\n"
                   "  // Why.\n"
                   "  if (WIDE && a > 1)\n    return 1;\n"
                   "  if (DEEP)\n    return 2;\n  else if (WIDE) {\n    a++;\n    return a;\n  }\n"
                   "  return 4;\n"
                   "}\n"),
            "int f(int a) {\n"
            "  // Why.\n"
            "  if (a > 1)\n    return 1;\n"
            "  a++;\n"
            "  return a;\n"
            "}\n");
}

TEST(Fold, TakesAwayWhatChangesNothing) {
  EXPECT_EQ(folded("int f(int a) { return a * STRIDE + (WIDE ? 2 : 3) - STRIDE; }"),
            "int f(int a) { return a + 1; }\n");
  EXPECT_EQ(folded("bool f(bool a) { return DEEP || !(WIDE && a == b); }"),
            "bool f(bool a) { return a != b; }\n");
  EXPECT_EQ(folded("int f(int a) { return 2 * 3 + a; }"),
            "int f(int a) { return 2 * 3 + a; }\n"); // As it is written.
}

/// An else stays with its if.
TEST(Fold, KeepsWhoseElseItIs) {
  EXPECT_EQ(folded("int f(bool a, bool b) {\n"
                   "  if (a)\n    if (WIDE) {\n      if (b)\n        return 1;\n    } else\n      return 2;\n"
                   "  else\n    return 3;\n"
                   "  return 4;\n"
                   "}\n"),
            "int f(bool a, bool b) {\n"
            "  if (a) {\n    if (b)\n      return 1;\n  } else\n    return 3;\n"
            "  return 4;\n"
            "}\n");
}

/// What is asked for is evaluated as before.
TEST(Fold, KeepsEffects) {
  EXPECT_EQ(folded("bool next(inout int a) { return a++ > 0; }\nbool f(int a) { return next(a) && DEEP; }\n"),
            "bool next(inout int a) { return a++ > 0; }\nbool f(int a) { return next(a) && false; }\n");
}

std::string dropped(std::string_view text) {
  return after(text, [](Module &module) { dropUnused(module, {"main", ".kept"}); });
}

TEST(DropUnused, LeavesWhatTheRootsComeTo) {
  EXPECT_EQ(dropped("const int A = 1;\nconst int B = 2;\n"
                    "struct Unused {\n  int a;\n};\n"
                    "int f(int a, int b) { return a + A; }\n"
                    "int g() { return B; }\n"
                    "void main() {\n  int unused = f(1, 2);\n  int a = f(3, 4);\n  a++;\n}\n"),
            "const int A = 1;\n"
            "int f(int a) { return a + A; }\n"
            "void main() {\n  int a = f(3);\n  a++;\n}\n");
}

TEST(DropUnused, LeavesMembersThatAreRead) {
  EXPECT_EQ(dropped("struct Traversal {\n  int cell;\n  int axis;\n  int kept;\n};\n"
                    "Traversal begin() { return Traversal(1, -1, 2); }\n"
                    "void main() {\n"
                    "  Traversal traversal = begin();\n"
                    "  traversal.axis = traversal.cell > 1 ? 1 : traversal.axis;\n"
                    "  traversal.kept = traversal.cell;\n"
                    "}\n"),
            "struct Traversal {\n  int cell;\n  int kept;\n};\n"
            "Traversal begin() { return Traversal(1, 2); }\n"
            "void main() {\n"
            "  Traversal traversal = begin();\n"
            "  traversal.kept = traversal.cell;\n"
            "}\n");
}

TEST(DropUnused, KeepsArgumentsThatDoMore) {
  const std::string text = "int next(inout int a) { return a++; }\n"
                           "int f(int unused) { return 1; }\n"
                           "void main() {\n  int a = 0;\n  a = f(next(a));\n}\n";
  EXPECT_EQ(dropped(text), text);
}

TEST(Unfold, EvaluatesNoMoreThanBefore) {
  EXPECT_EQ(after("bool step(inout int a) { return a++ > 1; }\n"
                  "bool f(inout int a) { return a > 0 && step(a); }\n"
                  "int g(bool b, inout int a) {\n  int c = b ? int(step(a)) : 2;\n  return c;\n}\n",
                  [](Module &module) {
                    EXPECT_TRUE(verify(module));
                    unfold(module, Unfolding::Effects);
                  }),
            "bool step(inout int a) { return a++ > 1; }\n"
            "bool f(inout int a) {\n  if (!(a > 0))\n    return false;\n  return step(a);\n}\n"
            "int g(bool b, inout int a) {\n"
            "  int c;\n"
            "  if (b)\n    c = int(step(a));\n  else\n    c = 2;\n"
            "  return c;\n"
            "}\n");
}

} // namespace
} // namespace voxc::glsl
