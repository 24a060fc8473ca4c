// The bits of a brick.
#include "Brick.h"

namespace voxc {

bool Brick::findBits() {
  masks = bitsOf(words.data());
  if (!isAny(masks))
    return false;
  slices = toSlices(masks);
  return true;
}

} // namespace voxc
