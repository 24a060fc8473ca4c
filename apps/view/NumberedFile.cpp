// Names for files that the viewer writes one after the other.
#include "view/NumberedFile.h"

#include <cstdio>
#include <filesystem>

namespace voxc::view {

std::string nextNumberedPath(const std::string &folder, const std::string &ending, int &number) {
  namespace fs = std::filesystem;
  fs::path path;
  std::error_code ignored;
  do {
    char name[48];
    std::snprintf(name, sizeof name, "voxc-%04d", ++number);
    path = fs::path(folder) / (name + ending);
  } while (fs::exists(path, ignored));
  return path.string();
}

} // namespace voxc::view
