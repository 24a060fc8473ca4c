// Hits on labels in the colours of these.
#include "voxc/Render/Picture.h"

#include "voxc/Volume/LabelColour.h"

namespace voxc {

void showLabels(std::span<Hit> hits) {
  for (Hit &hit : hits)
    if (hit.isHit())
      hit.rgba = labelColour(hit.rgba);
}

} // namespace voxc
