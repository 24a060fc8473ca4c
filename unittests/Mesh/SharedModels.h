// The models that lie beside the checkout: tests that need them skip where they are not.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace voxc {

/// Path of a shared model.
inline std::string sharedModel(const std::string &name) {
  const char *folder = std::getenv("VOXC_SHARED");
  return std::string(folder ? folder : VOXC_SHARED_DIR) + "/models/" + name;
}

} // namespace voxc

/// Skips the test, saying so, if the shared model is absent.
#define VOXC_SKIP_WITHOUT(name)                                                                              \
  if (!std::filesystem::exists(voxc::sharedModel(name)))                                                     \
  GTEST_SKIP() << "the shared model " << voxc::sharedModel(name) << " is not there"
