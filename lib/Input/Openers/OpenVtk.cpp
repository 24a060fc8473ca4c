// Opening VTK's image data: XML files (.vti).
#include "Input/Openers/Openers.h"

#include "Input/Openers/OpenDense.h"
#include "Input/Vtk/VtkImage.h"

#include <utility>

namespace voxc {

Expected<Input> openVtk(const std::string &path, const InputOptions &options) {
  return openDense(path, "VTK", options,
                   [&](std::shared_ptr<const WatchedFile> source) -> Expected<DenseVolume> {
                     const auto file = VOXC_TRY(readVtiFile(source->text(), options.progress));
                     return readVtkImage(file, std::move(source), options);
                   });
}

} // namespace voxc
