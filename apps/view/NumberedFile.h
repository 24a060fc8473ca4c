// Names for files that the viewer writes one after the other.
#pragma once

#include <string>

namespace voxc::view {

/// The next path "voxc-0001.png" in a folder that is not there yet, after `number`, which becomes its own.
std::string nextNumberedPath(const std::string &folder, const std::string &ending, int &number);

} // namespace voxc::view
