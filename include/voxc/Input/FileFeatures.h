// What is read of foreign files, feature by feature.
#pragma once

#include "voxc/Support/EnumText.h"

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace voxc {

/// What becomes of a feature that a file has.
enum class FileUse {
  Read,    ///< It shapes or colours voxels, or is kept.
  Warned,  ///< It is left out, or stands for something simpler, and one warning says so.
  Refused, ///< The file is an error that says what would be right.
};

template <>
inline constexpr std::array<std::string_view, 3> kEnumNames<FileUse> = {"read", "warned", "refused"};

/// A feature of a kind of file.
struct FileFeature {
  std::string_view format;  ///< Its ending, without a dot, or endings.
  std::string_view feature; ///< What a file may have.
  FileUse use;
  std::string_view what; ///< What it becomes, or what would be right; may be empty.
};

/// All that is known, by formats.
std::span<const FileFeature> fileFeatures();

/// The same as a table of Markdown, which docs/exchange.md has: format, feature, use, and what it becomes.
std::string fileFeatureTable();

} // namespace voxc
