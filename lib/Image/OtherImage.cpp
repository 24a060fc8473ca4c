// BMP and TGA through stb_image, whose code is compiled into this file alone.
#include "Image/ImageKinds.h"

#include <cstdlib>
#include <cstring>
#include <memory>

namespace voxc {

namespace {

/// What the library holds, and may hold: it takes memory as a file tells it to.
struct LibraryMemory {
  std::uint64_t now = 0;
  std::uint64_t allowance = 0;
};

thread_local LibraryMemory library;

/// Before each block stands its size, in as many bytes as keep the block aligned.
constexpr std::size_t kHead = 16;

void freeCounted(void *block) {
  if (!block)
    return;
  auto *head = static_cast<std::byte *>(block) - kHead;
  std::uint64_t size = 0;
  std::memcpy(&size, head, sizeof size);
  library.now -= size;
  std::free(head);
}

void *allocateCounted(std::size_t bytes) {
  const std::uint64_t size = std::uint64_t{bytes} + kHead;
  if (library.now + size > library.allowance)
    return nullptr;
  auto *head = static_cast<std::byte *>(std::malloc(size));
  if (!head)
    return nullptr;
  std::memcpy(head, &size, sizeof size);
  library.now += size;
  return head + kHead;
}

} // namespace

} // namespace voxc

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_MALLOC(bytes) voxc::allocateCounted(bytes)
#define STBI_REALLOC_SIZED(block, oldBytes, bytes) nullptr // PNG and GIF alone resize.
#define STBI_FREE(block) voxc::freeCounted(block)
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace voxc {

namespace {

constexpr std::uint64_t kLibraryBytesATexel = 12;
constexpr std::uint64_t kLibraryBytes = std::uint64_t{1} << 20; ///< For tables.

std::optional<ImageSize> readOtherSize(std::span<const std::byte> bytes) {
  library = {0, kLibraryBytes};
  ImageSize size;
  int channels = 0;
  if (!stbi_info_from_memory(dataOf(bytes), static_cast<int>(bytes.size()), &size.width, &size.height,
                             &channels))
    return std::nullopt;
  return size;
}

/// Does a TGA of four bytes a texel say that the fourth is no alpha? It has no sign but the size that it
/// claims.
bool isTgaWithoutAlpha(std::span<const std::byte> bytes, ImageSize size) {
  constexpr std::size_t kHeaderBytes = 18;
  if (bytes.size() < kHeaderBytes)
    return false;
  const auto at = [&](std::size_t i) { return std::to_integer<int>(bytes[i]); };
  const bool isTgaOfColours = at(1) == 0 && (at(2) == 2 || at(2) == 10) && at(16) == 32;
  const bool isOfSize = (at(12) | at(13) << 8) == size.width && (at(14) | at(15) << 8) == size.height;
  return isTgaOfColours && isOfSize && (at(17) & 15) == 0;
}

std::string decodeOther(std::span<const std::byte> bytes, ImageSize size, std::uint32_t *texels) {
  library = {0, kLibraryBytes + static_cast<std::uint64_t>(size.texels()) * kLibraryBytesATexel};
  ImageSize decodedSize;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&freeCounted)> decoded(
      stbi_load_from_memory(dataOf(bytes), static_cast<int>(bytes.size()), &decodedSize.width,
                            &decodedSize.height, &channels, 4),
      freeCounted);
  if (!decoded)
    return stbi_failure_reason();
  if (decodedSize.width != size.width || decodedSize.height != size.height)
    return "it has two sizes";
  std::memcpy(texels, decoded.get(), static_cast<std::size_t>(size.texels()) * 4);
  if (isTgaWithoutAlpha(bytes, size))
    for (std::uint32_t &texel : std::span(texels, static_cast<std::size_t>(size.texels())))
      texel |= 0xff000000;
  return {};
}

} // namespace

const ImageKind kOtherImage{[](std::span<const std::byte>) { return true; }, readOtherSize, decodeOther,
                            kLibraryBytesATexel};

} // namespace voxc
