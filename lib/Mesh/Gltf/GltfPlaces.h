// Where nodes stand in a glTF model, whether a scene has them or not.
#pragma once

#include "Mesh/Gltf/GltfContext.h"

#include <optional>
#include <vector>

namespace voxc {

class GltfPlaces {
public:
  explicit GltfPlaces(GltfContext &context) : nodes_(context.root.list("nodes")) {}

  const GltfList &nodes() const { return nodes_; }

  /// From the coordinates of a node to those of the model. Problem: the node is below itself.
  Transform of(std::size_t node);

private:
  void findParents();

  GltfList nodes_;
  std::vector<std::optional<std::size_t>> parents_; ///< Found when they are asked for first.
  std::vector<std::optional<Transform>> known_;
};

} // namespace voxc
