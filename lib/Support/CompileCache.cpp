// The folder of compiled code.
#include "voxc/Support/CompileCache.h"

#include "voxc/Support/File.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace voxc {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".compiled";
constexpr std::string_view kMagic = "voxccode";
constexpr std::size_t kHeadBytes = kMagic.size() + sizeof(XXH128_canonical_t);

/// After a trim there is room for some more.
constexpr double kTrimmedShare = 0.75;

XXH128_canonical_t digestOf(std::string_view bytes) {
  XXH128_canonical_t digest;
  XXH128_canonicalFromHash(&digest, XXH3_128bits(bytes.data(), bytes.size()));
  return digest;
}

/// Which voxc this is: the time and size of the program or library that this code is in. A version's number
/// would not change while voxc is worked on.
std::string identityOfCode() {
  Dl_info info{};
  struct stat file{};
  const auto *const address = reinterpret_cast<const void *>(&identityOfCode);
  const bool isKnown = dladdr(address, &info) != 0 && info.dli_fname && stat(info.dli_fname, &file) == 0;
  if (!isKnown && stat("/proc/self/exe", &file) != 0)
    return "";
  return std::to_string(file.st_size) + " " + std::to_string(file.st_mtim.tv_sec) + " " +
         std::to_string(file.st_mtim.tv_nsec);
}

struct Entry {
  fs::path path;
  std::uint64_t bytes;
  fs::file_time_type used;
};

/// Those of a folder; other processes may remove some meanwhile.
std::vector<Entry> entriesOf(const std::string &folder) {
  std::vector<Entry> entries;
  std::error_code failure;
  for (fs::directory_iterator at(folder, failure), end; !failure && at != end; at.increment(failure)) {
    if (!at->path().native().ends_with(kEnding))
      continue;
    std::error_code gone;
    const std::uint64_t bytes = at->file_size(gone);
    const fs::file_time_type used = at->last_write_time(gone);
    if (!gone)
      entries.push_back({at->path(), bytes, used});
  }
  return entries;
}

} // namespace

Expected<CompileCache> CompileCache::open(std::string folder, std::uint64_t mostBytes) {
  std::error_code failure;
  fs::create_directories(fs::path(folder).parent_path(), failure);
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
    return Error::environment("cannot make the folder '" + folder + "': " + std::strerror(errno));
  struct stat status{};
  if (stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
    return Error::environment("'" + folder + "' is no folder");
  if (status.st_uid != geteuid() || (status.st_mode & (S_IWGRP | S_IWOTH)) != 0)
    return Error::environment("'" + folder +
                              "' can be written to by others; compiled code must be nobody else's");
  return CompileCache(std::move(folder), mostBytes);
}

std::string CompileCache::pathOf(std::string_view kind, std::span<const std::string_view> parts) const {
  static const std::string identity = identityOfCode();
  if (identity.empty())
    return "";
  std::string all;
  const auto add = [&all](std::string_view part) {
    const std::uint64_t size = part.size();
    all.append(reinterpret_cast<const char *>(&size), sizeof size).append(part);
  };
  add(identity);
  for (const std::string_view part : parts)
    add(part);
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string path = folder_ + "/" + std::string(kind) + "-";
  for (const unsigned char byte : digestOf(all).digest)
    path.append({kDigits[byte >> 4], kDigits[byte & 15]});
  return path.append(kEnding);
}

std::optional<std::string> CompileCache::find(std::string_view kind,
                                              std::span<const std::string_view> parts) const {
  const std::string path = pathOf(kind, parts);
  Expected<std::string> file = path.empty() ? Error::environment("") : readTextFile(path);
  if (!file)
    return std::nullopt;
  const std::string_view bytes = std::string_view(*file).substr(std::min(kHeadBytes, file->size()));
  const XXH128_canonical_t digest = digestOf(bytes);
  if (file->size() < kHeadBytes || !file->starts_with(kMagic) ||
      std::memcmp(file->data() + kMagic.size(), &digest, sizeof digest) != 0) {
    ::unlink(path.c_str());
    return std::nullopt;
  }
  ::utimensat(AT_FDCWD, path.c_str(), nullptr, 0); // It was used now.
  return std::string(bytes);
}

void CompileCache::store(std::string_view kind, std::span<const std::string_view> parts,
                         std::string_view bytes) const {
  const std::string path = pathOf(kind, parts);
  if (path.empty() || bytes.size() + kHeadBytes > mostBytes_)
    return;
  const XXH128_canonical_t digest = digestOf(bytes);
  std::string file(kMagic);
  file.append(reinterpret_cast<const char *>(&digest), sizeof digest).append(bytes);
  if (writeFile(path, file))
    trim();
}

CompileCache::Usage CompileCache::usage() const {
  Usage usage;
  for (const Entry &entry : entriesOf(folder_))
    usage.entries += 1, usage.bytes += entry.bytes;
  return usage;
}

Expected<void> CompileCache::clear() const {
  for (const Entry &entry : entriesOf(folder_))
    if (::unlink(entry.path.c_str()) != 0 && errno != ENOENT)
      return Error::environment("cannot remove '" + entry.path.native() + "': " + std::strerror(errno));
  return {};
}

/// Gives up entries, those first that were longest without use, once they are too many.
void CompileCache::trim() const {
  std::vector<Entry> entries = entriesOf(folder_);
  std::uint64_t bytes = 0;
  for (const Entry &entry : entries)
    bytes += entry.bytes;
  if (bytes <= mostBytes_)
    return;
  std::ranges::sort(entries, {}, &Entry::used);
  for (const Entry &entry : entries) {
    if (double(bytes) <= kTrimmedShare * double(mostBytes_))
      return;
    ::unlink(entry.path.c_str());
    bytes -= entry.bytes;
  }
}

} // namespace voxc
