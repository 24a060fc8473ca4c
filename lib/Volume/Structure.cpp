// Proving that a volume's words are safe and well-formed, before any kernel sees them.
#include "voxc/Volume/Volume.h"

#include <array>
#include <map>
#include <utility>

namespace voxc {

bool WordReader::require(std::uint64_t offset, std::uint64_t count, const char *what) {
  if (offset <= words_.size() && count <= words_.size() - offset)
    return true;
  fail(std::string(what) + " at word " + std::to_string(offset) + " needs " + std::to_string(count) +
       " words, but the volume has " + std::to_string(words_.size()));
  return false;
}

namespace {

/// A set of word offsets, paged so that it costs what is visited.
class OffsetSet {
public:
  explicit OffsetSet(std::uint64_t words) : pages_(words / kPageBits + 1) {}

  /// True if the offset was not in the set before.
  bool insert(std::uint64_t offset) {
    auto &page = pages_[offset / kPageBits];
    if (!page)
      page = std::make_unique<Page>();
    std::uint64_t &bits = (*page)[offset % kPageBits / 64];
    const std::uint64_t bit = std::uint64_t{1} << (offset % 64);
    const bool isNew = (bits & bit) == 0;
    bits |= bit;
    return isNew;
  }

private:
  static constexpr std::uint64_t kPageBits = 1 << 15;
  using Page = std::array<std::uint64_t, kPageBits / 64>;
  std::vector<std::unique_ptr<Page>> pages_;
};

/// Walks all levels. A node may be shared across parents and heights, so each is visited once a (level,
/// height), which bounds the work however a hostile file ties its nodes together.
class StructureCheck final : public SubVolumeVisitor {
public:
  StructureCheck(const Format &format, std::span<const std::uint32_t> words)
      : format_(format), words_(words), seen_(format.levels.size()), gridWords_(format.levels.size()) {}

  Expected<void> run() {
    if (words_.size() == 0 || words_.size() > std::uint64_t{1} << 32)
      return Error::input("a volume has 1 to 2^32 words, not " + std::to_string(words_.size()));
    const std::uint32_t root = words_[0];
    if (root == 0 && words_.size() == 1)
      return {};
    enterSubVolume(0, root);
    if (words_.problem())
      return Error::input("the volume's structure is broken: " + *words_.problem());
    return {};
  }

  bool enterNode(std::uint32_t offset, int height) override {
    if (offset == 0 || offset >= words_.size()) {
      words_.fail("a pointer of level " + std::to_string(level_ + 1) + " leads to word " +
                  std::to_string(offset) + " of " + std::to_string(words_.size()));
      return false;
    }
    const auto [set, isNew] = seen_[level_].try_emplace(height, words_.size());
    return set->second.insert(offset) && spendGrid();
  }

  void cells(const Cube &, std::uint32_t value) override {
    if (level_ + 1 < format_.levels.size())
      enterSubVolume(level_ + 1, value);
  }

  bool done() const override { return words_.problem().has_value(); }

private:
  /// The grids of a level never overlap. Overlapping ones would let a small file ask for unbounded work.
  bool spendGrid() {
    const Level &level = format_.levels[level_];
    if (level.kind->arrangement != Arrangement::Grid)
      return true;
    const Int3 size = level.log2Size();
    gridWords_[level_] += std::uint64_t{level.kind->wordsPerCell} << (size.x + size.y + size.z);
    if (gridWords_[level_] <= words_.size())
      return true;
    words_.fail("the grids of level " + std::to_string(level_ + 1) + " overlap or lie outside");
    return false;
  }

  void enterSubVolume(std::size_t level, std::uint32_t offset) {
    if (words_.problem())
      return;
    const std::size_t above = std::exchange(level_, level);
    if (offset == 0)
      words_.fail("level " + std::to_string(level + 1) + " has a sub-volume at word 0");
    else
      format_.levels[level].kind->walk(words_, format_.levels[level], offset, *this);
    level_ = above;
  }

  const Format &format_;
  WordReader words_;
  std::vector<std::map<int, OffsetSet>> seen_; ///< For each level, by height.
  std::vector<std::uint64_t> gridWords_;       ///< For each level, the words of the grids entered.
  std::size_t level_ = 0;
};

} // namespace

Expected<void> checkStructure(const Format &format, std::span<const std::uint32_t> words) {
  return StructureCheck(format, words).run();
}

} // namespace voxc
