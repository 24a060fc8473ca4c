// The hierarchy over instances: it leaves out none that a ray hits, however instances and rays lie.
#include "Trace/Instances/InstanceTree.h"

#include "Instances.h"

#include "voxc/Source/VoxelSource.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace voxc {
namespace {

constexpr Int3 kExtent{16, 16, 16};

using Random = std::mt19937;

float number(Random &random, float low, float high) {
  return std::uniform_real_distribution<float>(low, high)(random);
}

glm::vec3 vector(Random &random, float reach) {
  return {number(random, -reach, reach), number(random, -reach, reach), number(random, -reach, reach)};
}

/// A kind of places: what is asked of the proof of the boxes.
struct PlaceKind {
  const char *name;
  std::function<glm::mat4(Random &)> make;
};

std::vector<PlaceKind> placeKinds() {
  return {
      {"upright",
       [](Random &random) {
         return glm::scale(glm::translate(glm::mat4(1), vector(random, 100)),
                           glm::vec3(number(random, 0.1f, 3), number(random, -3, -0.1f), 1 / 3.0f));
       }},
      {"turned", [](Random &random) { return test::randomPlace(random, 100); }},
      {"far from the origin",
       [](Random &random) {
         return glm::translate(glm::mat4(1), glm::vec3(3e6f, -1e6f, 2e6f)) * test::randomPlace(random, 100);
       }},
      {"tiny", [](Random &random) { return glm::scale(test::randomPlace(random, 0), glm::vec3(1e-6f)); }},
      {"huge", [](Random &random) { return glm::scale(test::randomPlace(random, 1), glm::vec3(1e9f)); }},
      {"sheared",
       [](Random &random) {
         glm::mat4 matrix(1);
         for (int axis = 0; axis < 3; ++axis)
           matrix[axis] = glm::vec4(vector(random, 3), 0);
         matrix[3] = glm::vec4(vector(random, 50), 1);
         return matrix;
       }},
      {"nearly flat",
       [](Random &random) {
         const float thin = std::exp2(number(random, -22, 0));
         return glm::scale(test::randomPlace(random, 20), glm::vec3(1, 1, thin));
       }},
      {"flat and sheared",
       [](Random &random) {
         const float thin = std::exp2(number(random, -18, 0));
         return glm::scale(glm::rotate(glm::scale(test::randomPlace(random, 20), glm::vec3(1, thin, 1)), 0.7f,
                                       glm::vec3(1, 1, 0)),
                           glm::vec3(thin, 1, 1));
       }},
      {"at one place", [](Random &random) { return test::randomPlace(random, 0); }},
  };
}

/// A ray of the world that comes close to corners and edges of the instance, from so many of its sizes away.
Ray rayAt(Random &random, const glm::mat4 &place, int log2Distance) {
  const auto coordinate = [&] { return static_cast<float>(random() % 3) * 8; };
  const glm::vec3 corner(place * glm::vec4(coordinate(), coordinate(), coordinate(), 1));
  const glm::vec3 away(place * glm::vec4(vector(random, 16), 0));
  glm::vec3 origin = corner + away * std::exp2(static_cast<float>(log2Distance));
  if (random() % 4 == 0) {
    const int axis = static_cast<int>(random() % 3);
    origin[axis] = corner[axis]; // In a plane, which a box that is not larger may end before.
  }
  glm::vec3 to = corner;
  if (random() % 2 == 0) // Beside it, by as much as the ray may be rounded in the voxels.
    to += vector(random, std::exp2(static_cast<float>(log2Distance - 24)) * glm::length(away));
  const glm::vec3 direction = to - origin;
  return makeRay(origin, direction * std::exp2(number(random, -40, 40)));
}

/// Whether a traversal that is stopped and begun again after each of its instances comes to that one.
bool comesTo(const InstanceTree &tree, const Ray &ray, std::uint32_t wanted) {
  const BoxRay boxRay(ray, tree);
  InstanceKey last;
  while (true) {
    InstanceKey nearest{std::numeric_limits<float>::infinity(), InstanceTree::kNone};
    auto visit = [&](const InstanceKey &key, float &limit) {
      nearest = std::min(nearest, key);
      limit = nearest.moment;
    };
    tree.traverse(boxRay, {}, last, nearest.moment, visit);
    if (nearest.number == wanted || nearest.number == InstanceTree::kNone)
      return nearest.number == wanted;
    last = nearest;
  }
}

TEST(InstanceTree, LeavesOutNoInstanceThatARayHits) {
  const auto solid = makeFunctionSource(kExtent, [](Int3) { return 1u; });
  const auto oracle = Oracle::of(*solid);
  ASSERT_TRUE(oracle) << oracle.error().message;
  for (const PlaceKind &kind : placeKinds()) {
    Random random(5);
    std::vector<glm::mat4> places;
    std::vector<InstanceBox> boxes;
    for (int i = 0; i < 200; ++i) {
      places.push_back(kind.make(random));
      const glm::dmat4 toWorld(places.back());
      boxes.push_back(boxOf(toWorld, glm::inverse(toWorld), kExtent));
    }
    const InstanceTree tree(boxes);
    std::size_t hits = 0, left = 0;
    for (int i = 0; i < 12000; ++i) {
      const auto instance = static_cast<std::uint32_t>(random() % places.size());
      const Ray ray = rayAt(random, places[instance], i % 24);
      if (!oracle->trace(test::rayIn(places[instance], ray)).isHit())
        continue;
      ++hits;
      left += !comesTo(tree, ray, instance);
    }
    EXPECT_EQ(left, 0u) << kind.name;
    EXPECT_GT(hits, 2000u) << kind.name;
  }
}

TEST(InstanceTree, ComesToFewBoxesOfMany) {
  std::vector<InstanceBox> boxes;
  for (int x = 0; x < 100; ++x)
    for (int y = 0; y < 100; ++y) {
      const glm::dmat4 toWorld = glm::translate(glm::dmat4(1), glm::dvec3(20 * x, 20 * y, 0));
      boxes.push_back(boxOf(toWorld, glm::inverse(toWorld), kExtent));
    }
  const InstanceTree tree(boxes);
  EXPECT_LT(tree.mostStacked(), 40u);
  std::size_t visited = 0;
  auto visit = [&](const InstanceKey &, float &) { ++visited; };
  tree.traverse(BoxRay({{1005, 1005, 100}, {0, 0, -1}}, tree), {}, {}, 1e30f, visit);
  EXPECT_EQ(visited, 1u);
  tree.traverse(BoxRay({{-10, 5, 5}, {1, 0, 0}}, tree), {}, {}, 1e30f, visit);
  EXPECT_EQ(visited, 101u);
  tree.traverse(BoxRay({{-10, 5, 5}, {1, 0, 0}}, tree), {100, 200}, {}, 1e30f, visit);
  EXPECT_EQ(visited, 107u);
}

/// A thousand instances in the cells of a grid, each turned and scaled within its own.
InstanceTree gridOfInstances(Random &random) {
  std::vector<InstanceBox> boxes;
  for (int i = 0; i < 1000; ++i) {
    glm::mat4 place = glm::translate(glm::mat4(1), 16.0f * (glm::vec3(i % 10, i / 10 % 10, i / 100) + 0.5f));
    place = glm::rotate(place, number(random, 0, 6), glm::vec3(vector(random, 1)) + glm::vec3(0, 0, 2));
    place = glm::translate(glm::scale(place, glm::vec3(number(random, 0.1f, 0.5f))), glm::vec3(-8));
    boxes.push_back(boxOf(glm::dmat4(place), glm::inverse(glm::dmat4(place)), kExtent));
  }
  return InstanceTree(boxes);
}

/// How many boxes rays to points of the grid come to in the mean, from so many of its edges away.
double boxesFrom(const InstanceTree &tree, Random &random, int log2Edges) {
  constexpr int kRays = 1000;
  std::size_t visited = 0;
  auto visit = [&](const InstanceKey &, float &) { ++visited; };
  for (int i = 0; i < kRays; ++i) {
    const glm::vec3 to = vector(random, 80) + 80.0f;
    const glm::vec3 away = glm::vec3(1, 0.3f, 0.2f) + vector(random, 0.2f);
    const glm::vec3 origin = to + away * std::ldexp(160.0f, log2Edges);
    tree.traverse(BoxRay(makeRay(origin, to - origin), tree), {}, {}, std::numeric_limits<float>::infinity(),
                  visit);
  }
  return static_cast<double>(visited) / kRays;
}

/// What rays are rounded by in the voxels of an instance, and no more, makes boxes larger: a 32nd of the
/// world from 2^18 edges away.
TEST(InstanceTree, ComesToFewBoxesFromFarAway) {
  Random random(6);
  const InstanceTree tree = gridOfInstances(random);
  const double near = boxesFrom(tree, random, 0);
  EXPECT_LT(near, 6);
  EXPECT_LT(boxesFrom(tree, random, 12), 1.1 * near);
  EXPECT_LT(boxesFrom(tree, random, 16), 2.2 * near);
  EXPECT_LT(boxesFrom(tree, random, 18), 8 * near);
}

TEST(InstanceTree, RefusesToBoxWhatCannotBeHeld) {
  const auto box = [](const glm::dmat4 &toWorld) { return boxOf(toWorld, glm::inverse(toWorld), kExtent); };
  EXPECT_FALSE(box(glm::dmat4(1)).isEverywhere);
  EXPECT_TRUE(box(glm::scale(glm::dmat4(1), glm::dvec3(1, 1, 1e-6))).isEverywhere);
  EXPECT_TRUE(box(glm::scale(glm::dmat4(1), glm::dvec3(1e38))).isEverywhere);
  // Its inverse is no inverse.
  EXPECT_TRUE(boxOf(glm::dmat4(1), glm::scale(glm::dmat4(1), glm::dvec3(2)), kExtent).isEverywhere);
}

} // namespace
} // namespace voxc
