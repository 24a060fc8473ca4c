// Kernels in the shading languages of Direct3D and Metal, by SPIRV-Cross.
#pragma once

#include "voxc/Trace/Kernel.h"

#include <array>
#include <string>
#include <string_view>

namespace voxc {

enum class ShadingLanguage {
  Hlsl, ///< Shader model 6.0.
  Msl,  ///< Metal 2.2.
};

template <> inline constexpr std::array<std::string_view, 2> kEnumNames<ShadingLanguage> = {"hlsl", "msl"};

/// Whether this voxc was built with SPIRV-Cross.
bool canTranslate();

/// A kernel as a compute shader of another language, with the function `main` (HLSL) or `main0` (MSL) and the
/// buffers of `Kernel` by the numbers of their bindings: registers t0, u1, t2, u3 or buffers 0 to 3. Push
/// constants are b4 or buffer 4, specialization constants macros SPIRV_CROSS_CONSTANT_ID_N or function
/// constants N. Errors: the kernel needs what the language has not, which is addresses of a device or doubles
/// (`Input`); this voxc was built without SPIRV-Cross (`Environment`).
Expected<std::string> translateKernel(const Kernel &kernel, ShadingLanguage language);

} // namespace voxc
