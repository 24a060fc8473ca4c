// Passes, each on a few lines.
#include "Glsl/Passes.h"

#include "Glsl/Parse.h"
#include "Glsl/Print.h"

#include <gtest/gtest.h>

namespace voxc::glsl {
namespace {

template <typename Pass> std::string after(std::string_view text, const Pass &pass) {
  auto module = parse(text);
  if (!module)
    return module.error().message;
  pass(*module);
  return print(*module);
}

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

} // namespace
} // namespace voxc::glsl
