// Comparing pictures.
#include "PictureDifference.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace voxc::tool {

PictureDifference difference(const Picture &reference, const Picture &picture) {
  PictureDifference result;
  double squares = 0;
  std::size_t changed = 0;
  const std::size_t count = std::min(reference.pixels.size(), picture.pixels.size());
  for (std::size_t i = 0; i < count; ++i) {
    int worst = 0;
    for (int shift = 0; shift < 24; shift += 8) {
      const int apart = std::abs(static_cast<int>(reference.pixels[i] >> shift & 255) -
                                 static_cast<int>(picture.pixels[i] >> shift & 255));
      worst = std::max(worst, apart);
      squares += double(apart) * apart;
    }
    changed += worst > 0;
    result.worst = std::max(result.worst, worst);
  }
  result.changed = count == 0 ? 0 : static_cast<double>(changed) / static_cast<double>(count);
  result.psnr = squares == 0 ? std::numeric_limits<double>::infinity()
                             : 10 * std::log10(255.0 * 255.0 * 3 * static_cast<double>(count) / squares);
  return result;
}

} // namespace voxc::tool
