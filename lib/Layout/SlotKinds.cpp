// The table of slot kinds; a new one is a file beside this and a row here.
#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <array>

namespace voxc {

// The rows, each in the file of its name.
extern const SlotKind kDenseSlots;
extern const SlotKind kPackedSlots;
extern const SlotKind kMaskedSlots;
extern const SlotKind kBrickSlots;
extern const SlotKind kNumberedSlots;
extern const SlotKind kNumberedBrickSlots;
extern const SlotKind kSiblingSlots;
extern const SlotKind kHashedSlots;
extern const SlotKind kOctantSlots;
extern const SlotKind kMirroredSlots;

namespace {

constexpr std::array<const SlotKind *, 10> kKinds = {
    &kDenseSlots,  &kPackedSlots, &kMirroredSlots, &kSiblingSlots,       &kHashedSlots,
    &kMaskedSlots, &kBrickSlots,  &kNumberedSlots, &kNumberedBrickSlots, &kOctantSlots};

} // namespace

Encoding defaultEncoding(const SlotKind &kind) {
  for (const Encoding &encoding :
       {Encoding(), Encoding(Distances{}), Encoding(Numbers{}), Encoding(Leaves{}), Encoding(Records{})})
    if (takes(kind, encoding))
      return encoding;
  return {};
}

double lookUpFactor(std::span<const Stratum> strata) {
  double factor = 1;
  for (const Stratum &stratum : strata)
    factor = std::max(factor, stratum.slots->cost.factor);
  return factor;
}

std::span<const SlotKind *const> slotKinds() { return kKinds; }

const SlotKind *findSlotKind(std::string_view name) {
  const auto found = std::ranges::find(kKinds, name, [](const SlotKind *kind) { return kind->name; });
  return found == kKinds.end() ? nullptr : *found;
}

} // namespace voxc
