// Where scenes and formats lie that tests may use and do not need.
#pragma once

#include <cstdlib>
#include <string>

namespace voxc::test {

/// The folder that VOXC_SHARED names, or else the one beside the checkout; it may not exist.
inline std::string sharedFolder() {
  const char *folder = std::getenv("VOXC_SHARED");
  return folder ? folder : VOXC_SHARED_DIR;
}

} // namespace voxc::test
