// Triangle meshes with colours: what the loaders make and the voxelizer takes.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace voxc {

using Float2 = std::array<float, 2>;
using Float3 = std::array<float, 3>;

// Until the voxelizer takes TriangleScene: other types than those of the same name there.
inline namespace replaced {

/// A texture: rows from the top, RGBA8 with R in the low byte; repeats outside [0, 1].
struct Texture {
  int width = 0;
  int height = 0;
  std::vector<std::uint32_t> texels;
};

struct Material {
  std::array<float, 4> colour{1, 1, 1, 1}; ///< Multiplies texture and vertex colour.
  int texture = -1;                        ///< Index into `TriangleMesh::textures`, or -1.
  int alphaMask = -1;                      ///< A texture whose red channel is the alpha (OBJ's map_d), or -1.
  bool opaque = false;                     ///< The texture's own alpha means nothing (glTF's OPAQUE).
};

} // namespace replaced

struct Triangle {
  std::array<std::uint32_t, 3> vertices;
  std::uint32_t material = 0;
};

/// Vertices with optional colours and texture coordinates; `colours` and `uvs` are empty or one a vertex. The
/// texture coordinates (0, 0) and (1, 1) are the low corner of a texture's first texel and the high corner of
/// its last. Colours are taken as they are: no part converts between colour spaces.
struct TriangleMesh {
  std::vector<Float3> positions;
  std::vector<Float2> uvs;
  std::vector<std::uint32_t> colours;
  std::vector<Triangle> triangles;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<std::string> warnings;
};

/// Reads .obj (with its .mtl and images), .ply, .glb, .gltf or .stl; node transforms and instances applied.
/// Errors: unreadable or broken files, no triangle, a coordinate that is not finite.
Expected<TriangleMesh> loadMesh(const std::string &path);

} // namespace voxc
