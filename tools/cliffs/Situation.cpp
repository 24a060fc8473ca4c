// Drawing places and situations.
#include "Situation.h"

#include "RayKinds.h"
#include "Scenes.h"

#include "testing/HardRays/RandomSource.h"
#include "testing/RandomFormat.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Search/Candidate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <random>

namespace voxc::cliffs {
namespace {

using test::RandomSource;

/// A seed for each of many numbers, so that neighbours have nothing in common.
std::uint64_t mixed(std::uint64_t seed, std::uint64_t salt) {
  std::uint64_t x = seed + 0x9e3779b97f4a7c15 * (salt + 1);
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
  x = (x ^ x >> 27) * 0x94d049bb133111eb;
  return x ^ x >> 31;
}

int log2Above(Int3 extent) {
  const int edge = std::max({extent.x, extent.y, extent.z});
  return std::max(1, static_cast<int>(std::bit_width(static_cast<unsigned>(edge - 1))));
}

/// As people write them by hand.
std::string plainText(RandomSource &random, int side) {
  const auto text = [](int number) { return std::to_string(number); };
  const int top = std::clamp(side / 2, 1, 4);
  const std::string below = text(side - top);
  switch (side < 2 ? 0 : random.integer(0, 5)) {
  case 0:
    return "G(" + text(side) + ")";
  case 1:
    return "S(" + text(side) + ")";
  case 2:
    return "R(" + text(top) + "^3) G(" + below + ")";
  case 3:
    return "R(" + text(top) + "^3) S(" + below + ")";
  case 4:
    return "H(" + text(top) + "^3) G(" + below + ")";
  default:
    return "M(" + text(top) + "^3) G(" + below + ")";
  }
}

/// Now and then another traversal than the format's own.
void maybeTraverse(RandomSource &random, Format &format) {
  constexpr std::array<const char *, 4> kTraversals = {"restart-sv", "unroll-sv", "flat-traversal",
                                                       "direct-traversal"};
  if (random.integer(0, 9) != 0)
    return;
  Diagnostics diagnostics; // What does not apply leaves the format as it is.
  Format traversed = format;
  findPass(kTraversals[static_cast<std::size_t>(random.integer(0, 3))])->run(traversed, diagnostics);
  if (!diagnostics.hasErrors())
    format = traversed;
}

/// Half of them are such as `voxc suggest` looks at; the others are what people write, or by chance.
Format drawFormat(RandomSource &random, int side) {
  const int kind = random.integer(0, 9);
  if (kind < 5) {
    const std::vector<Candidate> candidates = candidatesFor(side, {});
    if (!candidates.empty())
      return candidates[static_cast<std::size_t>(random.integer(0, static_cast<int>(candidates.size()) - 1))]
          .format;
  }
  if (kind < 8 || side > 7)
    return *parseFormat(plainText(random, side));
  std::mt19937 engine(static_cast<unsigned>(random.integer(0, 1 << 30)));
  Format format = *parseFormat(test::randomFormatText(engine, side));
  Diagnostics diagnostics;
  findPass("whole-level-dedup")->run(format, diagnostics);
  return format;
}

/// Most extents are cubes of a power of two, for so are most people's.
Int3 drawExtent(RandomSource &random, int log2Side) {
  Int3 extent{1 << log2Side, 1 << log2Side, 1 << log2Side};
  if (random.integer(0, 3) == 0)
    for (int axis = 0; axis < 3; ++axis)
      extent[axis] = std::max(1, random.integer(1, extent[axis]) >> random.integer(0, log2Side / 2));
  return extent;
}

std::size_t drawCount(RandomSource &random, std::size_t most) {
  constexpr std::array<std::size_t, 16> kCounts = {
      1, 1, 10, 100, 1000, 4000, 20000, 40000, 65536, 65536, 65536, 65536, 200000, 200000, 1000000, 10000000};
  return std::min(most, kCounts[static_cast<std::size_t>(random.integer(0, 15))]);
}

/// One of `Values`, each with a weight.
template <typename Value, std::size_t Count>
Value weighted(RandomSource &random, const std::array<std::pair<Value, int>, Count> &values) {
  int sum = 0;
  for (const auto &[value, weight] : values)
    sum += weight;
  int at = random.integer(0, sum - 1);
  for (const auto &[value, weight] : values) {
    at -= weight;
    if (at < 0)
      return value;
  }
  return values.front().first;
}

constexpr std::array<std::pair<Query, int>, 4> kQueries = {
    {{Query::Closest, 6}, {Query::Any, 3}, {Query::Occupancy, 1}, {Query::Distance, 1}}};
constexpr std::array<std::pair<Interval, int>, 6> kIntervals = {{{Interval::None, 4},
                                                                 {Interval::All, 2},
                                                                 {Interval::Short, 2},
                                                                 {Interval::Late, 2},
                                                                 {Interval::Slice, 2},
                                                                 {Interval::Nothing, 1}}};

/// What kernels of another kind are asked; only some situations have one, for each is compiled.
void drawQuestion(RandomSource &random, Situation &situation) {
  situation.query = weighted(random, kQueries);
  if (!isOfPoints(situation.query))
    situation.interval = weighted(random, kIntervals);
}

} // namespace

std::string_view nameOf(Interval interval) {
  constexpr std::array<std::string_view, 6> kNames = {"no-bounds", "all",   "short",
                                                      "late",      "slice", "nothing"};
  return kNames[static_cast<std::size_t>(interval)];
}

Place drawPlace(std::uint64_t seed, std::uint64_t number, const DrawLimits &limits) {
  RandomSource random(mixed(seed, 2 * number));
  const bool isHuge = random.integer(0, 4) == 0;
  const int log2Side = isHuge
                           ? random.integer(limits.mostLog2Filled + 1, kMaxLog2Extent)
                           : random.integer(random.integer(1, limits.mostLog2Filled), limits.mostLog2Filled);
  const Int3 extent = drawExtent(random, log2Side);
  const std::vector<std::string> scenes = sceneNames(extent);
  const auto scene = static_cast<std::size_t>(random.integer(0, static_cast<int>(scenes.size()) - 1));
  Place place{number, scenes[scene], extent, drawFormat(random, log2Above(extent))};
  maybeTraverse(random, place.format);
  return place;
}

Situation drawSituation(std::uint64_t seed, std::uint64_t number, const DrawLimits &limits) {
  RandomSource random(mixed(seed, 2 * number + 1));
  Situation situation{.number = number};
  const auto kinds = rayKinds();
  situation.rays =
      kinds[static_cast<std::size_t>(random.integer(0, static_cast<int>(kinds.size()) - 1))].name;
  situation.count = drawCount(random, limits.mostRays);
  situation.seed = mixed(seed, number ^ std::uint64_t{1} << 60);
  situation.threads = random.integer(0, 9) == 0 ? 2 : 1;
  // The first situations of a place share its plain kernel.
  const std::uint64_t rank = number % kSituationsOfPlace;
  if (rank == 5 || rank == 6)
    drawQuestion(random, situation);
  if (rank == 7 && random.flip())
    situation.instances = std::array{1u, 10u, 100u, 1000u}[static_cast<std::size_t>(random.integer(0, 3))];
  else if (rank == 7)
    situation.isPaged = true;
  const bool needsHits = situation.interval == Interval::Late || situation.interval == Interval::Slice;
  if (situation.instances > 0 || needsHits)
    situation.count = std::min<std::size_t>(situation.count, 65536);
  return situation;
}

Format askedFormat(const Place &place, const Situation &situation) {
  Format format = place.format;
  if (!isOfHits(situation.query))
    format.setAttribute(kQueryAttribute, kEnumNames<Query>[static_cast<std::size_t>(situation.query)]);
  if (situation.interval != Interval::None)
    askForBounds(format);
  return format;
}

std::string describe(const Place &place) {
  const auto text = [](int number) { return std::to_string(number); };
  std::string format = printIr(place.format);
  std::ranges::replace(format, '\n', ' ');
  return place.scene + " " + text(place.extent.x) + "x" + text(place.extent.y) + "x" + text(place.extent.z) +
         " in " + format;
}

std::string describe(const Situation &situation) {
  std::string text = std::to_string(situation.count) + " " + situation.rays;
  if (!isOfHits(situation.query))
    text += " " + std::string(kEnumNames<Query>[static_cast<std::size_t>(situation.query)]);
  if (situation.interval != Interval::None)
    text += " " + std::string(nameOf(situation.interval));
  if (situation.threads > 1)
    text += " threads";
  if (situation.instances > 0)
    text += " instances-" + std::to_string(situation.instances);
  if (situation.isPaged)
    text += " paged";
  return text;
}

} // namespace voxc::cliffs
