// Pictures for the driver.
#include "pictures/RenderSession.h"

#include "common/NumberedName.h"
#include "common/PictureFile.h"
#include "common/Statistics.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "voxc/IR/Query.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace voxc::tool {
namespace {

/// Times that follow each other: what one does not have the next has, even if this thread has to wait
/// between.
class Laps {
public:
  /// Seconds since it was made, or since the last lap.
  double next() {
    const double now = watch_.seconds();
    return now - std::exchange(last_, now);
  }

private:
  Stopwatch watch_;
  double last_ = 0;
};

void addSize(Json &figures, const Camera &camera) {
  figures["width"] = camera.width;
  figures["height"] = camera.height;
}

/// Of a frame: its camera, as camera files have it, its time, and what paging did for it.
Json frameFigures(const FileCamera &camera, double seconds, const std::optional<PagingReport> &before,
                  const std::optional<PagingReport> &after) {
  Json frame = {{"position", {camera.position.x, camera.position.y, camera.position.z}},
                {"pitch", camera.pitch},
                {"yaw", camera.yaw},
                {"fov", camera.fov},
                {"seconds", seconds}};
  if (camera.height != 0)
    frame["height"] = camera.height;
  if (before && after) {
    frame["pages_read"] = after->reads - before->reads;
    frame["page_hits"] = after->found - before->found;
    frame["rounds"] = after->rounds - before->rounds;
  }
  return frame;
}

/// What stands behind the last colon of a source that is no path alone: files may have colons in their names.
std::string nameIn(const std::string &source) {
  constexpr std::string_view kKinds[] = {"builtin:", "grid:", "raw:"};
  const bool isPath =
      std::ranges::none_of(kKinds, [&](std::string_view kind) { return source.starts_with(kind); });
  return isPath ? source : source.substr(source.rfind(':') + 1);
}

} // namespace

void RenderSession::declare(const CommandLine &command) {
  command
      .add("-o,--output", output_,
           "Picture to write, as " + pictureEndings() +
               "; the default is named after the input and the style")
      .takes("PICTURE")
      .notEmpty();
  addPictureOptions(command, picture_);
  addClipOptions(command, clip_);
  flight_.declare(command);
  command
      .add("--lod", picture_.lod,
           "Stop at nodes and cells that look smaller than so many pixels, with a colour from inside; 0: at "
           "voxels alone")
      .takes("PIXELS")
      .between(0.0, 1e6);
  check_.declare(command);
}

Expected<void> RenderSession::check(const std::string &source, const CommonOptions &common) {
  if (output_.empty()) {
    const std::string stem = stemOfNumbered(nameIn(source));
    output_ = (stem.empty() ? "picture" : stem) + "-" + std::string(toString(styleOf(picture_))) +
              (flight_.isGiven() ? "-###.png" : ".png");
  }
  if (flight_.isGiven())
    VOXC_TRY(flight_.check(output_));
  VOXC_TRY(checkOutput(output_, common));
  VOXC_TRY(checkPictureName(output_));
  if (clip_.isGiven() && (picture_.lod > 0 || picture_.coarse > 0))
    return Error::usage("--clip-box and --clip-plane show voxels alone; leave out --lod and --allow-coarse");
  if (const Expected<Clip> clip = clipOf(clip_); !clip)
    return clip.error();
  return checkPictureOptions(picture_);
}

Expected<void> RenderSession::applyTo(Format &format) const {
  const Outputs outputs = questionOf(format).outputs;
  if (styleOf(picture_) != Style::Heatmap && !(outputs.voxel && outputs.t && outputs.colour))
    return Error::usage("a picture is made of the voxel, t and colour of hits; leave out --query and "
                        "--outputs, or ask for --style heatmap");
  if (picture_.lod > 0)
    askForCones(format);
  if (clip_.isGiven())
    askForBounds(format);
  return {};
}

Expected<void> RenderSession::render(const Volume &volume, SurfaceNormals &normals, TraceSession &tracing,
                                     const CommonOptions &common, ProgressBar &bar, Json &figures) const {
  const Stopwatch watch;
  auto clip = VOXC_TRY(clipOf(clip_, volume.info().voxelToModel));
  PictureRays rays(tracing, check_.rays(), std::move(clip));
  RenderOptions options = renderOptions(picture_, volume);
  options.normals = &normals;
  options.progress = bar.progress();
  const auto warning = VOXC_TRY(flight_.isGiven() ? takeFlight(volume, options, rays, figures)
                                                  : takeOne(volume, options, rays, figures));
  figures["style"] = toString(styleOf(picture_));
  rays.addFigures(figures);
  const Stopwatch checking;
  // No picture needs faces, and a heatmap has counts in their place.
  if (Expected<void> checked =
          check_.run(volume, rays.eye().sampledRays(), rays.eye().sampledHits(), {}, bar.progress(), figures);
      !checked)
    return checked;
  if (check_.rays() > 0)
    figures["check_seconds"] = checking.seconds();
  figures["render_seconds"] = watch.seconds();
  bar.clear();
  if (warning && !common.quiet)
    printNote("warning: " + *warning);
  return {};
}

Expected<RenderSession::Warning> RenderSession::takeOne(const Volume &volume, const RenderOptions &options,
                                                        PictureRays &rays, Json &figures) const {
  Laps laps;
  const auto placed = VOXC_TRY(rays.findCamera(picture_, volume));
  VOXC_TRY(checkLens(picture_, placed.camera));
  figures["camera_seconds"] = laps.next();
  const auto taken = VOXC_TRY(rays.take(volume, placed, options));
  figures["picture_seconds"] = laps.next();
  addSize(figures, placed.camera);
  addCameraFigures(figures, picture_, placed, volume);
  figures["exposure"] = taken.rendering.exposure;
  figures["nearest_voxels"] = taken.rendering.nearest;
  figures["median_voxels"] = taken.rendering.middle;
  VOXC_TRY(writeTaken(output_, taken));
  figures["file_seconds"] = laps.next();
  addWritten(figures, output_);
  return cameraWarning(taken, volume, clip_.isGiven());
}

// One tracer takes all frames, so pages that one frame has brought are there for the next; and so are
// normals.
Expected<RenderSession::Warning> RenderSession::takeFlight(const Volume &volume, const RenderOptions &options,
                                                           PictureRays &rays, Json &figures) const {
  RenderOptions ofFrame = options;
  ofFrame.progress = {.stop = options.progress.stop};
  Warning warning;
  double taking = 0, writing = 0;
  for (unsigned frame = 0; frame < flight_.frames(); ++frame) {
    const Stopwatch watch;
    FileCamera place = flight_.camera(frame);
    const auto camera =
        VOXC_TRY(makeCamera(picture_.camera, place, volume.info().extent, volume.info().voxelToModel));
    VOXC_TRY(checkLens(picture_, camera));
    place.fov = camera.verticalFov; // As --fov says, if it does.
    const auto before = rays.paging();
    const auto taken = VOXC_TRY(rays.take(volume, PlacedCamera{camera}, ofFrame));
    const double took = watch.seconds();
    const std::string name = flight_.pictureName(frame);
    VOXC_TRY(writeTaken(name, taken));
    addWritten(figures, name);
    addSize(figures, camera);
    taking += took;
    writing += watch.seconds() - took;
    figures["frames"].push_back(frameFigures(place, watch.seconds(), before, rays.paging()));
    if (const auto odd = cameraWarning(taken, volume, clip_.isGiven()); odd && !warning)
      warning = "in frame " + std::to_string(frame) + " " + *odd;
    options.progress.at("render", double(frame + 1) / flight_.frames(), frame + 1);
  }
  figures["picture_seconds"] = taking;
  figures["file_seconds"] = writing;
  figures["files_written"] = flight_.frames();
  return warning;
}

} // namespace voxc::tool
