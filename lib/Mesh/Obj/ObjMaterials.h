// The materials that an .obj uses, with their textures.
#pragma once

#include "Mesh/FileBeside.h"
#include "Mesh/MeshInput.h"
#include "Mesh/Obj/MaterialLibrary.h"
#include "Mesh/TextureSet.h"
#include "Support/Problem.h"

#include <map>
#include <set>
#include <string>

namespace voxc {

class ObjMaterials {
public:
  ObjMaterials(const MeshInput &input, TriangleScene &scene, Warnings &warnings, Problem &problem);

  /// Reads the libraries of a line `mtllib`; one that cannot be read becomes a warning. If there is none, the
  /// one that is called as the model is taken, with a warning.
  void addLibraries(std::string_view names);

  /// Index of the scene's material for a name; white, with a warning, if it is not known. "" is that of faces
  /// without one.
  std::uint32_t use(const std::string &name);

  std::uint64_t libraryPeakBytes() const { return textures_.libraryPeakBytes(); }

private:
  bool addLibrary(std::string_view name);
  bool addOwnLibrary();
  const MtlMaterial *find(const std::string &name);
  Material makeMaterial(const std::string &name, const MtlMaterial &found);
  void makeEmission(const std::string &name, const MtlMaterial &found, Material &material);
  TextureUse makeTexture(const MtlTexture &texture, const std::string &folder);
  std::string imagePath(const MtlTexture &texture, const std::string &folder);

  const MeshInput &input_;
  TriangleScene &scene_;
  Warnings &warnings_;
  Problem &problem_;
  TextureSet textures_;
  FilesBeside files_;
  std::set<std::string> libraries_;
  std::map<std::string, std::string> images_; ///< Where the image of a folder and a name is.
  bool askedForOwn_ = false;                  ///< The library that is called as the model was looked for.
  std::map<std::string, MtlMaterial> known_;
  std::map<std::string, std::uint32_t> used_;
  std::set<std::string> missing_; ///< Those for which white stands in.
};

} // namespace voxc
