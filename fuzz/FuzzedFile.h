// Files that a fuzzer writes, in a folder that disappears with the process.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace voxc::fuzz {

class FuzzedFolder {
public:
  FuzzedFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "voxc-fuzz-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~FuzzedFolder() { std::filesystem::remove_all(path_); }
  FuzzedFolder(const FuzzedFolder &) = delete;
  FuzzedFolder &operator=(const FuzzedFolder &) = delete;

  /// Writes a file; its path.
  std::string write(const std::string &name, std::string_view content) const {
    std::string path = path_ + "/" + name;
    std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
    return path;
  }

private:
  std::string path_;
};

/// The folder of this process.
inline const FuzzedFolder &folder() {
  static const FuzzedFolder folder;
  return folder;
}

inline std::string_view textOf(const unsigned char *data, std::size_t size) {
  return {reinterpret_cast<const char *>(data), size};
}

} // namespace voxc::fuzz
