// Cameras by a word: where a picture of a volume is best taken from.
#pragma once

#include "voxc/Render/Render.h"

#include <span>
#include <string_view>

namespace voxc {

enum class View {
  Auto,   ///< Inside, if it is surely a room, a building or a yard; else iso.
  Iso,    ///< From above a corner, the longer side in front; fills the frame.
  Front,  ///< From +z.
  Back,   ///< From -z.
  Left,   ///< From -x.
  Right,  ///< From +x.
  Top,    ///< From above.
  Bottom, ///< From below.
  Inside, ///< From where most is to be seen within, at a level gaze.
};

template <>
inline constexpr std::array<std::string_view, 9> kEnumNames<View> = {
    "auto", "iso", "front", "back", "left", "right", "top", "bottom", "inside"};

/// A camera, and the view that it has: `Iso` or `Inside` where `Auto` was asked for.
struct FoundView {
  Camera camera;
  View view;
};

/// The camera of a view. `like` says the size of the picture, the spacing of the voxels, whether the camera
/// is orthographic (whatever height it has), and the field of view; `verticalFov` 0: the view's own. From
/// outside all voxels that are seen are within the frame, but for a margin: `trace` finds them by few rays.
/// From inside an orthographic camera sees nothing, so `Auto` is `Iso` then. Errors: those of tracing;
/// `Input`, a volume without voxels; `Usage`, `Inside` of an orthographic camera.
Expected<FoundView> findView(View view, const Volume &volume, TraceRays trace, const Camera &like);

/// The same for a picture of this size of voxels as the volume says that they are (`spacingOf`).
Expected<Camera> viewCamera(View view, const Volume &volume, TraceRays trace, int width, int height,
                            double verticalFov = 0);

/// The camera that looks in the same direction with the same angle from where all `points`, which are in
/// voxels, are just within the frame, but for a margin: they touch it on the left and on the right, or above
/// and below. Of an orthographic camera the height follows. Less than a hundredth of them that stand off all
/// others further than those are apart may fall outside. Of no points it is the same camera.
Camera frame(Camera camera, std::span<const glm::dvec3> points);

} // namespace voxc
