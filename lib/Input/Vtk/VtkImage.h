// An array of VTK image data as a dense volume.
#pragma once

#include "Input/Dense/DenseVolume.h"
#include "Input/Vtk/VtiFile.h"

namespace voxc {

/// The array that the options name, else the active scalars of points, of cells, or the first; of all pieces,
/// which must tile the extent. Raw numbers of one piece stay in the text of `source`. Errors: no such array;
/// pieces that do not tile; as `readVtkNumbers`; `Usage`, no such component.
Expected<DenseVolume> readVtkImage(const VtiFile &file, std::shared_ptr<const WatchedFile> source,
                                   const InputOptions &options);

} // namespace voxc
