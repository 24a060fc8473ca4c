// The header of a NRRD file.
#pragma once

#include "Input/Dense/Samples.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Transform.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace voxc {

struct NrrdHeader {
  Int3 extent;
  SampleLayout layout;
  bool isGzip = false;
  std::string dataFile;       ///< Beside the header; empty: the data follow the header.
  std::uint64_t lineSkip = 0; ///< Lines before the data as stored,
  std::int64_t byteSkip = 0;  ///< and bytes before the samples; -1: the samples end the file.
  Transform sampleToModel;
};

/// Reads up to and including the blank line that ends a header, and takes that off the front of `text`.
/// Errors: not a NRRD file; a field that makes no sense, which is quoted; what voxc does not read.
Expected<NrrdHeader> readNrrdHeader(std::string_view &text);

} // namespace voxc
