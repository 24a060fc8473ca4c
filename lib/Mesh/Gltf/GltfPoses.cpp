// Reading poses, and moving vertices by them.
#include "Mesh/Gltf/GltfPoses.h"

#include "Mesh/Gltf/GltfTransforms.h"
#include "Mesh/KeptArray.h"

#include <algorithm>

namespace voxc {

namespace {

using Type = AttributeView::Type;

/// Rows that may be read to place vertices: so many, and so many more for each byte of the files.
constexpr std::uint64_t kFewRows = std::uint64_t{1} << 22;
constexpr std::uint64_t kRowsPerByte = 16;

/// Vertices between two looks at memory.
constexpr std::uint64_t kStep = 256;

constexpr std::size_t kJointsPerSet = 4;

Transform matrixAt(const AttributeView &matrices, std::uint64_t row) {
  return fromColumns(readRow<16>(matrices, row));
}

/// The sum of the joints' maps by their weights, which need not add up to 1. One that no joint moves is moved
/// by the first that it names. Nothing if it names one that does not exist.
std::optional<Transform> blended(const std::vector<Transform> &joints, const std::vector<GltfJointSet> &sets,
                                 std::uint64_t vertex) {
  glm::dmat4x3 sum(0.0);
  double whole = 0;
  for (const GltfJointSet &set : sets) {
    const std::array<double, kJointsPerSet> names = readRow<kJointsPerSet>(set.joints, vertex);
    const std::array<double, kJointsPerSet> weights = readRow<kJointsPerSet>(set.weights, vertex);
    for (std::size_t i = 0; i < kJointsPerSet; ++i) {
      if (weights[i] == 0)
        continue;
      if (names[i] >= static_cast<double>(joints.size()))
        return std::nullopt;
      sum += joints[static_cast<std::size_t>(names[i])] * weights[i];
      whole += weights[i];
    }
  }
  if (whole != 0)
    return Transform(sum / whole);
  const double first = readRow<kJointsPerSet>(sets.front().joints, vertex)[0];
  if (first >= static_cast<double>(joints.size()))
    return std::nullopt;
  return joints[static_cast<std::size_t>(first)];
}

} // namespace

std::optional<GltfPose> GltfPoses::of(const GltfObject &node, const GltfObject &mesh,
                                      const Transform &toModel) {
  GltfPose pose{weightsOf(node, mesh), nullptr, toModel};
  if (const auto skin = node.index("skin", skins_))
    pose.joints = jointsOf(*skin);
  const bool isMorphed = std::ranges::any_of(pose.weights, [](double weight) { return weight != 0; });
  if (!isMorphed && !pose.joints)
    return std::nullopt;
  return pose;
}

std::vector<double> GltfPoses::weightsOf(const GltfObject &node, const GltfObject &mesh) {
  const GltfObject &from = node.has("weights") ? node : mesh;
  const GltfList list = from.list("weights");
  std::vector<double> weights;
  if (!spend(from, list.size()))
    return weights;
  weights.reserve(list.size());
  for (std::size_t i = 0; i < list.size(); ++i)
    weights.push_back(list.number(i));
  return weights;
}

std::shared_ptr<const std::vector<Transform>> GltfPoses::jointsOf(std::size_t skin) {
  if (lastSkin_ == skin)
    return lastJoints_;
  const GltfObject json = skins_[skin];
  const GltfList list = json.list("joints");
  const AttributeView matrices = bindMatrices(json, list.size());
  auto joints = std::make_shared<std::vector<Transform>>();
  if (spend(json, list.size())) {
    joints->reserve(list.size());
    for (std::size_t i = 0; i < list.size() && !context_.problem; ++i)
      if (const auto node = list.index(i, places_.nodes()))
        joints->push_back(matrices ? compose(places_.of(*node), matrixAt(matrices, i)) : places_.of(*node));
  }
  lastSkin_ = skin;
  lastJoints_ = std::move(joints);
  return lastJoints_;
}

AttributeView GltfPoses::bindMatrices(const GltfObject &skin, std::size_t joints) {
  const auto index = skin.index("inverseBindMatrices", accessors_.list());
  if (!index)
    return {};
  const AttributeView matrices = accessors_.view(*index);
  if (matrices && matrices.components != 16)
    skin.problem("has inverse bind matrices of " + std::to_string(matrices.components) + " components");
  else if (matrices && matrices.count < joints)
    skin.problem("has " + std::to_string(joints) + " joints, but " + std::to_string(matrices.count) +
                 " inverse bind matrices");
  return context_.problem ? AttributeView() : matrices;
}

bool GltfPoses::spend(const GltfObject &object, std::uint64_t work) {
  spent_ += work;
  const std::uint64_t most = kFewRows + kRowsPerByte * buffers_.bytesOfFiles();
  if (spent_ <= most)
    return true;
  object.problem("and those before it read more than " + std::to_string(most) +
                 " rows for skins and morph targets, too many for files of their size");
  return false;
}

AttributeView GltfPoses::positions(const GltfObject &primitive, const AttributeView &positions,
                                   const GltfPose &pose, const std::vector<GltfMorph> &morphs,
                                   const std::vector<GltfJointSet> &sets) {
  if (!spend(primitive, positions.count * (1 + morphs.size() + sets.size())))
    return {};
  ScratchArray<std::array<double, 3>> moved(context_.memory);
  if (auto resized = moved.resize(positions.count); !resized) {
    context_.problem.set(resized.error());
    return {};
  }
  for (std::uint64_t vertex = 0; vertex < positions.count; ++vertex) {
    if (vertex % kStep == 0)
      context_.memory->relieve();
    std::array<double, 3> point = readRow<3>(positions, vertex);
    for (const GltfMorph &morph : morphs) {
      const std::array<double, 3> delta = readRow<3>(morph.deltas, vertex);
      for (std::size_t axis = 0; axis < 3; ++axis)
        point[axis] += morph.weight * delta[axis];
    }
    if (pose.joints) {
      const auto place = sets.empty() ? pose.toModel : blended(*pose.joints, sets, vertex);
      if (!place) {
        primitive.problem("binds vertex " + std::to_string(vertex) + " to a joint that its skin, which has " +
                          std::to_string(pose.joints->size()) + ", does not have");
        return {};
      }
      const glm::dvec3 to = *place * glm::dvec4(point[0], point[1], point[2], 1);
      point = {to.x, to.y, to.z};
    }
    moved[vertex] = point;
  }
  return keep(std::move(moved), kDoubleRows3, context_.scene);
}

} // namespace voxc
