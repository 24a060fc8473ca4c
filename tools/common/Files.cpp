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

} // namespace

Expected<void> writeText(const std::string &path, std::string_view text) {
  return path == kStandardStream ? writeStandardOutput(text) : writeFile(path, text);
}

Expected<void> writeBytes(const std::string &path, std::span<const std::byte> bytes) {
  return writeText(path, {reinterpret_cast<const char *>(bytes.data()), bytes.size()});
}

Expected<RayFile> readRayFile(const std::string &path) {
  if (path == kStandardStream) {
    std::string text(std::istreambuf_iterator<char>(std::cin), {});
    return parseRayFile(std::as_bytes(std::span(text)), "standard input");
  }
  auto file = MappedFile::open(path);
  if (!file)
    return file.error();
  return parseRayFile(file->bytes(), path);
}

Expected<std::vector<Ray>> readRays(const std::string &path) {
  Expected<RayFile> file = readRayFile(path);
  if (!file)
    return file.error();
  if (file->rays().isBounded())
    return Error::input(path +
                        " has rays with bounds, of version 2; here rays without are wanted, of version 1");
  return std::move(*file).takeRays();
}

Expected<std::vector<Hit>> readHits(const std::string &path) {
  auto file = MappedFile::open(path);
  if (!file)
    return file.error();
  const std::span<const std::byte> bytes = file->bytes();
  if (bytes.size() % sizeof(Hit) != 0)
    return Error::input(path + " has " + std::to_string(bytes.size()) +
                        " bytes, but hits are 6 words each: it should have a multiple of 24");
  std::vector<Hit> hits(bytes.size() / sizeof(Hit));
  if (!hits.empty())
    std::memcpy(hits.data(), bytes.data(), bytes.size());
  return hits;
}

Expected<void> writeHits(const std::string &path, std::span<const Hit> hits) {
  return writeBytes(path, std::as_bytes(hits));
}

} // namespace voxc::tool
