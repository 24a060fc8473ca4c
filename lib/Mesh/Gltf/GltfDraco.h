// Primitives that Draco compressed (KHR_draco_mesh_compression).
#pragma once

#include "Mesh/Gltf/GltfBuffers.h"

#include <optional>
#include <string>

namespace voxc {

/// What Draco decoded of one primitive.
class DracoMesh {
public:
  /// Decodes what the extension of a primitive speaks of. Nothing, with a problem, if the data are broken,
  /// are no mesh of version 2.2, or would take more memory than there may be.
  static std::optional<DracoMesh> decode(GltfContext &context, GltfBuffers &buffers, const GltfObject &draco);

  /// The attribute of this name, such as POSITION; absent if the extension does not list it. Problems: it is
  /// not in the data, or of a type that no attribute has.
  AttributeView attribute(const std::string &name) const;

  const AttributeView &indices() const { return indices_; }

private:
  DracoMesh(GltfContext &context, const GltfObject &draco) : context_(&context), draco_(draco) {}

  GltfContext *context_;
  GltfObject draco_;
  std::shared_ptr<const void> mesh_; ///< Draco's own.
  AttributeView indices_;
};

} // namespace voxc
