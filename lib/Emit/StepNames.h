// The names of how a kernel goes from one cell to the next.
#pragma once

#include "Template.h"

#include "voxc/Plan/Plan.h"

namespace voxc {

/// Adds them to those of a plan.
void addStepNames(TemplateNames &names, const Plan &plan);

} // namespace voxc
