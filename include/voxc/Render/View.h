// Cameras by a word: where a picture of a volume is best taken from.
#pragma once

#include "voxc/Render/Render.h"

#include <span>
#include <string_view>

namespace voxc {

enum class View {
  Auto,   ///< Inside, if it is a building or a yard that one sees little of from outside; else iso.
  Iso,    ///< From above a corner, the longer side in front; fills the frame.
  Front,  ///< From +z.
  Top,    ///< From above.
  Inside, ///< From where most is to be seen within, at a level gaze.
};

template <>
inline constexpr std::array<std::string_view, 5> kEnumNames<View> = {"auto", "iso", "front", "top", "inside"};

/// The camera of a view, for a picture of this size; `verticalFov` 0: the view's own. From outside, the
/// voxels that are seen fill the frame: `trace` finds them by few rays. Errors: those of tracing; `Input`, a
/// volume without voxels.
Expected<Camera> viewCamera(View view, const Volume &volume, TraceRays trace, int width, int height,
                            double verticalFov = 0);

/// The camera that looks in the same direction with the same angle from where all `points` are just within
/// the frame, but for a margin: they touch it on the left and on the right, or above and below. Less than a
/// hundredth of them that stand off all others by a wide gap may fall outside.
Camera frame(Camera camera, std::span<const glm::dvec3> points);

} // namespace voxc
