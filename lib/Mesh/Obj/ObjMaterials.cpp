// From names to materials of the scene.
#include "Mesh/Obj/ObjMaterials.h"

#include "Support/Text.h"

#include <algorithm>

namespace voxc {

ObjMaterials::ObjMaterials(const MeshInput &input, TriangleScene &scene, Warnings &warnings, Problem &problem)
    : input_(input), scene_(scene), warnings_(warnings), problem_(problem),
      textures_(input.memory, scene, warnings) {}

void ObjMaterials::addLibraries(std::string_view names) {
  // Names may have blanks in them, and several may stand in a line.
  if (addLibrary(std::string(trimmed(names))))
    return;
  std::string_view rest = names;
  for (std::string_view name = takeWord(rest); !name.empty(); name = takeWord(rest))
    if (!addLibrary(std::string(name)))
      warnings_.add("the material library '" + std::string(name) + "' cannot be read");
}

bool ObjMaterials::addLibrary(const std::string &name) {
  std::string path = name;
  std::replace(path.begin(), path.end(), '\\', '/');
  path = path.starts_with('/') ? path : input_.folder() + path;
  if (libraries_.contains(path))
    return true;
  const auto file = WatchedFile::open(path, input_.memory);
  if (!file)
    return false;
  libraries_.insert(path);
  readMtl((*file)->text(), name, folderOf(path), known_, warnings_);
  return true;
}

std::uint32_t ObjMaterials::use(const std::string &name) {
  const auto [entry, isNew] = used_.try_emplace(name, static_cast<std::uint32_t>(scene_.materials.size()));
  if (!isNew)
    return entry->second;
  const auto found = known_.find(name);
  if (found == known_.end() && !name.empty())
    warnings_.add("the material '" + name + "' is not defined; white stands in for it");
  scene_.materials.push_back(found == known_.end() ? Material() : makeMaterial(found->second));
  return entry->second;
}

Material ObjMaterials::makeMaterial(const MtlMaterial &found) {
  Material material;
  material.colour = found.colour;
  material.texture = makeTexture(found.texture);
  // A mask that is the texture itself means that texture's alpha, which counts anyway.
  if (found.alphaMask.image != found.texture.image)
    material.alphaMask = makeTexture(found.alphaMask);
  return material;
}

TextureUse ObjMaterials::makeTexture(const MtlTexture &texture) {
  TextureUse use;
  if (texture.image.empty())
    return use;
  const auto index = textures_.readFile(texture.image);
  if (!index) {
    problem_.set(index.error());
    return use;
  }
  use.texture = *index;
  if (texture.clamp)
    use.wrap = {TextureWrap::ClampToEdge, TextureWrap::ClampToEdge};
  // An .obj counts v from below, the scene from above.
  const auto &[su, sv] = texture.scale;
  const auto &[ou, ov] = texture.offset;
  use.matrix = {su, 0, ou, 0, sv, 1 - sv - ov};
  return use;
}

} // namespace voxc
