// Numbers for lists of words: equal lists have one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace voxc {

/// An open hash table whose lists lie elsewhere, one after the other.
class InternTable {
public:
  /// The number of a list among those that begin in `words` at `begins`, to which it is added if it is new.
  /// All lists of a table must come through it. None may be the beginning of another.
  std::uint32_t intern(std::span<const std::uint32_t> list, std::vector<std::uint32_t> &words,
                       std::vector<std::uint64_t> &begins);

private:
  struct Entry {
    std::uint32_t number = 0; ///< From 1 on; 0: free.
    std::uint32_t hash = 0;
  };

  void grow();

  std::vector<Entry> entries_;
  std::size_t used_ = 0;
};

} // namespace voxc
