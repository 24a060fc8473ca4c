// Images through stb_image, whose code is compiled into this file alone.
#include "Mesh/Image/ImageDecoder.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

namespace voxc {

namespace {

/// What the library holds: it takes memory as a file tells it to, so each image gets an allowance.
struct LibraryMemory {
  std::uint64_t now = 0;
  std::uint64_t peak = 0;
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
  library.peak = std::max(library.peak, library.now);
  return head + kHead;
}

void *resizeCounted(void *block, std::size_t oldBytes, std::size_t bytes) {
  void *larger = allocateCounted(bytes);
  if (larger && block) {
    std::memcpy(larger, block, std::min(oldBytes, bytes));
    freeCounted(block);
  }
  return larger;
}

} // namespace

} // namespace voxc

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_MALLOC(bytes) voxc::allocateCounted(bytes)
#define STBI_REALLOC_SIZED(block, oldBytes, bytes) voxc::resizeCounted(block, oldBytes, bytes)
#define STBI_FREE(block) voxc::freeCounted(block)
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace voxc {

namespace {

/// A small file can claim an enormous image: 256 MiB decoded is enough for any texture.
constexpr std::int64_t kMostTexels = std::int64_t{1} << 26;
constexpr int kMostTexelsASide = 16384;

/// A progressive JPEG is drawn in about ten scans, each of which costs the time of the whole image.
constexpr int kMostScans = 100;

int countScans(std::span<const std::byte> bytes) {
  int scans = 0;
  for (std::size_t i = 1; i < bytes.size(); ++i)
    scans += bytes[i - 1] == std::byte{0xff} && bytes[i] == std::byte{0xda};
  return scans;
}

struct ImageSize {
  int width = 0;
  int height = 0;

  std::int64_t texels() const { return std::int64_t{width} * height; }
};

Expected<ImageSize> readSize(std::span<const std::byte> bytes) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    return Error::input("the image takes more than 2 GiB");
  ImageSize size;
  int channels = 0;
  if (!stbi_info_from_memory(reinterpret_cast<const stbi_uc *>(bytes.data()), static_cast<int>(bytes.size()),
                             &size.width, &size.height, &channels))
    return Error::input("it is no PNG, JPEG, BMP or TGA image, or a broken one");
  const std::string sides = std::to_string(size.width) + "x" + std::to_string(size.height);
  if (std::max(size.width, size.height) > kMostTexelsASide)
    return Error::input("the image has " + sides + " texels, but none may have more than 16384 a side");
  if (size.texels() > kMostTexels)
    return Error::input("the image has " + sides + " texels, but none may have more than 2^26");
  return size;
}

} // namespace

Expected<Texture> ImageDecoder::decode(std::span<const std::byte> bytes) {
  library = {0, 0, std::uint64_t{1} << 20};
  const auto size = readSize(bytes);
  if (!size)
    return size.error();
  const std::int64_t texels = size->texels();
  if (texels > texelsLeft_)
    return Error::input("the images before it have taken all of the 2^30 texels that a model may have");
  if (countScans(bytes) > kMostScans)
    return Error::input("the image has more than 100 scans");
  // The decoders hold up to 8 bytes a texel, twice, and what else a row or a tree takes.
  library.allowance = (std::uint64_t{1} << 20) + static_cast<std::uint64_t>(texels) * 24;
  Texture texture;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&freeCounted)> decoded(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc *>(bytes.data()), static_cast<int>(bytes.size()),
                            &texture.width, &texture.height, &channels, 4),
      freeCounted);
  libraryPeak_ = std::max(libraryPeak_, library.peak);
  if (!decoded || ImageSize{texture.width, texture.height}.texels() != texels)
    return Error::input(std::string("the image is broken: ") +
                        (decoded ? "its size changes" : stbi_failure_reason()));
  ScratchArray<std::uint32_t> words(memory_);
  if (auto resized = words.resize(static_cast<std::uint64_t>(texels)); !resized)
    return resized.error();
  std::memcpy(words.data(), decoded.get(), static_cast<std::size_t>(texels) * 4);
  texelsLeft_ -= texels;
  texture.texels = std::make_shared<const ScratchArray<std::uint32_t>>(std::move(words));
  return texture;
}

} // namespace voxc
