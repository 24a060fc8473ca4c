// Attributes: the table of a format's, and sets of them.
#include "voxc/IR/Attribute.h"
#include "AttributeReading.h"

#include "voxc/IR/Choices.h"
#include "voxc/IR/Query.h"
#include "voxc/IR/Stack.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace voxc {
namespace {

constexpr std::array<std::string_view, 2> kYesValues = {"yes", "no"};
constexpr std::array<std::string_view, 2> kNoValues = {"no", "yes"};
constexpr std::array<std::string_view, 36> kPayloadValues = {
    "rgba8",        "occupancy",    "constant",     "palette(1)",   "palette(2)",   "palette(3)",
    "palette(4)",   "palette(5)",   "palette(6)",   "palette(7)",   "palette(8)",   "palette(9)",
    "palette(10)",  "palette(11)",  "palette(12)",  "palette(13)",  "palette(14)",  "palette(15)",
    "palette(16)",  "rgb565",       "material(1)",  "material(2)",  "material(3)",  "material(4)",
    "material(5)",  "material(6)",  "material(7)",  "material(8)",  "material(9)",  "material(10)",
    "material(11)", "material(12)", "material(13)", "material(14)", "material(15)", "material(16)"};

constexpr std::array<std::string_view, 9> kGranuleValues = {"word", "2",  "4",   "8",  "16",
                                                            "32",   "64", "128", "256"};

constexpr AttributeList kOutputs = {
    "outputs", "what the kernel stores of a closest hit; the rest is 0, and no work is done for it"};

} // namespace

const TypedAttribute<Precision> kPrecisionAttribute = {
    {"precision", AttributeEffect::Traversal, kEnumNames<Precision>,
     "which hits the kernel gives: the exact ones, or those of plain float32, wrong only by rounding"},
    as<Precision>};

const TypedAttribute<Detail> kDetailAttribute = {
    {"detail", AttributeEffect::Traversal, kEnumNames<Detail>,
     "where the kernel stops: at voxels, or already at what looks smaller than a cone around the ray"},
    as<Detail>};

const TypedAttribute<LevelTraversal> kLevelsAttribute = {
    {"levels", AttributeEffect::Traversal, kEnumNames<LevelTraversal>,
     "how the kernel goes from level to level: by a loop for each, by one loop through all, by one that goes "
     "down from the root in each turn, or by what is fastest as a rule",
     nullptr, "--nested-traversal, --flat-traversal or --direct-traversal"},
    as<LevelTraversal>};

const TypedAttribute<Stack> kStackAttribute = {
    {"stack", AttributeEffect::Traversal, kEnumNames<Stack>,
     "where a traversal keeps the nodes above a cell, if it keeps any: in memory of each ray's own, or in "
     "that of a group of rays, which kernels for the cpu and functions for others do not have",
     nullptr, "--shared-stack"},
    as<Stack>};

const TypedAttribute<Query> kQueryAttribute = {
    {"query", AttributeEffect::Traversal, kEnumNames<Query>,
     "what the kernel answers: the closest hit, whether there is any, whether there is a voxel where the ray "
     "begins, or the t of the closest hit alone"},
    as<Query>};

const TypedAttribute<bool> kBoundsAttribute = {
    {"bounds", AttributeEffect::Traversal, kNoValues,
     "whether each ray has bounds, a tmin and a tmax, between which the kernel looks for voxels"},
    isSecond};

const TypedAttribute<bool> kVoxelAttribute = {{"voxel", AttributeEffect::Traversal, kYesValues,
                                               "whether the kernel stores which voxel a closest hit is",
                                               &kOutputs},
                                              isFirst};

const TypedAttribute<bool> kTAttribute = {{"t", AttributeEffect::Traversal, kYesValues,
                                           "whether the kernel stores the t of a closest hit", &kOutputs},
                                          isFirst};

const TypedAttribute<bool> kFaceAttribute = {
    {"face", AttributeEffect::Traversal, kNoValues,
     "whether the kernel stores by which face of its voxel the ray enters at a closest hit", &kOutputs},
    isSecond};

const TypedAttribute<bool> kColourAttribute = {{"colour", AttributeEffect::Traversal, kYesValues,
                                                "whether the kernel stores the colour of a closest hit",
                                                &kOutputs},
                                               isFirst};

const TypedAttribute<bool> kIndexAttribute = {{"index",
                                               AttributeEffect::Traversal,
                                               kNoValues,
                                               "whether the kernel stores, in place of the colour, the "
                                               "number of a closest hit's voxel among all of the volume",
                                               &kOutputs,
                                               {},
                                               &kValuesAttribute},
                                              isSecond};

const AttributeKind kPayloadAttribute = {
    "payload", AttributeEffect::Storage, kPayloadValues,
    "what a voxel is: a colour of four bytes; or nothing but that it is there, white or of the one colour of "
    "all voxels; or one of at most 2^n colours in a table; or a colour of 5, 6 and 5 bits; or a label of n "
    "bits. A build proves what is stated"};

const TypedAttribute<Alpha> kAlphaAttribute = {
    {"alpha", AttributeEffect::Storage, kEnumNames<Alpha>,
     "a fact about the voxels, which a build proves: whether one that is not empty may have an alpha of 0"},
    as<Alpha>};

const TypedAttribute<Values> kValuesAttribute = {
    {"values", AttributeEffect::Storage, kEnumNames<Values>,
     "where the colours of voxels stand: in the words of their cells, or apart from the shape, in compressed "
     "blocks by the rank of the voxel, so that equal shapes of other colours share storage"},
    as<Values>};

const TypedAttribute<int> kGranuleAttribute = {
    {"granule", AttributeEffect::Storage, kGranuleValues,
     "what references count: words, or granules of so many, at which all that they lead to begins, so that a "
     "volume may have as many times the words"},
    asNumber};
namespace {

/// The number in a value, "4" of "palette(4)", and what stands around it; 0 and all of it where there is
/// none.
struct Numbered {
  explicit Numbered(std::string_view value) {
    const std::size_t begin = std::min(value.find_first_of("0123456789"), value.size());
    before = value.substr(0, begin);
    const char *const end = value.data() + value.size();
    const char *const rest = std::from_chars(value.data() + begin, end, number).ptr;
    after = std::string_view(rest, end);
  }

  bool isFollowedBy(const Numbered &next) const {
    return number > 0 && next.number == number + 1 && before == next.before && after == next.after;
  }

  std::string_view before;
  std::string_view after;
  int number = 0;
};

} // namespace

std::string ValueRange::text(std::string_view mark) const {
  const auto marked = [mark](std::string_view value) {
    return std::string(mark) + std::string(value) + std::string(mark);
  };
  return first == last ? marked(first) : marked(first) + " to " + marked(last);
}

std::vector<ValueRange> valueRanges(const AttributeKind &kind) {
  std::vector<ValueRange> ranges;
  for (const std::string_view value : kind.values)
    if (ranges.empty() || !Numbered(ranges.back().last).isFollowedBy(Numbered(value)))
      ranges.push_back({value, value});
    else
      ranges.back().last = value;
  return ranges;
}

AttributeKinds formatAttributes() {
  static constexpr std::array<const AttributeKind *, 15> kAttributes = {
      &kPrecisionAttribute, &kDetailAttribute,  &kLevelsAttribute, &kStackAttribute,  &kQueryAttribute,
      &kBoundsAttribute,    &kVoxelAttribute,   &kTAttribute,      &kFaceAttribute,   &kColourAttribute,
      &kIndexAttribute,     &kPayloadAttribute, &kAlphaAttribute,  &kValuesAttribute, &kGranuleAttribute};
  return kAttributes;
}

std::size_t AttributeSet::number(const AttributeKind &kind) const {
  const auto found = std::ranges::find(attributes_, &kind, &Chosen::kind);
  return found == attributes_.end() ? 0 : found->value;
}

bool AttributeSet::set(AttributeKinds taken, const AttributeKind &kind, std::string_view value) {
  const auto found = std::ranges::find(kind.values, value);
  if (std::ranges::find(taken, &kind) == taken.end() || found == kind.values.end() ||
      this->value(kind) == value)
    return false;
  std::erase_if(attributes_, [&](const Chosen &attribute) { return attribute.kind == &kind; });
  if (found != kind.values.begin())
    attributes_.push_back({&kind, static_cast<std::size_t>(found - kind.values.begin())});
  // Kept in the order of the table, so that equal sets compare equal whatever the order of the passes.
  std::ranges::sort(attributes_, {}, [&](const Chosen &attribute) {
    return std::ranges::find(taken, attribute.kind) - taken.begin();
  });
  return true;
}

void AttributeSet::eraseTraversal() {
  std::erase_if(attributes_,
                [](const Chosen &set) { return set.kind->effect == AttributeEffect::Traversal; });
}

std::string printAttributes(const AttributeSet &set, AttributeKinds taken) {
  std::string text;
  for (const AttributeKind *kind : taken)
    if (set.value(*kind) != kind->values[0])
      text += " " + std::string(kind->name) + "=" + std::string(set.value(*kind));
  return text;
}

} // namespace voxc
