// Fuzzes files of cameras, which are JSON.
#include "FuzzedFile.h"

#include "common/CameraFile.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::string path = voxc::fuzz::folder().write("cameras.json", voxc::fuzz::textOf(data, size));
  const auto names = voxc::tool::cameraNames(path);
  if (!names)
    return 0;
  for (const std::string &name : *names)
    static_cast<void>(voxc::tool::readCamera(path, name));
  return 0;
}
