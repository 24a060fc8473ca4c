// The head of a .glb file, which says how long all is that follows.
#include "Source/Export/GlbFile.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace voxc {

namespace {

constexpr std::uint32_t kOneMaterial = 2428; ///< Of the head's text,
constexpr std::uint32_t kEachMore = 768;     ///< and for each material more.

std::string numberText(double number) {
  std::array<char, 32> text;
  return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.17g", number))};
}

std::string boundText(const std::array<float, 3> &bound) {
  return "[" + numberText(bound[0]) + "," + numberText(bound[1]) + "," + numberText(bound[2]) + "]";
}

/// Column by column, with the row that every affine map has.
std::string matrixText(const Transform &transform) {
  std::string text;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row)
      text += numberText(transform[column][row]) + ",";
    text += column < 3 ? "0," : "1";
  }
  return text;
}

/// Columns further off a right angle than readers that take a matrix apart would let pass.
constexpr double kSkew = 1e-6;
/// Each brings columns far nearer to right angles than the one before it.
constexpr int kSweeps = 16;
constexpr std::array<std::pair<int, int>, 3> kColumnPairs{{{0, 1}, {0, 2}, {1, 2}}};

bool isSkew(const Transform &transform) {
  return std::ranges::any_of(kColumnPairs, [&](const auto &pair) {
    const glm::dvec3 &a = transform[pair.first], &b = transform[pair.second];
    return std::abs(glm::dot(a, b)) > kSkew * glm::length(a) * glm::length(b);
  });
}

/// Turns two columns within their plane; `turn` gets what takes that back.
void makeOrthogonal(Transform &stretch, glm::dmat3 &turn, int p, int q) {
  const glm::dvec3 a = stretch[p], b = stretch[q];
  const double product = glm::dot(a, b);
  const double ratio = (glm::dot(b, b) - glm::dot(a, a)) / (2 * product);
  if (product == 0 || !std::isfinite(ratio))
    return;
  const double tangent = std::copysign(1.0, ratio) / (std::abs(ratio) + std::hypot(1.0, ratio));
  const double cosine = 1 / std::hypot(1.0, tangent), sine = cosine * tangent;
  stretch[p] = cosine * a - sine * b;
  stretch[q] = sine * a + cosine * b;
  const glm::dvec3 first = turn[p], second = turn[q];
  turn[p] = cosine * first - sine * second;
  turn[q] = sine * first + cosine * second;
}

/// The maps of the nodes, the outermost first. A node may turn and stretch, but not skew; each map is one
/// that turns, and behind it one whose columns are orthogonal (its singular value decomposition, by Jacobi).
std::vector<Transform> nodeMaps(const Transform &voxelToModel) {
  if (!isSkew(voxelToModel))
    return {voxelToModel};
  Transform stretch = voxelToModel;
  glm::dmat3 turn(1.0);
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (const auto &[p, q] : kColumnPairs)
      makeOrthogonal(stretch, turn, p, q);
  const glm::dmat3 back = glm::transpose(turn);
  return {stretch, Transform(back[0], back[1], back[2], {})};
}

/// In glTF +y is up, as it is in voxels. Where those lead to a model whose +z is up, the model is turned.
Transform withYUp(const Transform &voxelToModel) {
  const glm::dvec3 up = voxelToModel[1];
  if (!(up.z > std::abs(up.x) && up.z > std::abs(up.y)))
    return voxelToModel;
  Transform turned = voxelToModel;
  for (int column = 0; column < 4; ++column) {
    turned[column].y = voxelToModel[column].z;
    turned[column].z = -voxelToModel[column].y;
  }
  return turned;
}

/// Each node is the child of the one before it; the last has the mesh.
std::string nodesText(bool hasMesh, const Transform &voxelToModel) {
  const auto maps = nodeMaps(isFinite(voxelToModel) ? withYUp(voxelToModel) : Transform());
  std::string nodes;
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const bool isLast = i + 1 == maps.size();
    std::string node;
    if (!isLast)
      node = R"("children":[)" + std::to_string(i + 1) + "]";
    else if (hasMesh)
      node = R"("mesh":0)";
    if (rowsOf(maps[i]) != rowsOf(Transform()))
      node += std::string(node.empty() ? "" : ",") + R"("matrix":[)" + matrixText(maps[i]) + "]";
    nodes += (i == 0 ? "{" : ",{") + node + "}";
  }
  return nodes;
}

/// Padded with blanks to a size, so that it can be written last.
std::string jsonOf(const std::string &mesh, std::uint64_t bytes, const Transform &voxelToModel,
                   std::uint32_t size) {
  std::string json = R"({"asset":{"version":"2.0","generator":"voxc"},"scene":0,"scenes":[{"nodes":[0]}],)"
                     R"("nodes":[)" +
                     nodesText(!mesh.empty(), voxelToModel) + "]";
  if (!mesh.empty())
    json += "," + mesh + R"(,"buffers":[{"byteLength":)" + std::to_string(bytes) + "}]";
  json += "}";
  json.resize(size, ' ');
  return json;
}

} // namespace

void PositionBounds::add(const std::array<float, 3> &position) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low_[axis] = std::min(low_[axis], position[axis]);
    high_[axis] = std::max(high_[axis], position[axis]);
  }
}

std::string PositionBounds::text() const {
  return R"("min":)" + boundText(low_) + R"(,"max":)" + boundText(high_);
}

std::string jsonNumber(double number) {
  std::array<char, 32> text;
  return {text.data(), static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%.9g", number))};
}

Expected<void> GlbFile::begin(std::size_t materials) {
  jsonBytes_ = kOneMaterial + kEachMore * static_cast<std::uint32_t>(std::max<std::size_t>(materials, 1) - 1);
  const std::string room(binaryOffset(), ' ');
  return file_.write(room.data(), room.size());
}

Expected<void> GlbFile::write(const void *bytes, std::uint64_t size) {
  constexpr std::uint64_t kMost = std::numeric_limits<std::uint32_t>::max();
  if (size > kMost - binaryOffset() - 3 - bytes_)
    return Error::input(
        "the surface takes more than the 4 GiB that a .glb file can hold; export a part of it, or points");
  bytes_ += size;
  return file_.write(bytes, size);
}

Expected<void> GlbFile::finish(const std::string &mesh, const Transform &voxelToModel) {
  constexpr std::array<char, 3> kPadding{};
  VOXC_TRY(write(kPadding.data(), -bytes_ % 4));
  std::string head = "glTF";
  const auto word = [&](std::uint64_t value) {
    const auto narrow = static_cast<std::uint32_t>(value);
    head.append(reinterpret_cast<const char *>(&narrow), sizeof narrow);
  };
  word(2);
  word(binaryOffset() + bytes_);
  word(jsonBytes_);
  head += "JSON" + jsonOf(mesh, bytes_, voxelToModel, jsonBytes_);
  word(bytes_);
  head += std::string("BIN\0", 4);
  return file_.rewrite(0, head.data(), head.size());
}

} // namespace voxc
