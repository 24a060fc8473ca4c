// Rays of cameras, to a sun, and off surfaces.
#include "RaySets.h"

#include "common/Files.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
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
    auto hits = VOXC_TRY(oracle_.trace(rays));
    const std::string path = (std::filesystem::path(folder_) / name).string();
    VOXC_TRY(write(path + ".rays", rays));
    VOXC_TRY(write(path + ".hits", hits));
    return hits;
  }

private:
  const Oracle &oracle_;
  const std::string &folder_;
};

/// A picture of the volume from so many edges away, toward a corner between three sides.
Rays fromDistance(const Volume &volume, double edges, int side) {
  constexpr double kFill = 0.54; // Of an edge, from the middle of the picture to each side.
  const Int3 extent = volume.info().extent;
  const double edge = std::max({extent.x, extent.y, extent.z});
  const glm::dvec3 middle = 0.5 * glm::dvec3(extent.x, extent.y, extent.z);
  const glm::dvec3 way = glm::normalize(glm::dvec3(0.6, 0.35, 0.72)) * edges * edge;
  const glm::dvec3 right = glm::normalize(glm::cross(-way, glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::normalize(glm::cross(right, -way));
  Rays rays;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const auto place = [&](int pixel) { return kFill * edge * (2 * (pixel + 0.5) / side - 1); };
      rays.push_back(makeRay(middle + way, glm::normalize(place(column) * right + place(row) * up - way)));
    }
  return rays;
}

/// Makes a folder and lets `work` keep its sets there, unless it has the set that is made last already.
Expected<void> keepIn(const std::string &folder, const std::string &last, const Volume &volume,
                      const std::function<Expected<void>(const Sets &)> &work) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure)
    return Error::environment("folder '" + folder + "' cannot be made: " + failure.message());
  if (std::filesystem::exists(std::filesystem::path(folder) / (last + ".hits")))
    return {};
  const auto oracle = Oracle::of(volume);
  return oracle ? work(Sets(*oracle, folder)) : oracle.error();
}

Expected<void> keepSecondary(const Sets &sets, const Rays &rays, const Hits &hits) {
  const auto toSun = [](std::size_t, const glm::dvec3 &) { return kSun; };
  const auto diffuse = [](std::size_t index, const glm::dvec3 &normal) {
    const glm::dvec3 direction = normal + onSphere(index);
    return glm::dot(direction, direction) > 1e-12 ? direction : normal;
  };
  VOXC_TRY(sets.keep("shadow", offSurfaces(rays, hits, toSun)));
  VOXC_TRY(sets.keep("bounce", offSurfaces(rays, hits, diffuse)));
  return {};
}

Expected<void> keepCameras(const Sets &sets, const std::vector<NamedCamera> &cameras) {
  for (const NamedCamera &named : cameras) {
    const Rays rays = cameraRays(named.camera);
    const auto hits = VOXC_TRY(sets.keep(named.name, rays));
    if (&named == &cameras.front())
      VOXC_TRY(sets.keep(named.name + "-tiles", inTiles(rays, named.camera)));
    if (&named == &cameras.back())
      VOXC_TRY(keepSecondary(sets, rays, hits));
  }
  return {};
}

constexpr std::array kEdges = {1.1, 1.5, 1.9, 2.1, 3.0, 6.0, 20.0, 300.0, 1e4, 1e6};

std::string nameOfDistance(double edges) {
  char name[32];
  std::snprintf(name, sizeof name, "%09.1f-edges", edges); // In order of distance by name too.
  return name;
}

} // namespace

Expected<void> makeRaySets(const Volume &volume, const std::vector<NamedCamera> &cameras,
                           const std::string &folder) {
  return keepIn(folder, "bounce", volume, [&](const Sets &sets) { return keepCameras(sets, cameras); });
}

Expected<void> makeDistanceSets(const Volume &volume, int side, const std::string &folder) {
  return keepIn(folder, nameOfDistance(kEdges.back()), volume, [&](const Sets &sets) -> Expected<void> {
    for (const double edges : kEdges)
      VOXC_TRY(sets.keep(nameOfDistance(edges), fromDistance(volume, edges, side)));
    return {};
  });
}

} // namespace voxc::gpu
