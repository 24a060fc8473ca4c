// The table of level kinds and of the attributes that they take.
#include "Kinds.h"

#include "IR/AttributeReading.h"

#include "voxc/IR/Choices.h"

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
constexpr std::array<std::string_view, 2> kMirrorValues = {"no", "yes"};
constexpr std::array<std::string_view, 2> kShareValues = {"none", "level"};
constexpr std::array<std::string_view, 2> kMasksValues = {"whole", "octants"};
constexpr std::array<std::string_view, 18> kPointersValues = {"word", "8",  "9",  "10", "11", "12",
                                                              "13",   "14", "15", "16", "17", "18",
                                                              "19",   "20", "21", "22", "23", "24"};
constexpr std::array<std::string_view, 3> kTraversalValues = {"stack", "restart", "unrolled"};
/// One loop for all levels has a stack of its own, and no traversals of trees.
constexpr std::array<AttributeValue, 2> kTraversalExcludes = {
    {{&kLevelsAttribute, "flat"}, {&kLevelsAttribute, "direct"}}};

} // namespace

const TypedAttribute<Sharing> kDedupAttribute = {
    {.name = "dedup",
     .effect = AttributeEffect::Storage,
     .values = kDedupValues,
     .summary = "which equal nodes share storage: those of one sub-volume, or of the whole level",
     .amongSubVolumes = true},
    [](std::size_t value) { return value == 0 ? Sharing::SubVolume : Sharing::Level; }};

const TypedAttribute<Sharing> kShareAttribute = {
    {.name = "share",
     .effect = AttributeEffect::Storage,
     .values = kShareValues,
     .summary = "which equal sub-volumes of grids share storage: none, or those of the whole level",
     .amongSubVolumes = true},
    [](std::size_t value) { return value == 0 ? Sharing::None : Sharing::Level; }};

const TypedAttribute<bool> kMirrorAttribute = {
    {"mirror", AttributeEffect::Storage, kMirrorValues,
     "whether nodes share storage that are equal but for a reflection across some axes"},
    isSecond};

const TypedAttribute<LeafPlace> kLeavesAttribute = {
    {"leaves", AttributeEffect::Storage, kEnumNames<LeafPlace>,
     "where the value of a leaf stands: apart, in a word that its slot points to, or in the slot itself"},
    as<LeafPlace>};

const TypedAttribute<DistancePlace> kDistancesAttribute = {
    {"distances", AttributeEffect::Storage, kEnumNames<DistancePlace>,
     "where the distance of an empty cell stands: in a word beside its slot, or in the slot itself"},
    as<DistancePlace>};

const TypedAttribute<Metric> kMetricAttribute = {
    {"metric", AttributeEffect::Storage, kEnumNames<Metric>,
     "what the distance of an empty cell is: the L1 distance to the nearest full cell, or for each octant of "
     "directions the side of the empty cube ahead, 15 cells at most, in a voxel's own word 7"},
    as<Metric>};

const TypedAttribute<int> kPointersAttribute = {
    {"pointers", AttributeEffect::Storage, kPointersValues,
     "what leads to a sub-volume: its offset, a word, or its number in an array of all of the level's, of so "
     "many bits; of grids of 4 x 4 x 4 voxels that are masks alone, below a masked level",
     nullptr, "--short-pointers"},
    [](std::size_t value) { return value == 0 ? 0 : static_cast<int>(value) + 7; }};

const TypedAttribute<VoxelCountsOf> kCountsAttribute = {
    {.name = "counts",
     .effect = AttributeEffect::Storage,
     .values = kEnumNames<VoxelCountsOf>,
     .summary = "which sub-volumes whose numbers stand in a grid of 4 x 4 x 4 have a count of the voxels "
                "before theirs: each, or the first of each octant of eight, where masks give the rest",
     .needs = &kPointersAttribute},
    as<VoxelCountsOf>};

const TypedAttribute<bool> kMasksAttribute = {
    {.name = "masks",
     .effect = AttributeEffect::Storage,
     .values = kMasksValues,
     .summary = "how the masks of sub-volumes stand that have numbers: whole, or a byte for each octant of "
                "eight cells that is not empty",
     .needs = &kPointersAttribute},
    isSecond};

const TypedAttribute<Descent> kTraversalAttribute = {
    {.name = "traversal",
     .effect = AttributeEffect::Traversal,
     .values = kTraversalValues,
     .summary = "how a lookup finds its node: from the last lookup's ancestors on a stack, from the root "
                "each time, or by a loop for each height",
     .excludes = kTraversalExcludes},
    [](std::size_t value) { return static_cast<Descent>(value + 2); }};

bool LevelKind::isTree() const {
  return std::ranges::any_of(parameters,
                             [](const ParameterKind &kind) { return kind.role == ParameterRole::Side; });
}

bool Level::keepsNodes() const {
  return kind->isTree() && log2Size() != Int3{} && kindOf(get(kTraversalAttribute)).keepsNodes;
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
