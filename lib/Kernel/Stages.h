// The stages from GLSL to a finished module; each takes the words of the one before.
#pragma once

#include "voxc/Support/Error.h"

#include <glslang/Public/ShaderLang.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

using SpirvWords = std::vector<std::uint32_t>;

/// A shader, and a file that it may include.
struct Shader {
  EShLanguage stage = EShLangCompute;
  std::string_view glsl;
  std::string_view headerName = {};
  std::string_view header = {};
};

/// GLSL to SPIR-V 1.5 for Vulkan 1.2 (glslang).
Expected<SpirvWords> glslToSpirv(const Shader &shader);

/// Makes the module say `facts` in an OpModuleProcessed of its own.
SpirvWords addModuleProcessed(const SpirvWords &module, std::string_view facts);

/// spirv-opt -O.
Expected<SpirvWords> optimiseSpirv(const SpirvWords &module);

/// spirv-val for Vulkan 1.2.
Expected<void> validateSpirv(const SpirvWords &module);

/// spirv-dis.
Expected<std::string> disassembleSpirv(const SpirvWords &module);

} // namespace voxc
