// share-grids: equal sub-volumes of an R or D level are stored once.
//
// Contract: sets share=level on every grid level but the first, which has one sub-volume. The words of a
// volume get fewer, never more, and decode to the same voxels. Distances follow from the cells, so that D
// sub-volumes with equal cells are equal as a whole.
#include "SetOnLevels.h"

namespace voxc {

PassResult shareGrids(Format &format, Diagnostics &) {
  return setOnLevels(format, 1, kShareAttribute, "level");
}

} // namespace voxc
