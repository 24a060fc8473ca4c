// What templates may speak of: the names of a plan, of one of its strata, and of one layer of a tree. All
// names of a kind are always there, so that a template which is right for one plan is right for all.
#pragma once

#include "Template.h"

#include "voxc/Plan/Plan.h"

#include <cstddef>
#include <string>

namespace voxc {

/// Of the plan as a whole.
TemplateNames planNames(const Plan &plan);

/// Those, and of the stratum at an index.
TemplateNames stratumNames(const Plan &plan, std::size_t index);

/// Those, and of a layer of a tree, from 1, whose nodes have cells for children, to its depth.
TemplateNames layerNames(const Plan &plan, std::size_t index, int layer);

/// The layers of nodes that a flat walk keeps for a stratum: one for a single cell, which has none.
int flatLayers(const Stratum &stratum);

/// "// Level 2: svdag, 256 x 256 x 256 cells of 1 voxel a side." and an empty line before it.
std::string levelComment(const Plan &plan, std::size_t index);

/// "ivec3(4, 4, 4)".
std::string intVector(Int3 v);

} // namespace voxc
