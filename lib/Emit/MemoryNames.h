// Names of how a kernel reaches words: their addresses, and pages that may not be there.
#pragma once

#include "Template.h"

#include "voxc/Plan/Plan.h"

namespace voxc {

/// Adds them to those of a plan.
void addMemoryNames(TemplateNames &names, const Plan &plan);

/// Adds those of where slots of a stratum lead to, and of how its cells are numbered.
void addReferenceNames(TemplateNames &names, const Layout &layout, const Stratum &stratum);

} // namespace voxc
