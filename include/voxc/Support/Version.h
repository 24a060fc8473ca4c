// Which voxc this is. The build reads the numbers from here.
#pragma once

#include <string>

#define VOXC_VERSION_MAJOR 0
#define VOXC_VERSION_MINOR 1
#define VOXC_VERSION_PATCH 0

/// A version as one number, to compare with `VOXC_VERSION_NUMBER`.
#define VOXC_MAKE_VERSION(major, minor, patch) ((major) * 1000000 + (minor) * 1000 + (patch))
#define VOXC_VERSION_NUMBER VOXC_MAKE_VERSION(VOXC_VERSION_MAJOR, VOXC_VERSION_MINOR, VOXC_VERSION_PATCH)

namespace voxc {

/// "voxc 0.1.0".
std::string versionText();

} // namespace voxc
