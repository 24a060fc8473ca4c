// The folder of compiled code.
#include "voxc/Support/CompileCache.h"

#include "Support/Platform/Code.h"
#include "Support/Platform/File.h"
#include "Support/Platform/Path.h"
#include "voxc/Support/File.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
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
  return platform::identityOfCode(reinterpret_cast<const void *>(&identityOfCode));
}

struct Entry {
  std::string path;
  std::uint64_t bytes;
  fs::file_time_type used;
};

/// Those of a folder; other processes may remove some meanwhile.
std::vector<Entry> entriesOf(const std::string &folder) {
  std::vector<Entry> entries;
  std::error_code failure;
  for (fs::directory_iterator at(platform::pathFrom(folder), failure), end; !failure && at != end;
       at.increment(failure)) {
    if (!platform::utf8From(at->path()).ends_with(kEnding))
      continue;
    std::error_code gone;
    const std::uint64_t bytes = at->file_size(gone);
    const fs::file_time_type used = at->last_write_time(gone);
    if (!gone)
      entries.push_back({platform::utf8From(at->path()), bytes, used});
  }
  return entries;
}

} // namespace

Expected<CompileCache> CompileCache::open(std::string folder, std::uint64_t mostBytes) {
  std::error_code failure;
  fs::create_directories(platform::pathFrom(folder).parent_path(), failure);
  if (!platform::makeOwnFolder(folder))
    return Error::environment("cannot make the folder '" + folder + "': " + std::strerror(errno));
  const platform::Folder ownership = platform::ownershipOf(folder);
  if (ownership == platform::Folder::None)
    return Error::environment("'" + folder + "' is no folder");
  if (ownership == platform::Folder::OfOthers)
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
    platform::removeFile(path);
    return std::nullopt;
  }
  platform::touch(path); // It was used now.
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
    if (!platform::removeFile(entry.path) && errno != ENOENT)
      return Error::environment("cannot remove '" + entry.path + "': " + std::strerror(errno));
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
    platform::removeFile(entry.path);
    bytes -= entry.bytes;
  }
}

} // namespace voxc
