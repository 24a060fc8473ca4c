// Traversals that a kernel gave up, told in one way by all back ends.
#include "Nontermination.h"

#include <algorithm>
#include <string>

namespace voxc {

namespace {
constexpr std::int32_t kNonterminated = -0x7fffffff; ///< As in shaders-runtime/buffers.glsl.
}

Expected<void> checkEnded(std::span<const Hit> hits) {
  const auto isNonterminated = [](const Hit &hit) { return hit.voxel[0] == kNonterminated; };
  const auto count = std::ranges::count_if(hits, isNonterminated);
  if (count == 0)
    return {};
  const auto first = std::ranges::find_if(hits, isNonterminated) - hits.begin();
  return Error::input("the kernel gave up " + std::to_string(count) + " rays, the first of them ray " +
                      std::to_string(first) +
                      ", that took more steps than they have cells: an error of voxc");
}

} // namespace voxc
