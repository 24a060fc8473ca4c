// What a page does.
#include "page/Script.h"

#include "page/Merged.h"

#include "common/Json.h"
#include "voxc/Emit/Emit.h"
#include "voxc/IR/Attribute.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Support/EmbeddedFile.h"

#include <glm/geometric.hpp>

#include <span>

namespace voxc {

/// Made by cmake/VoxcEmbed.cmake.
std::span<const EmbeddedFile> pageFiles();

namespace page {
namespace {

using tool::Json;

/// In the order in which they build on each other.
constexpr const char *kScripts[] = {"script/device",   "script/arithmetic", "script/camera",
                                    "script/controls", "script/resident",   "script/picture",
                                    "script/rays",     "script/main"};
constexpr const char *kStreamedScripts[] = {
    "pages/xxh3",        "pages/zstd",    "pages/reader",    "pages/start", "script/device",
    "script/arithmetic", "script/camera", "script/controls", "pages/pool",  "pages/volume",
    "pages/waiting",     "pages/telling", "script/picture",  "script/rays", "script/main"};
constexpr const char *kShaders[] = {"camera.glsl",  "light.glsl",   "surface.glsl", "all.vert",
                                    "picture.frag", "develop.frag", "answer.frag",  "arithmetic.frag"};
constexpr const char *kResidentShaders[] = {"words.glsl"};
constexpr const char *kStreamedShaders[] = {"pages.glsl", "sketch.frag", "collect.frag"};

constexpr std::string_view kName = "scene"; ///< Of the functions, which shaders know.

std::string_view fileText(std::string_view path) {
  for (const EmbeddedFile &file : pageFiles())
    if (file.path == path)
      return file.text;
  return {};
}

std::string terse(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    line = line.substr(0, line.find(" // "));
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (!line.empty() && !line.starts_with("//"))
      result += std::string(line.substr(0, line.find_last_not_of(' ') + 1)) + "\n";
  }
  return result;
}

/// The functions that trace rays of a format, by one of the values of `precision`.
Expected<std::string> functionsOf(Format format, Addressing addressing, bool isCut,
                                  std::string_view precision) {
  askForPrecision(format, precision);
  PlanOptions options = isCut ? kHeaderPlan : kFirstHitPlan;
  options.addressing = addressing;
  const Expected<Plan> plan = makePlan(format, options);
  if (!plan)
    return plan.error();
  return terse(emitHeader(*plan, kName, HeaderLanguage::GlslEs));
}

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

std::string tersely(std::string_view path) { return terse(fileText(path)); }

Expected<std::string> makeScript(const Volume &volume, const PageContents &contents) {
  const bool isStreamed = contents.streamed.has_value();
  const Addressing addressing = isStreamed ? Addressing::Paged : Addressing::Buffer;
  const bool isCut = !contents.clip.cutsNothing();
  const Expected<std::string> exact = functionsOf(volume.format(), addressing, isCut, "exact");
  const Expected<std::string> fast = functionsOf(volume.format(), addressing, isCut, "fast");
  if (!exact || !fast)
    return exact ? fast.error() : exact.error();
  Json shaders{{"functions", merged(*exact, *fast)}};
  const auto addShaders = [&](std::span<const char *const> names) {
    for (const std::string name : names)
      shaders[name] = tersely("shader/" + name);
  };
  addShaders(kShaders);
  addShaders(isStreamed ? std::span<const char *const>(kStreamedShaders) : kResidentShaders);
  shaders["seen.glsl"] = tersely(isCut ? "shader/cut.glsl" : "shader/whole.glsl");
  std::string script =
      "const scene = " + sceneOf(volume, contents).dump() + ";\nconst shaders = " + shaders.dump() + ";\n";
  for (const std::string name : isStreamed ? std::span<const char *const>(kStreamedScripts) : kScripts)
    script += tersely(name + ".js");
  return script;
}

} // namespace page
} // namespace voxc
