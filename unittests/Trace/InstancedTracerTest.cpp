// Volumes that stand in one world: the nearest hit of all, on every device.
#include "voxc/Trace/InstancedTracer.h"

#include "Instances.h"

#include "TestLength.h"
#include "testing/HardScenes.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Kernel/OpenTracer.h"
#include "voxc/Trace/CpuKernel.h"

#include <glm/ext/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

namespace voxc {
namespace {

using testing::HasSubstr;

Volume makeVolume(const char *text, std::size_t scene) {
  const Format format = *parseFormat(text);
  auto built = Constructor::compile(format)->build(*test::hardScenes(format.extent())[scene].source());
  EXPECT_TRUE(built) << built.error().message;
  return std::move(built->volume);
}

std::unique_ptr<Tracer> open(const Volume &volume, const char *device = "cpu") {
  auto tracer = openTracer(volume, {.device = device});
  EXPECT_TRUE(tracer) << tracer.error().message;
  return std::move(*tracer);
}

/// The nearest hit of a ray by tracing it through every instance.
std::vector<InstanceHit> nearestOf(const std::vector<Instance> &instances, const std::vector<Ray> &rays) {
  std::vector<InstanceHit> nearest(rays.size(), InstanceHit{{{-1, -1, -1}, 0, 0, 0}});
  for (std::uint32_t number = 0; number < instances.size(); ++number) {
    std::vector<Ray> own;
    for (const Ray &ray : rays)
      own.push_back(test::rayIn(instances[number].toWorld, ray));
    std::vector<Hit> hits(rays.size());
    EXPECT_TRUE(instances[number].tracer->trace(own, hits));
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (hits[i].isHit() && (!nearest[i].isHit() || hits[i].t < nearest[i].hit.t))
        nearest[i] = {hits[i], number};
  }
  return nearest;
}

std::vector<InstanceHit> traced(const std::vector<Instance> &instances, const std::vector<Ray> &rays) {
  auto tracer = InstancedTracer::create(instances);
  EXPECT_TRUE(tracer) << tracer.error().message;
  std::vector<InstanceHit> hits(rays.size());
  const auto outcome = tracer->trace(rays, hits);
  EXPECT_TRUE(outcome) << outcome.error().message;
  return hits;
}

std::vector<Ray> raysAround(std::size_t count) {
  std::vector<Ray> rays = verifyRays(Int3{16, 16, 16}, count, 3);
  for (const test::HardRayClass &kind : test::hardRayClasses()) {
    const auto hard = test::hardRays({{16, 16, 16}}, kind.name, count / 10, 4);
    rays.insert(rays.end(), hard.begin(), hard.end());
  }
  return rays;
}

TEST(InstancedTracer, FindsTheNearestOfAllInstances) {
  const Volume tree = makeVolume("G(4)", 7), grid = makeVolume("R(2,3,2) M(1,1,1)", 8);
  const auto first = open(tree), second = open(grid);
  std::mt19937 random(7);
  const std::vector<Ray> rays = raysAround(20000);
  for (int round = 0; round < 4; ++round) {
    std::vector<Instance> instances;
    for (int i = 0; i < 6; ++i)
      instances.push_back(
          i % 2 == 0 ? Instance{first.get(), tree.format().extent(), test::randomPlace(random, 20)}
                     : Instance{second.get(), grid.format().extent(), test::randomPlace(random, 20)});
    const auto expected = nearestOf(instances, rays);
    EXPECT_EQ(test::countDifferent(traced(instances, rays), expected), 0u);
    EXPECT_GT(std::ranges::count_if(expected, [](const InstanceHit &hit) { return hit.instance > 2; }), 1000);
  }
}

TEST(InstancedTracer, FindsTheSameOnADevice) {
  if (listDevices().empty())
    GTEST_SKIP() << "there is no Vulkan device";
  const Volume volume = makeVolume("G(4)", 7);
  const auto cpu = open(volume), device = open(volume, "");
  std::mt19937 random(8);
  std::vector<Instance> instances;
  for (int i = 0; i < 3; ++i)
    instances.push_back({cpu.get(), volume.format().extent(), test::randomPlace(random, 20)});
  std::vector<Instance> others = instances;
  others[0].tracer = others[2].tracer = device.get(); // Of both kinds at once.
  const std::vector<Ray> rays = raysAround(3000 * static_cast<std::size_t>(test::rounds(1)));
  EXPECT_EQ(test::countDifferent(traced(others, rays), traced(instances, rays)), 0u);
}

std::unique_ptr<Tracer> openBounded(const Volume &volume) {
  Format format = volume.format();
  format.setAttribute(kBoundsAttribute, "yes");
  auto tracer = openTracer(volume, {.device = "cpu", .format = format});
  EXPECT_TRUE(tracer) << tracer.error().message;
  return std::move(*tracer);
}

/// Rays that end at the nearest hit so far find what rays without an end do, by fewer steps.
TEST(InstancedTracer, CutsRaysOffBehindWhatTheyHit) {
  const Volume volume = makeVolume("G(4)", 7);
  const auto whole = open(volume), cut = openBounded(volume);
  std::mt19937 random(11);
  std::vector<Instance> instances;
  for (int i = 0; i < 5; ++i)
    instances.push_back({whole.get(), volume.format().extent(), test::randomPlace(random, 20)});
  std::vector<Instance> others = instances;
  for (Instance &instance : others)
    instance = {cut.get(), instance.extent, instance.toWorld, true};
  const std::vector<Ray> rays = raysAround(20000);
  EXPECT_EQ(test::countDifferent(traced(others, rays), traced(instances, rays)), 0u);
}

TEST(InstancedTracer, KeepsTheBoundsOfRays) {
  const Volume volume = makeVolume("G(4)", 7);
  const auto whole = open(volume), cut = openBounded(volume);
  std::mt19937 random(12);
  const std::vector<Ray> rays = raysAround(3000);
  std::vector<BoundedRay> boundedRays;
  for (const Ray &ray : rays)
    boundedRays.push_back(bounded(ray, {float(random() % 10), float(5 + random() % 40)}));
  std::vector<Instance> instances;
  for (int i = 0; i < 3; ++i)
    instances.push_back({cut.get(), volume.format().extent(), test::randomPlace(random, 20), true});
  std::vector<InstanceHit> hits(rays.size()), expected(rays.size(), InstanceHit{{{-1, -1, -1}, 0, 0, 0}});
  ASSERT_TRUE(InstancedTracer::create(instances)->trace(boundedRays, hits));
  for (std::uint32_t number = 0; number < instances.size(); ++number) {
    std::vector<BoundedRay> own;
    for (const BoundedRay &ray : boundedRays)
      own.push_back(bounded(test::rayIn(instances[number].toWorld, ray.ray()), ray.bounds()));
    std::vector<Hit> found(rays.size());
    ASSERT_TRUE(cut->trace(own, found));
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (found[i].isHit() && (!expected[i].isHit() || found[i].t < expected[i].hit.t))
        expected[i] = {found[i], number};
  }
  EXPECT_EQ(test::countDifferent(hits, expected), 0u);
  EXPECT_GT(std::ranges::count_if(hits, &InstanceHit::isHit), 300);
  instances[1] = {whole.get(), volume.format().extent()};
  const auto refused = InstancedTracer::create(instances)->trace(boundedRays, hits);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("instance 1 is not said to take such"));
}

/// Two volumes beside each other are as one that holds both: by whole voxels nothing is rounded.
TEST(InstancedTracer, VolumesSideBySideAreAsOne) {
  const auto voxel = [](Int3 c) {
    return (c.x * 7 + c.y * 3 + c.z * 5) % 4 == 0 ? 0xff000000u + c.x + c.y : 0u;
  };
  const auto build = [&](Int3 low, Int3 size) {
    auto built = Constructor::compile(*parseFormat("G(4)"))->build(*makeFunctionSource(size, [=](Int3 c) {
      return voxel(c + low);
    }));
    return std::move(built->volume);
  };
  const Volume whole = build({0, 0, 0}, {16, 16, 16}), left = build({0, 0, 0}, {8, 16, 16}),
               right = build({8, 0, 0}, {8, 16, 16});
  const auto all = open(whole), a = open(left), b = open(right);
  std::mt19937 random(9);
  std::vector<Ray> rays;
  for (int i = 0; i < 20000; ++i) {
    const auto number = [&](int least, int most) {
      return static_cast<float>(std::uniform_int_distribution<int>(least, most)(random)) / 16;
    };
    rays.push_back({{number(-200, 400), number(-200, 400), number(-200, 400)},
                    {number(-16, 16), number(-16, 16), number(-16, 16)}});
  }
  std::vector<Hit> expected(rays.size());
  ASSERT_TRUE(all->trace(rays, expected));
  const auto hits = traced(
      {{a.get(), {16, 16, 16}}, {b.get(), {16, 16, 16}, glm::translate(glm::mat4(1), glm::vec3(8, 0, 0))}},
      rays);
  std::size_t wrong = 0, found = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    Hit hit = hits[i].hit;
    hit.voxel[0] += hits[i].instance == 1 ? 8 : 0;
    // At one t two voxels may be entered at an edge, of which either is the first here.
    wrong += hit.t != expected[i].t || hits[i].isHit() != expected[i].isHit();
    found += hits[i].isHit();
  }
  EXPECT_EQ(wrong, 0u);
  EXPECT_GT(found, 1000u);
}

/// Hard rays of single volumes, each taken to the world from the voxels of an instance.
std::vector<Ray> hardRaysAmong(const std::vector<glm::mat4> &places, std::size_t count) {
  std::vector<Ray> rays;
  std::mt19937 random(13);
  for (const Ray &ray : raysAround(count)) {
    const glm::mat4 &place = places[random() % places.size()];
    const auto there = [&](const float(&v)[3], float w) {
      return glm::vec3(place * glm::vec4(v[0], v[1], v[2], w));
    };
    rays.push_back(makeRay(there(ray.origin, 1), there(ray.direction, 0)));
  }
  return rays;
}

/// Against the oracle, traced through every one.
TEST(InstancedTracer, FindsTheNearestAmongMany) {
  const Volume volume = makeVolume("G(4)", 7);
  const auto oracle = Oracle::of(volume);
  ASSERT_TRUE(oracle) << oracle.error().message;
  const auto whole = open(volume), cut = openBounded(volume);
  std::mt19937 random(14);
  std::vector<glm::mat4> places;
  std::vector<Instance> instances;
  for (int i = 0; i < 120; ++i) {
    places.push_back(test::randomPlace(random, 60));
    instances.push_back(i % 3 ? Instance{cut.get(), {16, 16, 16}, places.back(), true}
                              : Instance{whole.get(), {16, 16, 16}, places.back()});
  }
  const std::vector<Ray> rays = hardRaysAmong(places, 1000 * static_cast<std::size_t>(test::rounds(1)));
  const auto expected = test::nearestOfOracle(*oracle, places, rays);
  EXPECT_EQ(test::countDifferent(traced(instances, rays), expected), 0u) << "of " << rays.size();
  EXPECT_GT(static_cast<std::size_t>(std::ranges::count_if(expected, &InstanceHit::isHit)), rays.size() / 3);
}

/// Instances that lie in each other at one place: of the same t the first is taken.
TEST(InstancedTracer, TakesTheFirstOfTheSame) {
  const Volume volume = makeVolume("G(4)", 7);
  const auto cut = openBounded(volume);
  std::vector<Instance> instances(40, Instance{cut.get(), {16, 16, 16}, glm::mat4(1), true});
  for (const InstanceHit &hit : traced(instances, raysAround(2000)))
    EXPECT_EQ(hit.instance, hit.hit.isHit() ? 0u : InstanceHit::kNone);
}

TEST(InstancedTracer, OfNoInstancesHasNoHits) {
  const std::vector<Ray> rays = raysAround(10);
  for (const InstanceHit &hit : traced({}, rays)) {
    EXPECT_FALSE(hit.isHit());
    EXPECT_FALSE(hit.hit.isHit());
  }
}

TEST(InstancedTracer, RefusesPlacesThatAreNone) {
  const Volume volume = makeVolume("G(2)", 7);
  const auto tracer = open(volume);
  const auto problem = [&](Instance instance) {
    const auto made = InstancedTracer::create({{tracer.get(), {4, 4, 4}}, instance});
    return made ? std::string() : made.error().message;
  };
  EXPECT_EQ(problem({tracer.get(), {4, 4, 4}}), "");
  EXPECT_THAT(problem({}), HasSubstr("instance 1 has no tracer"));
  EXPECT_THAT(problem({tracer.get(), {4, 4, 4}, glm::mat4(0)}), HasSubstr("not affine"));
  EXPECT_THAT(problem({tracer.get(), {4, 4, 4}, glm::scale(glm::mat4(1), glm::vec3(1, 0, 1))}),
              HasSubstr("inverse"));
  EXPECT_THAT(problem({tracer.get(), {4, 4, 4}, glm::mat4(std::numeric_limits<float>::infinity())}),
              HasSubstr("not affine"));
}

TEST(OpenTracer, NamesWhatIsNotThere) {
  const Volume volume = makeVolume("G(2)", 7);
  const auto tracer = openTracer(volume, {.device = "no such device"});
  ASSERT_FALSE(tracer);
  EXPECT_EQ(tracer.error().kind, ErrorKind::Environment);
}

TEST(OpenTracer, DirectionsMayBeHuge) {
  auto built = Constructor::compile(*parseFormat("G(2)"))->build(*makeFunctionSource({4, 4, 4}, [](Int3 c) {
    return c == Int3{2, 1, 3} ? 0xff0000ffu : 0u;
  }));
  const std::vector<Ray> rays = {{{2.5f, 1.5f, -2}, {1e30f, 1e30f, 3e38f}},
                                 {{2.5f, 1.5f, -2}, {1e38f, 0, 3e38f}}};
  for (const char *device : {"cpu", ""}) {
    std::vector<Hit> hits(rays.size());
    ASSERT_TRUE(open(built->volume, device)->trace(rays, hits));
    EXPECT_EQ(hits[0].voxel[2], 3);
    EXPECT_EQ(hits[0].t, 5 / 3e38f);
    EXPECT_FALSE(hits[1].isHit());
  }
}

TEST(OpenTracer, TakesAnotherTraversalButNoOtherStorage) {
  const Volume volume = makeVolume("R(1,1,1) G(3)", 7);
  EXPECT_TRUE(openTracer(
      volume, {.device = "cpu",
               .format = *parseFormat("format levels=flat { level 1: raw(1, 1, 1) level 2: svdag(3) }")}));
  EXPECT_FALSE(openTracer(volume, {.device = "cpu", .format = *parseFormat("G(4)")}));
}

} // namespace
} // namespace voxc
