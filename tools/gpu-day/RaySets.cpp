// Rays of cameras, to a sun, and off surfaces.
#include "RaySets.h"

#include "common/Files.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <filesystem>
#include <functional>

namespace voxc::gpu {
namespace {

using Rays = std::vector<Ray>;
using Hits = std::vector<Hit>;

constexpr int kTileColumns = 8, kTileRows = 4;
constexpr glm::dvec3 kSun(0.4, 0.8, 0.45);
/// What a renderer lifts an origin off its surface by.
constexpr double kLift = 1e-3;

/// A number in [0, 1) that follows from an index: the mixer of SplitMix64 (Steele, Lea and Flood, "Fast
/// splittable pseudorandom number generators", 2014).
double randomOf(std::uint64_t index) {
  std::uint64_t bits = (index + 1) * 0x9e3779b97f4a7c15;
  bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ bits >> 27) * 0x94d049bb133111eb;
  return static_cast<double>((bits ^ bits >> 31) >> 11) * 0x1p-53;
}

/// A point of the unit sphere's surface, by rejection: no function that libraries round differently.
glm::dvec3 onSphere(std::uint64_t index) {
  for (std::uint64_t draw = 0;; ++draw) {
    const std::uint64_t number = (index * 64 + draw) * 3;
    const glm::dvec3 at(2 * randomOf(number) - 1, 2 * randomOf(number + 1) - 1, 2 * randomOf(number + 2) - 1);
    if (const double square = glm::dot(at, at); square > 1e-6 && square <= 1)
      return at / std::sqrt(square);
  }
}

/// The picture's rays, one tile of pixels behind another, for devices that trace neighbours together.
Rays inTiles(const Rays &rows, const Camera &camera) {
  Rays tiles;
  tiles.reserve(rows.size());
  for (int top = 0; top < camera.height; top += kTileRows)
    for (int left = 0; left < camera.width; left += kTileColumns)
      for (int row = top; row < std::min(top + kTileRows, camera.height); ++row)
        for (int column = left; column < std::min(left + kTileColumns, camera.width); ++column)
          tiles.push_back(rows[static_cast<std::size_t>(row) * static_cast<std::size_t>(camera.width) +
                               static_cast<std::size_t>(column)]);
  return tiles;
}

/// The normal of the face that a point of a voxel's surface lies on, the nearest.
glm::dvec3 normalAt(const glm::dvec3 &point, const Hit &hit) {
  const glm::dvec3 off = point - (glm::dvec3(hit.voxel[0], hit.voxel[1], hit.voxel[2]) + 0.5);
  int axis = 0;
  for (int other : {1, 2})
    if (std::abs(off[other]) > std::abs(off[axis]))
      axis = other;
  glm::dvec3 normal(0);
  normal[axis] = off[axis] < 0 ? -1 : 1;
  return normal;
}

using Leave = std::function<glm::dvec3(std::size_t index, const glm::dvec3 &normal)>;

/// A ray from where each ray has hit, in the direction that `leave` says.
Rays offSurfaces(const Rays &rays, const Hits &hits, const Leave &leave) {
  Rays left;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hits[i].isHit())
      continue;
    const Ray &ray = rays[i];
    const glm::dvec3 origin(ray.origin[0], ray.origin[1], ray.origin[2]);
    const glm::dvec3 direction(ray.direction[0], ray.direction[1], ray.direction[2]);
    const glm::dvec3 point = origin + double(hits[i].t) * direction, normal = normalAt(point, hits[i]);
    left.push_back(makeRay(point + kLift * normal, leave(i, normal)));
  }
  return left;
}

template <typename Record> Expected<void> write(const std::string &path, const std::vector<Record> &records) {
  return tool::writeBytes(path, std::as_bytes(std::span(records)));
}

class Sets {
public:
  Sets(const Oracle &oracle, const std::string &folder) : oracle_(oracle), folder_(folder) {}

  /// Keeps a set, and gives the oracle's hits of it.
  Expected<Hits> keep(const std::string &name, const Rays &rays) const {
    auto hits = oracle_.trace(rays);
    if (!hits)
      return hits.error();
    const std::string path = (std::filesystem::path(folder_) / name).string();
    if (auto written = write(path + ".rays", rays); !written)
      return written.error();
    if (auto written = write(path + ".hits", *hits); !written)
      return written.error();
    return hits;
  }

private:
  const Oracle &oracle_;
  const std::string &folder_;
};

Expected<void> keepSecondary(const Sets &sets, const Rays &rays, const Hits &hits) {
  const auto toSun = [](std::size_t, const glm::dvec3 &) { return kSun; };
  const auto diffuse = [](std::size_t index, const glm::dvec3 &normal) {
    const glm::dvec3 direction = normal + onSphere(index);
    return glm::dot(direction, direction) > 1e-12 ? direction : normal;
  };
  if (auto kept = sets.keep("shadow", offSurfaces(rays, hits, toSun)); !kept)
    return kept.error();
  if (auto kept = sets.keep("bounce", offSurfaces(rays, hits, diffuse)); !kept)
    return kept.error();
  return {};
}

} // namespace

Expected<void> makeRaySets(const Volume &volume, const std::vector<NamedCamera> &cameras,
                           const std::string &folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    return Error::environment("folder '" + folder + "' cannot be made: " + failure.message());
  if (std::filesystem::exists(std::filesystem::path(folder) / "bounce.hits"))
    return {}; // The last that is made.
  const auto oracle = Oracle::of(volume);
  if (!oracle)
    return oracle.error();
  const Sets sets(*oracle, folder);
  for (const NamedCamera &named : cameras) {
    const Rays rays = cameraRays(named.camera);
    const auto hits = sets.keep(named.name, rays);
    if (!hits)
      return hits.error();
    if (&named == &cameras.front())
      if (const auto kept = sets.keep(named.name + "-tiles", inTiles(rays, named.camera)); !kept)
        return kept.error();
    if (&named == &cameras.back())
      if (auto kept = keepSecondary(sets, rays, *hits); !kept)
        return kept;
  }
  return {};
}

} // namespace voxc::gpu
