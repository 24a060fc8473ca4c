// Holding what stands of a build plan against its input.
#pragma once

#include "building/Comparison.h"
#include "cluster/MergeTree.h"
#include "options/BuildArguments.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <cstdint>
#include <string>
#include <vector>

namespace voxc::tool {

/// An output of a plan that stands and whose voxels are not those of the input, or not to be read.
struct BrokenOutput {
  std::string path;
  std::string problem; ///< What makes it no fragment, or "" if its voxels alone are wrong.
  VoxelDifferences differences;
};

/// What was found of a plan's parts and of the merges that leave fragments.
struct PlanCheck {
  std::uint64_t outputs = 0;    ///< That the plan has,
  std::uint64_t missing = 0;    ///< of which so many do not stand.
  VoxelDifferences differences; ///< Of all that stand together.
  std::vector<BrokenOutput> broken;
};

/// True if a file is a build plan, by its first words.
bool isBuildPlan(const std::string &path);

/// Compares the voxels of each fragment of the plan in the file `path` that stands with those of the input,
/// in the cubes of its share; the input is opened once. A fragment is made to a volume of its own for that.
/// Errors: the plan's and the input's; no memory; interrupted.
Expected<PlanCheck> checkPlan(const std::string &path, const BuildArguments &means, const Progress &progress);

} // namespace voxc::tool
