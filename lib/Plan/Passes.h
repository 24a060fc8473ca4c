// The passes over plans, each in the file of its name.
#pragma once

#include "voxc/Plan/Plan.h"

namespace voxc {

void chooseDescents(Plan &plan);
void chooseWalk(Plan &plan);
void chooseSteps(Plan &plan);
void placeStack(Plan &plan);
void placeStops(Plan &plan);

} // namespace voxc
