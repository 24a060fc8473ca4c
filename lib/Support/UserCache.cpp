// The folders of the user's cache.
#include "voxc/Support/UserCache.h"

#include <cstdlib>
#include <optional>

namespace voxc {

namespace {

std::string environment(const char *name) {
  const char *value = std::getenv(name);
  return value ? value : "";
}

std::optional<CompileCache> openCompileCache() {
  const std::string folder = compileCacheFolder();
  Expected<CompileCache> cache = folder.empty() ? Error::environment("") : CompileCache::open(folder);
  return cache ? std::optional(std::move(*cache)) : std::nullopt;
}

} // namespace

std::filesystem::path userCache() {
  if (const std::string cache = environment("XDG_CACHE_HOME"); !cache.empty())
    return std::filesystem::path(cache) / "voxc";
  const std::string home = environment("HOME");
  return home.empty() ? std::filesystem::path() : std::filesystem::path(home) / ".cache" / "voxc";
}

std::string compileCacheFolder() {
  if (const std::string named = environment("VOXC_CACHE"); !named.empty())
    return named == "off" ? "" : named;
  const std::filesystem::path cache = userCache();
  return cache.empty() ? "" : (cache / "compiled").string();
}

const CompileCache *compileCache() {
  static const std::optional<CompileCache> cache = openCompileCache();
  return cache ? &*cache : nullptr;
}

} // namespace voxc
