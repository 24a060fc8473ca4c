// What the descriptions of base formats share; each stands in the file of its name.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Layout/SlotKind.h"

#include <array>

namespace voxc {

inline constexpr ParameterKind kWidth = {"W", ParameterRole::Width, "log2 of the cells along x", 0,
                                         kMaxLog2Extent};
inline constexpr ParameterKind kHeight = {"H", ParameterRole::Height, "log2 of the cells along y", 0,
                                          kMaxLog2Extent};
inline constexpr ParameterKind kDepth = {"D", ParameterRole::Depth, "log2 of the cells along z", 0,
                                         kMaxLog2Extent};

/// The cells of a grid, which are the children of one node with slots of the kind of this name.
Stratum gridStratum(const Level &level, std::string_view slots);

/// The nodes of a tree, with slots of the kind of this name.
Stratum treeStratum(const Level &level, std::string_view slots);

} // namespace voxc
