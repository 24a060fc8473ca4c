// Pictures as files, by a table of their kinds.
#include "PictureFile.h"

#include "Exr.h"
#include "Files.h"
#include "Jpeg.h"
#include "Png.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <vector>

namespace voxc::tool {
namespace {

constexpr int kJpegQuality = 92;

/// Linear red, green, blue and alpha of the picture's own colours.
std::vector<float> lightOf(const Picture &picture) {
  std::vector<float> light;
  light.reserve(4 * picture.pixels.size());
  const auto toLinear = [](std::uint32_t channel) {
    const float value = float(channel & 255) / 255;
    return value <= 0.04045f ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
  };
  for (const std::uint32_t pixel : picture.pixels)
    light.insert(light.end(), {toLinear(pixel), toLinear(pixel >> 8), toLinear(pixel >> 16), 1.0f});
  return light;
}

std::string exrOf(const Picture &picture, std::span<const float> light) {
  return light.empty() ? encodeExr(lightOf(picture), picture.width, picture.height)
                       : encodeExr(light, picture.width, picture.height);
}

struct PictureKind {
  std::string_view ending;
  std::string (*encode)(const Picture &picture, std::span<const float> light);
};

constexpr PictureKind kKinds[] = {
    {".png", [](const Picture &picture, std::span<const float>) { return encodePng(picture); }},
    {".jpg",
     [](const Picture &picture, std::span<const float>) { return encodeJpeg(picture, kJpegQuality); }},
    {".jpeg",
     [](const Picture &picture, std::span<const float>) { return encodeJpeg(picture, kJpegQuality); }},
    {".exr", exrOf},
};

const PictureKind *kindOf(const std::string &path) {
  if (path == "-")
    return &kKinds[0];
  std::string lower = path;
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  for (const PictureKind &kind : kKinds)
    if (lower.ends_with(kind.ending))
      return &kind;
  return nullptr;
}

} // namespace

std::string pictureEndings() {
  std::string endings;
  for (const PictureKind &kind : kKinds)
    endings += std::string(endings.empty()                 ? ""
                           : &kind == std::end(kKinds) - 1 ? " or "
                                                           : ", ") +
               std::string(kind.ending);
  return endings;
}

Expected<void> checkPictureName(const std::string &path) {
  if (kindOf(path))
    return {};
  return Error::usage("'" + path + "' names no kind of picture that voxc writes; end it in " +
                      pictureEndings());
}

Expected<void> writePicture(const std::string &path, const Picture &picture, std::span<const float> light) {
  if (Expected<void> named = checkPictureName(path); !named)
    return named;
  const std::string bytes = kindOf(path)->encode(picture, light);
  if (bytes.empty())
    return Error::environment("out of memory while encoding " + path);
  return writeText(path, bytes);
}

} // namespace voxc::tool
