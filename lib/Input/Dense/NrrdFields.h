// The fields of a NRRD header as they are written, one by one.
#pragma once

#include "Input/Dense/Samples.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

enum class NrrdEncoding : std::uint8_t { Raw, Gzip, Bzip2, Text, Hex };

/// What the fields say, not yet held against each other.
struct NrrdFields {
  std::optional<SampleType> type;
  std::optional<std::int64_t> dimension;
  std::vector<std::int64_t> sizes;
  std::optional<NrrdEncoding> encoding;
  std::string endian;
  std::string space; ///< In lower case.
  std::vector<double> spacings;
  std::vector<double> mins, maxs;   ///< Where axes begin and end; of cells or, by `centers`, of samples.
  std::vector<std::string> centers; ///< "cell" or "node" for each axis.
  std::vector<std::vector<double>> directions; ///< One for each axis; empty for "none".
  std::vector<double> origin;
  std::vector<std::string> kinds;     ///< One for each axis, in lower case.
  std::vector<std::string> units;     ///< Of the space, one for each of its axes.
  std::string dataFile;               ///< As it is written.
  std::vector<std::string> dataFiles; ///< The lines behind "data file: LIST".
  std::uint64_t lineSkip = 0;
  std::int64_t byteSkip = 0;
  bool hasSegments = false;         ///< There are keys of a segmentation.
  std::vector<std::string> unknown; ///< Names of fields that are no part of the format.
  std::vector<std::string> twice;   ///< Names of fields that are there again, of which the last holds.
  std::vector<std::string> keys;    ///< Those of lines "key:=value".
};

/// Reads up to and including the blank line that ends a header, and takes that off the front of `text`.
/// Errors: not a NRRD file; a line or a field that makes no sense, which is quoted.
Expected<NrrdFields> readNrrdFields(std::string_view &text);

} // namespace voxc
