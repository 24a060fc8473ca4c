// choose-packet-width: how many rays of this processor go side by side.
#include "Passes.h"

namespace voxc {

/// Where each level has a loop, lanes in one wait for those in another: fewer lanes, less waiting.
void choosePacketWidth(Plan &plan) {
  if (plan.packing == Packing::Packets && kindOf(plan.levelTraversal).nests && plan.layout.strata.size() > 1)
    plan.packetWidth = PacketWidth::Narrow;
}

} // namespace voxc
