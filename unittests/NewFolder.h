// A folder for the files of a test.
#pragma once

#include <filesystem>
#include <random>
#include <string>

namespace voxc::test {

/// Makes one that no other test has: its name is this with a number behind it.
inline std::filesystem::path newFolder(const std::string &name) {
  std::random_device random;
  for (;;) {
    const auto folder = std::filesystem::temp_directory_path() / (name + "-" + std::to_string(random()));
    if (std::filesystem::create_directory(folder))
      return folder;
  }
}

} // namespace voxc::test
