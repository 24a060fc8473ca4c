// What stands for SPIRV-Cross in a build without it.
#include "SpirvCross.h"

namespace voxc {

const bool kHasSpirvCross = false;

Expected<std::string> spirvCross(std::span<const std::uint32_t>, ShadingLanguage language) {
  return Error::environment(std::string(toString(language)) +
                            " is written by SPIRV-Cross, without which this voxc was built: build it where "
                            "libspirv-cross-c-shared-dev is installed");
}

} // namespace voxc
