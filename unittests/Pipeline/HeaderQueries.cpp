// HLSL to SPIR-V.
#include "HeaderQueries.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <gtest/gtest.h>

namespace voxc::test {

std::vector<std::uint32_t> compileHlsl(const std::string &text) {
  glslang::InitializeProcess();
  std::vector<std::uint32_t> spirv;
  {
    glslang::TShader shader(EShLangCompute);
    const char *const source = text.c_str();
    shader.setStrings(&source, 1);
    shader.setEntryPoint("main");
    shader.setEnvInput(glslang::EShSourceHlsl, EShLangCompute, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
    constexpr auto kMessages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules | EShMsgReadHlsl);
    EXPECT_TRUE(shader.parse(GetDefaultResources(), 100, false, kMessages)) << shader.getInfoLog();
    glslang::TProgram program;
    program.addShader(&shader);
    EXPECT_TRUE(program.link(kMessages)) << program.getInfoLog();
    if (!testing::Test::HasFailure())
      glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), spirv);
  }
  glslang::FinalizeProcess();
  return spirv;
}

} // namespace voxc::test
