// Writing files with numbers.
#include "view/NumberedFiles.h"

#include <cstdio>
#include <filesystem>

namespace voxc::view {

std::string NumberedFiles::nextPath() {
  namespace fs = std::filesystem;
  fs::path path;
  std::error_code ignored;
  do {
    char name[48];
    std::snprintf(name, sizeof name, "voxc-%04d", ++number_);
    path = fs::path(folder_) / (name + ending_);
  } while (fs::exists(path, ignored));
  return path.string();
}

std::optional<Expected<std::string>>
NumberedFiles::write(std::function<Expected<void>(const std::string &path)> write) {
  if (writer_.joinable())
    writer_.join();
  auto before = take();
  writer_ = std::jthread([this, path = nextPath(), write = std::move(write)] {
    const Expected<void> written = write(path);
    written_.put(written ? Expected<std::string>(path) : written.error());
    wake_();
  });
  return before;
}

} // namespace voxc::view
