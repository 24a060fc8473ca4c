// What skins and morph targets make of the meshes of a glTF model, as it stands before it is animated.
#pragma once

#include "Mesh/Gltf/GltfAccessors.h"
#include "Mesh/Gltf/GltfPlaces.h"

#include <memory>
#include <optional>
#include <vector>

namespace voxc {

/// How a node deforms its mesh.
struct GltfPose {
  std::vector<double> weights; ///< Of morph targets, in their order.
  /// From the mesh as it is bound to each joint to the model; null without a skin.
  std::shared_ptr<const std::vector<Transform>> joints;
  Transform toModel; ///< Of the node: where what the skin does not bind stands.
};

/// Joints of a vertex, four in each set, and how much of it each of them moves.
struct GltfJointSet {
  AttributeView joints;
  AttributeView weights;
};

/// The positions that a morph target adds.
struct GltfMorph {
  AttributeView deltas;
  double weight = 0;
};

class GltfPoses {
public:
  GltfPoses(GltfContext &context, GltfBuffers &buffers, GltfAccessors &accessors)
      : context_(context), buffers_(buffers), accessors_(accessors), places_(context),
        skins_(context.root.list("skins")) {}

  /// The pose of a node's mesh, or nothing if it is as its positions are: it has no skin, and no target a
  /// weight. Problems: joints that do not exist, inverse bind matrices of another shape.
  std::optional<GltfPose> of(const GltfObject &node, const GltfObject &mesh, const Transform &toModel);

  /// The positions of a primitive in a pose, as doubles: those of the model if the pose has a skin, else of
  /// the mesh. Problems: a vertex that is bound to no joint of the skin, more work than the file is worth, no
  /// memory.
  AttributeView positions(const GltfObject &primitive, const AttributeView &positions, const GltfPose &pose,
                          const std::vector<GltfMorph> &morphs, const std::vector<GltfJointSet> &sets);

  /// Counts work that a few bytes of a file may ask for many times; false, with a problem, if it is too much.
  bool spend(const GltfObject &object, std::uint64_t work);

private:
  std::vector<double> weightsOf(const GltfObject &node, const GltfObject &mesh);
  std::shared_ptr<const std::vector<Transform>> jointsOf(std::size_t skin);
  AttributeView bindMatrices(const GltfObject &skin, std::size_t joints);
  GltfContext &context_;
  GltfBuffers &buffers_;
  GltfAccessors &accessors_;
  GltfPlaces places_;
  GltfList skins_;
  std::optional<std::size_t> lastSkin_; ///< Whose joints are kept.
  std::shared_ptr<const std::vector<Transform>> lastJoints_;
  std::uint64_t spent_ = 0;
};

} // namespace voxc
