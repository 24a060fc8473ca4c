// Pictures as PNG files.
#include "Png.h"

#include "Files.h"
#include "StbImageWrite.h"

namespace voxc::tool {

std::string encodePng(const Picture &picture) {
  constexpr int kChannels = 4;
  std::string png;
  if (!stbi_write_png_to_func(appendBytes, &png, picture.width, picture.height, kChannels,
                              picture.pixels.data(), picture.width * kChannels))
    return {};
  return png;
}

Expected<void> writePng(const std::string &path, const Picture &picture) {
  const std::string png = encodePng(picture);
  if (png.empty())
    return Error::environment("out of memory while encoding " + path);
  return writeText(path, png);
}

} // namespace voxc::tool
