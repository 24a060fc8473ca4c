// glTF whose geometry Draco or meshoptimizer compressed, and whose textures are WebP.
#include "LoadTesting.h"

#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <gmock/gmock.h>
#include <meshoptimizer.h>
#include <webp/encode.h>

namespace voxc {
namespace {

using ::testing::HasSubstr;

using Triangles = std::vector<std::array<ReadCorner, 3>>;

/// A grid of triangles with a corner at each whole number, which quantizing to 2^n - 1 steps keeps.
struct GridMesh {
  explicit GridMesh(unsigned cells) {
    for (unsigned y = 0; y <= cells; ++y)
      for (unsigned x = 0; x <= cells; ++x)
        positions.insert(positions.end(), {float(x), float(y), float(x * y % 3)});
    for (unsigned y = 0; y < cells; ++y)
      for (unsigned x = 0; x < cells; ++x) {
        const unsigned first = x + (cells + 1) * y;
        for (const unsigned corner :
             {first, first + 1, first + cells + 2, first, first + cells + 2, first + cells + 1})
          indices.push_back(corner);
      }
  }

  unsigned points() const { return unsigned(positions.size() / 3); }

  Triangles triangles() const {
    Triangles all;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      std::array<ReadCorner, 3> triangle;
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (std::size_t axis = 0; axis < 3; ++axis)
          triangle[corner][axis] = positions[3 * indices[i + corner] + axis];
      all.push_back(turned(triangle));
    }
    std::ranges::sort(all);
    return all;
  }

  /// The same triangle with its least corner first.
  static std::array<ReadCorner, 3> turned(std::array<ReadCorner, 3> triangle) {
    std::ranges::rotate(triangle, std::ranges::min_element(triangle));
    return triangle;
  }

  std::vector<float> positions;
  std::vector<unsigned> indices;
};

Triangles sorted(Triangles triangles) {
  for (auto &triangle : triangles)
    triangle = GridMesh::turned(triangle);
  std::ranges::sort(triangles);
  return triangles;
}

/// A .glb of this JSON and this binary chunk.
std::string glb(std::string json, std::string binary) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  binary.resize((binary.size() + 3) / 4 * 4);
  const auto word = [](std::size_t value) { return bytesOf({std::uint32_t(value)}); };
  return "glTF" + word(2) + word(28 + json.size() + binary.size()) + word(json.size()) + "JSON" + json +
         word(binary.size()) + std::string("BIN\0", 4) + binary;
}

class CompressedGltf : public LoadTest {};

/// Positions and one colour a face, compressed; the ids of the two attributes.
std::string dracoBytes(const GridMesh &mesh, int method) {
  draco::TriangleSoupMeshBuilder builder;
  builder.Start(int(mesh.indices.size() / 3));
  const int positions = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  const int colours = builder.AddAttribute(draco::GeometryAttribute::COLOR, 4, draco::DT_UINT8);
  const std::array<std::uint8_t, 4> colour{255, 51, 0, 255};
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const draco::FaceIndex face{std::uint32_t(i / 3)};
    const float *at = mesh.positions.data();
    builder.SetAttributeValuesForFace(positions, face, at + 3 * mesh.indices[i], at + 3 * mesh.indices[i + 1],
                                      at + 3 * mesh.indices[i + 2]);
    builder.SetAttributeValuesForFace(colours, face, colour.data(), colour.data(), colour.data());
  }
  const auto built = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*built, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

std::string dracoModel(const GridMesh &mesh, const std::string &bytes, const std::string &ids) {
  const std::string points = std::to_string(mesh.points());
  return glb(R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_draco_mesh_compression"],
    "extensionsRequired":["KHR_draco_mesh_compression"],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1},"indices":2,
      "extensions":{"KHR_draco_mesh_compression":{"bufferView":0,"attributes":)" +
                 ids + R"(}}}]}],"accessors":[{"componentType":5126,"type":"VEC3","count":)" + points +
                 R"(},{"componentType":5121,"normalized":true,"type":"VEC4","count":)" + points +
                 R"(},{"componentType":5125,"type":"SCALAR","count":)" + std::to_string(mesh.indices.size()) +
                 R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + std::to_string(bytes.size()) +
                 R"(}],"buffers":[{"byteLength":)" + std::to_string(bytes.size()) + "}]}",
             bytes);
}

constexpr const char *kIds = R"({"POSITION":0,"COLOR_0":1})";

TEST_F(CompressedGltf, DracoIsDecoded) {
  const GridMesh mesh(15);
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const TriangleScene scene = load("m.glb", dracoModel(mesh, dracoBytes(mesh, method), kIds));
    EXPECT_EQ(scene.warnings, std::vector<std::string>());
    EXPECT_EQ(sorted(trianglesOf(scene)), mesh.triangles());
    ASSERT_EQ(scene.parts.size(), 1u);
    const auto colour = readRow<4>(scene.parts[0].colours, 3);
    EXPECT_EQ(colour, (std::array<double, 4>{1, 0.2, 0, 1}));
  }
}

/// Targets are not compressed: one that has no data moves nothing.
TEST_F(CompressedGltf, TargetsOfDracoAreTheirOwn) {
  const GridMesh mesh(15);
  std::string model = dracoModel(mesh, dracoBytes(mesh, draco::MESH_SEQUENTIAL_ENCODING), kIds);
  const std::string binary = model.substr(model.find(std::string("BIN\0", 4)) + 4);
  std::string json = model.substr(20, model.find(std::string("BIN\0", 4)) - 24);
  const auto insert = [&](const std::string &behind, const std::string &what) {
    json.insert(json.find(behind) + behind.size(), what);
  };
  insert(R"("meshes":[{)", R"("weights":[1],)");
  insert(R"("indices":2,)", R"("targets":[{"POSITION":3}],)");
  json.insert(json.find(R"(],"bufferViews")"),
              R"(,{"componentType":5126,"type":"VEC3","count":)" + std::to_string(mesh.points()) + "}");
  const TriangleScene scene = load("m.glb", glb(json, binary));
  EXPECT_EQ(sorted(trianglesOf(scene)), mesh.triangles());
}

TEST_F(CompressedGltf, BrokenDracoIsAnError) {
  const GridMesh mesh(15);
  const std::string bytes = dracoBytes(mesh, draco::MESH_EDGEBREAKER_ENCODING);
  const auto message = [&](const std::string &changed, const std::string &ids = kIds) {
    return problem("m.glb", dracoModel(mesh, changed, ids));
  };
  EXPECT_EQ(message(bytes), "no error");
  EXPECT_THAT(message("nonsense"), HasSubstr("no mesh of Draco 2.2"));
  EXPECT_THAT(message(bytes.substr(0, bytes.size() / 2)), HasSubstr("has broken data"));
  EXPECT_THAT(message(bytes, R"({"POSITION":7})"), HasSubstr("has no attribute 7"));
  // 2^28 points of 2^28 faces: bytes 12 to 19 of the head.
  std::string claims = bytes.substr(0, 12) + "\x80\x80\x80\x80\1\x80\x80\x80\x80\1" + bytes.substr(14);
  EXPECT_THAT(message(claims), HasSubstr("claims 268435456 faces"));
  // Whatever is broken ends in an error or in a mesh.
  for (std::size_t at = 11; at < bytes.size(); at += 3) {
    std::string changed = bytes;
    changed[at] = char(changed[at] ^ 0x55);
    message(changed);
  }
}

/// Views 0 and 1, positions and indices, are compressed; buffer 1 has no bytes.
std::string meshoptModel(const GridMesh &mesh, const std::string &filter = "NONE") {
  std::string vertices(meshopt_encodeVertexBufferBound(mesh.points(), 12), '\0');
  vertices.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char *>(vertices.data()),
                                             vertices.size(), mesh.positions.data(), mesh.points(), 12));
  std::string indices(meshopt_encodeIndexBufferBound(mesh.indices.size(), mesh.points()), '\0');
  indices.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char *>(indices.data()), indices.size(),
                                           mesh.indices.data(), mesh.indices.size()));
  const auto number = [](std::size_t value) { return std::to_string(value); };
  const std::string points = number(mesh.points());
  const std::string corners = number(mesh.indices.size());
  return glb(
      R"({"asset":{"version":"2.0"},"extensionsRequired":["EXT_meshopt_compression"],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
          points + R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" + corners +
          R"(}],"bufferViews":[{"buffer":1,"byteStride":12,"byteLength":)" + number(12 * mesh.points()) +
          R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0,"mode":"ATTRIBUTES","filter":")" + filter +
          R"(","byteStride":12,"count":)" + points + R"(,"byteLength":)" + number(vertices.size()) +
          R"(}}},{"buffer":1,"byteLength":)" + number(4 * mesh.indices.size()) +
          R"(,"extensions":{"EXT_meshopt_compression":{"buffer":0,"mode":"TRIANGLES","byteStride":4,"count":)" +
          corners + R"(,"byteOffset":)" + number(vertices.size()) + R"(,"byteLength":)" +
          number(indices.size()) + R"(}}}],"buffers":[{"byteLength":)" +
          number(vertices.size() + indices.size()) +
          R"(},{"byteLength":999999,"extensions":{"EXT_meshopt_compression":{"fallback":true}}}]})",
      vertices + indices);
}

TEST_F(CompressedGltf, MeshoptIsDecoded) {
  const GridMesh mesh(20);
  const TriangleScene scene = load("m.glb", meshoptModel(mesh));
  EXPECT_EQ(scene.warnings, std::vector<std::string>());
  EXPECT_EQ(sorted(trianglesOf(scene)), mesh.triangles());
}

TEST_F(CompressedGltf, BrokenMeshoptIsAnError) {
  const GridMesh mesh(20);
  const std::string model = meshoptModel(mesh);
  const auto with = [&](const std::string &from, const std::string &to) {
    std::string changed = model;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return problem("m.glb", changed.replace(at, from.size(), to));
  };
  EXPECT_EQ(problem("m.glb", model), "no error");
  EXPECT_THAT(with("ATTRIBUTES", "ATTRIBUTED"), HasSubstr("that is not known"));
  EXPECT_THAT(problem("m.glb", meshoptModel(mesh, "QUATERNION")), HasSubstr("do not go together"));
  EXPECT_THAT(with(R"("byteStride":12,"count":441)", R"("byteStride":13,"count":441)"),
              HasSubstr("do not go together"));
  EXPECT_THAT(with(R"("byteStride":4,"count":2400)", R"("byteStride":4,"count":9e99)"), HasSubstr("count"));
  EXPECT_THAT(with(R"("byteStride":4,"count":2400)", R"("byteStride":4,"count":3e8 )"),
              HasSubstr("more than its"));
  EXPECT_THAT(with(R"("byteStride":4,"count":2400)", R"("byteStride":4,"count":2403)"),
              HasSubstr("that are broken"));
  EXPECT_THAT(with(R"("byteStride":12,"byteLength":5292)", R"("byteStride":12,"byteLength":5293)"),
              HasSubstr("not that of its compressed data"));
}

TEST_F(CompressedGltf, WebPTexturesAreRead) {
  const std::array<std::uint32_t, 2> texels{0xff0000ff, 0x4000ff00};
  std::uint8_t *encoded = nullptr;
  const std::size_t size =
      WebPEncodeLosslessRGBA(reinterpret_cast<const std::uint8_t *>(texels.data()), 2, 1, 8, &encoded);
  ASSERT_GT(size, 0u);
  const std::string image(reinterpret_cast<const char *>(encoded), size);
  WebPFree(encoded);
  const std::string corners = bytesOf({0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 1.f, 1.f, 0.f});
  const auto model = [&](const std::string &bytes) {
    return glb(R"({"asset":{"version":"2.0"},"extensionsRequired":["EXT_texture_webp"],"nodes":[{"mesh":0}],
      "meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}],
      "materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
      "textures":[{"extensions":{"EXT_texture_webp":{"source":0}}}],
      "images":[{"bufferView":1,"mimeType":"image/webp"}],
      "accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3},
        {"bufferView":0,"componentType":5126,"type":"VEC2","count":3}],
      "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":)" +
                   std::to_string(bytes.size()) + R"(}],"buffers":[{"byteLength":)" +
                   std::to_string(36 + bytes.size()) + "}]}",
               corners + bytes);
  };
  const TriangleScene scene = load("m.glb", model(image));
  EXPECT_EQ(scene.warnings, std::vector<std::string>());
  ASSERT_EQ(scene.textures.size(), 1u);
  EXPECT_EQ(texelsOf(scene.textures[0]), kTexels);
  // A broken one is left out.
  const TriangleScene broken = load("m.glb", model(image.substr(0, image.size() - 6)));
  ASSERT_EQ(broken.warnings.size(), 1u);
  EXPECT_THAT(broken.warnings[0], HasSubstr("is left out"));
}

TEST_F(CompressedGltf, Ktx2TexturesAreRefusedWithAdvice) {
  EXPECT_THAT(problem("m.gltf", R"({"asset":{"version":"2.0"},"extensionsRequired":["KHR_texture_basisu"]})"),
              HasSubstr("convert its KTX2 textures to PNG, JPEG or WebP"));
}

} // namespace
} // namespace voxc
