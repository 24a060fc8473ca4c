// The base formats, each described in the file of its name, and what their descriptions share.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Layout/SlotKind.h"

#include <array>

namespace voxc {

extern const LevelKind kRaw;
extern const LevelKind kDistance;
extern const LevelKind kSvo;
extern const LevelKind kSvdag;
extern const LevelKind kMasked;
extern const LevelKind kHash;

inline constexpr ParameterKind kWidth = {"W", ParameterRole::Width, "log2 of the cells along x", 0,
                                         kMaxLog2Extent};
inline constexpr ParameterKind kHeight = {"H", ParameterRole::Height, "log2 of the cells along y", 0,
                                          kMaxLog2Extent};
inline constexpr ParameterKind kDepth = {"D", ParameterRole::Depth, "log2 of the cells along z", 0,
                                         kMaxLog2Extent};

/// The cells of a grid, which are the children of one node.
Stratum gridStratum(const Level &level, const SlotKind &slots);

/// The nodes of a tree.
Stratum treeStratum(const Level &level, const SlotKind &slots, Cells cells);

} // namespace voxc
