// Pictures in C.
#include "C/Handles.h"
#include "voxc/IR/Query.h"
#include "voxc/Render/View.h"

#include <voxc-c/voxc.h>

using namespace voxc;
using namespace voxc::c;

namespace {

constexpr std::int32_t kMostPixels = 32768; ///< On an axis.

/// The value of this name among an enumeration's, or an error that names `what` it is.
template <Named Enum> Expected<Enum> valueOf(const char *text, Enum usual, const std::string &what) {
  if (!text)
    return usual;
  if (const std::optional<Enum> value = fromString<Enum>(text))
    return *value;
  std::string names;
  for (const std::string_view name : kEnumNames<Enum>)
    names += (names.empty() ? "" : ", ") + std::string(name);
  return Error::usage("'" + std::string(text) + "' is no " + what + "; there are " + names);
}

Expected<Camera> cameraOf(const voxc_picture_options &options, const Volume &volume, TraceRays trace) {
  const std::int32_t width = options.width == 0 ? 1280 : options.width;
  const std::int32_t height = options.height == 0 ? 720 : options.height;
  if (width < 1 || height < 1 || width > kMostPixels || height > kMostPixels)
    return Error::usage("a picture has 1 to 32768 pixels on each axis");
  if (!options.eye != !options.look)
    return Error::usage(options.eye
                            ? "an eye is given without the point that it looks at; give both, or neither"
                            : "a point to look at is given without an eye; give both, or neither");
  if (!(options.vertical_fov >= 0 && options.vertical_fov < 180))
    return Error::usage("a field of view lies between 0 and 180 degrees");
  if (!options.eye) {
    const Expected<View> view = valueOf(options.view, View::Auto, "view");
    return view ? viewCamera(*view, volume, trace, width, height, options.vertical_fov)
                : Expected<Camera>(view.error());
  }
  Camera camera;
  camera.eye = {options.eye[0], options.eye[1], options.eye[2]};
  camera.look = {options.look[0], options.look[1], options.look[2]};
  if (options.vertical_fov > 0)
    camera.verticalFov = options.vertical_fov;
  camera.width = width;
  camera.height = height;
  camera.spacing = spacingOf(volume.info().voxelToModel);
  return camera;
}

} // namespace

voxc_error *voxc_render(voxc_tracer *tracer, const voxc_picture_options *options, uint32_t *pixels) {
  return guarded([&]() -> voxc_error * {
    const voxc_picture_options given = optionsOf(options);
    const Question question = questionOf(tracer->format);
    if (question.query != Query::Closest || !question.outputs.voxel || !question.outputs.t ||
        !question.outputs.colour)
      return wrap(Error::usage(
          "a picture is made of the voxel, t and colour of the closest hits: of a tracer with the "
          "usual query and outputs"));
    const auto trace = [tracer](std::span<const Ray> rays, std::span<Hit> hits,
                                const TraceOptions &how) -> Expected<void> {
      const Expected<TraceReport> report = tracer->tracer->trace(rays, hits, how);
      return report ? Expected<void>() : report.error();
    };
    const Expected<Camera> camera = cameraOf(given, *tracer->volume, trace);
    if (!camera)
      return wrap(camera.error());
    const Expected<Style> style = valueOf(given.style, Style::Lit, "style");
    if (!style)
      return wrap(style.error());
    const CallersProgress progress(given.progress);
    RenderOptions how{.style = *style, .samples = given.samples};
    how.isSmooth = isSmoothSurface(tracer->volume->info());
    how.threads = tracer->threads;
    how.progress = progress.get();
    const Expected<Rendering> taken = render(*tracer->volume, *camera, {trace, trace}, how);
    if (!taken)
      return wrap(taken.error());
    std::ranges::copy(taken->picture.pixels, pixels);
    return nullptr;
  });
}
