// Which files a pattern names.
#include "voxc/Input/NumberedPaths.h"

#include "voxc/Support/NumberedPath.h"

#include <filesystem>

namespace voxc {

Expected<std::vector<std::string>> numberedPaths(const std::string &path, std::size_t most) {
  const auto pattern = NumberedPath::parse(path);
  if (!pattern)
    return std::vector<std::string>{path};
  std::vector<std::string> paths;
  std::error_code ignored;
  std::uint64_t number = std::filesystem::exists((*pattern)(0), ignored) ? 0 : 1;
  for (; std::filesystem::exists((*pattern)(number), ignored); ++number) {
    if (paths.size() == most)
      return Error::input("'" + path + "' names more than " + std::to_string(most) +
                          " files, which is all that may be");
    paths.push_back((*pattern)(number));
  }
  if (paths.empty())
    return Error::input("'" + path + "' names no file: there is neither " + (*pattern)(0) + " nor " +
                        (*pattern)(1));
  if (std::filesystem::exists((*pattern)(number + 1), ignored))
    return Error::input("'" + path + "' names no whole set: there is no " + (*pattern)(number) + ", but " +
                        (*pattern)(number + 1) + " is there");
  return paths;
}

bool namesFiles(const std::string &path) {
  const auto pattern = NumberedPath::parse(path);
  std::error_code ignored;
  return pattern &&
         (std::filesystem::exists((*pattern)(0), ignored) || std::filesystem::exists((*pattern)(1), ignored));
}

} // namespace voxc
