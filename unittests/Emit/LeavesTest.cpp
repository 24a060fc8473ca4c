// Leaves of kernels are GLSL: a compiler that knows nothing of plans takes each as it stands.
#include "LeafPrelude.h"

#include "Emit/RuntimeText.h"

#include "voxc/Emit/Emit.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voxc {
namespace {

/// What glslang has against a text of GLSL ES 3.00, or "".
std::string problemInGlslEs(const std::string &text) {
  glslang::TShader shader(EShLangFragment);
  // Headers give these functions names of their own.
  const std::string all = "#version 300 es\nprecision highp float;\nprecision highp int;\n"
                          "#define mix voxc_format_mix\n" +
                          text;
  const char *const source = all.c_str();
  shader.setStrings(&source, 1);
  return shader.parse(GetDefaultResources(), 300, false, EShMsgDefault) ? "" : shader.getInfoLog();
}

/// What it has against one of a kernel, or "".
std::string problemOf(const std::string &text) {
  glslang::TShader shader(EShLangCompute);
  const char *const source = text.c_str();
  shader.setStrings(&source, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 100);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
  const bool isTaken = shader.parse(GetDefaultResources(), 460, false,
                                    static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules));
  return isTaken ? "" : shader.getInfoLog();
}

class Leaves : public testing::Test {
protected:
  static void SetUpTestSuite() { glslang::InitializeProcess(); }
  static void TearDownTestSuite() { glslang::FinalizeProcess(); }
};

TEST_F(Leaves, AreTakenByACompilerAsTheyStand) {
  for (const std::string &path : test::leaves()) {
    const std::string text = test::preludeOf(path) + std::string(runtimeFile(shaderFiles(), path));
    EXPECT_EQ(problemOf(text), "") << path;
  }
}

TEST_F(Leaves, OfBuiltInFunctionsAreTakenWhereTheseAreNot) {
  ASSERT_FALSE(test::builtins().empty());
  for (const std::string &path : test::builtins())
    EXPECT_EQ(problemInGlslEs(std::string(runtimeFile(shaderFiles(), path))), "") << path;
}

TEST_F(Leaves, HaveNoHolesAndNoDirectivesOfOurs) {
  for (const std::string &path : test::leaves()) {
    const std::string text(runtimeFile(shaderFiles(), path));
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("${"))) << path;
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("%if"))) << path;
  }
}

TEST_F(Leaves, AreRefusedWithAHoleOrAWrongName) {
  const std::string text =
      test::preludeOf("field.glsl") + std::string(runtimeFile(shaderFiles(), "field.glsl"));
  EXPECT_EQ(problemOf(text), "");
  for (const char *const wrong : {"uint f() { return ${words}; }\n", "uint f() { return LEVEL_UNHEARD; }\n",
                                  "uint f() { return load_word_from(1u); }\n", "%if wide\n"})
    EXPECT_NE(problemOf(text + wrong), "") << wrong;
}

} // namespace
} // namespace voxc
