// GLSL to SPIR-V with glslang, in this process.
#include "Stages.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace voxc {
namespace {

/// glslang's process-wide tables, made once.
struct GlslangProcess {
  GlslangProcess() { glslang::InitializeProcess(); }
  ~GlslangProcess() { glslang::FinalizeProcess(); }
};

Error rejected(const char *log) { return Error::input(std::string("glslang rejects the kernel: ") + log); }

} // namespace

Expected<SpirvWords> glslToSpirv(std::string_view glsl) {
  static const GlslangProcess process;
  constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
  glslang::TShader shader(EShLangCompute);
  const char *text = glsl.data();
  const int length = static_cast<int>(glsl.size());
  shader.setStringsWithLengths(&text, &length, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, EShLangCompute, glslang::EShClientVulkan, 120);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
  if (!shader.parse(GetDefaultResources(), 460, false, messages))
    return rejected(shader.getInfoLog());
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages))
    return rejected(program.getInfoLog());
  SpirvWords module;
  glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), module);
  return module;
}

} // namespace voxc
