// Rays brought in order bin by bin, in memory that is kept from one call to the next.
#pragma once

#include "ThreadTeam.h"

#include "voxc/Trace/BoundedRay.h"

#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

class RayBins {
public:
  /// As `binnedOrder` gives it, until the next call.
  std::span<const std::uint32_t> order(const RaySpan &rays, int edge, const ThreadTeam &team);

private:
  struct BinnedRay {
    std::uint32_t bin;
    std::uint32_t number;
  };

  template <typename Item, typename Put>
  static void sendByDigit(const ThreadTeam &team, std::size_t count, unsigned shift, const Item &item,
                          const Put &put);

  std::vector<BinnedRay> given_, half_; ///< Those of before and after the first digit, and maybe more.
  std::vector<std::uint32_t> order_;
};

} // namespace voxc
