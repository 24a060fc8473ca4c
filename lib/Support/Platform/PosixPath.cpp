// Paths are bytes.
#include "Path.h"

namespace voxc::platform {

std::filesystem::path pathFrom(std::string_view utf8) { return utf8; }

std::string utf8From(const std::filesystem::path &path) { return path.native(); }

std::string folderOf(const std::string &path) {
  const std::size_t name = lastPart(path);
  return name == 0 ? "." : name == 1 ? "/" : path.substr(0, name - 1);
}

std::size_t lastPart(std::string_view path) { return path.rfind('/') + 1; }

} // namespace voxc::platform
