// Names and types: what fits passes, and what does not is said.
#include "Glsl/Verify.h"
#include "Glsl/Parse.h"

#include <gtest/gtest.h>

namespace voxc::glsl {
namespace {

std::string problemOf(std::string_view text) {
  static constexpr External kExternals[] = {{"load", "uint"}};
  auto module = parse(text);
  if (!module)
    return module.error().message;
  const auto verified = verify(*module, kExternals);
  return verified ? "" : verified.error().message;
}

TEST(Verify, TakesWhatFits) {
  EXPECT_EQ(problemOf("const ivec3 SIZE = ivec3(4);\n"
                      "struct Gap {\n  int side;\n  vec3 face;\n};\n"
                      "bool is_in(ivec3 cell) { return all(lessThan(uvec3(cell), uvec3(SIZE))); }\n"
                      "int side(const Gap gap) { return gap.side << 2u; }\n"
                      "int side(ivec3 a) { return (a >> 1).x & a[2]; }\n"
                      "vec3 f(inout Gap gap, bvec3 b) {\n"
                      "  int path[4];\n"
                      "  path[0] = side(gap) + side(ivec3(1));\n"
                      "  gap.face.x = 2.0f * float(path[0]);\n"
                      "  gap.face *= 0.5f;\n"
                      "  Gap other = Gap(1, vec3(0.0f));\n"
                      "  if (load(3u) != 0u)\n    return mix(gap.face, other.face, b);\n"
                      "  return 1.0f + gap.face;\n"
                      "}\n"),
            "");
}

TEST(Verify, SaysWhatDoesNotFit) {
  EXPECT_EQ(problemOf("int f() { return a; }"), "f: 'a' is not declared");
  EXPECT_EQ(problemOf("int f() { return g(1); }"), "f: 'g(1)' calls what is not declared");
  EXPECT_EQ(problemOf("int f(int a) { return a; } int g() { return f(1u); }"),
            "g: 'f(1u)' gives a function what it does not take");
  EXPECT_EQ(problemOf("int f() { return 1u; }"), "f: '1u' is of type 'uint' where 'int' is wanted");
  EXPECT_EQ(problemOf("int f(int a) { return a + 1.0f; }"),
            "f: 'a + 1.0f' has 'int' and 'float' on its sides");
  EXPECT_EQ(problemOf("int f(vec3 a) { return a.w; }"), "f: 'a.w' has no such member, as 'vec3'");
  EXPECT_EQ(problemOf("void f(int a) { if (a)\n return; }"),
            "f: 'a' is of type 'int' where 'bool' is wanted");
  EXPECT_EQ(problemOf("struct A { int a; int b; };\nA f() { return A(1); }"),
            "f: 'A(1)' does not give a struct all its members");
  EXPECT_EQ(problemOf("struct A { float a; };\nA f(double a) { return A(a); }"),
            "f: 'A(a)' does not give a struct all its members");
  EXPECT_EQ(problemOf("struct A { double a; };\nA f() { return A(0.0f); }"), "");
  EXPECT_EQ(problemOf("const float A = 1;"), "A: '1' is of type 'int' where 'float' is wanted");
}

} // namespace
} // namespace voxc::glsl
