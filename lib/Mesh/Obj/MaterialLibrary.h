// Material libraries of .obj files.
#pragma once

#include "Support/Problem.h"
#include "Support/Warnings.h"
#include "voxc/Mesh/TriangleScene.h"

#include <map>
#include <string>
#include <string_view>

namespace voxc {

/// A texture as an .mtl names it. The image is a path below the library's folder; empty if there is none.
struct MtlTexture {
  std::string image;
  bool clamp = false;
  std::array<float, 2> scale{1, 1};
  std::array<float, 2> offset{0, 0};
};

struct MtlMaterial {
  std::array<float, 4> colour{1, 1, 1, 1};
  MtlTexture texture;
  MtlTexture alphaMask;
};

/// Adds the materials of a library's text. What is malformed becomes a warning that names `library`; paths of
/// images begin with `folder`.
void readMtl(std::string_view text, const std::string &library, const std::string &folder,
             std::map<std::string, MtlMaterial> &materials, Warnings &warnings);

} // namespace voxc
