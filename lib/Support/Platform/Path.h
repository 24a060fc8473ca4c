// Paths as voxc has them everywhere, in UTF-8, and as the system wants them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace voxc::platform {

/// For functions of the standard library, which may read a `std::string` in another encoding.
std::filesystem::path pathFrom(std::string_view utf8);
std::string utf8From(const std::filesystem::path &path);

/// The folder that a path lies in; "." for a name alone.
std::string folderOf(const std::string &path);

/// Where the last part of a path begins: behind its last separator.
std::size_t lastPart(std::string_view path);

} // namespace voxc::platform
