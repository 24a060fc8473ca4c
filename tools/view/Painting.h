// A picture of a scene, in one step of its refinement.
#pragma once

#include "view/Refinement.h"
#include "view/Scene.h"

#include "voxc/Render/Render.h"

namespace voxc::view {

/// What is to be seen, but for the camera.
struct Look {
  Style style = Style::Lit;
  bool isSmooth = false; ///< This and the others as in `RenderOptions`.
  glm::dvec3 sun{-0.42, 0.76, 0.5};
  double coarse = 0;

  bool operator==(const Look &) const = default;
};

/// What to paint.
struct Shot {
  std::shared_ptr<const Scene> scene;
  Camera camera;
  Look look;
};

/// Renders a shot by the step and enlarges it to the size of its camera; the legend of maps is drawn after
/// that, so that it can be read in any step. Errors: those of tracing; interrupted, by `progress`.
Expected<Picture> paint(const Shot &shot, const RefinementStep &step, const Progress &progress);

} // namespace voxc::view
