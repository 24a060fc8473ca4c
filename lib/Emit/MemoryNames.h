// Names of how a kernel reaches words: their addresses, and pages that may not be there.
#pragma once

#include "Template.h"

#include "voxc/Plan/Plan.h"

namespace voxc {

/// Adds them to those of a plan.
void addMemoryNames(TemplateNames &names, const Plan &plan);

} // namespace voxc
