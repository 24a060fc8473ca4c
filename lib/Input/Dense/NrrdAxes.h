// Which axes of a NRRD file are those of a volume.
#pragma once

#include "Input/Dense/NrrdHeader.h"

namespace voxc {

/// Fills extent, steps, channels and other axes of `header`, whose layout is known, with what `fields` say of
/// the axes; `order` has the axes of the file that became x, y and z, -1 where there is none. Errors: sizes
/// that no volume has, or that do not go with the dimension.
Expected<void> fillAxes(const NrrdFields &fields, bool picksVolume, NrrdHeader &header,
                        std::array<int, 3> &order);

} // namespace voxc
