// A picture of a scene, in one step of its refinement.
#pragma once

#include "view/Refinement.h"
#include "view/Scene.h"

#include "voxc/Render/Render.h"
#include "voxc/Trace/Clip.h"

namespace voxc::view {

/// What is to be seen, but for the camera.
struct Look {
  Style style = Style::Lit;
  bool isSmooth = false; ///< This and the others as in `RenderOptions`.
  glm::dvec3 sun{-0.42, 0.76, 0.5};
  double coarse = 0;
  Clip clip; ///< What of the volume is looked at; the scene's kernel has bounds if that cuts anything.

  bool operator==(const Look &) const = default;
};

/// What to paint.
struct Shot {
  std::shared_ptr<const Scene> scene;
  Camera camera;
  Look look;
};

/// Traces rays through what is to be seen of a scene. Errors: those of tracing.
Expected<TraceReport> traceClipped(const Scene &scene, const Clip &clip, std::span<const Ray> rays,
                                   std::span<Hit> hits, const TraceOptions &options = {});

/// Renders a shot by the step and enlarges it to the size of its camera; the legend of maps is drawn after
/// that, so that it can be read in any step. Errors: those of tracing; interrupted, by `progress`.
Expected<Picture> paint(const Shot &shot, const RefinementStep &step, const Progress &progress);

} // namespace voxc::view
