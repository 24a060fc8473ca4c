// Attributes: the table of a format's, and sets of them.
#include "voxc/IR/Attribute.h"
#include "voxc/IR/Query.h"

#include <algorithm>
#include <array>

namespace voxc {
namespace {

constexpr std::array<std::string_view, 2> kPrecisionValues = {"exact", "fast"};
constexpr std::array<std::string_view, 2> kDetailValues = {"full", "cone"};
constexpr std::array<std::string_view, 4> kLevelsValues = {"auto", "nested", "flat", "direct"};
constexpr std::array<std::string_view, 2> kYesValues = {"yes", "no"};
constexpr std::array<std::string_view, 2> kNoValues = {"no", "yes"};
constexpr std::array<std::string_view, 3> kPayloadValues = {"rgba8", "occupancy", "constant"};
constexpr std::array<std::string_view, 2> kAlphaValues = {"any", "positive"};
constexpr std::array<std::string_view, 2> kValuesValues = {"in-place", "apart"};

constexpr std::array<std::string_view, 9> kGranuleValues = {"word", "2",  "4",   "8",  "16",
                                                            "32",   "64", "128", "256"};

constexpr AttributeList kOutputs = {"outputs",
                                    "what the kernel stores of a closest hit; the rest is 0, and no "
                                    "work is done for it"};

} // namespace

const AttributeKind kPrecisionAttribute = {
    "precision", AttributeEffect::Walk, kPrecisionValues,
    "which hits the kernel gives: the exact ones, or those of plain float32, wrong only by rounding"};

const AttributeKind kDetailAttribute = {
    "detail", AttributeEffect::Walk, kDetailValues,
    "where the kernel stops: at voxels, or already at what looks smaller than a cone around the ray"};

const AttributeKind kLevelsAttribute = {"levels", AttributeEffect::Walk, kLevelsValues,
                                        "how the kernel goes from level to level: by a loop for each, by one "
                                        "loop through all, by one that goes down "
                                        "from the root in each turn, or by what is fastest as a rule"};

const AttributeKind kQueryAttribute = {
    "query", AttributeEffect::Walk, kEnumNames<Query>,
    "what the kernel answers: the closest hit, whether there is any, whether there is a voxel where the ray "
    "begins, or the t of the closest hit alone"};

const AttributeKind kVoxelAttribute = {"voxel", AttributeEffect::Walk, kYesValues,
                                       "whether the kernel stores which voxel a closest hit is", &kOutputs};

const AttributeKind kTAttribute = {"t", AttributeEffect::Walk, kYesValues,
                                   "whether the kernel stores the t of a closest hit", &kOutputs};

const AttributeKind kFaceAttribute = {
    "face", AttributeEffect::Walk, kNoValues,
    "whether the kernel stores by which face of its voxel the ray enters at a closest hit", &kOutputs};

const AttributeKind kColourAttribute = {"colour", AttributeEffect::Walk, kYesValues,
                                        "whether the kernel stores the colour of a closest hit", &kOutputs};

const AttributeKind kPayloadAttribute = {"payload", AttributeEffect::Storage, kPayloadValues,
                                         "what a voxel is: a colour of four bytes, in the word of its cell, "
                                         "or nothing but that it is there, white "
                                         "or of the one colour of all voxels, which a build proves"};

const AttributeKind kAlphaAttribute = {
    "alpha", AttributeEffect::Storage, kAlphaValues,
    "a fact about the voxels, which a build proves: whether one that is not empty may have an alpha of 0"};

const AttributeKind kValuesAttribute = {
    "values", AttributeEffect::Storage, kValuesValues,
    "where the colours of voxels stand: in the words of their cells, or apart from the shape, in compressed "
    "blocks by the rank of the voxel, so that equal shapes of other colours share storage"};

const AttributeKind kGranuleAttribute = {
    "granule", AttributeEffect::Storage, kGranuleValues,
    "what references count: words, or granules of so many, at which all that they lead to begins, so that a "
    "volume may have as many times the words"};

AttributeKinds formatAttributes() {
  static constexpr std::array<const AttributeKind *, 12> kAttributes = {
      &kPrecisionAttribute, &kDetailAttribute, &kLevelsAttribute, &kQueryAttribute,
      &kVoxelAttribute,     &kTAttribute,      &kFaceAttribute,   &kColourAttribute,
      &kPayloadAttribute,   &kAlphaAttribute,  &kValuesAttribute, &kGranuleAttribute};
  return kAttributes;
}

std::string_view AttributeSet::value(const AttributeKind &kind) const {
  const auto found = std::ranges::find(attributes_, &kind, &Attribute::kind);
  return kind.values[found == attributes_.end() ? 0 : found->value];
}

bool AttributeSet::set(AttributeKinds taken, const AttributeKind &kind, std::string_view value) {
  const auto found = std::ranges::find(kind.values, value);
  if (std::ranges::find(taken, &kind) == taken.end() || found == kind.values.end() ||
      this->value(kind) == value)
    return false;
  std::erase_if(attributes_, [&](const Attribute &attribute) { return attribute.kind == &kind; });
  if (found != kind.values.begin())
    attributes_.push_back({&kind, static_cast<std::size_t>(found - kind.values.begin())});
  // Kept in the order of the table, so that equal sets compare equal whatever the order of the passes.
  std::ranges::sort(attributes_, {}, [&](const Attribute &attribute) {
    return std::ranges::find(taken, attribute.kind) - taken.begin();
  });
  return true;
}

void AttributeSet::eraseWalk() {
  std::erase_if(attributes_, [](const Attribute &set) { return set.kind->effect == AttributeEffect::Walk; });
}

std::string printAttributes(const AttributeSet &set, AttributeKinds taken) {
  std::string text;
  for (const AttributeKind *kind : taken)
    if (set.value(*kind) != kind->values[0])
      text += " " + std::string(kind->name) + "=" + std::string(set.value(*kind));
  return text;
}

} // namespace voxc
