// stb_image_write, private to the file that includes this, which uses but a part of it.
#pragma once

#include <cstddef>
#include <string>

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

/// What stb_image_write gives its bytes to: `text` is a std::string.
inline void appendBytes(void *text, void *data, int size) {
  static_cast<std::string *>(text)->append(static_cast<const char *>(data), static_cast<std::size_t>(size));
}

} // namespace voxc::tool
