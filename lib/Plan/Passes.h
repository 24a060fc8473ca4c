// The passes over plans, each in the file of its name.
#pragma once

#include "voxc/Plan/Plan.h"

namespace voxc {

/// The descent that a stratum has where nothing else is asked for.
Descent defaultDescent(const Stratum &stratum);

void chooseDescents(Plan &plan);
void chooseTraversal(Plan &plan);
void chooseSteps(Plan &plan);
void chooseComparison(Plan &plan);
void chooseSpeculation(Plan &plan);
void chooseSpanFaces(Plan &plan);
void choosePacketWidth(Plan &plan);
void placeStack(Plan &plan);
void placeStops(Plan &plan);
void deferValues(Plan &plan);
void dropValues(Plan &plan);
void guardLookUps(Plan &plan);
void chooseVoxelSteps(Plan &plan);
void chooseBricks(Plan &plan);
void chooseLookAhead(Plan &plan);

} // namespace voxc
