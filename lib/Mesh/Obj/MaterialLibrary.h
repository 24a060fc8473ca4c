// Material libraries of .obj files.
#pragma once

#include "Mesh/Obj/TextureOptions.h"
#include "Support/Problem.h"
#include "Support/Warnings.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace voxc {

struct MtlMaterial {
  std::array<float, 4> colour{1, 1, 1, 1};
  bool hasOpacity = false; ///< It has a `d`, which says more than a `Tr`.
  MtlTexture texture;
  MtlTexture alphaMask;
  std::string ambientImage;                     ///< Of `map_Ka`; most often that of `map_Kd`.
  std::optional<std::array<float, 3>> emission; ///< `Ke`, which may be above 1.
  MtlTexture emissionTexture;
  std::optional<float> metallic;  ///< `Pm`,
  std::optional<float> roughness; ///< and `Pr`.
  std::string folder;             ///< The library's, where images are looked for first.
};

/// Adds the materials of a library's text, which lies in `folder`. What is malformed becomes a warning that
/// names `library`, and so does, once, what would change how a surface looks and is not used. Numbers about
/// how light falls (`Ka`, `Ks`, `Ns`, `Ni`, `illum`, `Tf`) are passed over.
void readMtl(std::string_view text, const std::string &library, const std::string &folder,
             std::map<std::string, MtlMaterial> &materials, Warnings &warnings);

} // namespace voxc
