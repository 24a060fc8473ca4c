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

/// `source` names the bytes in errors.
Expected<std::vector<Ray>> parseRays(std::span<const std::byte> bytes, const std::string &source) {
  if (bytes.size() % sizeof(Ray) != 0)
    return Error::input(source + " has " + std::to_string(bytes.size()) +
                        " bytes, but rays are 6 float32 each: it should have a multiple of 24");
  std::vector<Ray> rays(bytes.size() / sizeof(Ray));
  if (!rays.empty())
    std::memcpy(rays.data(), bytes.data(), bytes.size());
  return rays;
}

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
    return parseRays(std::as_bytes(std::span(text)), "standard input");
  }
  auto file = MappedFile::open(path);
  if (!file)
    return file.error();
  return parseRays(file->bytes(), path);
}

Expected<void> writeHits(const std::string &path, std::span<const Hit> hits) {
  return writeBytes(path, std::as_bytes(hits));
}

} // namespace voxc::tool
