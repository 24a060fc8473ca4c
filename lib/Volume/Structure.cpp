// Proving that a volume's words are safe and well-formed, before any kernel sees them.
#include "Structure.h"

#include "voxc/Layout/SubVolume.h"
#include "voxc/Layout/Values.h"
#include "voxc/Volume/Volume.h"

#include "Support/HashTable.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace voxc {

namespace {

/// The voxels of nodes, by what refers to them.
class NodeCounts {
public:
  /// 0 if the node is not known.
  std::uint64_t find(Ref ref) const {
    const std::uint32_t *voxels = voxels_.find(ref);
    return !voxels ? 0 : *voxels < kLarge ? *voxels : large_[*voxels - kLarge];
  }

  void fetch(Ref ref) const { voxels_.fetch(ref); }

  /// `ref` is not 0 and not known yet; it has at least one voxel.
  void insert(Ref ref, std::uint64_t voxels) {
    voxels_[ref] = static_cast<std::uint32_t>(voxels < kLarge ? voxels : kLarge + large_.size());
    if (voxels >= kLarge)
      large_.push_back(voxels);
  }

private:
  /// Numbers of voxels from here on stand in `large_`, and their entries say where.
  static constexpr std::uint64_t kLarge = std::uint64_t{1} << 31;
  /// Nodes that lie next to each other in the file are looked for at one time, so their entries do too.
  static constexpr int kLog2Neighbours = 4;

  HashTable<std::uint32_t, Ref, kLog2Neighbours> voxels_;
  std::vector<std::uint64_t> large_;
};

/// Traverses all levels. A node may be shared across parents and heights, so its voxels are counted once a
/// (level, height), which bounds the work however a hostile file ties its nodes together. Low nodes are most
/// of all and soon counted: they are counted anew instead of remembered.
class StructureCheck final : public SubVolumeVisitor {
public:
  StructureCheck(const Layout &layout, std::span<const std::uint32_t> words, const KeepOn &keepOn)
      : layout_(layout), words_(layout.reader(words)), keepOn_(keepOn), gridWords_(layout.strata.size()) {
    for (const Stratum &stratum : layout.strata)
      known_.emplace_back(static_cast<std::size_t>(maxComponent(stratum.log2Size())) + 1);
  }

  Expected<std::uint64_t> run() {
    VOXC_TRY(checkSize());
    const std::uint32_t root = words_[0];
    if (root == 0 && words_.size() == layout_.headWords())
      return std::uint64_t{0};
    enterRoot(root);
    if (layout_.ranksVoxels() && !words_.problem())
      checkSection(words_.wordOf(words_[1]));
    return outcome();
  }

  /// Nodes that an earlier frame had are known, and not gone through again.
  Expected<void> run(std::span<const Frame> frames) {
    VOXC_TRY(checkSize());
    for (std::size_t i = 0; i < frames.size() && !done(); ++i) {
      voxels_ = 0;
      if (frames[i].root != 0)
        enterRoot(frames[i].root);
      if (!done() && voxels_ != frames[i].voxels)
        words_.fail("frame " + std::to_string(i + 1) + " holds " + std::to_string(voxels_) +
                    " voxels, and is said to hold " + std::to_string(frames[i].voxels));
    }
    const auto checked = outcome();
    return checked ? Expected<void>() : checked.error();
  }

  bool enterNode(std::uint64_t offset, int height, Ranks ranks) override {
    // Grids of an array check for themselves what words they are.
    const std::uint64_t begin = beginOf(layout_.strata[level_], offset);
    if (begin == 0 || (begin >= words_.size() && !layout_.strata[level_].inArray())) {
      words_.fail("a pointer of level " + std::to_string(level_ + 1) + " leads to word " +
                  std::to_string(begin) + " of " + std::to_string(words_.size()));
      return false;
    }
    checkFirst(ranks);
    if (const std::uint64_t voxels =
            isRemembered(level_, height) ? known(level_, height).find(refOf(offset)) : 0) {
      voxels_ += voxels;
      checkCount(ranks, voxels);
      return false;
    }
    if (!spendGrid(offset) || !mayGoOn())
      return false;
    entered_.push_back({offset, height, voxels_, ranks});
    return true;
  }

  void leaveNode() override {
    const Node node = entered_.back();
    entered_.pop_back();
    if (done())
      return;
    const std::uint64_t voxels = voxels_ - node.voxelsBefore;
    checkCount(node.ranks, voxels);
    if (voxels == 0)
      words_.fail("what level " + std::to_string(level_ + 1) + " has at word " + std::to_string(node.offset) +
                  " holds no voxel");
    else if (isRemembered(level_, node.height))
      known(level_, node.height).insert(refOf(node.offset), voxels);
  }

  void foreseeNode(std::uint64_t offset, int height) override {
    if (isRemembered(level_, height))
      known(level_, height).fetch(refOf(offset));
  }

  void foreseeCell(std::uint32_t value) override {
    if (layout_.holdsVoxels(level_))
      return;
    const int height = maxComponent(layout_.strata[level_ + 1].log2Size());
    words_.fetch(beginOf(layout_.strata[level_ + 1], words_.wordOf(value)));
    if (isRemembered(level_ + 1, height))
      known(level_ + 1, height).fetch(value);
  }

  /// Nodes that are counted anew each time, unless their ranks must be compared.
  bool countsCells(int height) const override {
    return layout_.holdsVoxels(level_) &&
           (height == 0 || (!isRemembered(level_, height) && !layout_.ranksVoxels()));
  }
  void countCells(std::uint64_t count) override { voxels_ += count; }

  void cells(const Cube &cube, std::uint32_t value, Ranks ranks) override {
    // The cells of a grid of voxels have ranks in an order of their own, which its masks tell.
    if (!(layout_.strata[level_].isGrid() && layout_.strata[level_].implied))
      checkFirst(ranks);
    const std::uint64_t cells = std::uint64_t{1} << (3 * cube.log2Side);
    const std::uint64_t before = voxels_;
    if (!layout_.holdsVoxels(level_))
      enterSubVolume(level_ + 1, value);
    else
      ++voxels_;
    // No more than the format has: 2^63 at most.
    voxels_ = before + (voxels_ - before) * cells;
    checkCount(ranks, voxels_ - before);
  }

  bool done() const override { return interrupted_ || words_.problem().has_value(); }

private:
  Expected<void> checkSize() const {
    if (words_.size() < layout_.headWords() || words_.size() > layout_.maxWords())
      return Error::input("a volume of this format has " + std::to_string(layout_.headWords()) + " to 2^" +
                          std::to_string(std::bit_width(layout_.maxWords()) - 1) + " words, not " +
                          std::to_string(words_.size()));
    return {};
  }

  void enterRoot(Ref root) {
    enterSubVolume(0, root);
    if (layout_.hasOneColour() && words_[1] == 0)
      words_.fail("the colour of all voxels is the word 0, which is no voxel");
  }

  Expected<std::uint64_t> outcome() const {
    if (interrupted_)
      return Error::interrupted();
    if (words_.problem())
      return Error::input("the volume's structure is broken: " + *words_.problem());
    return voxels_;
  }

  struct Node {
    std::uint64_t offset;
    int height;
    std::uint64_t voxelsBefore;
    Ranks ranks;
  };

  static constexpr int kLowestRemembered = 3;
  static constexpr std::uint64_t kNodesBetweenLooks = 1024;

  bool mayGoOn() {
    if (keepOn_ && ++looks_ % kNodesBetweenLooks == 0)
      interrupted_ |= !keepOn_();
    return !interrupted_;
  }

  Ref refOf(std::uint64_t offset) const { return layout_.refOf(offset); }
  NodeCounts &known(std::size_t level, int height) { return known_[level][static_cast<std::size_t>(height)]; }

  /// Grids of an array are counted as soon as they are found again.
  bool isRemembered(std::size_t level, int height) const {
    return height >= kLowestRemembered ||
           (height == maxComponent(layout_.strata[level].log2Size()) && !layout_.strata[level].inArray());
  }

  /// The grids of a level never overlap. Overlapping ones would let a small file ask for unbounded work.
  /// Those of an array have places of their own by their numbers.
  bool spendGrid(std::uint64_t offset) {
    const Stratum &stratum = layout_.strata[level_];
    if (!stratum.isGrid() || stratum.inArray())
      return true;
    const std::uint64_t size = stratum.slots->size(words_, stratum, offset);
    gridWords_[level_] += size;
    if (gridWords_[level_] > words_.size())
      words_.fail("the grids of level " + std::to_string(level_ + 1) + " overlap or lie outside");
    else if (!stratum.slots->hasEmptySlots)
      checkReach(size, "a grid of level " + std::to_string(level_ + 1));
    return !words_.problem();
  }

  /// Where references count granules, kernels reach so many words behind one.
  void checkReach(std::uint64_t words, const std::string &what) {
    if (words > layout_.maxNodeWords())
      words_.fail(what + " has " + std::to_string(words) + " words, more than a kernel can reach");
  }

  void checkSection(std::uint64_t section) {
    checkValues(words_, layout_, voxels_);
    checkReach(words_.size() - std::min(section, words_.size()), "the section of values");
  }

  /// Ranks lead to values: they must be what the voxels found so far make them.
  void checkFirst(Ranks ranks) {
    if (layout_.ranksVoxels() && ranks.first != voxels_ - subVolumeBegin_)
      words_.fail("level " + std::to_string(level_ + 1) + " counts " + std::to_string(ranks.first) +
                  " voxels before a cell that has " + std::to_string(voxels_ - subVolumeBegin_));
  }
  void checkCount(Ranks ranks, std::uint64_t voxels) {
    if (ranks.count != 0 && ranks.count != voxels)
      words_.fail("level " + std::to_string(level_ + 1) + " counts " + std::to_string(ranks.count) +
                  " voxels where there are " + std::to_string(voxels));
  }

  void enterSubVolume(std::size_t level, Ref ref) {
    if (words_.problem())
      return;
    const std::size_t above = std::exchange(level_, level);
    const std::uint64_t beginAbove = std::exchange(subVolumeBegin_, voxels_);
    if (ref == 0)
      words_.fail("level " + std::to_string(level + 1) + " has a sub-volume at word 0");
    else
      visitSubVolume(words_, layout_.strata[level], words_.wordOf(ref), *this);
    level_ = above;
    subVolumeBegin_ = beginAbove;
  }

  const Layout &layout_;
  WordReader words_;
  const KeepOn &keepOn_;
  std::uint64_t looks_ = 0;
  bool interrupted_ = false;
  std::vector<std::vector<NodeCounts>> known_; ///< For each level, by height.
  std::vector<std::uint64_t> gridWords_;       ///< For each level, the words of the grids entered.
  std::vector<Node> entered_;
  std::size_t level_ = 0;
  std::uint64_t voxels_ = 0;         ///< Found so far,
  std::uint64_t subVolumeBegin_ = 0; ///< and when the sub-volume at hand was entered.
};

} // namespace

Expected<std::uint64_t> checkStructure(const Layout &layout, std::span<const std::uint32_t> words,
                                       const KeepOn &keepOn) {
  return StructureCheck(layout, words, keepOn).run();
}

Expected<void> checkStructure(const Layout &layout, std::span<const std::uint32_t> words,
                              std::span<const Frame> frames, const KeepOn &keepOn) {
  return StructureCheck(layout, words, keepOn).run(frames);
}

Expected<std::uint64_t> checkStructure(const Format &format, std::span<const std::uint32_t> words,
                                       const KeepOn &keepOn) {
  return checkStructure(layoutOf(format), words, keepOn);
}

} // namespace voxc
