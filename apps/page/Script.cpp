// What a page does.
#include "page/Script.h"

#include "page/Shaders.h"

#include "common/Json.h"
#include "voxc/Volume/Frames.h"

#include <glm/geometric.hpp>

#include <span>

namespace voxc::page {
namespace {

using tool::Json;

/// In the order in which they build on each other.
constexpr const char *kScripts[] = {"script/passes",  "script/webgl",  "script/webgpu",   "script/arithmetic",
                                    "script/camera",  "script/frames", "script/controls", "script/resident",
                                    "script/picture", "script/rays",   "script/main"};
constexpr const char *kStreamedScripts[] = {
    "pages/xxh3",   "pages/zstd",        "pages/reader",  "pages/start",   "script/passes",
    "script/webgl", "script/arithmetic", "script/camera", "script/frames", "script/controls",
    "pages/pool",   "pages/volume",      "pages/waiting", "pages/telling", "script/picture",
    "script/rays",  "script/main"};

Json numbers(const glm::dvec3 &v) { return {v.x, v.y, v.z}; }

/// Normals and offsets.
Json planesOf(const Clip &clip) {
  Json planes = Json::array();
  for (const ClipPlane &plane : clip.planes)
    planes.push_back({plane.normal.x, plane.normal.y, plane.normal.z, plane.offset});
  return planes;
}

/// Each number as what it is more than the one before.
Json stepsOf(const std::vector<std::uint32_t> &numbers) {
  Json steps = Json::array();
  std::int64_t before = 0;
  for (const std::uint32_t number : numbers) {
    steps.push_back(number - before);
    before = number;
  }
  return steps;
}

/// The roots of an animation, of a page that holds all its words; else none.
Json rootsOf(const Volume &volume, bool isStreamed) {
  Json roots = Json::array();
  if (!isStreamed)
    for (const Frame &frame : framesOf(volume))
      roots.push_back(frame.root);
  return roots;
}

/// What a page knows of a volume that it reads.
Json streamedOf(const Volume &volume, const StreamedVolume &streamed) {
  return {{"name", streamed.url},
          {"headBytes", streamed.headBytes},
          {"fileBytes", streamed.fileBytes},
          {"checksum", std::to_string(streamed.checksum)}, // A number of JavaScript has 53 bits.
          {"pageBytes", streamed.pageBytes},
          {"bytes", volume.words().size_bytes()},
          {"budget", streamed.memoryBytes},
          {"view",
           {{"eye", numbers(streamed.view.eye)},
            {"front", numbers(streamed.view.front)},
            {"right", numbers(streamed.view.right)},
            {"up", numbers(streamed.view.up)},
            {"isParallel", streamed.view.isParallel}}},
          {"first", stepsOf(streamed.first)}};
}

Json sceneOf(const Volume &volume, const PageContents &contents) {
  const Int3 extent = volume.info().extent;
  const Camera &camera = contents.camera;
  return {{"extent", {extent.x, extent.y, extent.z}},
          {"spacing", numbers(camera.spacing)},
          {"camera", // In spaced space.
           {{"eye", numbers(camera.eye * camera.spacing)},
            {"look", numbers(camera.look * camera.spacing)},
            {"up", numbers(camera.up * camera.spacing)},
            {"fov", camera.verticalFov},
            {"height", camera.orthographicHeight}, // 0: a pinhole.
            {"aspect", double(camera.width) / camera.height}}},
          {"frames", rootsOf(volume, contents.streamed.has_value())},
          {"cuts", planesOf(contents.clip)},
          {"sun", numbers(glm::normalize(contents.sun))},
          {"smooth", contents.smooth},
          {"exposure", contents.exposure},
          {"labels", volume.layout().hasLabels()},
          {"fast", {{"rays", contents.fast.rays}, {"others", contents.fast.differences()}}},
          {"wait", kWait},
          {"volume", contents.streamed ? streamedOf(volume, *contents.streamed) : Json()}};
}

} // namespace

Expected<std::string> makeScript(const Volume &volume, const PageContents &contents) {
  const bool isStreamed = contents.streamed.has_value();
  const auto shaders = VOXC_TRY(makeShaders(volume.format(), isStreamed, !contents.clip.cutsNothing()));
  std::string script =
      "const scene = " +
      // An address may have bytes that are no UTF-8, which is none that a browser asks for either.
      sceneOf(volume, contents).dump(-1, ' ', false, Json::error_handler_t::replace) +
      ";\nconst shaders = " + shaders.dump() + ";\n";
  for (const std::string name : isStreamed ? std::span<const char *const>(kStreamedScripts) : kScripts)
    script += tersely(name + ".js");
  return script;
}

} // namespace voxc::page
