// The clock that a device runs at, which a machine may change at any time.
#pragma once

#include <optional>

namespace voxc::gpu {

/// MHz of the processors of the first device of NVIDIA's, as its driver says; none where that is not there.
std::optional<unsigned> clockMegahertz();

} // namespace voxc::gpu
