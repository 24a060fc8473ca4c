// The table of slot kinds; a new one is a file beside this and a row here.
#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <array>

namespace voxc {
namespace {

constexpr std::array<const SlotKind *, 4> kKinds = {&kDenseSlots, &kPackedSlots, &kSiblingSlots,
                                                    &kHashedSlots};

} // namespace

std::span<const SlotKind *const> slotKinds() { return kKinds; }

const SlotKind *findSlotKind(std::string_view name) {
  const auto found = std::ranges::find(kKinds, name, [](const SlotKind *kind) { return kind->name; });
  return found == kKinds.end() ? nullptr : *found;
}

} // namespace voxc
