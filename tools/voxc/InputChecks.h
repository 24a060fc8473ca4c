// Whether options of inputs mean something for the input at hand.
#pragma once

#include "InputArguments.h"

#include <string>

namespace voxc::tool {

/// Whether every option that was given means something for this input, as a command line has it. Error:
/// `Usage`, naming the first that does not.
Expected<void> checkInputArguments(const InputArguments &arguments, const std::string &input);

/// Whether the ending or prefix of an input is a known one.
bool isKnownInput(const std::string &input);

/// Sets the resolution, where none was given, to `kDefaultResolution`, if the input has no voxels of its own.
void fillResolution(InputArguments &arguments, const std::string &input);

} // namespace voxc::tool
