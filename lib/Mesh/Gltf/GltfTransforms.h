// Transforms of nodes, and of the instances of a node.
#pragma once

#include "Mesh/Gltf/GltfAccessors.h"

namespace voxc {

/// First `inner`, then `outer`.
Transform compose(const Transform &outer, const Transform &inner);

/// A matrix of four rows, of which the last is left out, as glTF writes it: column by column.
Transform fromColumns(const std::array<double, 16> &columns);

/// A node's matrix, or its translation, rotation and scale.
Transform readTransform(const GltfObject &node);

/// The transforms that EXT_mesh_gpu_instancing gives a node's mesh.
class InstanceTransforms {
public:
  /// Problems: accessors of the wrong shape or of different lengths.
  InstanceTransforms(const GltfObject &instancing, GltfAccessors &accessors);

  std::uint64_t count() const { return count_; }
  Transform at(std::uint64_t instance) const;

private:
  AttributeView read(const GltfObject &attributes, std::string_view name, std::uint8_t components,
                     GltfAccessors &accessors);

  AttributeView translations_;
  AttributeView rotations_;
  AttributeView scales_;
  std::uint64_t count_ = 0;
};

} // namespace voxc
