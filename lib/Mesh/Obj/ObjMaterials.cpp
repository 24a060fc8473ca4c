// From names to materials of the scene.
#include "Mesh/Obj/ObjMaterials.h"

#include "Support/Text.h"

#include <algorithm>
#include <utility>

namespace voxc {

ObjMaterials::ObjMaterials(const MeshInput &input, TriangleScene &scene, Warnings &warnings, Problem &problem)
    : input_(input), scene_(scene), warnings_(warnings), problem_(problem),
      textures_(input.memory, scene, warnings) {}

void ObjMaterials::addLibraries(std::string_view names) {
  // Names may have blanks in them, and several may stand in a line.
  if (addLibrary(names))
    return;
  std::string_view rest = names;
  for (std::string_view name = takeName(rest); !name.empty(); name = takeName(rest))
    if (!addLibrary(name) && !addOwnLibrary())
      warnings_.add("the material library '" + std::string(name) + "' cannot be read");
}

bool ObjMaterials::addLibrary(std::string_view name) {
  const std::string folder = input_.folder();
  const auto found = files_.find(name, std::span(&folder, 1));
  if (!found)
    return false;
  if (libraries_.contains(found->path))
    return true;
  const auto file = WatchedFile::open(found->path, input_.memory);
  if (!file)
    return false;
  if (found->isElsewhere)
    warnings_.add("the material library '" + std::string(trimmed(name)) + "' is not there; '" + found->path +
                  "' beside the model is taken");
  libraries_.insert(found->path);
  scene_.files.push_back(found->path);
  readMtl((*file)->text(), std::string(trimmed(name)), folderOf(found->path), known_, warnings_);
  // It may have what was missing before.
  std::erase_if(used_, [&](const auto &entry) { return missing_.contains(entry.first); });
  missing_.clear();
  return true;
}

/// A model that was called otherwise has lost its library, or the library its old name.
bool ObjMaterials::addOwnLibrary() {
  if (std::exchange(askedForOwn_, true))
    return false;
  const std::string folder = input_.folder();
  const std::string name = input_.path.substr(folder.size());
  const std::string library = name.substr(0, name.find_last_of('.')) + ".mtl";
  if (!files_.find(library, std::span(&folder, 1)))
    return false;
  warnings_.add("the model's material library is not there or not named; '" + library +
                "' beside it is taken");
  return addLibrary(library);
}

/// Libraries and models of different programs differ in letters.
const MtlMaterial *ObjMaterials::find(const std::string &name) {
  if (known_.empty() && libraries_.empty())
    addOwnLibrary();
  if (const auto found = known_.find(name); found != known_.end())
    return &found->second;
  const auto found = std::ranges::find_if(
      known_, [&](const auto &entry) { return lowerCase(entry.first) == lowerCase(name); });
  if (found == known_.end())
    return nullptr;
  warnings_.add("the material '" + name + "' is not defined; '" + found->first + "' stands in for it");
  return &found->second;
}

std::uint32_t ObjMaterials::use(const std::string &name) {
  const auto [entry, isNew] = used_.try_emplace(name, static_cast<std::uint32_t>(scene_.materials.size()));
  if (!isNew)
    return entry->second;
  const MtlMaterial *const found = name.empty() ? nullptr : find(name);
  if (!found && !name.empty()) {
    missing_.insert(name);
    warnings_.add("the material '" + name + "' is not defined; white stands in for it");
  }
  scene_.materials.push_back(found ? makeMaterial(name, *found) : Material());
  return entry->second;
}

Material ObjMaterials::makeMaterial(const std::string &name, const MtlMaterial &found) {
  Material material;
  material.colour = found.colour;
  material.texture = makeTexture(found.texture, found.folder);
  // A mask that is the texture itself means that texture's alpha, which counts anyway.
  if (found.alphaMask.image != found.texture.image)
    material.alphaMask = makeTexture(found.alphaMask, found.folder);
  material.alphaChannel = found.alphaMask.channel;
  // Maya writes black beside a texture, and shows the texture.
  const bool isBlack =
      std::ranges::all_of(std::span(material.colour).first(3), [](float c) { return c == 0; });
  if (isBlack && material.texture.texture >= 0) {
    std::ranges::fill(std::span(material.colour).first(3), 1.0f);
    warnings_.add("the material '" + name + "' has the Kd 0 beside a texture, which is taken as it is");
  }
  // MeshLab writes "Tr 1" for what is opaque.
  if (material.colour[3] <= 0) {
    material.colour[3] = 1;
    warnings_.add("the material '" + name + "' would be wholly invisible, and is taken for opaque");
  }
  makeEmission(name, found, material);
  material.hasMetal = found.metallic || found.roughness;
  material.metallic = found.metallic.value_or(0);
  material.roughness = found.roughness.value_or(1);
  return material;
}

/// Light above 1 keeps its hue; a texture alone is what the surface gives off.
void ObjMaterials::makeEmission(const std::string &name, const MtlMaterial &found, Material &material) {
  material.emission = found.emission.value_or(Material().emission);
  material.emissionTexture = makeTexture(found.emissionTexture, found.folder);
  if (material.emission == Material().emission && material.emissionTexture.texture >= 0) {
    material.emission.fill(1);
    if (found.emission)
      warnings_.add("the material '" + name +
                    "' has the Ke 0 beside a texture of what it gives off, which is taken as it is");
  }
  material.emissionStrength = std::max(std::ranges::max(material.emission), 1.0f);
  for (float &channel : material.emission)
    channel /= material.emissionStrength;
}

/// Where the image of a texture is; if nowhere, where it should be.
std::string ObjMaterials::imagePath(const MtlTexture &texture, const std::string &folder) {
  const auto [entry, isNew] =
      images_.try_emplace(folder + '\n' + texture.image, pathBelow(folder, texture.image));
  if (!isNew)
    return entry->second;
  const std::array<std::string, 2> folders{folder, input_.folder()};
  for (const std::string &name : {texture.image, texture.otherwise})
    if (const auto found = name.empty() ? std::nullopt : files_.find(name, folders)) {
      if (found->isElsewhere)
        warnings_.add("the texture '" + name + "' is not there; '" + found->path +
                      "' beside the model is taken");
      if (const std::size_t mark = name.find(" -");
          mark != std::string::npos && found->path.find(name.substr(mark)) == std::string::npos)
        warnings_.add("the texture '" + name + "' has options behind its name, which are not used");
      return entry->second = found->path;
    }
  return entry->second;
}

TextureUse ObjMaterials::makeTexture(const MtlTexture &texture, const std::string &folder) {
  TextureUse use;
  if (texture.image.empty())
    return use;
  const auto index = textures_.readFile(imagePath(texture, folder));
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
