// The table of level kinds and of the attributes that they take.
#include "Kinds.h"

#include <algorithm>

namespace voxc {

// The rows, each in the file of its name.
extern const LevelKind kRaw;
extern const LevelKind kDistance;
extern const LevelKind kSvo;
extern const LevelKind kSvdag;
extern const LevelKind kMasked;
extern const LevelKind kHash;

namespace {

constexpr std::array<const LevelKind *, 6> kKinds = {&kRaw, &kDistance, &kSvo, &kSvdag, &kMasked, &kHash};

constexpr std::array<std::string_view, 2> kDedupValues = {"sub-volume", "level"};
constexpr std::array<std::string_view, 2> kShareValues = {"none", "level"};
constexpr std::array<std::string_view, 2> kLeavesValues = {"apart", "in-slot"};
constexpr std::array<std::string_view, 2> kDistancesValues = {"beside", "in-slot"};
constexpr std::array<std::string_view, 2> kMetricValues = {"l1", "octant"};
constexpr std::array<std::string_view, 18> kPointersValues = {"word", "8",  "9",  "10", "11", "12",
                                                              "13",   "14", "15", "16", "17", "18",
                                                              "19",   "20", "21", "22", "23", "24"};
constexpr std::array<std::string_view, 2> kCountsValues = {"each", "octant"};
constexpr std::array<std::string_view, 2> kMasksValues = {"whole", "octants"};
constexpr std::array<std::string_view, 3> kWalkValues = {"stack", "restart", "unrolled"};

} // namespace

const AttributeKind kDedupAttribute = {
    "dedup", AttributeEffect::Storage, kDedupValues,
    "which equal nodes share storage: those of one sub-volume, or of the whole level"};

const AttributeKind kShareAttribute = {
    "share", AttributeEffect::Storage, kShareValues,
    "which equal sub-volumes of grids share storage: none, or those of the whole level"};

const AttributeKind kLeavesAttribute = {
    "leaves", AttributeEffect::Storage, kLeavesValues,
    "where the value of a leaf stands: apart, in a word that its slot points to, or in the slot itself"};

const AttributeKind kDistancesAttribute = {
    "distances", AttributeEffect::Storage, kDistancesValues,
    "where the distance of an empty cell stands: in a word beside its slot, or in the slot itself"};

const AttributeKind kMetricAttribute = {
    "metric", AttributeEffect::Storage, kMetricValues,
    "what the distance of an empty cell is: the L1 distance to the nearest full cell, or for each octant of "
    "directions the side of the empty cube ahead, 15 cells at most, in a voxel's own word 7"};

const AttributeKind kPointersAttribute = {
    "pointers", AttributeEffect::Storage, kPointersValues,
    "what leads to a sub-volume: its offset, a word, or its number in an array of all of the level's, of so "
    "many bits; of grids of 4 x 4 x 4 voxels that are masks alone, below a masked level"};

const AttributeKind kCountsAttribute = {
    "counts", AttributeEffect::Storage, kCountsValues,
    "which sub-volumes whose numbers stand in a grid of 4 x 4 x 4 have a count of the voxels before theirs: "
    "each, or the first of each octant of eight, where masks tell the rest"};

const AttributeKind kMasksAttribute = {
    "masks", AttributeEffect::Storage, kMasksValues,
    "how the masks of sub-volumes stand that have numbers: whole, or a byte for each octant of eight cells "
    "that is not empty"};

const AttributeKind kWalkAttribute = {
    "walk", AttributeEffect::Walk, kWalkValues,
    "how a lookup finds its node: from the last lookup's ancestors on a stack, from "
    "the root each time, or by a loop for each height"};

bool LevelKind::isTree() const {
  return std::ranges::any_of(parameters,
                             [](const ParameterKind &kind) { return kind.role == ParameterRole::Side; });
}

std::span<const LevelKind *const> levelKinds() { return kKinds; }

const LevelKind *findLevelKind(char letter) {
  const auto found = std::ranges::find(kKinds, letter, [](const LevelKind *kind) { return kind->letter; });
  return found == kKinds.end() ? nullptr : *found;
}

const LevelKind *findLevelKind(std::string_view name) {
  const auto found = std::ranges::find(kKinds, name, [](const LevelKind *kind) { return kind->name; });
  return found == kKinds.end() ? nullptr : *found;
}

} // namespace voxc
