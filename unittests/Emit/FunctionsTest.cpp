// Functions of GLSL in WGSL: what stands in other text, and what the two languages spell apart.
#include "voxc/Emit/Emit.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace voxc {
namespace {

std::string wgsl(std::string_view functions, std::string_view declared = "") {
  const auto text = emitFunctions(functions, declared, HeaderLanguage::Wgsl);
  return text ? *text : "error in " + text.error().message;
}

TEST(Functions, HaveWhatIsDeclaredAndDoNotPrintIt) {
  EXPECT_EQ(
      wgsl(
          "bool is_near(vec3 from) {\n  Hit hit;\n  return first(from + given.eye, hit) && hit.t < 1.0;\n}\n",
          "struct Hit {\n  float t;\n};\n"
          "struct Given {\n  vec3 eye;\n};\n"
          "uniform Given given;\n"
          "bool first(vec3 origin, out Hit hit);\n"),
      "fn is_near(from_: vec3<f32>) -> bool {\n  var hit: Hit;\n"
      "  return first(from_ + given.eye, &hit) && hit.t < 1.0;\n}\n");
}

TEST(Functions, MixNumbersAndChoose) {
  EXPECT_EQ(wgsl("vec3 part(vec3 a, vec3 b, float t) { return mix(a, b, t); }\n"
                 "vec3 less(vec3 a, vec3 b) { return mix(b, a, lessThan(a, b)); }\n"),
            "fn part(a: vec3<f32>, b: vec3<f32>, t: f32) -> vec3<f32> { return mix(a, b, vec3<f32>(t)); }\n"
            "fn less(a: vec3<f32>, b: vec3<f32>) -> vec3<f32> { return select(b, a, a < b); }\n");
}

TEST(Functions, OfPicturesHaveTheirTypes) {
  EXPECT_EQ(wgsl("float shade(vec3 a, vec3 b) { return pow(dot(cross(a, b), fract(a)), exp(sin(a.x))); }\n"),
            "fn shade(a: vec3<f32>, b: vec3<f32>) -> f32 { return pow(dot(cross(a, b), fract(a)), "
            "exp(sin(a.x))); }\n");
}

TEST(Functions, ThatAreNoneAreAnError) {
  EXPECT_EQ(wgsl("float one() { return 1; }\n"),
            "error in one: '1' is of type 'int' where 'float' is wanted");
  EXPECT_EQ(wgsl("float one() { return 1.0 }\n"), "error in line 1: found '}' where ';' would be right");
  EXPECT_EQ(wgsl("", "float one("), "error in line 1: found the end where a type would be right");
}

} // namespace
} // namespace voxc
