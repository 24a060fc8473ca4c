// SPIRV-Cross, where this voxc was built with it.
#pragma once

#include "voxc/Kernel/Translate.h"

#include <cstdint>
#include <span>

namespace voxc {

extern const bool kHasSpirvCross;

/// A kernel's module in another language. Errors: as `translateKernel`.
Expected<std::string> spirvCross(std::span<const std::uint32_t> spirv, ShadingLanguage language);

} // namespace voxc
