// Accessors of a glTF model as attribute views.
#pragma once

#include "Mesh/Gltf/GltfBuffers.h"

#include <vector>

namespace voxc {

class GltfAccessors {
public:
  GltfAccessors(GltfContext &context, GltfBuffers &buffers);

  /// The rows of an accessor, in place unless it is sparse. Absent, with a problem, if they are not all
  /// there.
  AttributeView view(std::size_t index);

  const GltfList &list() const { return list_; }

private:
  struct Known {
    bool isRead = false;
    AttributeView view;
  };

  AttributeView read(const GltfObject &json);
  /// Points `view` at rows of a buffer view; false, with a problem, if there are too few.
  bool place(AttributeView &view, const GltfObject &json);
  bool spend(const AttributeView &view, const GltfObject &json);
  AttributeView withSparse(const AttributeView &base, const GltfObject &json);
  bool overwrite(std::byte *rows, const AttributeView &base, const GltfObject &sparse);

  GltfContext &context_;
  GltfBuffers &buffers_;
  GltfList list_;
  std::vector<Known> known_;
  std::uint64_t bytesSpent_ = 0;
};

} // namespace voxc
