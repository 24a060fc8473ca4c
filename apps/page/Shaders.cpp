// The shaders of a page: the kernel's functions by either precision, and what draws and answers by them.
#include "page/Shaders.h"

#include "page/Merged.h"

#include "voxc/Emit/Emit.h"
#include "voxc/IR/Attribute.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Support/EmbeddedFile.h"

#include <algorithm>
#include <array>
#include <span>

namespace voxc {

/// Made by cmake/VoxcEmbed.cmake.
std::span<const EmbeddedFile> pageFiles();

namespace page {
namespace {

using tool::Json;

/// What a program is made of beside the kernel.
struct Pass {
  std::string_view name;
  std::string_view files; ///< Of page-runtime/shader, in the order in which they build on each other.
  std::string_view essl;  ///< What ties them to a target of WebGL 2.
  std::string_view wgsl;  ///< And of WebGPU.
};

/// SEEN is what tells of the volume what rays see of it.
constexpr std::array<Pass, 4> kPasses = {
    {{"picture", "camera light SEEN surface picture", "webgl/main.glsl", "webgpu/main.wgsl"},
     {"develop", "camera develop", "webgl/shown.glsl", "webgpu/shown.wgsl"},
     {"answer", "SEEN answer", "webgl/main.glsl", "webgpu/main.wgsl"},
     {"arithmetic", "arithmetic", "webgl/main.glsl", "webgpu/main.wgsl"}}};
constexpr std::array<Pass, 6> kStreamedPasses = {
    {{"picture", "camera light SEEN surface picture", "pages/main.glsl", ""},
     {"sketch", "camera light SEEN pages/sketch", "pages/main.glsl", ""},
     {"collect", "", "pages/collect.glsl", ""},
     {"develop", "camera develop", "webgl/shown.glsl", ""},
     {"answer", "SEEN answer", "pages/answer.glsl", ""},
     {"arithmetic", "arithmetic", "webgl/main.glsl", ""}}};

constexpr std::string_view kName = "scene"; ///< Of the functions, which shaders know.

std::string_view fileText(std::string_view path) {
  for (const EmbeddedFile &file : pageFiles())
    if (file.path == path)
      return file.text;
  return {};
}

std::string shaderText(std::string_view path) { return std::string(fileText("shader/" + std::string(path))); }

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
Expected<std::string> functionsOf(Format format, const PlanOptions &options, std::string_view precision,
                                  HeaderLanguage language) {
  askForPrecision(format, precision);
  const auto plan = VOXC_TRY(makePlan(format, options));
  return terse(emitHeader(plan, kName, language));
}

/// Those of both as one text.
Expected<std::string> functionsOf(const Format &format, const PlanOptions &options, HeaderLanguage language) {
  const Expected<std::string> exact = functionsOf(format, options, "exact", language);
  const Expected<std::string> fast = functionsOf(format, options, "fast", language);
  if (!exact || !fast)
    return exact ? fast.error() : exact.error();
  return merged(*exact, *fast);
}

/// Deflate finds what two texts have in common where it is not far apart: so many pieces of each in turn.
constexpr std::size_t kPieces = 16;

/// The i-th piece of a text, of whole lines.
std::string_view pieceOf(std::string_view text, std::size_t i) {
  const auto begin = [&](std::size_t piece) {
    const std::size_t end = text.find('\n', text.size() * piece / kPieces);
    return piece == 0 ? 0 : end == std::string_view::npos ? text.size() : end + 1;
  };
  return text.substr(begin(i), begin(i + 1) - begin(i));
}

/// The functions in pieces, each by the names of its languages.
Expected<Json> piecesOf(const Format &format, const PlanOptions &options, bool isStreamed) {
  Json pieces(kPieces, Json::object());
  for (const HeaderLanguage language : {HeaderLanguage::GlslEs, HeaderLanguage::Wgsl}) {
    if (language == HeaderLanguage::Wgsl && isStreamed)
      break;
    const auto functions = VOXC_TRY(functionsOf(format, options, language));
    for (std::size_t i = 0; i < kPieces; ++i)
      pieces[i][std::string(toString(language))] = pieceOf(functions, i);
  }
  return pieces;
}

/// The text of a pass in GLSL, without what ties it to a target.
std::string textOf(const Pass &pass, bool isStreamed, bool isCut) {
  std::string text;
  std::string_view files = pass.files;
  while (!files.empty()) {
    const std::string_view file = files.substr(0, files.find(' '));
    files.remove_prefix(std::min(file.size() + 1, files.size()));
    text += file == "SEEN" ? shaderText(isStreamed ? "pages/streamed.glsl" : "resident.glsl") + "\n" +
                                 shaderText(isCut ? "cut.glsl" : "whole.glsl")
                           : shaderText(std::string(file) + ".glsl");
    text += "\n";
  }
  return text;
}

/// The same in WGSL.
Expected<std::string> wgslOf(const std::string &functions, const std::string &declared) {
  const auto text = VOXC_TRY(emitFunctions(functions, declared, HeaderLanguage::Wgsl));
  return terse(text);
}

Json esslShaders(std::span<const Pass> passes, bool isStreamed, bool isCut) {
  Json shaders;
  for (const std::string name : {"begin", "vertex"})
    shaders[name] = tersely("shader/webgl/" + name + ".glsl");
  shaders["words"] = tersely(isStreamed ? "shader/pages/words.glsl" : "shader/webgl/words.glsl");
  for (const Pass &pass : passes)
    shaders[std::string(pass.name)] = terse(textOf(pass, isStreamed, isCut) + shaderText(pass.essl));
  return shaders;
}

Expected<Json> wgslShaders(std::span<const Pass> passes, bool isCut) {
  const std::string given = shaderText("given.glsl");
  const auto structs = VOXC_TRY(wgslOf(given, ""));
  Json shaders{{"begin", structs + tersely("shader/webgpu/begin.wgsl")}};
  for (const Pass &pass : passes) {
    const auto text = VOXC_TRY(wgslOf(textOf(pass, false, isCut), given + shaderText("kernel.glsl")));
    shaders[std::string(pass.name)] = text + terse(shaderText(pass.wgsl));
  }
  return shaders;
}

} // namespace

std::string tersely(std::string_view path) { return terse(fileText(path)); }

Expected<Json> makeShaders(const Format &format, bool isStreamed, bool isCut) {
  PlanOptions options = isCut ? kHeaderPlan : kFirstHitPlan;
  options.addressing = isStreamed ? Addressing::Paged : Addressing::Buffer;
  const std::span<const Pass> passes = isStreamed ? std::span<const Pass>(kStreamedPasses) : kPasses;
  Json shaders{{"given", tersely("shader/given.glsl")}, {"essl", esslShaders(passes, isStreamed, isCut)}};
  if (!isStreamed) {
    const auto wgsl = VOXC_TRY(wgslShaders(passes, isCut));
    shaders["wgsl"] = wgsl;
  }
  const auto functions = VOXC_TRY(piecesOf(format, options, isStreamed));
  shaders["functions"] = functions;
  return shaders;
}

} // namespace page
} // namespace voxc
