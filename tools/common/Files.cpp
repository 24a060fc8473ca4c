// Files of the tools.
#include "Files.h"

#include "voxc/Support/File.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <iterator>
#include <poll.h>
#include <unistd.h>

namespace voxc::tool {
namespace {

constexpr std::string_view kStandardStream = "-";

bool isReaderGone() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

/// Why standard output took no more. Who reads it may have enough: then this ends the process by the signal
/// that ends other tools, without a word.
Error outputFailure(int why) {
  if (why == EPIPE || isReaderGone()) {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  return Error::environment("cannot write to standard output" +
                            (why == 0 ? "" : std::string(": ") + std::strerror(why)));
}

Expected<void> writeStandardOutput(std::string_view bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size())
    return outputFailure(errno);
  return flushStandardOutput();
}

} // namespace

Expected<void> flushStandardOutput() {
  if (std::fflush(stdout) != 0)
    return outputFailure(errno);
  // What was written before may have failed unseen.
  return std::ferror(stdout) == 0 ? Expected<void>() : outputFailure(0);
}

Expected<void> writeText(const std::string &path, std::string_view text) {
  return path == kStandardStream ? writeStandardOutput(text) : writeFile(path, text);
}

bool hasEnding(std::string_view path, std::string_view ending) {
  const auto lower = [](unsigned char c) { return std::tolower(c); };
  return path.size() >= ending.size() &&
         std::ranges::equal(path.substr(path.size() - ending.size()), ending, {}, lower, lower);
}

Expected<void> writeBytes(const std::string &path, std::span<const std::byte> bytes) {
  return writeText(path, {reinterpret_cast<const char *>(bytes.data()), bytes.size()});
}

Expected<RayFile> readRayFile(const std::string &path) {
  if (path == kStandardStream) {
    std::string text(std::istreambuf_iterator<char>(std::cin), {});
    return parseRayFile(std::as_bytes(std::span(text)), "standard input");
  }
  auto file = VOXC_TRY(MappedFile::open(path));
  return parseRayFile(file.bytes(), path);
}

Expected<std::vector<Ray>> readRays(const std::string &path) {
  auto file = VOXC_TRY(readRayFile(path));
  if (file.rays().isBounded())
    return Error::input(path +
                        " has rays with bounds, of version 2; here rays without are wanted, of version 1");
  return std::move(file).takeRays();
}

Expected<std::vector<Hit>> readHits(const std::string &path) {
  auto file = VOXC_TRY(MappedFile::open(path));
  const std::span<const std::byte> bytes = file.bytes();
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
