// The options that say where a picture is taken from.
#include "CameraOptions.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace voxc::tool {
namespace {

constexpr const char *kCameraForms = "[model:]EX,EY,EZ:LX,LY,LZ[:UX,UY,UZ] or FILE.json:NAME";

constexpr std::array<int, 2> kDefaultSize = {Camera{}.width, Camera{}.height};

/// Splits at each separator; n separators give n + 1 parts.
std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t at; (at = text.find(separator)) != std::string_view::npos; text.remove_prefix(at + 1))
    parts.push_back(text.substr(0, at));
  parts.push_back(text);
  return parts;
}

template <typename Number> std::optional<Number> parseNumber(std::string_view text) {
  Number value{};
  auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

std::optional<glm::dvec3> parsePoint(std::string_view text) {
  std::vector<std::string_view> parts = split(text, ',');
  if (parts.size() != 3)
    return std::nullopt;
  glm::dvec3 point;
  for (int axis = 0; axis < 3; ++axis) {
    auto value = parseNumber<double>(parts[static_cast<std::size_t>(axis)]);
    if (!value || !std::isfinite(*value))
      return std::nullopt;
    point[axis] = *value;
  }
  return point;
}

/// A camera in the units of the model, in voxels.
Camera toVoxels(const Camera &camera, const Transform &voxelToModel) {
  glm::dmat4 matrix(1.0);
  for (int column = 0; column < 4; ++column)
    matrix[column] = glm::dvec4(voxelToModel[column], column == 3 ? 1 : 0);
  const glm::dmat4 toVoxels = glm::inverse(matrix);
  Camera moved = camera;
  moved.eye = glm::dvec3(toVoxels * glm::dvec4(camera.eye, 1));
  moved.look = glm::dvec3(toVoxels * glm::dvec4(camera.look, 1));
  moved.up = glm::dvec3(toVoxels * glm::dvec4(camera.up, 0));
  return moved;
}

/// The camera of "eye:look" or "eye:look:up"; nothing if the text is not of this form.
std::optional<Camera> parsePoints(std::string_view text, const glm::dvec3 &defaultUp) {
  std::vector<std::string_view> parts = split(text, ':');
  if (parts.size() != 2 && parts.size() != 3)
    return std::nullopt;
  auto eye = parsePoint(parts[0]);
  auto look = parsePoint(parts[1]);
  auto up = parts.size() == 3 ? parsePoint(parts[2]) : defaultUp;
  if (!eye || !look || !up)
    return std::nullopt;
  return Camera{.eye = *eye, .look = *look, .up = *up};
}

/// Of a number, which may follow a blank and a plus; what is none CLI11 tells.
std::string problemOfFov(const std::string &text) {
  char *end = nullptr;
  const double degrees = std::strtod(text.c_str(), &end);
  return end == text.c_str() || (degrees > 0 && degrees < 180)
             ? ""
             : "should lie between 0 and 180 degrees, not at " + text;
}

/// What --size says, or nothing. Errors: `Usage`, that is malformed.
Expected<std::optional<std::array<int, 2>>> checkedSize(const CameraOptions &options) {
  if (options.size.empty())
    return std::optional<std::array<int, 2>>();
  const auto size = VOXC_TRY(parseSize(options.size));
  return std::optional(size);
}

Expected<Camera> cameraOfFile(const CameraOptions &options, Int3 extent, const Transform &voxelToModel) {
  const std::string &text = options.camera;
  // The file's own name may hold colons; a camera's may not.
  std::size_t colon = text.rfind(':');
  if (colon == std::string::npos)
    return Error::usage("--camera \"" + text + "\" is not understood: it should be " + kCameraForms);
  auto camera = VOXC_TRY(readCamera(text.substr(0, colon), text.substr(colon + 1)));
  return makeCamera(options, camera, extent, voxelToModel);
}

/// The field of view and the projection that the options say.
Camera withLens(const CameraOptions &options, Camera camera) {
  if (options.fov != 0)
    camera.verticalFov = options.fov;
  camera = projected(camera, isOrthographic(options));
  if (options.viewHeight != 0)
    camera.orthographicHeight = options.viewHeight;
  return camera;
}

Expected<Camera> placeCamera(const CameraOptions &options, Int3 extent, const Transform &voxelToModel,
                             std::array<int, 2> size) {
  if (options.camera.empty()) {
    Camera camera = frameExtent(extent, size[0], size[1]);
    camera.spacing = spacingOf(options, voxelToModel);
    return withLens(options, camera);
  }
  const bool inModel = isInModelUnits(options);
  const std::string_view points =
      std::string_view(options.camera).substr(inModel ? std::strlen(kModelUnits) : 0);
  // Voxels are turned so that +y is up; the model's way up is what becomes of it.
  const glm::dvec3 up = inModel ? glm::dvec3(voxelToModel[1]) : glm::dvec3(0, 1, 0);
  if (auto camera = parsePoints(points, up)) {
    if (inModel)
      camera = toVoxels(*camera, voxelToModel);
    if (camera->eye == camera->look)
      return Error::usage("--camera \"" + options.camera + "\" looks nowhere: its two points should differ");
    camera->width = size[0];
    camera->height = size[1];
    camera->spacing = spacingOf(options, voxelToModel);
    return withLens(options, *camera);
  }
  return cameraOfFile(options, extent, voxelToModel);
}

} // namespace

bool isInModelUnits(const CameraOptions &options) { return options.camera.starts_with(kModelUnits); }

bool isOrthographic(const CameraOptions &options) { return options.orthographic || options.viewHeight != 0; }

glm::dvec3 spacingOf(const CameraOptions &options, const Transform &voxelToModel) {
  return options.cubicVoxels ? glm::dvec3(1) : voxc::spacingOf(voxelToModel);
}

void addCameraPlace(const CommandLine &command, CameraOptions &options) {
  const OptionGroup group(command, "Picture");
  command
      .add("--camera", options.camera,
           "Eye, a point looked at and the way up (default 0,1,0), in voxels, or after 'model:' in the units "
           "of the model; or a camera of a camera file; the default sees the whole volume")
      .takes("[model:]EX,EY,EZ:LX,LY,LZ[:UX,UY,UZ]|FILE:NAME");
  const Option fov = command.add("--fov", options.fov, "Vertical field of view; the default is the camera's")
                         .takes("DEGREES")
                         .check(problemOfFov);
  command.addFlag("--orthographic", options.orthographic,
                  "Parallel rays: what is further off does not look smaller");
  command
      .add("--view-height", options.viewHeight,
           "What an orthographic picture shows from bottom to top, in voxels (in their shortest sides, where "
           "they are no cubes); by default what --fov would show at the point looked at")
      .takes("VOXELS")
      .between(1e-3, 1e9)
      .excludes(fov);
  command.addFlag("--cubic-voxels", options.cubicVoxels,
                  "Draw voxels as cubes, not with the spacing that a scan has");
}

void addCameraOptions(const CommandLine &command, CameraOptions &options) {
  addCameraPlace(command, options);
  command.add("--size", options.size, "Pixels of the picture; the default is the camera file's, or 1280x720")
      .takes("WxH");
}

Expected<Camera> makeCamera(const CameraOptions &options, Int3 extent, const Transform &voxelToModel) {
  const auto given = VOXC_TRY(checkedSize(options));
  return placeCamera(options, extent, voxelToModel, given.value_or(kDefaultSize));
}

Expected<Camera> makeCamera(const CameraOptions &options, const FileCamera &camera, Int3 extent,
                            const Transform &voxelToModel) {
  const auto given = VOXC_TRY(checkedSize(options));
  const std::array<int, 2> size = given.value_or(camera.size.value_or(kDefaultSize));
  const glm::dvec3 spacing = spacingOf(options, voxelToModel);
  Camera made = cameraFromAngles(extent, camera.position, camera.pitch, camera.yaw,
                                 options.fov != 0 ? options.fov : camera.fov, size[0], size[1], spacing);
  if (options.viewHeight != 0) {
    made.orthographicHeight = options.viewHeight;
  } else if (camera.height != 0) {
    const glm::dvec3 sides = glm::dvec3(extent.x, extent.y, extent.z) * spacing;
    made.orthographicHeight = camera.height * std::max({sides.x, sides.y, sides.z}) / 100;
  } else if (options.orthographic) {
    return Error::usage(
        "--orthographic takes a camera with a height; give the camera of the file a \"height\", "
        "in hundredths of the longest axis, or give --view-height");
  }
  return made;
}

Expected<std::array<int, 2>> parseSize(const std::string &text) {
  std::vector<std::string_view> parts = split(text, 'x');
  if (parts.size() == 2) {
    auto width = parseNumber<int>(parts[0]);
    auto height = parseNumber<int>(parts[1]);
    auto inRange = [](std::optional<int> side) { return side && *side >= 1 && *side <= kMaxPictureSide; };
    if (inRange(width) && inRange(height))
      return std::array<int, 2>{*width, *height};
  }
  return Error::usage("--size \"" + text + "\" should be WIDTHxHEIGHT, two numbers from 1 to " +
                      std::to_string(kMaxPictureSide));
}

} // namespace voxc::tool
