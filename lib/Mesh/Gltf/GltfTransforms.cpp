// Matrices, and those made of translation, rotation and scale.
#include "Mesh/Gltf/GltfTransforms.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

using Three = std::array<double, 3>;
using Four = std::array<double, 4>;

/// `rotation` is a quaternion x, y, z, w, and is brought to length 1.
Transform fromParts(const Three &move, const Four &rotation, const Three &scale) {
  auto [x, y, z, w] = rotation;
  const double length = std::sqrt(x * x + y * y + z * z + w * w);
  if (length > 0) {
    x /= length;
    y /= length;
    z /= length;
    w /= length;
  }
  Transform transform;
  transform.rows = {(1 - 2 * (y * y + z * z)) * scale[0], 2 * (x * y - w * z) * scale[1],
                    2 * (x * z + w * y) * scale[2],       move[0],
                    2 * (x * y + w * z) * scale[0],       (1 - 2 * (x * x + z * z)) * scale[1],
                    2 * (y * z - w * x) * scale[2],       move[1],
                    2 * (x * z - w * y) * scale[0],       2 * (y * z + w * x) * scale[1],
                    (1 - 2 * (x * x + y * y)) * scale[2], move[2]};
  return transform;
}

/// glTF writes matrices column by column.
Transform fromColumns(const std::array<double, 16> &columns) {
  Transform transform;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      transform.rows[4 * row + column] = columns[4 * column + row];
  return transform;
}

constexpr std::array<double, 16> kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

} // namespace

Transform compose(const Transform &outer, const Transform &inner) {
  Transform result;
  for (std::size_t row = 0; row < 3; ++row)
    for (std::size_t column = 0; column < 4; ++column) {
      double sum = column == 3 ? outer.rows[4 * row + 3] : 0;
      for (std::size_t k = 0; k < 3; ++k)
        sum += outer.rows[4 * row + k] * inner.rows[4 * k + column];
      result.rows[4 * row + column] = sum;
    }
  return result;
}

bool isFinite(const Transform &transform) {
  return std::all_of(transform.rows.begin(), transform.rows.end(), [](double v) { return std::isfinite(v); });
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
