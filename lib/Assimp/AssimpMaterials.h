// Materials of assimp's scenes.
#pragma once

#include "Mesh/FileBeside.h"
#include "Mesh/Image/TextureSet.h"
#include "Mesh/MeshInput.h"
#include "Support/Problem.h"
#include "Support/Warnings.h"
#include "voxc/Mesh/TriangleScene.h"

#include <assimp/scene.h>

#include <set>
#include <string>
#include <vector>

namespace voxc {

/// Makes the materials of a scene, with their diffuse textures.
class AssimpMaterials {
public:
  AssimpMaterials(const aiScene &from, const MeshInput &input, TriangleScene &scene, Warnings &warnings,
                  Problem &problem);

  /// Adds all of them, at least one, in their order.
  void readAll();
  /// Which of a mesh's sets of texture coordinates a material uses.
  unsigned uvSet(unsigned material) const { return material < uvSets_.size() ? uvSets_[material] : 0; }
  std::uint64_t libraryPeakBytes() const { return textures_.libraryPeakBytes(); }

private:
  Material read(const aiMaterial &from, unsigned &uvSet);
  TextureUse readTexture(const aiMaterial &from, unsigned &uvSet);
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
  std::vector<unsigned> uvSets_;
  std::set<std::string> unused_; ///< Kinds of textures.
  std::set<std::string> said_;   ///< Warnings.
};

} // namespace voxc
