// Files of the tools.
#include "Files.h"

#include "voxc/Support/File.h"

#include <cstdio>
#include <cstring>
#include <iostream>
#include <iterator>

namespace voxc::tool {
namespace {

constexpr std::string_view kStandardStream = "-";

Expected<void> writeStandardOutput(std::string_view bytes) {
  std::size_t written = std::fwrite(bytes.data(), 1, bytes.size(), stdout);
  if (written != bytes.size() || std::fflush(stdout) != 0)
    return Error::environment("cannot write to standard output");
  return {};
}

/// Rays or hits. `source` names the bytes in errors, `form` what a record is.
template <typename Item>
Expected<std::vector<Item>> parse(std::span<const std::byte> bytes, const std::string &source,
                                  const char *form) {
  if (bytes.size() % sizeof(Item) != 0)
    return Error::input(source + " has " + std::to_string(bytes.size()) + " bytes, but " + form +
                        " each: it should have a multiple of 24");
  std::vector<Item> items(bytes.size() / sizeof(Item));
  if (!items.empty())
    std::memcpy(items.data(), bytes.data(), bytes.size());
  return items;
}

constexpr const char *kRayForm = "rays are 6 float32", *kHitForm = "hits are 6 words";

} // namespace

Expected<void> writeText(const std::string &path, std::string_view text) {
  return path == kStandardStream ? writeStandardOutput(text) : writeFile(path, text);
}

Expected<void> writeBytes(const std::string &path, std::span<const std::byte> bytes) {
  return writeText(path, {reinterpret_cast<const char *>(bytes.data()), bytes.size()});
}

Expected<std::vector<Ray>> readRays(const std::string &path) {
  if (path == kStandardStream) {
    std::string text(std::istreambuf_iterator<char>(std::cin), {});
    return parse<Ray>(std::as_bytes(std::span(text)), "standard input", kRayForm);
  }
  auto file = MappedFile::open(path);
  if (!file)
    return file.error();
  return parse<Ray>(file->bytes(), path, kRayForm);
}

Expected<std::vector<Hit>> readHits(const std::string &path) {
  auto file = MappedFile::open(path);
  if (!file)
    return file.error();
  return parse<Hit>(file->bytes(), path, kHitForm);
}

Expected<void> writeHits(const std::string &path, std::span<const Hit> hits) {
  return writeBytes(path, std::as_bytes(hits));
}

} // namespace voxc::tool
