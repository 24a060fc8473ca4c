// A volume as one page for browsers.
#include "page/Page.h"

#include "page/Holes.h"
#include "page/Packed.h"
#include "page/Poster.h"
#include "page/Script.h"
#include "page/Shaders.h"

#include "common/Command.h"
#include "voxc/Volume/Frames.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstdio>

namespace voxc::page {
namespace {

/// Text with what HTML reserves escaped.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text)
    result += c == '&'   ? "&amp;"
              : c == '<' ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '"' ? "&quot;"
                         : std::string(1, c);
  return result;
}

/// In groups of three digits.
std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3)
    text.insert(at - 3, ",");
  return text;
}

std::string bytesText(std::uint64_t bytes) {
  char text[64];
  if (bytes < std::uint64_t{1} << 20)
    std::snprintf(text, sizeof text, "%.1f KiB", double(bytes) / 1024);
  else
    std::snprintf(text, sizeof text, "%.2f MiB", double(bytes) / 1048576);
  return text;
}

std::string fact(std::string_view name, const std::string &value) {
  return "<dt>" + std::string(name) + "</dt><dd>" + value + "</dd>\n";
}

/// The figures that a volume has everywhere.
std::string factsOf(const Volume &volume) {
  const VolumeInfo &info = volume.info();
  const Int3 extent = info.extent;
  const std::uint64_t bytes = volume.words().size_bytes();
  char each[64];
  std::snprintf(each, sizeof each, "%.2f bytes a voxel",
                double(bytes) / double(info.voxels ? info.voxels : 1));
  return fact("Format", "<code>" + escaped(volume.layout().format) + "</code>") +
         fact("Extent", std::to_string(extent.x) + " × " + std::to_string(extent.y) + " × " +
                            std::to_string(extent.z)) +
         fact("Voxels", grouped(info.voxels)) + fact("Memory", bytesText(bytes) + ", " + each) +
         fact("Made by", versionText());
}

/// What chooses a frame of an animation, and plays it.
std::string frameControls(std::size_t frames) {
  const std::string count = std::to_string(frames);
  return "<p id=\"frames\"><button id=\"play\" type=\"button\">Play</button> <input id=\"frame\" "
         "type=\"range\" "
         "min=\"1\" max=\"" +
         count + "\" value=\"1\" aria-label=\"Frame\"> <output id=\"number\" for=\"frame\">1 of " + count +
         "</output></p>\n";
}

/// Those of what a page reads.
std::string factsOf(const StreamedVolume &streamed) {
  return fact("Read from", escaped(streamed.url) + ", " + bytesText(streamed.fileBytes)) +
         "<dt>Pages</dt><dd id=\"pages\">–</dd>\n";
}

} // namespace

Clip scaled(Clip clip) {
  constexpr double kFar = 1e30; // As good as infinitely far off.
  for (ClipPlane &plane : clip.planes) {
    const glm::dvec3 sides = glm::abs(plane.normal);
    const double most = std::max({sides.x, sides.y, sides.z});
    plane.normal /= most;
    plane.offset = std::clamp(plane.offset / most, -kFar, kFar);
  }
  return clip;
}

Expected<std::string> makePage(const Volume &volume, const PageContents &contents) {
  const std::optional<StreamedVolume> &streamed = contents.streamed;
  const auto words = streamed ? std::span<const std::uint32_t>() : volume.words();
  if (words.size() > kMostWords)
    return Error::input(
        "the volume has " + grouped(words.size()) + " words, and browsers keep no more than " +
        grouped(kMostWords) +
        " in a texture; a smaller format or resolution fits, or a page that reads what it needs (--url)");
  const auto script = VOXC_TRY(makeScript(volume, contents));
  const std::string packed = deflated(script + planesOf(words) + contents.checks);
  const std::size_t frames = streamed ? 0 : framesOf(volume).size();
  Holes holes = {
      {"BYTES", std::to_string(packed.size())},
      {"SCRIPT_BYTES", std::to_string(script.size())},
      {"WORDS", std::to_string(words.size())},
      {"BLOCK_WORDS", std::to_string(kBlockWords)},
      {"TITLE", escaped(contents.title)},
      {"STYLE", tersely("style.css")},
      {"FACTS", factsOf(volume) + (streamed ? factsOf(*streamed) : "")},
      {"FRAMES", frames > 0 ? frameControls(frames) : ""},
      {"FRAME_KEYS", frames > 0 ? "; space plays, comma and full stop step" : ""},
      {"WAIT", std::string(kWait)},
      {"POSTER", posterHtml(contents.picture, contents.camera, volume.info().extent, packed.size())},
      // Whoever is on a server is asked for an icon.
      {"ICON", streamed ? "<link rel=\"icon\" href=\"data:,\">\n" : ""},
      {"PACKED", sevenBitText(packed)}};
  const auto unpack = VOXC_TRY(fill(tersely("unpack.js"), holes));
  holes["UNPACK"] = unpack;
  return fill(tersely("page.html"), holes);
}

} // namespace voxc::page
