// The table of slot kinds; a new one is a file beside this and a row here.
#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <array>

namespace voxc {

// The rows, each in the file of its name.
extern const SlotKind kDenseSlots;
extern const SlotKind kPackedSlots;
extern const SlotKind kSiblingSlots;
extern const SlotKind kHashedSlots;
extern const SlotKind kOctantSlots;

namespace {

constexpr std::array<const SlotKind *, 5> kKinds = {&kDenseSlots, &kPackedSlots, &kSiblingSlots,
                                                    &kHashedSlots, &kOctantSlots};

} // namespace

std::span<const SlotKind *const> slotKinds() { return kKinds; }

const SlotKind *findSlotKind(std::string_view name) {
  const auto found = std::ranges::find(kKinds, name, [](const SlotKind *kind) { return kind->name; });
  return found == kKinds.end() ? nullptr : *found;
}

} // namespace voxc
