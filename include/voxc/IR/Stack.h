// Where a traversal keeps the nodes above a cell.
#pragma once

#include "voxc/Support/EnumText.h"

namespace voxc {

/// The memory in which a traversal keeps the nodes above a cell: their references alone, for their words are
/// read again.
enum class Stack {
  Private, ///< Each ray's own.
  Shared,  ///< Of a group of rays, as a device has: each has a column of it.
};

template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Stack> = {"private", "shared"};

} // namespace voxc
