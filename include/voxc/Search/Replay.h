// What rays cost in a format, counted on the graph of a scene, without building the format: how often a
// kernel looks up, how many words it reads, how long the rays of a packet keep each other waiting.
#pragma once

#include "voxc/Plan/Plan.h"
#include "voxc/Search/SceneDag.h"
#include "voxc/Trace/Ray.h"

#include <memory>
#include <span>
#include <vector>

namespace voxc {

/// Of one ray, on average.
struct RayCost {
  double lookups = 0; ///< As kernels count them (`TraceOptions::countSteps`).
  double turns = 0;   ///< Steps over what is empty, and one for the voxel that is hit.
  double words = 0;   ///< Words of nodes that are read; those of a hit's colour are not among them.
  double layers = 0;  ///< Layers of trees that are gone down.
  double marches = 0; ///< Steps from cell to cell within an L1 distance.
  double waits = 0;   ///< Turns of the ray of a packet that has the most.
};

class Replay {
public:
  static constexpr std::size_t kPacketRays = 16;

  /// `dag` must outlive the replay. `rays` are packets, `kPacketRays` neighbours each; what is left over is
  /// left out.
  Replay(const SceneDag &dag, std::vector<Ray> rays);
  ~Replay();

  /// What the rays cost in kernels of a plan that has been through all passes. Positions are of float64, so a
  /// ray that float64 cannot tell from its neighbour may cost a step more or less than the kernel's.
  /// Precondition: the scene lies in the plan's layout (`Pricer::price` tells).
  RayCost run(const Plan &plan);

private:
  class Scene;

  std::vector<Ray> rays_;
  std::unique_ptr<Scene> scene_;
};

} // namespace voxc
