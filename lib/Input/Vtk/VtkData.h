// The numbers of VTK's XML files, out of whatever they are encoded with.
#pragma once

#include "Input/Vtk/VtiFile.h"
#include "voxc/Input/Input.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace voxc {

using VtkBytes = ScratchArray<std::byte>;

struct VtkNumbers {
  const std::byte *first = nullptr;
  std::shared_ptr<const void> storage; ///< What `first` points into; null if that is the file itself.
  bool isBigEndian = false;
};

/// The `bytes` bytes of an array whose type is known. Raw ones are left where they lie in the file. Errors:
/// other bytes than so many; broken base 64 or compression; a compressor other than zlib's; no memory;
/// interrupted.
Expected<VtkNumbers> readVtkNumbers(const VtiFile &file, const VtkArray &array, std::uint64_t bytes,
                                    const InputOptions &options);

} // namespace voxc
