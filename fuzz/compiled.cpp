// Fuzzes entries of the folder of compiled code: what is not whole is as good as not there, and is gone when
// it was asked for. Of an odd first byte the digest of the rest is put right.
#include "Expect.h"
#include "FuzzedFile.h"

#include "voxc/Support/CompileCache.h"
#include "voxc/Support/File.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <array>
#include <cstring>

namespace {

using namespace voxc;
using fuzz::expect;

constexpr std::size_t kDigestAt = 8;
constexpr std::size_t kHeadBytes = kDigestAt + sizeof(XXH128_canonical_t);
constexpr std::array<std::string_view, 2> kParts = {"source", "options"};

const CompileCache &cache() {
  static const std::string folder =
      std::filesystem::path(fuzz::folder().write("x", "")).parent_path() / "compiled";
  static const Expected<CompileCache> cache = CompileCache::open(folder);
  return *cache;
}

/// Where the one entry lies.
std::string entryPath() {
  cache().store("object", kParts, "whole");
  return std::filesystem::directory_iterator(cache().folder())->path();
}

std::string digestOf(std::string_view bytes) {
  XXH128_canonical_t digest;
  XXH128_canonicalFromHash(&digest, XXH3_128bits(bytes.data(), bytes.size()));
  return {reinterpret_cast<const char *>(&digest), sizeof digest};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  static const std::string path = entryPath();
  if (size == 0)
    return 0;
  std::string entry(fuzz::textOf(data, size).substr(1));
  if (data[0] % 2 == 1 && entry.size() >= kHeadBytes)
    entry.replace(kDigestAt, sizeof(XXH128_canonical_t),
                  digestOf(std::string_view(entry).substr(kHeadBytes)));
  std::ofstream(path, std::ios::binary | std::ios::trunc) << entry;
  const auto found = cache().find("object", kParts);
  const bool isWhole =
      entry.size() >= kHeadBytes && entry.starts_with("voxccode") &&
      entry.substr(kDigestAt, sizeof(XXH128_canonical_t)) == digestOf(entry.substr(kHeadBytes));
  expect(found.has_value() == isWhole && std::filesystem::exists(path) == isWhole);
  expect(!found || *found == entry.substr(kHeadBytes));
  return 0;
}
