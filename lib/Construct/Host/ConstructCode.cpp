// Calling generated code, and asking its host how it ended.
#include "ConstructCode.h"

namespace voxc {

Expected<std::uint32_t> ConstructCode::whole(BuildHost &host) const {
  const std::uint32_t root = whole_(&host.interface());
  if (host.store().failure())
    return *host.store().failure();
  return root;
}

Expected<void> ConstructCode::part(BuildHost &host, const Cube &cube) const {
  part_(&host.interface(), cube.low.x, cube.low.y, cube.low.z, cube.log2Side);
  if (host.store().failure())
    return *host.store().failure();
  return {};
}

} // namespace voxc
