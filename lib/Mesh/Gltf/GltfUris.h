// Files that a glTF model names by URIs.
#pragma once

#include "Mesh/FileBeside.h"
#include "Support/Warnings.h"

#include <map>
#include <string>
#include <string_view>

namespace voxc {

class GltfUris {
public:
  /// Relative URIs go from `folder`, which has a slash at its end or is empty.
  GltfUris(std::string folder, Warnings &warnings) : folder_(std::move(folder)), warnings_(warnings) {}

  /// The path of the file that is meant, be it there or not. One that is found elsewhere, as models lie that
  /// come from another machine, is a warning.
  const std::string &path(std::string_view uri);

private:
  std::string folder_;
  Warnings &warnings_;
  FilesBeside files_;
  std::map<std::string, std::string> known_; ///< Paths by URIs.
};

} // namespace voxc
