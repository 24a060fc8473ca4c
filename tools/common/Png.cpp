// Pictures as PNG files.
#include "Png.h"

#include "Files.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#include <stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace voxc::tool {
namespace {

void append(void *context, void *data, int size) {
  static_cast<std::string *>(context)->append(static_cast<const char *>(data),
                                              static_cast<std::size_t>(size));
}

} // namespace

Expected<void> writePng(const std::string &path, const Picture &picture) {
  constexpr int kChannels = 4;
  std::string png;
  if (!stbi_write_png_to_func(append, &png, picture.width, picture.height, kChannels, picture.pixels.data(),
                              picture.width * kChannels))
    return Error::environment("out of memory while encoding " + path);
  return writeText(path, png);
}

} // namespace voxc::tool
