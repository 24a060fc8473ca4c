// Pictures as files, by a table of their kinds.
#include "PictureFile.h"

#include "Files.h"

#include "voxc/Image/Encode.h"

#include <algorithm>
#include <cctype>

namespace voxc::tool {
namespace {

constexpr int kJpegQuality = 92;

using Light = std::span<const float>;

Expected<std::string> pngOf(const Picture &picture, Light) {
  return encodePng(picture.pixels, picture.width, picture.height);
}

Expected<std::string> jpegOf(const Picture &picture, Light) {
  return encodeJpeg(picture.pixels, picture.width, picture.height, kJpegQuality);
}

Expected<std::string> exrOf(const Picture &picture, Light light) {
  return light.empty() ? encodeExr(picture.pixels, picture.width, picture.height)
                       : encodeExr(light, picture.width, picture.height);
}

struct PictureKind {
  std::string_view ending;
  Expected<std::string> (*encode)(const Picture &picture, Light light);
};

constexpr PictureKind kKinds[] = {{".png", pngOf}, {".jpg", jpegOf}, {".jpeg", jpegOf}, {".exr", exrOf}};

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
  const Expected<std::string> bytes = kindOf(path)->encode(picture, light);
  return bytes ? writeText(path, *bytes) : bytes.error();
}

} // namespace voxc::tool
