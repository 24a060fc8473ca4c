// What slot kinds of trees have in common: how construction ends a sub-volume.
#pragma once

#include "voxc/Layout/SlotKind.h"

namespace voxc {

inline constexpr RuntimeClass kEditedTree = {"voxc_edited_tree.h", "EditedTree"};

/// `SlotKind::root` of trees whose leaves have values.
inline std::string_view rootOfLeaves(const Stratum &stratum) {
  return stratum.leaves()->place == LeafPlace::Apart ? "ApartRoot" : "InSlotRoot";
}

} // namespace voxc
