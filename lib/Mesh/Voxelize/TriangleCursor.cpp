// Reading triangles in place, with short ways for what most files hold.
#include "Mesh/Voxelize/TriangleCursor.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cstring>

namespace voxc {

namespace {

using Type = AttributeView::Type;

template <typename Index> std::array<std::uint32_t, 3> indicesAt(const std::byte *row, std::uint32_t stride) {
  std::array<std::uint32_t, 3> indices;
  for (std::size_t i = 0; i < 3; ++i) {
    Index index;
    std::memcpy(&index, row + i * stride, sizeof index);
    indices[i] = index;
  }
  return indices;
}

template <typename Coordinate> glm::dvec3 pointAt(const std::byte *row) {
  std::array<Coordinate, 3> point;
  std::memcpy(point.data(), row, sizeof point);
  return {point[0], point[1], point[2]};
}

} // namespace

TriangleNumbers::TriangleNumbers(const TriangleScene &scene) {
  constexpr std::uint64_t kMost = std::uint64_t{1} << 33;
  firsts_.reserve(scene.instances.size() + 1);
  firsts_.push_back(0);
  for (const MeshInstance &instance : scene.instances)
    firsts_.push_back(
        std::min(firsts_.back() + std::min(scene.parts[instance.part].triangles(), kMost), kMost));
}

std::size_t TriangleNumbers::instanceOf(std::uint64_t triangle) const {
  const auto behind = std::upper_bound(firsts_.begin(), firsts_.end(), triangle);
  return static_cast<std::size_t>(behind - firsts_.begin()) - 1;
}

void TriangleCursor::enter(std::size_t instance) {
  first_ = numbers_.first(instance);
  end_ = numbers_.first(instance + 1);
  instance_ = &scene_.instances[instance];
  part_ = &scene_.parts[instance_->part];
  isMoved_ = instance_->toModel != Transform();
  isMirrored_ = isMoved_ && glm::determinant(glm::dmat3(instance_->toModel)) < 0;
  const AttributeView &indices = part_->indices;
  const bool isPlain = part_->mode == PrimitiveMode::Triangles &&
                       (indices.type == Type::Uint32 || indices.type == Type::Uint16);
  indexRows_ = isPlain ? indices.data : nullptr;
  const AttributeView &positions = part_->positions;
  areDoubles_ = positions.type == Type::Float64;
  const bool isPlainRow = (areDoubles_ || positions.type == Type::Float32) && positions.components >= 3;
  positionRows_ = isPlainRow ? positions.data : nullptr;
}

void TriangleCursor::moveTo(std::uint64_t triangle) {
  if (triangle < first_ || triangle >= end_)
    enter(numbers_.instanceOf(triangle));
  const std::uint64_t place = triangle - first_;
  const std::uint32_t stride = part_->indices.stride;
  const std::byte *row = indexRows_ + 3 * place * stride;
  if (!indexRows_)
    vertices_ = part_->corners(place);
  else if (part_->indices.type == Type::Uint32)
    vertices_ = indicesAt<std::uint32_t>(row, stride);
  else
    vertices_ = indicesAt<std::uint16_t>(row, stride);
}

glm::dvec3 TriangleCursor::corner(std::uint32_t vertex) const {
  if (!positionRows_) {
    const std::array<double, 3> row = readRow<3>(part_->positions, vertex);
    return {row[0], row[1], row[2]};
  }
  const std::byte *const row = positionRows_ + std::uint64_t{vertex} * part_->positions.stride;
  return areDoubles_ ? pointAt<double>(row) : pointAt<float>(row);
}

std::array<glm::dvec3, 3> TriangleCursor::corners() const {
  std::array<glm::dvec3, 3> corners{corner(vertices_[0]), corner(vertices_[1]), corner(vertices_[2])};
  if (isMoved_)
    for (glm::dvec3 &point : corners)
      point = instance_->toModel * glm::dvec4(point, 1);
  return corners;
}

bool TriangleCursor::isCollapsed(const std::array<glm::dvec3, 3> &corners) const {
  const auto &[a, b, c] = corners;
  return !part_->isThin() && (a == b || b == c || c == a);
}

} // namespace voxc
