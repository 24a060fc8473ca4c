// The names of what a kernel is asked: which parts of a hit, and between which bounds of a ray.
#pragma once

#include "Template.h"

#include "voxc/Plan/Plan.h"

namespace voxc {

/// Adds them to those of a plan.
void addQuestionNames(TemplateNames &names, const Plan &plan);

} // namespace voxc
