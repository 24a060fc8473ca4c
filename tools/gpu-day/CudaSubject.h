// The functions of the CUDA header on a device of NVIDIA's, by the driver alone.
#pragma once

#include "Subject.h"

namespace voxc::gpu {

/// Traces all sets by the function `trace` of a PTX text or of a cubin (trace.cu, nanovdb.cu) through these
/// words: rows as of a kernel of Vulkan, timed by events. Errors: `Environment`, where there is no driver, or
/// it refuses the code; what CUDA says.
Expected<tool::Json> measureCuda(const std::string &code, std::span<const std::uint32_t> words,
                                 std::span<const RaysThere> sets, double seconds);

} // namespace voxc::gpu
