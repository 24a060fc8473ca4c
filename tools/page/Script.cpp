// What a page does.
#include "page/Script.h"

#include "page/Merged.h"

#include "common/Json.h"
#include "voxc/Emit/Emit.h"
#include "voxc/IR/Attribute.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Support/EmbeddedFile.h"

#include <glm/geometric.hpp>

#include <array>

namespace voxc {

/// Made by cmake/VoxcEmbed.cmake.
std::span<const EmbeddedFile> pageFiles();

namespace page {
namespace {

using tool::Json;

/// In the order in which they build on each other.
constexpr std::array kScripts = {"device", "arithmetic", "camera", "controls", "picture", "rays", "main"};
constexpr std::array kShaders = {"words.glsl",   "light.glsl",   "surface.glsl", "all.vert",
                                 "picture.frag", "develop.frag", "answer.frag",  "arithmetic.frag"};

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
Expected<std::string> functionsOf(Format format, std::string_view precision) {
  format.setAttribute(kPrecisionAttribute, precision);
  const Expected<Plan> plan = makePlan(format, kFirstHitPlan);
  if (!plan)
    return plan.error();
  return terse(emitWebGl(*plan, kName));
}

Json numbers(const glm::dvec3 &v) { return {v.x, v.y, v.z}; }

Json sceneOf(const Volume &volume, const PageContents &contents) {
  const Int3 extent = volume.info().extent;
  const Camera &camera = contents.camera;
  return {{"extent", {extent.x, extent.y, extent.z}},
          {"camera",
           {{"eye", numbers(camera.eye)},
            {"look", numbers(camera.look)},
            {"up", numbers(camera.up)},
            {"fov", camera.verticalFov},
            {"aspect", double(camera.width) / camera.height}}},
          {"sun", numbers(glm::normalize(contents.sun))},
          {"smooth", contents.smooth},
          {"exposure", contents.exposure},
          {"labels", volume.layout().payload == Payload::Material},
          {"fast", {{"rays", contents.fast.rays}, {"others", contents.fast.differences()}}},
          {"wait", kWait}};
}

} // namespace

std::string tersely(std::string_view path) { return terse(fileText(path)); }

Expected<std::string> makeScript(const Volume &volume, const PageContents &contents) {
  const Expected<std::string> exact = functionsOf(volume.format(), "exact");
  const Expected<std::string> fast = functionsOf(volume.format(), "fast");
  if (!exact || !fast)
    return exact ? fast.error() : exact.error();
  Json shaders{{"functions", merged(*exact, *fast)}};
  for (const std::string name : kShaders)
    shaders[name] = tersely("shader/" + name);
  std::string script =
      "const scene = " + sceneOf(volume, contents).dump() + ";\nconst shaders = " + shaders.dump() + ";\n";
  for (const std::string name : kScripts)
    script += tersely("script/" + name + ".js");
  return script;
}

} // namespace page
} // namespace voxc
