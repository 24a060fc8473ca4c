// URIs as paths, where they lead to a file and where they do not.
#include "Mesh/Gltf/GltfUris.h"

#include "Mesh/Gltf/DataUri.h"

#include <span>
#include <utility>

namespace voxc {

const std::string &GltfUris::path(std::string_view uri) {
  std::string &path = known_[std::string(uri)];
  if (!path.empty())
    return path;
  const std::string name = uriToPath(uri);
  path = folder_ + name;
  if (auto found = files_.find(name, std::span(&folder_, 1))) {
    if (found->isElsewhere)
      warnings_.add("the file '" + name + "' is not there; '" + found->path + "' beside the model is taken");
    path = std::move(found->path);
  }
  return path;
}

} // namespace voxc
