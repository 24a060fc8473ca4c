// How an input becomes voxels as people write it, on a command line, in C or in Python, and whether that
// means something.
#pragma once

#include "voxc/Input/Input.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// As they were written; what was left out is the library's default.
struct InputArguments {
  int resolution = 0;         ///< 0: what the format holds.
  std::string voxelSize;      ///< A length such as "0.05m", or empty.
  std::string unit;           ///< Of the model, or empty.
  std::vector<double> align;  ///< Empty, or three numbers.
  std::vector<double> bounds; ///< Empty, or six numbers.
  std::string up;             ///< "y", "z", or empty.
  std::string coverage;       ///< A name of `kCoverageNames`, or empty.
  std::string colour;         ///< "mean", "nearest", or empty.
  std::optional<double> threshold;
  std::string colourMap;      ///< Empty: the library's default.
  std::vector<double> window; ///< Empty, or two numbers.
  int volume = 0;             ///< From 1 on; 0: the first.
  std::string grid;           ///< Its name, or empty.
  std::string interior;       ///< "keep", "drop", "fill", or empty.
  std::string fillColour;     ///< 6 or 8 hexadecimal digits, or empty.
  bool crop = false;
  bool isAutomatic = true; ///< What is left out of a dense volume is found by looking at it.
};

/// Voxels on the longest axis of a model, where no format says how many it holds.
inline constexpr int kDefaultResolution = 512;

/// The most that --volume takes.
inline constexpr int kMostVolumes = 1 << 30;

/// "rrggbb" or "rrggbbaa" as a word, R in the low byte; nothing if it is neither.
std::optional<std::uint32_t> parseColour(std::string_view text);

/// The values that "--coverage", "--colour", "--up" or "--interior" takes; none for others.
std::vector<std::string> inputValues(std::string_view option);

/// What is wrong with a value of --fill-colour, --voxel-size or --unit, and what would be right; or "".
std::string problemOfFillColour(const std::string &text);
std::string problemOfVoxelSize(const std::string &text);
std::string problemOfUnit(const std::string &text);

/// Whether every value is one that its option takes: for anyone who has no command line that refuses others.
/// Error: `Usage`, naming the first that is not.
Expected<void> checkInputValues(const InputArguments &arguments);

/// Whether every option that was given means something for this input, as a command line has it. Error:
/// `Usage`, naming the first that does not.
Expected<void> checkInputArguments(const InputArguments &arguments, const std::string &input);

/// Whether the ending or prefix of an input is a known one.
bool isKnownInput(const std::string &input);

/// Sets the resolution, where none was given, to `kDefaultResolution`, if the input has no voxels of its own.
void fillResolution(InputArguments &arguments, const std::string &input);

/// The options for an input that shall fit into `formatExtent`. A value that is none that its option takes is
/// left out.
InputOptions inputOptionsOf(const InputArguments &arguments, Int3 formatExtent);

} // namespace voxc
