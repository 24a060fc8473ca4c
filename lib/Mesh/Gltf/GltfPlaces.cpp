// Climbing from nodes to their roots, without recursion.
#include "Mesh/Gltf/GltfPlaces.h"

#include "Mesh/Gltf/GltfTransforms.h"

namespace voxc {

void GltfPlaces::findParents() {
  parents_.resize(nodes_.size());
  known_.resize(nodes_.size());
  for (std::size_t node = 0; node < nodes_.size(); ++node) {
    const GltfList children = nodes_[node].list("children");
    for (std::size_t i = 0; i < children.size(); ++i)
      if (const auto child = children.index(i, nodes_); child && !parents_[*child])
        parents_[*child] = node;
  }
}

Transform GltfPlaces::of(std::size_t node) {
  if (parents_.size() != nodes_.size())
    findParents();
  std::vector<std::size_t> path;
  Transform place;
  for (std::optional<std::size_t> at = node; at; at = parents_[*at]) {
    if (known_[*at]) {
      place = *known_[*at];
      break;
    }
    if (path.size() == nodes_.size()) {
      nodes_[node].problem("is below itself, but nodes make a tree");
      return {};
    }
    path.push_back(*at);
  }
  for (std::size_t i = path.size(); i-- > 0;) {
    place = compose(place, readTransform(nodes_[path[i]]));
    known_[path[i]] = place;
  }
  return place;
}

} // namespace voxc
