// Shaders of pages: each pass in both languages, and the kernel's functions in pieces that are whole again.
#include "page/Shaders.h"
#include "page/Merged.h"

#include "voxc/Emit/Emit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace voxc::page {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using tool::Json;

Json shadersOf(const char *format, bool isStreamed, bool isCut) {
  const auto shaders = makeShaders(*parseFormat(format), isStreamed, isCut);
  EXPECT_TRUE(shaders) << (shaders ? "" : shaders.error().message);
  return shaders ? *shaders : Json();
}

/// As page-runtime/script/main.js does: the lines of one kernel.
std::string functionsOf(const Json &shaders, const char *language, char other) {
  std::string text, lines;
  for (const Json &piece : shaders["functions"])
    text += piece[language].get<std::string>();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = text.find('\n', begin) + 1;
    if (text[begin] != other)
      lines += text.substr(begin + 1, end - begin - 1);
    begin = end;
  }
  return lines;
}

TEST(Shaders, OfAPassAreInBothLanguages) {
  for (const bool isCut : {false, true}) {
    const Json shaders = shadersOf("D(3^3, 6) R(2^3)", false, isCut);
    for (const char *const pass : {"picture", "develop", "answer", "arithmetic"}) {
      EXPECT_THAT(shaders["essl"][pass].get<std::string>(), HasSubstr("void main()")) << pass;
      const std::string wgsl = shaders["wgsl"][pass];
      EXPECT_THAT(wgsl, HasSubstr("@fragment fn fragment(")) << pass;
      // What the text around it has does not stand in it once more.
      EXPECT_THAT(wgsl, Not(HasSubstr("voxc_scene_Hit {"))) << pass;
    }
    const std::string picture = shaders["wgsl"]["picture"];
    EXPECT_EQ(picture.find("PLANES[i]") != std::string::npos, isCut);
    EXPECT_THAT(picture, HasSubstr(isCut ? "voxc_scene_closest(0, " : "voxc_scene_first(0, "));
  }
}

TEST(Shaders, OfPagesThatReadTheirVolumeAreThoseOfWebGl) {
  const Json shaders = shadersOf("G(5)", true, false);
  EXPECT_FALSE(shaders.contains("wgsl"));
  for (const char *const pass : {"picture", "sketch", "collect", "develop", "answer", "arithmetic"})
    EXPECT_THAT(shaders["essl"][pass].get<std::string>(), HasSubstr("void main()")) << pass;
}

TEST(Shaders, HaveTheKernelOfEitherPrecision) {
  const Json shaders = shadersOf("R(2^3) G(3)", false, false);
  for (const auto &[language, name] :
       {std::pair("essl", "bool voxc_scene_first("), std::pair("wgsl", "fn voxc_scene_first(")})
    for (const char other : {'+', '-'}) {
      const std::string functions = functionsOf(shaders, language, other);
      const std::size_t first = functions.find(name);
      EXPECT_NE(first, functions.npos) << language << other;
      EXPECT_EQ(functions.find(name, first + 1), functions.npos) << language << other;
      EXPECT_EQ(std::ranges::count(functions, '{'), std::ranges::count(functions, '}')) << language << other;
    }
  EXPECT_NE(functionsOf(shaders, "wgsl", '+'), functionsOf(shaders, "wgsl", '-'));
}

} // namespace
} // namespace voxc::page
