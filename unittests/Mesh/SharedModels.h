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

/// The same unpacked, if it lies there compressed: "a/b.obj" in a.tar.zst, others in NAME.zst. `folder` is
/// where to. Empty if it is not there at all.
inline std::string unpackedModel(const std::string &name, const std::string &folder) {
  if (std::filesystem::exists(sharedModel(name)))
    return sharedModel(name);
  const std::size_t slash = name.find('/');
  const bool isTar = slash != std::string::npos;
  const std::string packed = sharedModel(isTar ? name.substr(0, slash) + ".tar.zst" : name + ".zst");
  if (!std::filesystem::exists(packed))
    return {};
  const std::string path = folder + "/" + name;
  const std::string command = isTar ? "tar --zstd -xf '" + packed + "' -C '" + folder + "'"
                                    : "zstd -dq '" + packed + "' -o '" + path + "'";
  return std::system(command.c_str()) == 0 ? path : std::string();
}

} // namespace voxc

/// Skips the test, saying so, if the shared model is absent.
#define VOXC_SKIP_WITHOUT(name)                                                                              \
  if (!std::filesystem::exists(voxc::sharedModel(name)))                                                     \
  GTEST_SKIP() << "the shared model " << voxc::sharedModel(name) << " is not there"
