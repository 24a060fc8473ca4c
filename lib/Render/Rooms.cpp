// Cameras that stand inside of a volume.
#include "Rooms.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <vector>

namespace voxc {

namespace {

/// Directions around a place: rings of so many each, by pitch; the last sees the sky, where there is one.
constexpr int kTurns = 24;
constexpr double kPitches[] = {-30, -8, 12, 70};
constexpr int kLevelRings = 3;
constexpr std::size_t kLevel = std::size_t(kLevelRings) * kTurns; ///< Directions of the level rings.

/// By which a place is looked at more closely.
constexpr int kFineTurns = 96;
constexpr double kFinePitches[] = {-50, -30, -15, -5, 5, 15, 30, 70};
constexpr std::size_t kFineLevel = (std::size(kFinePitches) - 1) * std::size_t(kFineTurns);

std::vector<glm::dvec3> ringsOf(std::span<const double> pitches, int turns) {
  std::vector<glm::dvec3> directions;
  for (const double pitch : pitches)
    for (int turn = 0; turn < turns; ++turn) {
      const double yaw = glm::radians(360.0 * turn / turns);
      const double level = std::cos(glm::radians(pitch));
      directions.emplace_back(level * std::sin(yaw), std::sin(glm::radians(pitch)), level * std::cos(yaw));
    }
  return directions;
}

constexpr std::uint32_t kUpperBits = 0xe0e0e0; ///< Of the channels: colours that differ there look different.

/// Colours that look different, of those that are hit around a direction.
std::size_t colourVariety(const glm::dvec3 &level, std::span<const glm::dvec3> directions,
                          std::span<const Hit> hits) {
  std::set<std::uint32_t> colours;
  for (std::size_t i = 0; i < hits.size(); ++i)
    if (hits[i].isHit() && glm::dot(level, directions[i]) > 0.75)
      colours.insert(hits[i].rgba & kUpperBits);
  return colours.size();
}

/// The level direction around which most is seen, far off and in many colours. `hits` are those of the level
/// rings.
glm::dvec3 bestDirection(std::span<const glm::dvec3> directions, std::span<const Hit> hits) {
  glm::dvec3 chosen{0, 0, -1};
  double best = -1;
  for (int turn = 0; turn < kTurns; ++turn) {
    const glm::dvec3 level = directions[std::size_t(kTurns + turn)];
    double far = 0;
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (hits[i].isHit())
        far += std::max(glm::dot(level, directions[i]) - 0.6, 0.0) * std::sqrt(double(hits[i].t));
    far *= 4 + double(colourVariety(level, directions, hits));
    if (far > best) {
      best = far;
      chosen = glm::normalize(glm::dvec3(level.x, 0.04, level.z));
    }
  }
  return chosen;
}

double shareOfHits(std::span<const Hit> hits) {
  return double(std::ranges::count_if(hits, &Hit::isHit)) / double(std::max(hits.size(), std::size_t(1)));
}

/// The room around a place: the distance that a quarter of the level rays do not come to.
double roomOf(std::span<const Hit> level) {
  std::vector<double> distances;
  for (const Hit &hit : level)
    distances.push_back(hit.isHit() ? double(hit.t) : 0);
  const auto quarter = distances.begin() + std::ptrdiff_t(distances.size() / 4);
  std::ranges::nth_element(distances, quarter);
  return *quarter;
}

/// A place is worth the more, the more there is around it at eye level and the more room it has. One that
/// sees the sky is worth more than a closed one.
double worthOf(std::span<const Hit> hits) {
  const auto level = hits.first(kLevel), above = hits.subspan(kLevel);
  const double share = shareOfHits(level);
  return share * share * roomOf(level) * (std::ranges::all_of(above, &Hit::isHit) ? 1 : 2);
}

/// The share of level rays beside which the next one of their ring goes much further or less far: edges of
/// things that stand before others. The walls of a hollow have none.
double edgesOf(std::span<const Hit> level, double longest) {
  const auto distance = [&](std::size_t i) { return level[i].isHit() ? double(level[i].t) : longest; };
  std::size_t edges = 0;
  for (std::size_t i = 0; i < level.size(); ++i) {
    const std::size_t next = (i + 1) % kFineTurns == 0 ? i + 1 - kFineTurns : i + 1;
    const double near = std::min(distance(i), distance(next)), far = std::max(distance(i), distance(next));
    edges += far > 1.35 * near + 2;
  }
  return double(edges) / double(level.size());
}

/// The entropy of the colours that are hit, in bits: 0 of one colour, 3 of eight that are seen alike much of.
double colourBits(std::span<const Hit> level) {
  std::map<std::uint32_t, std::size_t> counts;
  std::size_t all = 0;
  for (const Hit &hit : level)
    if (hit.isHit()) {
      ++counts[hit.rgba & kUpperBits];
      ++all;
    }
  double bits = 0;
  for (const auto &[colour, count] : counts)
    bits -= double(count) / double(all) * std::log2(double(count) / double(all));
  return bits;
}

struct Rays {
  glm::dvec3 spacing;
  std::vector<Ray> rays = {};

  void add(const glm::dvec3 &from, const glm::dvec3 &direction) {
    rays.push_back(makeRay(from, direction / spacing));
  }
  Expected<std::vector<Hit>> traced(TraceRays trace) const {
    std::vector<Hit> hits(rays.size());
    VOXC_TRY(trace(rays, hits, {}));
    return hits;
  }
};

/// How much of what a place sees lies under a roof, where no camera from above would look.
Expected<double> roofedShare(const Place &place, std::span<const glm::dvec3> directions,
                             std::span<const Hit> level, const glm::dvec3 &spacing, TraceRays trace) {
  constexpr double kBefore = 0.97; // Of the way, so that a wall is not its own roof.
  Rays up{spacing};
  for (std::size_t i = 0; i < level.size(); ++i)
    if (level[i].isHit())
      up.add(place.eye + directions[i] / spacing * (kBefore * double(level[i].t)), {0, 1, 0});
  const auto roofs = up.traced(trace);
  return roofs ? Expected<double>(shareOfHits(*roofs)) : roofs.error();
}

} // namespace

Expected<Place> bestPlace(const glm::dvec3 &extent, const glm::dvec3 &spacing, TraceRays trace) {
  const std::vector<glm::dvec3> directions = ringsOf(kPitches, kTurns);
  std::vector<glm::dvec3> eyes;
  constexpr int kAcross = 14;
  for (const double height : {0.1, 0.16, 0.24})
    for (int x = 1; x < kAcross; ++x)
      for (int z = 1; z < kAcross; ++z)
        eyes.push_back(extent * glm::dvec3(double(x) / kAcross, height, double(z) / kAcross) + 0.37);
  Rays rays{spacing};
  for (const glm::dvec3 &eye : eyes)
    for (const glm::dvec3 &direction : directions)
      rays.add(eye, direction);
  const auto hits = VOXC_TRY(rays.traced(trace));
  const auto around = [&](std::size_t i) {
    return std::span<const Hit>(hits).subspan(i * directions.size(), directions.size());
  };
  Place best{extent * 0.5};
  std::size_t number = 0;
  for (std::size_t i = 0; i < eyes.size(); ++i)
    if (const double worth = worthOf(around(i)); worth > best.worth) {
      best = {eyes[i], best.direction, worth};
      number = i;
    }
  if (best.worth > 0)
    best.direction = bestDirection(directions, around(number).first(kLevel));
  return best;
}

// From the middle of a teapot one sees walls all around as well, some sky through the spout, and a roof. What
// tells a room from a hollow is what stands in it, and colours; where neither says much, the outside is sure
// to show something.
Expected<bool> isInRoom(const Place &place, const glm::dvec3 &extent, const glm::dvec3 &spacing,
                        TraceRays trace) {
  constexpr double kLeastShare = 0.9; // Of level rays that meet something.
  constexpr double kLeastRoom = 0.04; // In parts of the longer side of the ground: a thicket has less.
  constexpr double kLeastRoofed = 0.25;
  constexpr double kLeastToSee = 0.08; // Edges, to which a bit of colours adds so much:
  constexpr double kOfBit = 0.02;
  const glm::dvec3 sides = extent * spacing;
  const std::vector<glm::dvec3> directions = ringsOf(kFinePitches, kFineTurns);
  Rays rays{spacing};
  for (const glm::dvec3 &direction : directions)
    rays.add(place.eye, direction);
  const auto hits = VOXC_TRY(rays.traced(trace));
  const auto level = std::span<const Hit>(hits).first(kFineLevel);
  const auto above = std::span<const Hit>(hits).subspan(kFineLevel);
  if (shareOfHits(level) < kLeastShare || std::ranges::all_of(above, &Hit::isHit) ||
      roomOf(level) < kLeastRoom * std::max(sides.x, sides.z))
    return false;
  const double longest = glm::length(sides);
  if (edgesOf(level, longest) + kOfBit * colourBits(level) < kLeastToSee)
    return false;
  const Expected<double> roofed = roofedShare(place, directions, level, spacing, trace);
  return roofed ? Expected<bool>(*roofed >= kLeastRoofed) : roofed.error();
}

} // namespace voxc
