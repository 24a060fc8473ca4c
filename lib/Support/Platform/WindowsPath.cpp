// Paths are UTF-16, and both slashes separate their parts.
#include "Path.h"

#include "WindowsText.h"

namespace voxc::platform {

std::filesystem::path pathFrom(std::string_view utf8) { return wide(utf8); }

std::string utf8From(const std::filesystem::path &path) { return narrow(path.native()); }

std::string folderOf(const std::string &path) {
  const std::size_t name = lastPart(path);
  return name == 0 ? "." : path.substr(0, name);
}

std::size_t lastPart(std::string_view path) { return path.find_last_of("/\\:") + 1; }

} // namespace voxc::platform
