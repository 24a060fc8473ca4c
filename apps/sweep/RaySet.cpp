// Reading cameras and rays.
#include "sweep/RaySet.h"

#include "common/CameraFile.h"
#include "common/CameraOptions.h"
#include "common/Files.h"
#include "common/Json.h"

#include <algorithm>
#include <filesystem>

namespace voxc::tool::bench {
namespace {

constexpr const char *kOverview = "overview";

std::string exact(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", number);
  return text;
}

/// What a record says of an order; of the default, nothing.
std::optional<std::string> orderOf(const std::string &asked) {
  return asked == kAutoOrder ? std::nullopt : std::optional(asked);
}

Expected<std::array<int, 2>> sizeOf(const std::string &text, std::array<int, 2> fallback) {
  return text.empty() ? fallback : parseSize(text);
}

/// A file of this camera alone.
std::string textOf(const FileCamera &camera) {
  Json text{{"position", {camera.position.x, camera.position.y, camera.position.z}},
            {"pitch", camera.pitch},
            {"yaw", camera.yaw},
            {"fov", camera.fov}};
  if (camera.height != 0)
    text["height"] = camera.height;
  return Json{{"cameras", {{"camera", text}}}}.dump();
}

Expected<RaySet> readCameraSet(const RayArguments &arguments, const std::string &name) {
  const Camera defaults;
  const auto file = VOXC_TRY(readCamera(arguments.cameraFile, name));
  const auto size = sizeOf(arguments.size, file.size.value_or(std::array{defaults.width, defaults.height}));
  if (!size)
    return size.error();
  Digest digest;
  for (const double number :
       {file.position[0], file.position[1], file.position[2], file.pitch, file.yaw, file.fov})
    digest.add(exact(number));
  if (file.height != 0) // Of an orthographic one alone: others have the names that they had.
    digest.add(exact(file.height));
  RaySet set;
  set.part = measure::cameraPart(name, *size, digest);
  set.cameraText = textOf(file);
  const CameraOptions options{.size = std::to_string((*size)[0]) + "x" + std::to_string((*size)[1])};
  VOXC_TRY(makeCamera(options, file, {1, 1, 1}));
  set.camera = [file, options](Int3 extent) { return *makeCamera(options, file, extent); };
  return set;
}

/// A camera that sees all of a volume.
Expected<RaySet> makeOverview(const RayArguments &arguments) {
  const Camera defaults;
  const auto size = sizeOf(arguments.size, {defaults.width, defaults.height});
  if (!size)
    return size.error();
  RaySet set;
  set.part = measure::overviewPart(*size);
  set.camera = [size = *size](Int3 extent) { return frameExtent(extent, size[0], size[1]); };
  return set;
}

Expected<RaySet> readRayFile(const std::string &path) {
  auto rays = VOXC_TRY(readRays(path));
  if (rays.empty())
    return Error::input("ray file '" + path + "' is empty; it should hold one ray at least");
  return makeRaySet(std::filesystem::path(path).stem().string(), std::move(rays));
}

Expected<std::vector<std::string>> chooseCameras(const RayArguments &arguments, const std::string &model) {
  auto names = VOXC_TRY(cameraNames(arguments.cameraFile));
  if (std::ranges::find(names, model) != names.end())
    return std::vector{model};
  if (names.empty())
    return Error::input(arguments.cameraFile + " has no cameras; it should have one at least");
  return names;
}

} // namespace

RaySet makeRaySet(const std::string &name, std::vector<Ray> rays, const std::string &order) {
  RaySet set;
  set.part = measure::listPart(name, rays);
  set.part.order = orderOf(order);
  set.rays = std::move(rays);
  return set;
}

std::string kindOf(const RaysPart &part) {
  if (part.kind != "camera" || !part.size)
    return "file";
  const std::array<int, 2> size{int((*part.size)[0]), int((*part.size)[1])};
  return measure::overviewPart(size).digest == part.digest ? kOverview : "camera";
}

std::string rayFileName(const RaysPart &part) {
  const std::string kind = kindOf(part);
  if (kind == kOverview)
    return "";
  return "rays-" + part.digest + (kind == "camera" ? ".json" : ".bin");
}

Expected<void> keepRays(const RaySet &set, const std::string &folder) {
  const std::string name = rayFileName(set.part);
  const std::string path = folder + "/" + name;
  std::error_code ignored;
  if (name.empty() || std::filesystem::exists(path, ignored))
    return {};
  return set.camera ? writeText(path, set.cameraText) : writeBytes(path, std::as_bytes(std::span(set.rays)));
}

Expected<std::vector<Ray>> keptRays(const RaysPart &part, const std::string &folder, Int3 extent) {
  const std::string kind = kindOf(part), path = folder + "/" + rayFileName(part);
  if (kind == "file")
    return readRays(path);
  const auto size = *part.size;
  const RayArguments arguments{path, std::to_string(size[0]) + "x" + std::to_string(size[1]), {}, kAutoOrder};
  const auto set = VOXC_TRY(kind == kOverview ? makeOverview(arguments) : readCameraSet(arguments, "camera"));
  return set.raysFor(extent);
}

Expected<std::vector<RaySet>> readRaySets(const RayArguments &arguments, const std::string &model) {
  std::vector<RaySet> sets;
  const auto add = [&](Expected<RaySet> set) -> Expected<void> {
    if (!set)
      return set.error();
    set->part.order = orderOf(arguments.order);
    sets.push_back(std::move(*set));
    return {};
  };
  if (!arguments.cameraFile.empty()) {
    const auto names = VOXC_TRY(chooseCameras(arguments, model));
    for (const std::string &name : names)
      VOXC_TRY(add(readCameraSet(arguments, name)));
  } else if (arguments.rayFiles.empty()) {
    VOXC_TRY(add(makeOverview(arguments)));
  }
  for (const std::string &path : arguments.rayFiles)
    VOXC_TRY(add(readRayFile(path)));
  return sets;
}

} // namespace voxc::tool::bench
