// Materials of assimp's scenes.
#pragma once

#include "Mesh/FileBeside.h"
#include "Mesh/MeshInput.h"
#include "Mesh/TextureSet.h"
#include "Support/Problem.h"
#include "Support/Warnings.h"
#include "voxc/Mesh/TriangleScene.h"

#include <assimp/scene.h>

#include <set>
#include <span>
#include <string>
#include <vector>

namespace voxc {

/// Which of a mesh's sets of texture coordinates the textures of a material use.
struct AssimpUvSets {
  unsigned colour = 0;
  unsigned emission = 0;
};

/// Makes the materials of a scene, with the textures of their colours and of what they give off.
class AssimpMaterials {
public:
  AssimpMaterials(const aiScene &from, const MeshInput &input, TriangleScene &scene, Warnings &warnings,
                  Problem &problem);

  /// Adds all of them, at least one, in their order.
  void readAll();
  /// Those of a material; the first for one that does not exist.
  AssimpUvSets uvSets(unsigned material) const {
    return material < uvSets_.size() ? uvSets_[material] : AssimpUvSets();
  }
  std::uint64_t libraryPeakBytes() const { return textures_.libraryPeakBytes(); }

private:
  Material read(const aiMaterial &from, AssimpUvSets &uvSets);
  void readEmission(const aiMaterial &from, Material &material, unsigned &uvSet);
  TextureUse readTexture(const aiMaterial &from, std::span<const aiTextureType> types, unsigned &uvSet);
  void warnOnce(const std::string &sentence);
  int imageOf(const std::string &names);
  int embedded(const std::string &name, const aiTexture &texture);
  int fileOf(const std::string &name);
  int checked(const Expected<int> &index);
  void noteOthers(const aiMaterial &from);

  const aiScene &from_;
  const MeshInput &input_;
  TriangleScene &scene_;
  Warnings &warnings_;
  Problem &problem_;
  TextureSet textures_;
  FilesBeside files_;
  std::vector<AssimpUvSets> uvSets_;
  std::set<std::string> unused_; ///< Kinds of textures.
  std::set<std::string> said_;   ///< Warnings.
};

} // namespace voxc
