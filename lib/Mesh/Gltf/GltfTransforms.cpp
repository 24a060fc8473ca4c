// Matrices, and those made of translation, rotation and scale.
#include "Mesh/Gltf/GltfTransforms.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace voxc {

namespace {

using Three = std::array<double, 3>;
using Four = std::array<double, 4>;

/// `rotation` is a quaternion x, y, z, w, and is brought to length 1.
Transform fromParts(const Three &move, const Four &rotation, const Three &scale) {
  const glm::dquat turn(rotation[3], rotation[0], rotation[1], rotation[2]);
  const glm::dmat3 axes = glm::mat3_cast(glm::normalize(turn));
  return {axes[0] * scale[0], axes[1] * scale[1], axes[2] * scale[2], glm::dvec3(move[0], move[1], move[2])};
}

constexpr std::array<double, 16> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

} // namespace

Transform compose(const Transform &outer, const Transform &inner) { return outer * glm::dmat4(inner); }

Transform fromColumns(const std::array<double, 16> &columns) {
  return Transform(glm::make_mat4(columns.data()));
}

Transform readTransform(const GltfObject &node) {
  if (node.has("matrix"))
    return fromColumns(node.numbers<16>("matrix", kIdentity));
  if (!node.has("translation") && !node.has("rotation") && !node.has("scale"))
    return {};
  return fromParts(node.numbers<3>("translation", {0, 0, 0}), node.numbers<4>("rotation", {0, 0, 0, 1}),
                   node.numbers<3>("scale", {1, 1, 1}));
}

InstanceTransforms::InstanceTransforms(const GltfObject &instancing, GltfAccessors &accessors) {
  const GltfObject attributes = instancing.object("attributes");
  translations_ = read(attributes, "TRANSLATION", 3, accessors);
  rotations_ = read(attributes, "ROTATION", 4, accessors);
  scales_ = read(attributes, "SCALE", 3, accessors);
  for (const AttributeView &view : {translations_, rotations_, scales_})
    if (view && view.count != count_)
      attributes.problem("have different counts");
}

AttributeView InstanceTransforms::read(const GltfObject &attributes, std::string_view name,
                                       std::uint8_t components, GltfAccessors &accessors) {
  const auto index = attributes.index(name, accessors.list());
  if (!index)
    return {};
  const AttributeView view = accessors.view(*index);
  if (view && view.components != components)
    attributes.problem("have a " + std::string(name) + " of " + std::to_string(view.components) +
                       " components");
  count_ = std::max(count_, view.count);
  return view;
}

Transform InstanceTransforms::at(std::uint64_t instance) const {
  return fromParts(translations_ ? readRow<3>(translations_, instance) : Three{},
                   rotations_ ? readRow<4>(rotations_, instance) : Four{0, 0, 0, 1},
                   scales_ ? readRow<3>(scales_, instance) : Three{1, 1, 1});
}

} // namespace voxc
