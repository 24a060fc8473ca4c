// Pictures as PNG files.
#include "Png.h"

#include "Files.h"
#include "StbImageWrite.h"

namespace voxc::tool {

Expected<void> writePng(const std::string &path, const Picture &picture) {
  constexpr int kChannels = 4;
  std::string png;
  if (!stbi_write_png_to_func(appendBytes, &png, picture.width, picture.height, kChannels,
                              picture.pixels.data(), picture.width * kChannels))
    return Error::environment("out of memory while encoding " + path);
  return writeText(path, png);
}

} // namespace voxc::tool
