// What the header of a NRRD file means.
#pragma once

#include "Input/Dense/NrrdFields.h"
#include "Input/Dense/Samples.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Transform.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

struct NrrdHeader {
  Int3 extent;
  SampleLayout layout;
  std::uint64_t bytes = 0;             ///< Of all samples, those of other volumes too.
  std::array<std::int64_t, 3> steps{}; ///< As those of `DenseVolume`.
  int channels = 1;
  std::int64_t channelStep = 0;
  /// Axes that are none of space, such as times or components: the sizes of each, and the bytes from one to
  /// the next. Their product is the number of volumes.
  struct Others {
    std::uint64_t size;
    std::int64_t step;
  };
  std::vector<Others> others;
  NrrdEncoding encoding = NrrdEncoding::Raw;
  std::vector<std::string>
      dataFiles;              ///< Beside the header, each with as many bytes; none: behind the header.
  std::uint64_t lineSkip = 0; ///< Lines before the data as stored,
  std::int64_t byteSkip = 0;  ///< and bytes before the samples; -1: the samples end the file.
  bool areLabels = false;
  bool hasSpace = false;     ///< It is said in which space the axes lie,
  bool isLeftHanded = false; ///< which is a mirrored one, with +x to the left,
  bool isUpZ = false;        ///< or one of patients, with +z to the head.
  double unit = 0;           ///< Metres of a step of length 1; 0: not said.
  Transform sampleToModel;
  std::vector<std::string> warnings;
  std::vector<std::string> notes;
};

/// Reads up to and including the blank line that ends a header, and takes that off the front of `text`.
/// `picksVolume`: one of several volumes is asked for, so that samples are not put together as colours.
/// Errors: not a NRRD file; a field that makes no sense, which is quoted; what voxc does not read.
Expected<NrrdHeader> readNrrdHeader(std::string_view &text, bool picksVolume = false);

} // namespace voxc
