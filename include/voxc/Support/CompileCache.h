// What was compiled before, kept in a folder under what it was compiled from.
#pragma once

#include "voxc/Support/Error.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace voxc {

/// A folder of compiled code that any number of processes share: an entry is whole or not there. It stays
/// below a bound by giving up what was longest without use. Entries are found by a 128-bit digest of all that
/// they were made of, voxc itself included, so that no version sees what another made; one that is damaged is
/// as good as none. Nothing here fails loudly: without a folder that can be used, everything is compiled
/// anew.
class CompileCache {
public:
  /// A quarter of a gigabyte: some thousands of kernels.
  static constexpr std::uint64_t kDefaultBytes = std::uint64_t{1} << 28;

  /// Opens a folder, which is made if need be. Compiled code is executed: an error (`Environment`) if the
  /// folder belongs to someone else, or others may write to it; also if it cannot be made.
  static Expected<CompileCache> open(std::string folder, std::uint64_t mostBytes = kDefaultBytes);

  /// What was stored as of `kind`, a word of letters, under the same `parts`, which are texts of any bytes.
  std::optional<std::string> find(std::string_view kind, std::span<const std::string_view> parts) const;
  /// Stores it, if that is possible.
  void store(std::string_view kind, std::span<const std::string_view> parts, std::string_view bytes) const;

  struct Usage {
    std::uint64_t entries = 0;
    std::uint64_t bytes = 0;
  };
  Usage usage() const;
  std::uint64_t mostBytes() const { return mostBytes_; }
  const std::string &folder() const { return folder_; }

  /// Removes all entries. Error: `Environment`, one that cannot be removed.
  Expected<void> clear() const;

private:
  CompileCache(std::string folder, std::uint64_t mostBytes)
      : folder_(std::move(folder)), mostBytes_(mostBytes) {}
  std::string pathOf(std::string_view kind, std::span<const std::string_view> parts) const;
  void trim() const;

  std::string folder_;
  std::uint64_t mostBytes_;
};

} // namespace voxc
