// The table of extensions.
#include "Mesh/Gltf/GltfExtensions.h"

#include <algorithm>
#include <array>

namespace voxc {

namespace {

constexpr std::array<std::string_view, 12> kRead{"KHR_texture_transform",
                                                 "KHR_mesh_quantization",
                                                 "EXT_mesh_gpu_instancing",
                                                 "KHR_draco_mesh_compression",
                                                 "EXT_meshopt_compression",
                                                 "KHR_meshopt_compression",
                                                 "EXT_texture_webp",
                                                 "KHR_materials_emissive_strength",
                                                 "KHR_materials_pbrSpecularGlossiness",
                                                 "KHR_materials_transmission",
                                                 "KHR_materials_unlit",
                                                 "KHR_node_visibility"};

/// Those that say nothing about where the surface is or which colour it has. A name that ends in _ stands for
/// all that begin so.
constexpr std::array<std::string_view, 14> kHarmless{
    "KHR_materials_",        "KHR_lights_",       "KHR_animation_", "KHR_node_",         "KHR_xmp",
    "KHR_xmp_json_ld",       "KHR_audio_",        "EXT_lights_",    "EXT_mesh_manifold", "EXT_structural_",
    "EXT_instance_features", "EXT_mesh_features", "MSFT_lod",       "MSFT_packing_"};

bool isRead(std::string_view name) { return std::ranges::find(kRead, name) != kRead.end(); }

bool isHarmless(std::string_view name) {
  return std::any_of(kHarmless.begin(), kHarmless.end(), [&](std::string_view known) {
    return known.ends_with('_') ? name.starts_with(known) : name == known;
  });
}

/// What to do about an extension that cannot be read.
std::string adviceOn(std::string_view name) {
  return name == "KHR_texture_basisu" ? "; convert its KTX2 textures to PNG, JPEG or WebP" : "";
}

} // namespace

void checkGltfExtensions(GltfContext &context) {
  const GltfList required = context.root.list("extensionsRequired");
  for (std::size_t i = 0; i < required.size(); ++i)
    if (const std::string name(required.text(i)); !isRead(name) && !isHarmless(name))
      context.problem.set("it requires the extension '" + name + "', which is not read" + adviceOn(name));
  // Those that are there count, though a file should list them too.
  std::set<std::string, std::less<>> names = context.root.extensionNames();
  const GltfList used = context.root.list("extensionsUsed");
  for (std::size_t i = 0; i < used.size(); ++i)
    names.emplace(used.text(i));
  for (const std::string &name : names)
    if (isHarmless(name) && !isRead(name))
      context.unused.insert(name);
    else if (!isRead(name))
      context.warnings.add("the model uses the extension '" + name + "', which is not read");
}

} // namespace voxc
