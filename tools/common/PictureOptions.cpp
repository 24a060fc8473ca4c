// The options of a picture.
#include "PictureOptions.h"

#include "PictureFile.h"

#include "voxc/Render/View.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace voxc::tool {
namespace {

template <typename Enum> std::vector<std::string> namesOf() {
  return {kEnumNames<Enum>.begin(), kEnumNames<Enum>.end()};
}

std::string styleHelp() {
  std::string text = "What the picture shows:";
  for (const StyleKind &kind : styleKinds())
    text += (&kind == styleKinds().data() ? " " : "; ") + std::string(toString(kind.style)) +
            (kind.style == Style::Lit ? " (default), " : ", ") + std::string(kind.summary);
  return text;
}

bool isSmooth(const PictureOptions &options, const VolumeInfo &info) {
  return options.normals == "auto" ? isSmoothSurface(info) : options.normals == "smooth";
}

std::string pointText(const glm::dvec3 &point) {
  char text[96];
  std::snprintf(text, sizeof text, "%.6g,%.6g,%.6g", point.x, point.y, point.z);
  return text;
}

} // namespace

void addViewOptions(const CommandLine &command, PictureOptions &options) {
  command
      .add("--sun", options.sun,
           "Where the sun of style lit stands, in degrees: azimuth, from +z (0) to +x (90), and elevation; "
           "default: -40,49")
      .takes("AZ,EL")
      .list()
      .values(2);
  command
      .add("--view", options.view,
           "A camera by a word: iso, from above a corner; front, back, left, right, top, bottom; inside, "
           "from where most of the inside is seen; auto (default): inside of what is surely a room or a "
           "yard, else iso")
      .takes("WORD")
      .oneOf(namesOf<View>());
}

void addPictureOptions(const CommandLine &command, PictureOptions &options) {
  const OptionGroup group(command, "Picture");
  command.add("--style", options.style, styleHelp()).takes("STYLE").oneOf(namesOf<Style>());
  command.addFormer("--heatmap", "--style heatmap");
  command
      .add("--samples", options.samples,
           "Rays through each pixel; the default is 4 for lit and ao, which suits a look, and 1 for others; "
           "64 leaves no noise")
      .takes("N")
      .between(1u, 65536u);
  command
      .add("--normals", options.normals,
           "Directions of surfaces: smooth, from the voxels around, flat, those of faces, or auto (default): "
           "flat for .vox files and built-in scenes")
      .takes("KIND")
      .oneOf({"auto", "smooth", "flat"});
  addViewOptions(command, options);
  addCameraOptions(command, options.camera);
}

Expected<void> checkPictureOptions(const PictureOptions &options) {
  if (!options.view.empty() && !options.camera.camera.empty())
    return Error::usage(
        "--view and --camera both say where the picture is taken from; leave one of them out");
  const StyleKind &kind = kindOf(styleOf(options));
  if (!options.sun.empty() && kind.style != Style::Lit)
    return Error::usage("--sun is for the style lit; the style " + std::string(toString(kind.style)) +
                        " has no sun");
  if (options.normals != "auto" && !kind.needsNormals)
    return Error::usage("--normals is for the styles lit, ao and normals; the style " +
                        std::string(toString(kind.style)) + " has no use for them");
  if (!std::ranges::all_of(options.sun, [](double angle) { return std::isfinite(angle); }))
    return Error::usage("the angles of --sun should be finite numbers");
  if (isOrthographic(options.camera))
    VOXC_TRY(checkLens(options, {.orthographicHeight = 1}));
  Expected<Camera> camera = makeCamera(options.camera, {1, 1, 1});
  return camera ? Expected<void>() : camera.error();
}

Expected<void> checkLens(const PictureOptions &options, const Camera &camera) {
  if (!camera.isOrthographic() || (options.lod == 0 && options.coarse == 0))
    return {};
  return Error::usage("--lod and --allow-coarse go by what looks small from afar, and by parallel rays "
                      "nothing does; leave out --orthographic and --view-height, or take a camera of the "
                      "file that has no height");
}

glm::dvec3 sunOf(const PictureOptions &options) {
  if (options.sun.size() != 2)
    return RenderOptions{}.sun;
  const double azimuth = glm::radians(options.sun[0]);
  const double elevation = glm::radians(options.sun[1]);
  return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
          std::cos(azimuth) * std::cos(elevation)};
}

Style styleOf(const PictureOptions &options) { return fromString<Style>(options.style).value_or(Style::Lit); }

Expected<PlacedCamera> placeCamera(const PictureOptions &options, const Volume &volume, TraceRays trace) {
  auto camera = VOXC_TRY(makeCamera(options.camera, volume.info().extent, volume.info().voxelToModel));
  if (!options.camera.camera.empty())
    return PlacedCamera{camera, "", false};
  const View view = fromString<View>(options.view).value_or(View::Auto);
  camera.verticalFov = options.camera.fov;
  auto found = VOXC_TRY(findView(view, volume, trace, camera));
  if (options.camera.viewHeight != 0)
    found.camera.orthographicHeight = options.camera.viewHeight;
  return PlacedCamera{found.camera, std::string(toString(found.view)), view == View::Auto};
}

RenderOptions renderOptions(const PictureOptions &options, const Volume &volume) {
  RenderOptions result;
  result.style = styleOf(options);
  result.samples = options.samples;
  result.isSmooth = isSmooth(options, volume.info());
  result.lod = options.lod;
  result.coarse = options.coarse;
  result.sun = sunOf(options);
  return result;
}

Expected<TakenPicture> takePicture(const PictureOptions &options, const Volume &volume,
                                   const RenderTracers &tracers, TraceRays probe, unsigned threads,
                                   const Progress &progress) {
  const auto placed = VOXC_TRY(placeCamera(options, volume, probe));
  RenderOptions render = renderOptions(options, volume);
  render.threads = threads;
  render.progress = progress;
  auto rendering = VOXC_TRY(voxc::render(volume, placed.camera, tracers, render));
  return TakenPicture{std::move(rendering), placed};
}

bool looksAround(const PictureOptions &options, const VolumeInfo &info) {
  return kindOf(styleOf(options)).needsNormals && isSmooth(options, info);
}

Expected<void> writeTaken(const std::string &path, const TakenPicture &taken) {
  return writePicture(path, taken.rendering.picture, taken.rendering.light);
}

void addCameraFigures(Json &figures, const PictureOptions &options, const PlacedCamera &placed,
                      const Volume &volume) {
  figures["camera"] = cameraText(options, placed.camera, volume);
  if (placed.view.empty())
    return;
  figures["view"] = placed.view;
  if (placed.isAuto)
    figures["view_is_auto"] = true;
}

std::string cameraText(const PictureOptions &options, const Camera &camera, const Volume &volume) {
  const bool inModel = isInModelUnits(options.camera);
  const Transform &toModel = volume.info().voxelToModel;
  const auto point = [&](const glm::dvec3 &p) { return pointText(inModel ? toModel * glm::dvec4(p, 1) : p); };
  std::string text =
      std::string("--camera ") + (inModel ? kModelUnits : "") + point(camera.eye) + ":" + point(camera.look);
  if (camera.up != glm::dvec3(0, 1, 0))
    text += ":" + pointText(inModel ? toModel * glm::dvec4(camera.up, 0) : camera.up);
  char lens[48];
  if (camera.isOrthographic())
    std::snprintf(lens, sizeof lens, " --view-height %.6g", camera.orthographicHeight);
  else
    std::snprintf(lens, sizeof lens, " --fov %g", camera.verticalFov);
  return text + lens + (options.camera.cubicVoxels ? " --cubic-voxels" : "");
}

std::optional<std::string> cameraWarning(const TakenPicture &taken, const Volume &volume, bool isClipped) {
  const glm::dvec3 &eye = taken.placed.camera.eye;
  const Int3 extent = volume.info().extent;
  const bool isWithin =
      eye.x >= 0 && eye.y >= 0 && eye.z >= 0 && eye.x < extent.x && eye.y < extent.y && eye.z < extent.z;
  if (!isClipped && isWithin && volume.lookup({int(eye.x), int(eye.y), int(eye.z)}).value != 0)
    return "the camera stands in a voxel that is not empty, and sees nothing but that";
  const Rendering &rendering = taken.rendering;
  if (rendering.hits == 0)
    return "the camera sees no voxel";
  constexpr double kNear = 3;
  if (rendering.middle > 0 && rendering.middle < kNear) {
    char text[160];
    std::snprintf(
        text, sizeof text,
        "the camera stands right before a wall: half of what it sees is no further off than %.2g voxels",
        rendering.middle);
    return text;
  }
  return std::nullopt;
}

} // namespace voxc::tool
