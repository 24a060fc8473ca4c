// Meshes of a glTF model as parts of a scene.
#pragma once

#include "Mesh/Gltf/GltfAccessors.h"
#include "Mesh/Gltf/GltfDraco.h"
#include "Mesh/Gltf/GltfMaterials.h"
#include "Mesh/Gltf/GltfPoses.h"

#include <optional>
#include <set>
#include <vector>

namespace voxc {

class GltfMeshes {
public:
  GltfMeshes(GltfContext &context, GltfBuffers &buffers, GltfAccessors &accessors, GltfMaterials &materials,
             GltfPoses &poses);

  const GltfList &list() const { return list_; }

  /// The scene's parts from `begin` to before `end`.
  struct Parts {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };

  /// The parts of a mesh, which are read when it is asked for first.
  Parts parts(std::size_t mesh);
  /// Those of a mesh in a pose, which are read anew.
  Parts parts(std::size_t mesh, const GltfPose &pose);

private:
  Parts readParts(std::size_t mesh, const GltfPose *pose);
  /// Names attributes that have no place in voxels.
  void noteAttributes(const GltfObject &attributes);
  /// Warns of corners behind the last whole triangle or line.
  void checkSurplus(const GltfObject &primitive, const MeshPart &part);
  void readPrimitive(const GltfObject &primitive, const GltfPose *pose);
  void applyPose(const GltfObject &primitive, const GltfPose &pose, MeshPart &part);
  std::vector<GltfMorph> morphsOf(const GltfObject &primitive, const GltfPose &pose, const MeshPart &part);
  std::vector<GltfJointSet> jointSetsOf(const GltfObject &attributes, const MeshPart &part);
  /// The coordinates that a texture takes; absent, with a warning, if the primitive has none.
  AttributeView readUvs(const GltfObject &attributes, const TextureUse &texture, std::uint64_t set,
                        const MeshPart &part);
  void readColours(const GltfObject &attributes, MeshPart &part);
  /// True if a number is above 1; once for each accessor.
  bool areAboveOne(const GltfObject &attributes, const AttributeView &colours);
  /// The rows of an attribute, of Draco's mesh if there is one that has it. `index` is that of its accessor.
  AttributeView rowsOf(const std::string &name, std::size_t index) const;
  /// What an accessor gives for an attribute, after a look at its rows and how many numbers they have.
  AttributeView checked(const GltfObject &attributes, const std::string &name, std::size_t index,
                        const AttributeView &view, std::array<std::uint8_t, 2> components,
                        const MeshPart &part) const;
  AttributeView attribute(const GltfObject &attributes, const std::string &name, std::uint8_t fewest,
                          std::uint8_t most, const MeshPart &part);
  AttributeView readIndices(const GltfObject &primitive);

  GltfContext &context_;
  GltfBuffers &buffers_;
  GltfAccessors &accessors_;
  GltfMaterials &materials_;
  GltfList list_;
  GltfPoses &poses_;
  std::vector<std::optional<Parts>> known_;
  std::set<std::size_t> aboveOne_; ///< Accessors of colours of which that was looked for.
  std::optional<DracoMesh> draco_; ///< Of the primitive that is being read.
};

} // namespace voxc
