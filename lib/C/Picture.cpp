// Pictures in C.
#include "C/Handles.h"
#include "voxc/IR/Query.h"
#include "voxc/Render/View.h"

#include <voxc-c/voxc.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace voxc;
using namespace voxc::c;

namespace {

constexpr std::int32_t kMostPixels = 32768; ///< On an axis.

/// The value of this name among an enumeration's, or an error that names `what` it is.
template <Named Enum> Expected<Enum> valueOf(const char *text, Enum fallback, const std::string &what) {
  if (!text)
    return fallback;
  if (const std::optional<Enum> value = fromString<Enum>(text))
    return *value;
  std::string names;
  for (const std::string_view name : kEnumNames<Enum>)
    names += (names.empty() ? "" : ", ") + std::string(name);
  return Error::usage("'" + std::string(text) + "' is no " + what + "; there are " + names);
}

bool isFinite(const double *numbers, std::size_t count) {
  return std::all_of(numbers, numbers + count, [](double number) { return std::isfinite(number); });
}

Expected<Clip> clipOf(const voxc_picture_options &options) {
  Clip clip;
  if (options.clip_box) {
    const double *const box = options.clip_box;
    if (!isFinite(box, 6) || !(box[0] < box[3] && box[1] < box[4] && box[2] < box[5]))
      return Error::usage(
          "a box of a picture holds nothing: its first corner should be below the second on each axis");
    clip.keepBox({box[0], box[1], box[2]}, {box[3], box[4], box[5]});
  }
  if (options.clip_plane_count > 0 && !options.clip_planes)
    return Error::usage("a number of planes is given without the planes");
  for (std::size_t i = 0; i < options.clip_plane_count; ++i) {
    const double *const plane = options.clip_planes + 4 * i;
    const glm::dvec3 normal(plane[0], plane[1], plane[2]);
    if (!isFinite(plane, 4) || normal == glm::dvec3(0))
      return Error::usage("a plane of a picture should be a direction, which is not 0, 0, 0, and a number");
    clip.planes.push_back({normal, plane[3]});
  }
  return clip;
}

Error notOfPictures() {
  return Error::usage(
      "a picture is made of the voxel, t and colour of the closest hits: of a tracer with the "
      "default query and outputs");
}

/// Whether the size, the place and the lens of a picture can be. Error: `Usage`.
Expected<void> checkCamera(const voxc_picture_options &options, int width, int height) {
  if (width < 1 || height < 1 || width > kMostPixels || height > kMostPixels)
    return Error::usage("a picture has 1 to 32768 pixels on each axis");
  if (!options.eye != !options.look)
    return Error::usage(options.eye
                            ? "an eye is given without the point that it looks at; give both, or neither"
                            : "a point to look at is given without an eye; give both, or neither");
  if (options.eye && (!isFinite(options.eye, 3) || !isFinite(options.look, 3)))
    return Error::usage("an eye and the point that it looks at are finite numbers");
  if (options.eye && std::equal(options.eye, options.eye + 3, options.look))
    return Error::usage("a camera looks nowhere: its eye and the point that it looks at should differ");
  if (!(options.vertical_fov >= 0 && options.vertical_fov < 180))
    return Error::usage("a field of view lies between 0 and 180 degrees");
  if (options.view_height != 0 && !(options.view_height >= 1e-3 && options.view_height <= 1e9))
    return Error::usage("the height of an orthographic picture lies between 0.001 and 1e9 voxels");
  if (options.view_height != 0 && options.vertical_fov != 0)
    return Error::usage(
        "a height is of orthographic pictures, and a field of view of others; give one of the two");
  return {};
}

Expected<Camera> cameraOf(const voxc_picture_options &options, const Volume &volume, TraceRays trace) {
  const std::int32_t width = options.width == 0 ? 1280 : options.width;
  const std::int32_t height = options.height == 0 ? 720 : options.height;
  VOXC_TRY(checkCamera(options, width, height));
  const bool isOrthographic = options.orthographic || options.view_height > 0;
  Camera camera;
  camera.width = width;
  camera.height = height;
  camera.spacing = spacingOf(volume.info().voxelToModel);
  if (options.eye) {
    camera.eye = {options.eye[0], options.eye[1], options.eye[2]};
    camera.look = {options.look[0], options.look[1], options.look[2]};
    if (options.vertical_fov > 0)
      camera.verticalFov = options.vertical_fov;
    camera = projected(camera, isOrthographic);
  } else {
    const auto view = VOXC_TRY(valueOf(options.view, View::Auto, "view"));
    camera.verticalFov = options.vertical_fov;
    camera.orthographicHeight = isOrthographic ? 1 : 0;
    const auto found = VOXC_TRY(findView(view, volume, trace, camera));
    camera = found.camera;
  }
  if (options.view_height > 0)
    camera.orthographicHeight = options.view_height;
  return camera;
}

/// Marks a tracer whose picture is being made.
class Busy {
public:
  explicit Busy(voxc_tracer &tracer) : tracer_(tracer) { tracer.renders = true; }
  ~Busy() { tracer_.renders = false; }
  Busy(const Busy &) = delete;
  Busy &operator=(const Busy &) = delete;

private:
  voxc_tracer &tracer_;
};

} // namespace

voxc_error *voxc_render(voxc_tracer *tracer, const voxc_picture_options *options, uint32_t *pixels) {
  return guarded([&]() -> Expected<void> {
    VOXC_TRY(checkIdle(*tracer));
    const auto given = VOXC_TRY(optionsOf(options));
    const Question question = questionOf(tracer->format);
    if (!isOfHits(question.query) || !question.outputs.voxel || !question.outputs.t ||
        !question.outputs.colour)
      return notOfPictures();
    const auto clip = VOXC_TRY(clipOf(given));
    // What the kernel of a file takes, its tracer knows.
    if (!clip.cutsNothing() && !tracer->format.levels.empty() && !question.bounds)
      return Error::usage("a picture with cuts is made by a tracer with bounds; this one is without");
    const auto trace = [&](std::span<const Ray> rays, std::span<Hit> hits,
                           const TraceOptions &how) -> Expected<void> {
      const std::vector<BoundedRay> kept =
          clip.cutsNothing() ? std::vector<BoundedRay>() : clip.bounded(rays, tracer->threads);
      const Expected<TraceReport> report =
          tracer->tracer->trace(clip.cutsNothing() ? RaySpan(rays) : RaySpan(kept), hits, how);
      if (!report)
        return report.error();
      // A kernel of a file does not say what it answers, but a voxel's word is never 0.
      const bool hasColours =
          std::ranges::none_of(hits, [](const Hit &hit) { return hit.isHit() && hit.rgba == 0; });
      return hasColours ? Expected<void>() : notOfPictures();
    };
    const auto camera = VOXC_TRY(cameraOf(given, *tracer->volume, trace));
    const auto style = VOXC_TRY(valueOf(given.style, Style::Lit, "style"));
    const CallersProgress progress(given.progress);
    RenderOptions how{.style = style, .samples = given.samples};
    how.isSmooth = isSmoothSurface(tracer->volume->info());
    how.clip = clip.cutsNothing() ? nullptr : &clip;
    how.threads = tracer->threads;
    how.progress = progress.get();
    const Busy busy(*tracer);
    const auto taken = VOXC_TRY(render(*tracer->volume, camera, {trace, trace}, how));
    std::ranges::copy(taken.picture.pixels, pixels);
    return {};
  });
}
