// What rays cost in a format, counted on the graph of a scene, without building the format: how often a
// kernel looks up, how many words it reads, how long the rays of a packet keep each other waiting.
#pragma once

#include "voxc/Plan/Plan.h"
#include "voxc/Search/SceneDag.h"
#include "voxc/Trace/Ray.h"

#include <cstddef>
#include <span>

namespace voxc {

/// Of one ray, on average. "As a packet goes": what the rays of a packet do in the same turn of the same
/// loops, they do at once.
struct RayCost {
  double lookups = 0;        ///< As kernels count them (`TraceOptions::countSteps`).
  double turns = 0;          ///< Steps over what is empty, and one for the voxel that is hit.
  double words = 0;          ///< Words of nodes that are read; those of a hit's colour are not among them.
  double layers = 0;         ///< Layers of trees that are gone down.
  double packetLayers = 0;   ///< The same as a packet goes: as many as the ray with the most.
  double packetTrees = 0;    ///< Look-ups in trees, as a packet goes.
  double probes = 0;         ///< Look-ups in hash grids.
  double marches = 0;        ///< Steps from cell to cell within an L1 distance.
  double waits = 0;          ///< Turns of the ray of a packet that has the most.
  double switches = 0;       ///< Look-ups beyond those of turns: changes of level, where levels are traversed
                             ///< one by one,
  double packetSwitches = 0; ///< and the same as a packet goes.
  double lines = 0;          ///< Different cache lines that a packet reads, its share of them.
  double colours = 0;        ///< Hits whose colour is looked up apart from the voxel.
  double levels = 0;         ///< Levels of the format.
  double binned =
      0; ///< 1 if a tracer sorts the rays first (`RaySet::isBinned`), else 0; `modelRayCost` leaves it.
};

/// Rays of a packet: neighbours, which wait for each other; as many as a vector of 256 bits holds.
inline constexpr std::size_t kSimulatedPacket = 8;

/// What rays cost in kernels of a plan that has been through all passes; packet after packet, and what is
/// left over is left out. Positions are of float64, so a ray that float64 cannot distinguish from its
/// neighbour may cost a step more or less than the kernel's. Precondition: the scene lies in the plan's
/// layout
/// (`SizeModel::price` checks).
RayCost modelRayCost(const SceneDag &dag, std::span<const Ray> rays, const Plan &plan);

} // namespace voxc
