// Writing screenshots.
#include "view/Screenshots.h"

#include "common/Png.h"

#include <cstdio>
#include <filesystem>

namespace voxc::view {

std::string Screenshots::nextPath() {
  namespace fs = std::filesystem;
  fs::path path;
  std::error_code ignored;
  do {
    char name[48];
    std::snprintf(name, sizeof name, "voxc-%04d.png", ++number_);
    path = fs::path(folder_) / name;
  } while (fs::exists(path, ignored));
  return path.string();
}

std::optional<Expected<std::string>> Screenshots::write(Picture picture) {
  if (writer_.joinable())
    writer_.join();
  auto before = take();
  writer_ = std::jthread([this, path = nextPath(), picture = std::move(picture)] {
    const Expected<void> written = tool::writePng(path, picture);
    written_.put(written ? Expected<std::string>(path) : written.error());
    wake_();
  });
  return before;
}

} // namespace voxc::view
