// The options that say how an input becomes voxels.
#pragma once

#include "common/CommandLine.h"
#include "voxc/Input/Input.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool {

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

/// What INPUT is, for the help texts of commands.
inline constexpr const char *kInputHelp =
    "A mesh, points, .vox, a dense volume, .hvx, grid:WxHxD:FILE or builtin:NAME[:N]";

/// "rrggbb" or "rrggbbaa" as a word, R in the low byte; nothing if it is neither.
std::optional<std::uint32_t> parseColour(std::string_view text);

/// Adds the options of the group "Input" to a command, from --resolution to --crop.
void addInputArguments(const CommandLine &command, InputArguments &arguments);

/// Adds --volume to a command that writes a volume under that name: a path for `path`, or the number of a
/// volume of the input.
Option addVolumePath(const CommandLine &command, std::string &path, InputArguments &arguments,
                     const char *text);

/// Fills what was left out with what a volume says of how it was voxelized ("resolution=512 up=z ...").
void fillFromProvenance(InputArguments &arguments, std::string_view provenance);

/// The options for an input that shall fit into `formatExtent`.
InputOptions makeInputOptions(const InputArguments &arguments, Int3 formatExtent);

} // namespace voxc::tool
