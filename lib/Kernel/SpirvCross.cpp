// SPIRV-Cross by its C interface, which throws nothing.
#include "SpirvCross.h"

#include <spirv_cross_c.h>

#include <memory>

namespace voxc {

const bool kHasSpirvCross = true;

namespace {

/// Where a kernel's push constants go: behind its buffers.
constexpr unsigned kPushBinding = 4;
constexpr unsigned kPushBytes = 12;

constexpr unsigned kShaderModel = 60;
constexpr unsigned kMetalVersion = SPVC_MAKE_MSL_VERSION(2, 2, 0);

spvc_result describeHlsl(spvc_compiler compiler) {
  const spvc_hlsl_root_constants constants = {0, kPushBytes, kPushBinding, 0};
  return spvc_compiler_hlsl_set_root_constants_layout(compiler, &constants, 1);
}

spvc_result describeMsl(spvc_compiler compiler) {
  for (unsigned number = 0; number <= kPushBinding; ++number) {
    spvc_msl_resource_binding binding;
    spvc_msl_resource_binding_init(&binding);
    const bool isPush = number == kPushBinding;
    binding.stage = SpvExecutionModelGLCompute;
    binding.desc_set = isPush ? SPVC_MSL_PUSH_CONSTANT_DESC_SET : 0;
    binding.binding = isPush ? SPVC_MSL_PUSH_CONSTANT_BINDING : number;
    binding.msl_buffer = number;
    if (const spvc_result result = spvc_compiler_msl_add_resource_binding(compiler, &binding);
        result != SPVC_SUCCESS)
      return result;
  }
  return SPVC_SUCCESS;
}

struct Language {
  spvc_backend backend;
  spvc_compiler_option versionOption;
  unsigned version;
  spvc_result (*describe)(spvc_compiler compiler);
};

/// In the order of `ShadingLanguage`.
constexpr Language kLanguages[] = {
    {SPVC_BACKEND_HLSL, SPVC_COMPILER_OPTION_HLSL_SHADER_MODEL, kShaderModel, describeHlsl},
    {SPVC_BACKEND_MSL, SPVC_COMPILER_OPTION_MSL_VERSION, kMetalVersion, describeMsl},
};

spvc_result translate(spvc_context context, std::span<const std::uint32_t> spirv, const Language &language,
                      const char *&text) {
  spvc_parsed_ir module = nullptr;
  spvc_compiler compiler = nullptr;
  spvc_compiler_options options = nullptr;
  spvc_result result = spvc_context_parse_spirv(context, spirv.data(), spirv.size(), &module);
  const auto next = [&result](const auto &step) { result = result == SPVC_SUCCESS ? step() : result; };
  next([&] {
    return spvc_context_create_compiler(context, language.backend, module, SPVC_CAPTURE_MODE_TAKE_OWNERSHIP,
                                        &compiler);
  });
  next([&] { return spvc_compiler_create_compiler_options(compiler, &options); });
  next([&] { return spvc_compiler_options_set_uint(options, language.versionOption, language.version); });
  next([&] { return spvc_compiler_install_compiler_options(compiler, options); });
  next([&] { return language.describe(compiler); });
  next([&] { return spvc_compiler_compile(compiler, &text); });
  return result;
}

} // namespace

Expected<std::string> spirvCross(std::span<const std::uint32_t> spirv, ShadingLanguage language) {
  spvc_context made = nullptr;
  if (spvc_context_create(&made) != SPVC_SUCCESS)
    return Error::environment("there is no memory for SPIRV-Cross");
  const std::unique_ptr<spvc_context_s, void (*)(spvc_context)> context(made, spvc_context_destroy);
  const char *text = nullptr; // The context's.
  if (translate(context.get(), spirv, kLanguages[static_cast<std::size_t>(language)], text) != SPVC_SUCCESS)
    return Error::input("SPIRV-Cross cannot write this kernel as " + std::string(toString(language)) + ": " +
                        spvc_context_get_last_error_string(context.get()));
  return std::string(text);
}

} // namespace voxc
