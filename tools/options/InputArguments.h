// The options that say how an input becomes voxels.
#pragma once

#include "common/CommandLine.h"
#include "voxc/Input/Arguments.h"

#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool {

/// What INPUT is, for the help texts of commands.
inline constexpr const char *kInputHelp =
    "A mesh, points, .vox, a dense volume, .hvx, grid:WxHxD:FILE or builtin:NAME[:N]";

/// Adds the options of the group "Input" to a command, from --resolution to --crop.
void addInputArguments(const CommandLine &command, InputArguments &arguments);

/// Adds --volume to a command that writes a volume under that name: a path for `path`, or the number of a
/// volume of the input.
Option addVolumePath(const CommandLine &command, std::string &path, InputArguments &arguments,
                     const char *text);

/// Fills what was left out with what a volume says of how it was voxelized ("resolution=512 up=z ...").
void fillFromProvenance(InputArguments &arguments, std::string_view provenance);

/// The arguments as words for a command line.
std::vector<std::string> toWords(const InputArguments &arguments);

/// The options for an input that shall fit into `formatExtent`, which optional components may read.
InputOptions makeInputOptions(const InputArguments &arguments, Int3 formatExtent);

} // namespace voxc::tool
