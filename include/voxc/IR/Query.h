// What a kernel answers of a ray, as the attributes of a format ask for it.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Support/EnumText.h"

#include <span>
#include <string_view>

namespace voxc {

/// What is asked of a ray.
enum class Query {
  Closest,   ///< Its hit: the first voxel on it.
  Any,       ///< Whether there is a voxel on it.
  Occupancy, ///< Whether there is a voxel where it begins. Its direction does not count.
  Distance,  ///< The t of its hit.
};

/// True if points are looked up, where rays begin, and no ray is followed.
constexpr bool isOfPoints(Query query) { return query == Query::Occupancy; }

/// True if hits are answered, of which outputs can be chosen.
constexpr bool isOfHits(Query query) { return query == Query::Closest; }

template <>
inline constexpr std::array<std::string_view, 4> kEnumNames<Query> = {"closest", "any", "occupancy",
                                                                      "distance"};

/// What is stored of a hit; what is not is 0 in its record. That of a miss is the same in each case.
struct Outputs {
  bool voxel = true;
  bool t = true;
  bool face = false; ///< By which the ray enters the voxel: `Hit::steps`.
  bool colour = true;
  /// The number of the voxel (docs/attributes.md), in place of the colour: `Hit::rgba`.
  bool index = false;

  bool operator==(const Outputs &) const = default;
};

struct Question {
  Query query = Query::Closest;
  Outputs outputs;
  bool bounds = false; ///< Rays have a tmin and a tmax (voxc/Trace/BoundedRay.h).

  bool operator==(const Question &) const = default;
};

/// The outputs that a query other than the closest has: none is left to choose. Those of the closest are the
/// default ones.
constexpr Outputs outputsOf(Query query) {
  switch (query) {
  case Query::Closest:
    break;
  case Query::Any:
    return {.voxel = false, .t = false, .colour = false};
  case Query::Occupancy:
    return {.t = false, .colour = false};
  case Query::Distance:
    return {.voxel = false, .colour = false};
  }
  return {};
}

/// What the attributes of a verified format ask.
Question questionOf(const Format &format);

/// Asks for a kernel whose rays have bounds.
void askForBounds(Format &format);

/// Asks for a kernel that stops at what looks smaller than a cone around the ray, or at voxels alone.
void askForCones(Format &format, bool stops = true);

/// Asks for hits of this precision, which is one of `precisionNames`.
void askForPrecision(Format &format, std::string_view precision);
std::span<const std::string_view> precisionNames();

/// Whether the kernel stores something that the voxel has: its colour or its number.
constexpr bool storesValue(const Outputs &outputs) { return outputs.colour || outputs.index; }

/// What is wrong with a question, to follow the words "the format" or "the plan"; empty if it is right.
std::string_view problemOf(const Question &question);

/// What is wrong with what a format asks, to follow the words "the format"; empty if it is right.
std::string_view problemOfQuestion(const Format &format);

} // namespace voxc
