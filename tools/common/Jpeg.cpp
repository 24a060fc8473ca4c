// Pictures as JPEG.
#include "Jpeg.h"

#include "StbImageWrite.h"

namespace voxc::tool {

std::string encodeJpeg(const Picture &picture, int quality) {
  constexpr int kChannels = 4; // The last is left out.
  std::string jpeg;
  stbi_write_jpg_to_func(appendBytes, &jpeg, picture.width, picture.height, kChannels, picture.pixels.data(),
                         quality);
  return jpeg;
}

} // namespace voxc::tool
