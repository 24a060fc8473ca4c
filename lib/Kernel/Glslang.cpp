// GLSL to SPIR-V with glslang, in this process.
#include "Stages.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/SPIRV/GlslangToSpv.h>

namespace voxc {
namespace {

/// glslang's process-wide tables, made once.
struct GlslangProcess {
  GlslangProcess() { glslang::InitializeProcess(); }
  ~GlslangProcess() { glslang::FinalizeProcess(); }
};

/// Gives a shader the one file that it may include.
class OneHeader : public glslang::TShader::Includer {
public:
  explicit OneHeader(const Shader &shader) : shader_(shader) {}

  IncludeResult *includeLocal(const char *name, const char *, size_t) override {
    if (shader_.headerName != name)
      return nullptr;
    return new IncludeResult(name, shader_.header.data(), shader_.header.size(), nullptr);
  }
  void releaseInclude(IncludeResult *result) override { delete result; }

private:
  const Shader &shader_;
};

Error rejected(const char *log) { return Error::input(std::string("glslang rejects the kernel: ") + log); }

} // namespace

Expected<SpirvWords> glslToSpirv(const Shader &source) {
  static const GlslangProcess process;
  constexpr auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
  glslang::TShader shader(source.stage);
  const char *text = source.glsl.data();
  const int length = static_cast<int>(source.glsl.size());
  shader.setStringsWithLengths(&text, &length, 1);
  shader.setEnvInput(glslang::EShSourceGlsl, source.stage, glslang::EShClientVulkan, 120);
  shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_2);
  shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_5);
  OneHeader header(source);
  if (!shader.parse(GetDefaultResources(), 460, false, messages, header))
    return rejected(shader.getInfoLog());
  glslang::TProgram program;
  program.addShader(&shader);
  if (!program.link(messages))
    return rejected(program.getInfoLog());
  SpirvWords module;
  glslang::GlslangToSpv(*program.getIntermediate(source.stage), module);
  return module;
}

} // namespace voxc
