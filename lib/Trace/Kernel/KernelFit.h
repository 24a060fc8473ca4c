// Whether a kernel fits a volume, told in one way by all back ends.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Volume/Volume.h"

#include <cstdint>
#include <string_view>

namespace voxc {

/// Error (`Input`) if a kernel of that storage digest was made for another format than the volume's; `emit`
/// is what `voxc compile` would have to be asked for.
Expected<void> checkFit(std::uint64_t storageDigest, const Volume &volume, std::string_view emit);

/// The same of a volume of which the digest and the format are known.
Expected<void> checkFit(std::uint64_t storageDigest, std::uint64_t volumeDigest, std::string_view format,
                        std::string_view emit);

/// The error of `Tracer::update` for a volume that the tracer does not trace.
Error notTraced();

} // namespace voxc
