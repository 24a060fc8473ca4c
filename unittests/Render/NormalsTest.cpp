// Directions of surfaces from the voxels around.
#include "Render/PlaneFit.h"

#include "voxc/Render/SurfaceNormals.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace voxc {
namespace {

/// The neighbourhood whose voxels are those of which `isFull` says so, by their offset from the middle.
template <typename IsFull> Neighbourhood voxelsWhere(const IsFull &isFull) {
  Neighbourhood voxels{};
  for (int z = -kReach; z <= kReach; ++z)
    for (int y = -kReach; y <= kReach; ++y)
      for (int x = -kReach; x <= kReach; ++x)
        if (isFull(glm::vec3(float(x), float(y), float(z))))
          voxels[std::size_t(y + kReach + kNeighbours * (z + kReach))] |= std::uint16_t(1u << (x + kReach));
  return voxels;
}

/// The angle between two lines, in degrees.
float degreesBetween(const glm::vec3 &a, const glm::vec3 &b) {
  return std::acos(std::min(std::abs(glm::dot(glm::normalize(a), glm::normalize(b))), 1.0f)) * 57.29578f;
}

constexpr glm::vec3 kNormals[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 0}, {1, 1, 1}, {3, -1, 2}};

TEST(PlaneNormal, OfAShellIsThatOfItsPlane) {
  for (const glm::vec3 &normal : kNormals) {
    const glm::vec3 unit = glm::normalize(normal);
    const auto voxels = voxelsWhere([&](const glm::vec3 &at) { return std::abs(glm::dot(at, unit)) < 0.8f; });
    EXPECT_LT(degreesBetween(planeNormal(voxels), normal), 6) << normal.x << normal.y << normal.z;
  }
}

TEST(PlaneNormal, OfABodyIsThatOfItsSurface) {
  for (const glm::vec3 &normal : kNormals) {
    const glm::vec3 unit = glm::normalize(normal);
    const auto voxels = voxelsWhere([&](const glm::vec3 &at) { return glm::dot(at, unit) < 0.5f; });
    EXPECT_LT(degreesBetween(planeNormal(voxels), normal), 6) << normal.x << normal.y << normal.z;
  }
}

TEST(PlaneNormal, OfAHairOrALoneVoxelIsNone) {
  const auto hair = voxelsWhere([](const glm::vec3 &at) { return at.x == 0 && at.z == 0; });
  const auto lone = voxelsWhere([](const glm::vec3 &at) { return at == glm::vec3(0); });
  const auto all = voxelsWhere([](const glm::vec3 &) { return true; });
  for (const Neighbourhood &voxels : {hair, lone, all, Neighbourhood{}})
    EXPECT_EQ(planeNormal(voxels), glm::vec3(0));
}

/// A body with a flat top, and hits of two voxels of that.
struct Table {
  Table() : words{1} {
    info.format = *parseFormat("R(4,4,4)");
    info.extent = {16, 16, 16};
    for (int i = 0; i < 4096; ++i)
      words.push_back(i / 16 % 16 < 8 ? 0xff8090a0u : 0);
  }

  VolumeInfo info;
  std::vector<std::uint32_t> words;
  std::vector<Hit> hits{{{8, 7, 8}}, {{9, 7, 8}}};
};

TEST(SurfaceNormals, AreKeptForTheNextPicture) {
  Table table;
  const Volume volume(table.info, table.words);
  SurfaceNormals normals(volume, 1);
  EXPECT_EQ(normals.at(table.hits[0]).direction, glm::vec3(0));
  ASSERT_TRUE(normals.learn(table.hits));
  const std::atomic<bool> stop = true;
  // What is known already takes no work that could be ended.
  EXPECT_FALSE(normals.learn(table.hits, {.stop = &stop}));
  for (const Hit &hit : table.hits)
    EXPECT_LT(degreesBetween(normals.at(hit).direction, {0, 1, 0}), 6);
}

TEST(SurfaceNormals, OfAnEndedSearchAreFoundByTheNext) {
  Table table;
  const Volume volume(table.info, table.words);
  SurfaceNormals normals(volume, 1);
  const std::atomic<bool> stop = true;
  const Expected<void> learned = normals.learn(table.hits, {.stop = &stop});
  ASSERT_FALSE(learned);
  EXPECT_EQ(learned.error().kind, ErrorKind::Interrupted);
  EXPECT_EQ(normals.at(table.hits[0]).direction, glm::vec3(0));
  ASSERT_TRUE(normals.learn(table.hits));
  EXPECT_LT(degreesBetween(normals.at(table.hits[0]).direction, {0, 1, 0}), 6);
}

} // namespace
} // namespace voxc
