// What a file's name says about its kind.
#pragma once

#include "Support/Platform/Path.h"
#include "Support/Text.h"

#include <string>
#include <string_view>

namespace voxc {

/// The ending of a path's last part with its dot, in lower case; empty if it has none.
inline std::string pathEnding(std::string_view path) {
  const std::string_view name = path.substr(platform::lastPart(path));
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string_view::npos ? std::string() : lowerCase(name.substr(dot));
}

/// The folder of a path, with a slash at its end; empty if it names none.
inline std::string folderOf(std::string_view path) {
  return std::string(path.substr(0, platform::lastPart(path)));
}

} // namespace voxc
