// Generators of rays.
#include "RayKinds.h"

#include "testing/HardRays.h"
#include "testing/HardRays/RandomSource.h"
#include "voxc/Trace/Camera.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace voxc::cliffs {
namespace {

using test::RandomSource;
using Rays = std::vector<Ray>;

glm::dvec3 unit(RandomSource &random) {
  for (;;) {
    const glm::dvec3 at(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
    if (const double length = glm::length(at); length > 0.01 && length <= 1)
      return at / length;
  }
}

glm::dvec3 sizeOf(const RayScene &scene) { return {scene.extent.x, scene.extent.y, scene.extent.z}; }

glm::dvec3 inBox(RandomSource &random, const RayScene &scene) {
  const double x = random.real(0, 1), y = random.real(0, 1), z = random.real(0, 1);
  return sizeOf(scene) * glm::dvec3(x, y, z);
}

/// A voxel that is not empty, or any where there is none.
Int3 voxelOf(RandomSource &random, const RayScene &scene) {
  if (!scene.voxels.empty())
    return scene
        .voxels[static_cast<std::size_t>(random.integer(0, static_cast<int>(scene.voxels.size()) - 1))];
  return {random.integer(0, scene.extent.x - 1), random.integer(0, scene.extent.y - 1),
          random.integer(0, scene.extent.z - 1)};
}

Camera pictureOf(std::size_t count) {
  Camera camera;
  camera.width = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count) * 16 / 9)));
  camera.height = static_cast<int>((count + static_cast<std::size_t>(camera.width) - 1) /
                                   static_cast<std::size_t>(camera.width));
  return camera;
}

/// A pinhole at so many edges from the middle, which sees about all of the scene.
Rays cameraFrom(RandomSource &random, const RayScene &scene, std::size_t count, double edges) {
  Camera camera = pictureOf(count);
  camera.look = 0.5 * sizeOf(scene);
  camera.eye = camera.look + edges * scene.edge() * unit(random);
  const double half = std::atan(random.real(0.3, 0.9) / edges);
  camera.verticalFov = std::clamp(2 * half * 57.29577951308232, 1e-9, 120.0);
  return cameraRays(camera);
}

Rays near(RandomSource &random, const RayScene &scene, std::size_t count) {
  return cameraFrom(random, scene, count, random.real(0.9, 1.8));
}

Rays far(RandomSource &random, const RayScene &scene, std::size_t count) {
  return cameraFrom(random, scene, count, std::exp2(random.real(1, 20)));
}

Rays inside(RandomSource &random, const RayScene &scene, std::size_t count) {
  Camera camera = pictureOf(count);
  camera.eye = inBox(random, scene);
  camera.look = camera.eye + unit(random);
  camera.verticalFov = random.real(20, 110);
  return cameraRays(camera);
}

/// A pinhole that sees a small part of the scene, in many pixels.
Rays close(RandomSource &random, const RayScene &scene, std::size_t count) {
  Camera camera = pictureOf(count);
  const Int3 at = voxelOf(random, scene);
  camera.look = glm::dvec3(at.x, at.y, at.z) + 0.5;
  camera.eye = camera.look + random.real(1.5, 0.2 * scene.edge() + 2) * unit(random);
  return cameraRays(camera);
}

Rays orthographic(RandomSource &random, const RayScene &scene, std::size_t count) {
  Camera camera = pictureOf(count);
  camera.look = 0.5 * sizeOf(scene);
  camera.eye = camera.look + random.real(1, 4) * scene.edge() * unit(random);
  camera.orthographicHeight = random.real(0.1, 1.5) * scene.edge();
  return cameraRays(camera);
}

/// Along an axis of the scene: every ray has two components that are zero.
Rays plan(RandomSource &random, const RayScene &scene, std::size_t count) {
  Camera camera = pictureOf(count);
  const int axis = random.integer(0, 2);
  camera.look = 0.5 * sizeOf(scene);
  camera.eye = camera.look;
  camera.eye[axis] += random.sign() * (random.flip() ? 0.75 : 100.0) * scene.edge();
  camera.up = glm::dvec3(0);
  camera.up[(axis + 1) % 3] = 1;
  camera.orthographicHeight = random.flip() ? scene.edge() : random.real(0.1, 1.2) * scene.edge();
  return cameraRays(camera);
}

/// A picture of one pixel for each column of voxels, through corners of voxels or through their middles.
Rays columns(RandomSource &random, const RayScene &scene, std::size_t count) {
  const int axis = random.integer(0, 2), u = (axis + 1) % 3, v = (axis + 2) % 3;
  const float place = random.flip() ? 0.5f : 0.0f, sign = random.sign();
  Rays rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto columnsOfRow = static_cast<std::size_t>(scene.extent[u]);
    Ray ray{};
    ray.origin[u] = static_cast<float>(i % columnsOfRow) + place;
    ray.origin[v] = static_cast<float>(i / columnsOfRow % static_cast<std::size_t>(scene.extent[v])) + place;
    ray.origin[axis] = sign > 0 ? -1.0f : static_cast<float>(scene.extent[axis] + 1);
    ray.direction[axis] = sign;
    rays[i] = ray;
  }
  return rays;
}

template <typename Make> Rays each(std::size_t count, const Make &make) {
  Rays rays(count);
  std::ranges::generate(rays, make);
  return rays;
}

Rays lines(RandomSource &random, const RayScene &scene, std::size_t count) {
  return each(count, [&] {
    const glm::dvec3 from = 0.5 * sizeOf(scene) + 1.5 * scene.edge() * unit(random);
    return makeRay(from, inBox(random, scene) - from);
  });
}

Rays axes(RandomSource &random, const RayScene &scene, std::size_t count) {
  return each(count, [&] {
    glm::dvec3 direction(0);
    direction[random.integer(0, 2)] = random.sign();
    return makeRay(inBox(random, scene) - scene.edge() * direction, direction);
  });
}

/// Whole origins and small whole directions: times of two axes agree again and again.
Rays whole(RandomSource &random, const RayScene &scene, std::size_t count) {
  return each(count, [&] {
    glm::dvec3 direction(random.integer(-3, 3), random.integer(-3, 3), random.integer(-3, 3));
    if (direction == glm::dvec3(0))
      direction.x = 1;
    return makeRay(glm::floor(inBox(random, scene)) - std::floor(scene.edge()) * direction, direction);
  });
}

/// From whole points in the box along diagonals.
Rays diagonals(RandomSource &random, const RayScene &scene, std::size_t count) {
  return each(count, [&] {
    return makeRay(glm::floor(inBox(random, scene)), glm::dvec3(random.sign(), random.sign(), random.sign()));
  });
}

/// From whole points of a far corner to corners of voxels: many cross edges exactly.
Rays corners(RandomSource &random, const RayScene &scene, std::size_t count) {
  const glm::dvec3 eye = glm::floor(0.5 * sizeOf(scene) + 2 * scene.edge() * unit(random));
  return each(count, [&] {
    const Int3 at = voxelOf(random, scene);
    return makeRay(eye, glm::dvec3(at.x, at.y, at.z) - eye);
  });
}

/// From within solids.
Rays solid(RandomSource &random, const RayScene &scene, std::size_t count) {
  return each(count, [&] {
    const Int3 at = voxelOf(random, scene);
    const glm::dvec3 place(random.real(0, 1), random.real(0, 1), random.real(0, 1));
    return makeRay(glm::dvec3(at.x, at.y, at.z) + place, unit(random));
  });
}

/// Nearly along faces between voxels.
Rays grazing(RandomSource &random, const RayScene &scene, std::size_t count) {
  return each(count, [&] {
    const int axis = random.integer(0, 2);
    glm::dvec3 direction = unit(random), from = inBox(random, scene);
    direction[axis] = random.sign() * std::exp2(random.real(-30, -8));
    from[axis] = std::floor(from[axis]);
    return makeRay(from - scene.edge() * direction, direction);
  });
}

Rays missing(RandomSource &random, const RayScene &scene, std::size_t count) {
  return each(count, [&] {
    const glm::dvec3 away = unit(random);
    return makeRay(0.5 * sizeOf(scene) + 2 * scene.edge() * away, away + 0.5 * unit(random));
  });
}

/// Short and long directions of the same lines.
Rays scaled(RandomSource &random, const RayScene &scene, std::size_t count) {
  const auto scale = static_cast<float>(std::exp2(random.real(-100, 100)));
  Rays rays = near(random, scene, count);
  for (Ray &ray : rays)
    for (float &component : ray.direction)
      component *= scale;
  return rays;
}

struct Surface {
  glm::vec3 point;
  glm::dvec3 from; ///< The direction that the ray came by.
};

/// Where rays of a camera hit, as a renderer has it: origin + t * direction, in float32.
std::vector<Surface> surfacesOf(RandomSource &random, const RayScene &scene, std::size_t count) {
  std::vector<Surface> surfaces;
  for (const Ray &ray : near(random, scene, std::min<std::size_t>(count, 4096)))
    if (const Hit hit = scene.oracle.trace(ray); hit.isHit()) {
      const glm::vec3 direction(ray.direction[0], ray.direction[1], ray.direction[2]);
      surfaces.push_back(
          {glm::vec3(ray.origin[0], ray.origin[1], ray.origin[2]) + hit.t * direction, direction});
    }
  return surfaces;
}

Rays fromSurfaces(RandomSource &random, const RayScene &scene, std::size_t count, double lift, bool toLamp) {
  const std::vector<Surface> surfaces = surfacesOf(random, scene, count);
  if (surfaces.empty())
    return lines(random, scene, count);
  const glm::dvec3 lamp = 0.5 * sizeOf(scene) + 1.5 * scene.edge() * unit(random);
  std::size_t next = 0;
  return each(count, [&] {
    // As many neighbours as the count has for each, so that they stay neighbours.
    const Surface &surface = surfaces[next++ * surfaces.size() / count];
    const glm::dvec3 from = glm::dvec3(surface.point) - lift * surface.from;
    return makeRay(from, toLamp ? lamp - from : unit(random));
  });
}

Rays bounces(RandomSource &random, const RayScene &scene, std::size_t count) {
  return fromSurfaces(random, scene, count, 1e-3, false);
}

Rays bouncesOnFaces(RandomSource &random, const RayScene &scene, std::size_t count) {
  return fromSurfaces(random, scene, count, 0, false);
}

Rays shadows(RandomSource &random, const RayScene &scene, std::size_t count) {
  return fromSurfaces(random, scene, count, 1e-3, true);
}

/// One of the classes that kernels are verified with, which are hard on purpose.
Rays hard(RandomSource &random, const RayScene &scene, std::size_t count) {
  return verifyRays(scene.extent, count, static_cast<std::uint64_t>(random.integer(0, 1 << 30)));
}

constexpr std::array<RayKind, 20> kKinds = {{{"near", near},
                                             {"far", far},
                                             {"inside", inside},
                                             {"close", close},
                                             {"orthographic", orthographic},
                                             {"plan", plan},
                                             {"columns", columns},
                                             {"lines", lines},
                                             {"axes", axes},
                                             {"whole", whole},
                                             {"diagonals", diagonals},
                                             {"corners", corners},
                                             {"solid", solid},
                                             {"grazing", grazing},
                                             {"missing", missing},
                                             {"scaled", scaled},
                                             {"bounces", bounces},
                                             {"bounces-on-faces", bouncesOnFaces},
                                             {"shadows", shadows},
                                             {"verify", hard}}};

} // namespace

double RayScene::edge() const { return std::max({extent.x, extent.y, extent.z}); }

std::span<const RayKind> rayKinds() { return kKinds; }

std::vector<Ray> makeRays(std::string_view kind, const RayScene &scene, std::size_t count,
                          std::uint64_t seed) {
  const RayKind *const row = std::ranges::find(kKinds, kind, &RayKind::name);
  RandomSource random(seed);
  std::vector<Ray> rays = row->make(random, scene, count);
  rays.resize(count);
  return rays;
}

} // namespace voxc::cliffs
