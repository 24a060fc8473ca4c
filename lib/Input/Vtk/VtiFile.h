// The XML of a .vti file (VTK ImageData): what there is, and where its numbers lie.
#pragma once

#include "Input/Dense/Samples.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// First and last point along x, y and z.
using VtkExtent = std::array<std::int64_t, 6>;

enum class VtkFormat : std::uint8_t { Ascii, Binary, Appended };

/// An array of numbers, one or several for each point or cell.
struct VtkArray {
  std::string name;
  std::string typeName;
  std::optional<SampleType> type; ///< None for texts and bits.
  std::int64_t components = 1;
  bool isOfCells = false;
  VtkFormat format = VtkFormat::Ascii;
  std::uint64_t offset = 0; ///< Of appended data.
  std::string_view text;    ///< Of all others, as it stands in the file.
};

struct VtkPiece {
  VtkExtent extent{};
  std::vector<VtkArray> arrays;
};

struct VtiFile {
  bool isBigEndian = false;
  int headerBytes = 4;    ///< Of each number that says how long data are.
  std::string compressor; ///< "" for none.
  VtkExtent whole{};
  std::array<double, 3> origin{};
  std::array<double, 3> spacing{1, 1, 1};
  std::array<double, 9> direction{1, 0, 0, 0, 1, 0, 0, 0, 1}; ///< Row by row.
  std::string pointScalars; ///< The names of the arrays that are active, "" where none is said to be.
  std::string cellScalars;
  std::vector<VtkPiece> pieces;
  std::vector<std::string> fieldArrays; ///< Names of arrays of no point and no cell.
  std::string_view appended;            ///< Behind the mark where appended data begin.
  bool isAppendedBase64 = false;
};

/// Reads the XML, and nothing of the data. Views go into `text`. Errors: no XML of ImageData; more pieces or
/// arrays than any program writes; interrupted.
Expected<VtiFile> readVtiFile(std::string_view text, const Progress &progress);

} // namespace voxc
