// Triangles as mesh files store them: parts, instances of parts, materials. What the readers make and the
// voxelizer takes; nothing is written out that a file can be read from in place.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Support/Progress.h"
#include "voxc/Support/Transform.h"
#include "voxc/Support/WorkingMemory.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace voxc {

/// Numbers of a vertex attribute, or indices, as they lie in memory or in a mapped file: `count` rows of
/// `components` numbers, `stride` bytes apart. Whoever makes a view has checked that all rows lie in range.
struct AttributeView {
  enum class Type : std::uint8_t { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

  const std::byte *data = nullptr; ///< Null: the attribute is absent.
  std::uint64_t count = 0;
  std::uint32_t stride = 0; ///< In bytes; 0 repeats one row.
  Type type = Type::Float32;
  std::uint8_t components = 1;
  bool normalized = false; ///< Integers stand for [0, 1] or [-1, 1].

  explicit operator bool() const { return data != nullptr; }
};

/// The first `N` numbers of a row; those that a row does not have are 0. Normalized integers are divided.
template <int N> std::array<double, N> readRow(const AttributeView &view, std::uint64_t row);
/// The one integer of a row of indices.
std::uint32_t readIndex(const AttributeView &view, std::uint64_t row);

/// How the vertices of a part make primitives; the numbers are glTF's.
enum class PrimitiveMode : std::uint8_t {
  Points,
  Lines,
  LineLoop,
  LineStrip,
  Triangles,
  TriangleStrip,
  TriangleFan
};

/// Geometry of one material. A line or a point is a triangle whose corners coincide.
struct MeshPart {
  AttributeView positions;   ///< Three components.
  AttributeView uvs;         ///< Two: those that the material's texture takes; or absent. May not be finite.
  AttributeView emissionUvs; ///< The same of its `emissionTexture`,
  AttributeView metalUvs;    ///< and of its `metalTexture`.
  AttributeView colours;     ///< Three or four, 0 to 1 (not checked); or absent.
  AttributeView indices;     ///< Absent: the vertices in their order.
  PrimitiveMode mode = PrimitiveMode::Triangles;
  std::uint32_t material = 0;

  /// Lines or points, which have no area.
  bool isThin() const { return mode < PrimitiveMode::Triangles; }
  /// Number of primitives.
  std::uint64_t triangles() const;
  /// The vertices of a primitive.
  std::array<std::uint32_t, 3> corners(std::uint64_t triangle) const;
};

/// A part at a place.
struct MeshInstance {
  std::uint32_t part = 0;
  Transform toModel;
};

/// Texels in rows from the top, RGBA8 with R in the low byte. The texture coordinates (0, 0) and (1, 1) are
/// the low corner of the first texel and the high corner of the last.
struct Texture {
  int width = 0;
  int height = 0;
  std::shared_ptr<const ScratchArray<std::uint32_t>> texels;
};

/// What a texture is outside [0, 1].
enum class TextureWrap : std::uint8_t { Repeat, MirroredRepeat, ClampToEdge };

/// A texture as a material uses it: coordinates are first mapped by the 2x3 `matrix` (row-major).
struct TextureUse {
  int texture = -1; ///< Index into `TriangleScene::textures`, or -1.
  std::array<TextureWrap, 2> wrap{};
  std::array<float, 6> matrix{1, 0, 0, 0, 1, 0};
};

/// What alpha means.
enum class AlphaRule : std::uint8_t {
  Kept,   ///< What texture and mask do not cut out has the alpha of factor and vertices, but is always there.
  Blend,  ///< The same, but where that alpha is 0 of 255, the surface is cut out (glTF's BLEND).
  Mask,   ///< The product of all alpha is held against the cutoff; what it leaves is opaque (glTF's MASK).
  Opaque, ///< Nothing: all is opaque (glTF's OPAQUE).
};

/// The colour of a surface is factor, texture and vertex colour multiplied, and emission added. Texels are in
/// sRGB. Where `isLinear`, the numbers are linear light, as texels are made before they are multiplied; else
/// all are taken as they are.
struct Material {
  std::array<float, 4> colour{1, 1, 1, 1}; ///< The factor.
  TextureUse texture;
  TextureUse alphaMask;          ///< A texture of which a channel is the alpha (OBJ's map_d):
  std::uint8_t alphaChannel = 0; ///< 0 red, 1 green, 2 blue, 3 its own alpha.
  bool isLinear = false;
  AlphaRule alpha = AlphaRule::Kept;
  float alphaCutoff = 0.5;         ///< Below this alpha of texture and mask the surface is cut out.
  std::array<float, 3> emission{}; ///< What the surface gives off,
  TextureUse emissionTexture;      ///< which is multiplied by this texture.
  float emissionStrength = 1;      ///< So many times as bright it is, which no colour shows.
  bool hasMetal = false;           ///< One of the three below was said; they change no colour.
  float clear = 0;                 ///< How much light goes through, times the red of the texture.
  float metallic = 1;              ///< Times the blue of the texture.
  float roughness = 1;             ///< Times the green.
  TextureUse metalTexture;         ///< Its texels are no colours.
};

/// A whole model. Triangles are numbered through, instance after instance.
struct TriangleScene {
  std::vector<MeshPart> parts;
  std::vector<MeshInstance> instances;
  std::vector<Material> materials; ///< At least one.
  std::vector<Texture> textures;
  std::vector<std::string> warnings;                ///< One sentence each.
  std::vector<std::string> files;                   ///< That the model's own names and that were read.
  std::vector<std::shared_ptr<const void>> storage; ///< What the views point into.
  std::uint64_t loaderPeakBytes = 0; ///< What a library took beside the bound while it read; 0: nothing.
};

/// Triangles of all instances together.
std::uint64_t triangleCount(const TriangleScene &scene);

/// Reads .obj (with its .mtl and images), .ply, .glb, .gltf or .stl into `memory`, mapped files watched by
/// it. Errors: unreadable or broken files, no triangle, a coordinate that is not finite, an index that
/// points nowhere, 2^32 triangles or more. `withMetal`: textures of metal and roughness are wanted, too.
Expected<TriangleScene> loadScene(const std::string &path, const std::shared_ptr<WorkingMemory> &memory,
                                  const Progress &progress = {}, bool withMetal = false);

} // namespace voxc
