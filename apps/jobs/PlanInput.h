// Opening the input of a build plan, as far as some of its outputs need it.
#pragma once

#include "cluster/BuildPlan.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Input/Input.h"

#include <span>

namespace voxc::tool {

/// Opens the input for who asks for the cubes of these items alone, with the memory, threads and progress of
/// `options`. Errors (`Input`): a file is not what it was when the plan was made; those of opening.
Expected<Input> openPlanned(const cluster::BuildPlan &plan, std::span<const cluster::WorkItem> items,
                            const BuildOptions &options);

} // namespace voxc::tool
