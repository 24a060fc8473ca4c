// The surface of a volume has every visible face once, in the colour of its voxel, seen from outside.
#include "SourceTesting.h"

#include "voxc/Mesh/MeshSource.h"
#include "voxc/Source/Export.h"
#include "voxc/Support/File.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>

namespace voxc {
namespace {

/// A voxel's face: its axis times 2, and 1 more if it looks along +axis.
struct Face {
  Int3 voxel;
  int side = 0;

  auto key() const { return std::array{voxel.x, voxel.y, voxel.z, side}; }
  bool operator<(const Face &other) const { return key() < other.key(); }
  bool operator==(const Face &other) const { return key() == other.key(); }
};
using Faces = std::map<Face, std::uint32_t>;

/// Its map to the model turns it.
Volume mappedVolume(const Voxels &voxels, Int3 extent) {
  return denseVolume(voxels, extent, transformOfRows({0, 0, 2, 5, 0, 2, 0, 6, -2, 0, 0, 7}));
}

Faces visibleFaces(const Voxels &voxels) {
  Faces faces;
  for (const auto &[code, word] : voxels)
    for (int side = 0; side < 6; ++side) {
      const Int3 voxel = mortonCell(code);
      Int3 beyond = voxel;
      beyond[side / 2] += side % 2 ? 1 : -1;
      if (beyond[side / 2] < 0 || !voxels.contains(mortonCode(beyond)))
        faces[{voxel, side}] = word;
    }
  return faces;
}

/// Adds the faces of a rectangle: the corners of its two triangles, counter-clockwise from outside.
void addFaces(const MeshPart &part, std::uint64_t triangle, Faces &faces) {
  const auto first = part.corners(triangle);
  const auto second = part.corners(triangle + 1);
  ASSERT_EQ(first[0], second[0]);
  ASSERT_EQ(first[2], second[1]);
  const auto at = [&](std::uint32_t corner) {
    const auto row = readRow<3>(part.positions, corner);
    return glm::dvec3(row[0], row[1], row[2]);
  };
  const glm::dvec3 normal = glm::cross(at(first[1]) - at(first[0]), at(first[2]) - at(first[0]));
  const glm::dvec3 other = glm::cross(at(second[1]) - at(second[0]), at(second[2]) - at(second[0]));
  ASSERT_EQ(normal, other);
  const int axis = normal.x != 0 ? 0 : normal.y != 0 ? 1 : 2;
  const bool isHigh = normal[axis] > 0;
  Int3 low;
  Int3 high;
  for (int i = 0; i < 3; ++i) {
    low[i] = static_cast<int>(std::min(at(first[0])[i], at(first[2])[i]));
    high[i] = static_cast<int>(std::max(at(first[0])[i], at(first[2])[i]));
  }
  ASSERT_EQ(low[axis], high[axis]);
  low[axis] -= isHigh;
  high[axis] = low[axis] + 1;
  const auto light = readRow<4>(part.colours, first[0]);
  const auto byte = [&](double value) { return static_cast<std::uint32_t>(std::lround(value * 255)); };
  // The curve of sRGB, in floating point.
  const auto encoded = [&](double value) {
    return byte(value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055);
  };
  const std::uint32_t word = rgba(encoded(light[0]), encoded(light[1]), encoded(light[2]), byte(light[3]));
  Int3 cell;
  for (cell.z = low.z; cell.z < high.z; ++cell.z)
    for (cell.y = low.y; cell.y < high.y; ++cell.y)
      for (cell.x = low.x; cell.x < high.x; ++cell.x)
        ASSERT_TRUE(faces.emplace(Face{cell, 2 * axis + isHigh}, word).second) << "a face stands twice";
}

Faces facesOf(const TriangleScene &scene) {
  Faces faces;
  for (const MeshPart &part : scene.parts)
    for (std::uint64_t triangle = 0; triangle < part.triangles(); triangle += 2)
      addFaces(part, triangle, faces);
  return faces;
}

TEST(SurfaceExport, HasEveryVisibleFaceOnce) {
  std::mt19937 random(3);
  const TemporaryFolder folder;
  const std::string path = folder.path("v.glb");
  for (const Int3 extent : {Int3{1, 1, 1}, Int3{5, 9, 3}, Int3{70, 66, 5}, Int3{3, 64, 130}})
    for (const unsigned sparse : {1u, 2u, 40u}) {
      Voxels voxels;
      Int3 cell;
      for (cell.z = 0; cell.z < extent.z; ++cell.z)
        for (cell.y = 0; cell.y < extent.y; ++cell.y)
          for (cell.x = 0; cell.x < extent.x; ++cell.x)
            if (random() % sparse == 0)
              voxels[mortonCode(cell)] = rgba(random() % 2 * 255, 7, 9, 1 + random() % 2 * 254);
      const auto exported = exportVoxels(mappedVolume(voxels, extent), path);
      ASSERT_TRUE(exported) << exported.error().message;
      if (voxels.empty())
        continue;
      const auto scene = loadScene(path, WorkingMemory::createDefault());
      ASSERT_TRUE(scene) << scene.error().message;
      EXPECT_EQ(scene->warnings, std::vector<std::string>());
      EXPECT_EQ(facesOf(*scene), visibleFaces(voxels));
      EXPECT_EQ(triangleCount(*scene), 2 * exported->rectangles);
      ASSERT_EQ(scene->instances.size(), 1u);
      EXPECT_EQ(rowsOf(scene->instances[0].toModel),
                (std::array<double, 12>{0, 0, 2, 5, 0, 2, 0, 6, -2, 0, 0, 7}));
    }
}

/// The matrices of the nodes of a .glb, column by column.
std::vector<std::array<double, 16>> matricesOf(const std::string &path) {
  const std::string text = *readTextFile(path);
  const std::string begin = R"("matrix":[)";
  std::vector<std::array<double, 16>> matrices;
  for (std::size_t at = text.find(begin); at != std::string::npos; at = text.find(begin, at)) {
    at += begin.size();
    for (double &entry : matrices.emplace_back()) {
      char *end = nullptr;
      entry = std::strtod(text.c_str() + at, &end);
      at = static_cast<std::size_t>(end - text.c_str()) + 1;
    }
  }
  return matrices;
}

glm::dmat3 linearPartOf(const std::array<double, 16> &m) {
  return {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]};
}

/// glTF allows no node whose matrix is skew: rotations with a scale between them are none, and give the same.
TEST(SurfaceExport, WritesASkewMapAsTwoNodes) {
  const TemporaryFolder folder;
  const std::string path = folder.path("v.glb");
  const Voxels voxels{{mortonCode({1, 0, 0}), rgba(9, 8, 7)}};
  for (const std::array<double, 12> &rows :
       {std::array<double, 12>{1, 0.5, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7}, // Sheared, as a tilted scan is;
        {-2, 0.1, 0.7, 1, 0.3, 3, -1, 2, 0.2, 0.4, 0.5, 3},           // mirrored as well;
        {1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0}}) {                      // without a volume.
    ASSERT_TRUE(exportVoxels(denseVolume(voxels, {2, 2, 2}, transformOfRows(rows)), path));
    const auto matrices = matricesOf(path);
    ASSERT_EQ(matrices.size(), 2u);
    for (const auto &matrix : matrices) {
      const glm::dmat3 columns = linearPartOf(matrix);
      for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(glm::dot(columns[i], columns[(i + 1) % 3]), 0, 1e-12);
    }
    EXPECT_NEAR(glm::determinant(linearPartOf(matrices[1])), 1, 1e-12);
    const auto scene = loadScene(path, WorkingMemory::createDefault());
    ASSERT_TRUE(scene) << scene.error().message;
    ASSERT_EQ(scene->instances.size(), 1u);
    const auto read = rowsOf(scene->instances[0].toModel);
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_NEAR(read[i], rows[i], 1e-12) << i;
  }
}

/// The voxels of `path`, a mesh in units of voxels.
Voxels voxelsOfMesh(const std::string &path, Int3 extent) {
  auto scene = loadScene(path, WorkingMemory::createDefault());
  EXPECT_TRUE(scene) << scene.error().message;
  VoxelizeOptions options;
  options.bounds = {{0, 0, 0, double(extent.x), double(extent.y), double(extent.z)}};
  options.resolution = std::max({extent.x, extent.y, extent.z});
  options.coverage = Coverage::Thin;
  auto source = makeMeshSource(std::make_shared<TriangleScene>(std::move(*scene)), options,
                               WorkingMemory::createDefault());
  EXPECT_TRUE(source) << source.error().message;
  return voxelsOf(**source);
}

TEST(SurfaceExport, ComesBackInTheSameColours) {
  const TemporaryFolder folder;
  const std::string path = folder.path("v.glb");
  // Each byte of each channel, and alpha down to what is hardly there.
  for (const std::uint32_t leastAlpha : {255u, 1u}) {
    Voxels voxels;
    for (int n = 0; n < 256; ++n) {
      const auto byte = static_cast<std::uint32_t>(n);
      voxels[mortonCode({2 * (n % 16), 0, 2 * (n / 16)})] =
          rgba(byte, 255 - byte, byte * 7 % 256, std::max(byte, leastAlpha));
    }
    ASSERT_TRUE(exportVoxels(denseVolume(voxels, {32, 1, 32}, Transform()), path));
    const Voxels back = voxelsOfMesh(path, {32, 1, 32});
    for (const auto &[code, word] : voxels)
      EXPECT_EQ(back.at(code), word);
  }
}

ExportOptions withTexture() {
  ExportOptions options;
  options.texture = true;
  return options;
}

Voxels randomVoxels(Int3 extent, unsigned sparse, std::mt19937 &random) {
  Voxels voxels;
  Int3 cell;
  for (cell.z = 0; cell.z < extent.z; ++cell.z)
    for (cell.y = 0; cell.y < extent.y; ++cell.y)
      for (cell.x = 0; cell.x < extent.x; ++cell.x)
        if (random() % sparse == 0)
          voxels[mortonCode(cell)] = rgba(random() % 256, random() % 256, random() % 256);
  return voxels;
}

/// Checks that each triangle has an area and that all of them share whole edges, and gives their area.
double areaOfClosed(const TriangleScene &scene) {
  using Point = std::array<double, 3>;
  std::map<std::pair<Point, Point>, int> edges; // Those that go one way less those that go the other.
  double area = 0;
  for (const MeshPart &part : scene.parts)
    for (std::uint64_t triangle = 0; triangle < part.triangles(); ++triangle) {
      const auto corners = part.corners(triangle);
      std::array<Point, 3> points;
      for (std::size_t i = 0; i < 3; ++i)
        points[i] = readRow<3>(part.positions, corners[i]);
      const auto at = [&](std::size_t i) { return glm::dvec3(points[i][0], points[i][1], points[i][2]); };
      const double twice = glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
      EXPECT_GT(twice, 0);
      area += twice / 2;
      for (std::size_t i = 0; i < 3; ++i) {
        ++edges[{points[i], points[(i + 1) % 3]}];
        --edges[{points[(i + 1) % 3], points[i]}];
      }
    }
  for (const auto &[edge, count] : edges)
    EXPECT_EQ(count, 0);
  return area;
}

TEST(SurfaceExport, WithATextureIsClosedAndComesBackInTheSameColours) {
  std::mt19937 random(7);
  const TemporaryFolder folder;
  const std::string path = folder.path("v.glb");
  for (const Int3 extent : {Int3{1, 1, 1}, Int3{5, 9, 3}, Int3{70, 66, 5}, Int3{3, 64, 130}})
    for (const unsigned sparse : {1u, 2u, 3u, 40u}) {
      const Voxels voxels = randomVoxels(extent, sparse, random);
      if (voxels.empty())
        continue;
      const auto exported = exportVoxels(denseVolume(voxels, extent, Transform()), path, withTexture());
      ASSERT_TRUE(exported) << exported.error().message;
      const auto scene = loadScene(path, WorkingMemory::createDefault());
      ASSERT_TRUE(scene) << scene.error().message;
      EXPECT_EQ(scene->warnings, std::vector<std::string>());
      EXPECT_NEAR(areaOfClosed(*scene), static_cast<double>(visibleFaces(voxels).size()), 1e-6);
    }
  // Apart from each other, so that no voxel beside them is taken too.
  Voxels apart;
  for (const auto &[code, word] : randomVoxels({35, 20, 30}, 2, random))
    apart[mortonCode(mortonCell(code) * 2)] = word;
  ASSERT_TRUE(exportVoxels(denseVolume(apart, {70, 40, 60}, Transform()), path, withTexture()));
  const Voxels back = voxelsOfMesh(path, {70, 40, 60});
  for (const auto &[code, word] : apart)
    ASSERT_EQ(back.at(code), word);
}

TEST(SurfaceExport, WithATextureMergesColours) {
  const TemporaryFolder folder;
  Voxels voxels;
  for (int x = 0; x < 60; ++x)
    for (int z = 0; z < 60; ++z)
      voxels[mortonCode({x, 0, z})] = rgba(static_cast<std::uint32_t>(x), 9, static_cast<std::uint32_t>(z));
  const auto plate = exportVoxels(mappedVolume(voxels, {60, 1, 60}), folder.path("v.glb"), withTexture());
  ASSERT_TRUE(plate);
  EXPECT_EQ(plate->rectangles, 6u);
  const auto other = exportVoxels(mappedVolume(voxels, {60, 1, 60}), folder.path("v.ply"), withTexture());
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().message.find("only a file that ends in .glb"), std::string::npos);
}

TEST(SurfaceExport, MergesWhatIsFlatAndOfOneColour) {
  const TemporaryFolder folder;
  Voxels voxels;
  for (int x = 0; x < 60; ++x)
    for (int z = 0; z < 60; ++z)
      voxels[mortonCode({x, 0, z})] = rgba(9, 9, 9);
  const auto plate = exportVoxels(mappedVolume(voxels, {60, 1, 60}), folder.path("v.glb"));
  ASSERT_TRUE(plate);
  EXPECT_EQ(plate->rectangles, 6u);
  voxels[mortonCode({30, 0, 30})] = rgba(1, 1, 1);
  const auto spotted = exportVoxels(mappedVolume(voxels, {60, 1, 60}), folder.path("v.glb"));
  ASSERT_TRUE(spotted);
  // Above and below the spot, what is before it, beside it on both sides, and behind it.
  EXPECT_EQ(spotted->rectangles, 4u + 2 * 5);
}

TEST(SurfaceExport, OfNothingIsAModelWithoutAMesh) {
  const TemporaryFolder folder;
  ASSERT_TRUE(exportVoxels(mappedVolume({}, {4, 4, 4}), folder.path("t.glb"), withTexture()));
  ASSERT_TRUE(exportVoxels(mappedVolume({}, {4, 4, 4}), folder.path("v.glb")));
  std::ifstream file(folder.path("v.glb"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(bytes.find("meshes"), std::string::npos);
}

} // namespace
} // namespace voxc
