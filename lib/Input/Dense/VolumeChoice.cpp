// The choice of a volume.
#include "Input/Dense/VolumeChoice.h"

namespace voxc {

Expected<std::uint64_t> chooseVolume(std::uint64_t volumes, const InputOptions &options,
                                     std::vector<std::string> &warnings) {
  const auto asked = static_cast<std::uint64_t>(options.volume);
  if (asked > volumes)
    return Error::usage("there is no volume " + std::to_string(asked) + "; the file has " +
                        (volumes == 1 ? "one" : std::to_string(volumes)) + ", numbered from 1 on");
  if (asked == 0 && volumes > 1)
    warnings.push_back("it holds " + std::to_string(volumes) +
                       " volumes or components; the first of them is taken (--volume N takes another)");
  return asked == 0 ? 0 : asked - 1;
}

} // namespace voxc
