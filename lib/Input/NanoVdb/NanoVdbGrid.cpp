// Checking a grid, and finding its cells.
#include "Input/NanoVdb/NanoVdbGrid.h"

#include "Source/NanoVdbLayout.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>

namespace voxc {

namespace {

template <typename T> T load(const std::byte *at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

/// How a level of inner nodes lies.
struct NodeLevel {
  int log2Child;
  int log2Children;
  std::uint32_t bytes;
  std::uint32_t isActive;
  std::uint32_t isChild;
  std::uint32_t table;

  std::uint32_t children() const { return 1u << 3 * log2Children; }
  bool bit(const std::byte *node, std::uint32_t mask, std::uint32_t slot) const {
    return (std::to_integer<unsigned>(node[mask + slot / 8]) >> slot % 8 & 1) != 0;
  }
  const std::byte *entry(const std::byte *node, std::uint32_t slot) const {
    return node + table + std::size_t{8} * slot;
  }
  Int3 lowOf(Int3 low, std::uint32_t slot) const {
    const auto part = [&](int shift) {
      return static_cast<std::int32_t>(slot >> shift & ((1u << log2Children) - 1)) << log2Child;
    };
    return low + Int3{part(2 * log2Children), part(log2Children), part(0)};
  }
};

template <typename Node> constexpr NodeLevel shapeOf(int log2Child, int log2Children) {
  return {log2Child,
          log2Children,
          sizeof(Node),
          offsetof(Node, isActive),
          offsetof(Node, isChild),
          offsetof(Node, table)};
}

constexpr NodeLevel kUpperShape =
    shapeOf<nanovdb::Upper>(nanovdb::kLog2Lower, nanovdb::kLog2Upper - nanovdb::kLog2Lower);
constexpr NodeLevel kLowerShape =
    shapeOf<nanovdb::Lower>(nanovdb::kLog2Leaf, nanovdb::kLog2Lower - nanovdb::kLog2Leaf);

/// The child of a node, which was checked.
const std::byte *childOf(const NodeLevel &shape, const std::byte *node, std::uint32_t slot) {
  return node + load<std::int64_t>(shape.entry(node, slot));
}

std::uint32_t slotOf(const NodeLevel &shape, Int3 cell) {
  return nanovdb::childOf(cell, shape.log2Child, shape.log2Children);
}

Int3 lowOfKey(std::uint64_t key) {
  const auto part = [&](int shift) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(key >> shift & 0x1fffff)
                                     << nanovdb::kLog2Upper);
  };
  return {part(42), part(21), part(0)};
}

/// A number as the map of a grid has it. One that is not finite makes all of it the map that moves nothing.
Transform mapOf(const nanovdb::Map &map) {
  std::array<double, 12> rows;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column)
      rows[4 * row + column] = map.matrix[3 * row + column];
    rows[4 * row + 3] = map.origin[row];
  }
  const Transform transform = transformOfRows(rows);
  return isFinite(transform) ? transform : Transform();
}

} // namespace

/// Goes once through all nodes: proves their offsets, and finds the box of active cells.
class NanoVdbGrid::Checker {
public:
  Checker(std::span<const std::byte> bytes, NanoVdbGrid &grid, const Progress &progress)
      : bytes_(bytes), grid_(grid), progress_(progress) {}

  Expected<void> run() {
    constexpr std::size_t kHeads = sizeof(nanovdb::Grid) + sizeof(nanovdb::Tree);
    if (bytes_.size() < kHeads)
      return Error::input("its grid is cut short");
    const auto head = load<nanovdb::Grid>(bytes_.data());
    VOXC_TRY(readHead(head));
    const auto tree = load<nanovdb::Tree>(bytes_.data() + sizeof head);
    const std::uint64_t root = tree.offsets[3];
    const std::uint64_t rest = bytes_.size() - sizeof head;
    if (root < sizeof tree || root > rest || grid_.kind_->rootBytes > rest - root)
      return Error::input("its root lies outside of it");
    VOXC_TRY(checkRoot(sizeof head + root));
    if (high_.x == kLeast)
      return {};
    grid_.low_ = low_;
    grid_.high_ = high_;
    return {};
  }

private:
  Expected<void> readHead(const nanovdb::Grid &head) {
    if (head.magic != nanovdb::kMagic && head.magic != nanovdb::kMagicGrid)
      return Error::input("its grid does not begin as grids do");
    if (nanovdb::majorOf(head.version) != nanovdb::kMajorVersion)
      return Error::input("its grid has version " + std::to_string(nanovdb::majorOf(head.version)) +
                          " of the layout; only 32 is read");
    grid_.kind_ = findValueKind(head.type);
    if (!grid_.kind_)
      return Error::input("its grid has values of type " + std::to_string(head.type) +
                          ", which is not read; float, int, bool, mask and RGBA8 are");
    grid_.isLevelSet_ = head.gridClass == nanovdb::kLevelSet;
    grid_.voxelSize_ = head.voxelSize[0];
    grid_.indexToWorld_ = mapOf(head.map);
    return {};
  }

  Expected<void> checkRoot(std::uint64_t at) {
    const std::byte *root = bytes_.data() + at;
    const ValueKind &kind = *grid_.kind_;
    grid_.background_ = kind.read(root + kind.background);
    const auto tiles = load<std::uint32_t>(root + offsetof(nanovdb::Root, tiles));
    const std::uint64_t rest = bytes_.size() - at - kind.rootBytes;
    if (tiles > rest / sizeof(nanovdb::RootTile))
      return Error::input("its root has " + std::to_string(tiles) + " tiles, more than there are bytes for");
    for (std::uint32_t i = 0; i < tiles; ++i)
      if (auto checked = checkTile(root, root + kind.rootBytes + std::size_t{i} * sizeof(nanovdb::RootTile));
          !checked)
        return checked;
    std::ranges::sort(grid_.root_, {}, &RootEntry::key);
    if (std::ranges::adjacent_find(grid_.root_, {}, &RootEntry::key) != grid_.root_.end())
      return Error::input("its root has two tiles in one place");
    return {};
  }

  Expected<void> checkTile(const std::byte *root, const std::byte *at) {
    const auto tile = load<nanovdb::RootTile>(at);
    RootEntry entry{tile.key, lowOfKey(tile.key), nullptr, 0, false};
    if (tile.child == 0) {
      entry.value = grid_.kind_->read(at + grid_.kind_->tileValue);
      entry.isActive = tile.isActive != 0;
      if (entry.isActive)
        addBox(entry.low, nanovdb::kLog2Upper);
    } else {
      auto upper = VOXC_TRY(follow(root, tile.child, kUpperShape.bytes, uppers_));
      entry.upper = upper;
      VOXC_TRY(checkUpper(upper, entry.low));
    }
    grid_.root_.push_back(entry);
    return {};
  }

  Expected<void> checkUpper(const std::byte *node, Int3 low) {
    VOXC_TRY(progress_.check());
    for (std::uint32_t slot = 0; slot < kUpperShape.children(); ++slot) {
      const Int3 childLow = kUpperShape.lowOf(low, slot);
      if (!kUpperShape.bit(node, kUpperShape.isChild, slot)) {
        if (kUpperShape.bit(node, kUpperShape.isActive, slot))
          addBox(childLow, nanovdb::kLog2Lower);
        continue;
      }
      auto lower = VOXC_TRY(
          follow(node, load<std::int64_t>(kUpperShape.entry(node, slot)), kLowerShape.bytes, lowers_));
      VOXC_TRY(checkLower(lower, childLow));
    }
    return {};
  }

  Expected<void> checkLower(const std::byte *node, Int3 low) {
    for (std::uint32_t slot = 0; slot < kLowerShape.children(); ++slot) {
      const Int3 childLow = kLowerShape.lowOf(low, slot);
      if (!kLowerShape.bit(node, kLowerShape.isChild, slot)) {
        if (kLowerShape.bit(node, kLowerShape.isActive, slot))
          addBox(childLow, nanovdb::kLog2Leaf);
        continue;
      }
      const auto leaf = VOXC_TRY(
          follow(node, load<std::int64_t>(kLowerShape.entry(node, slot)), grid_.kind_->leafBytes, leaves_));
      addLeaf(leaf, childLow);
    }
    return {};
  }

  /// Where an offset leads, if a node of so many bytes lies there. `followed` counts those of its size: more
  /// than fit side by side are none that a few kilobytes should make us go through.
  Expected<const std::byte *> follow(const std::byte *from, std::int64_t offset, std::uint32_t nodeBytes,
                                     std::uint64_t &followed) {
    const std::int64_t here = from - bytes_.data();
    const auto size = static_cast<std::int64_t>(bytes_.size());
    if (offset < -here || offset > size - here || size - here - offset < std::int64_t{nodeBytes})
      return Error::input("a node at byte " + std::to_string(here) + " has a child outside of the grid");
    if (++followed > bytes_.size() / nodeBytes)
      return Error::input("its nodes are used more than once");
    return from + offset;
  }

  void addLeaf(const std::byte *leaf, Int3 low) {
    for (Int3 cell; cell.x < 8; ++cell.x)
      for (cell.y = 0; cell.y < 8; ++cell.y)
        for (cell.z = 0; cell.z < 8; ++cell.z)
          if (isActiveInLeaf(leaf, slotInLeaf(cell)))
            addBox(low + cell, 0);
  }

  void addBox(Int3 low, int log2Side) {
    for (int axis = 0; axis < 3; ++axis) {
      low_[axis] = std::min(low_[axis], low[axis]);
      high_[axis] = std::max(high_[axis], low[axis] + ((1 << log2Side) - 1));
    }
  }

  static constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  static constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::lowest();

  std::span<const std::byte> bytes_;
  NanoVdbGrid &grid_;
  const Progress &progress_;
  std::uint64_t uppers_ = 0;
  std::uint64_t lowers_ = 0;
  std::uint64_t leaves_ = 0;
  Int3 low_{kMost, kMost, kMost};
  Int3 high_{kLeast, kLeast, kLeast};
};

Expected<NanoVdbGrid> NanoVdbGrid::open(std::span<const std::byte> bytes, const Progress &progress) {
  NanoVdbGrid grid;
  VOXC_TRY(Checker(bytes, grid, progress).run());
  return grid;
}

NanoVdbGrid::Place NanoVdbGrid::find(Int3 cell) const {
  const std::uint64_t key = nanovdb::keyOf(cell);
  const auto entry = std::ranges::lower_bound(root_, key, {}, &RootEntry::key);
  if (entry == root_.end() || entry->key != key)
    return {nullptr, nanovdb::kLog2Upper, background_, false};
  if (!entry->upper)
    return {nullptr, nanovdb::kLog2Upper, entry->value, entry->isActive};
  const std::byte *node = entry->upper;
  for (const NodeLevel *shape : {&kUpperShape, &kLowerShape}) {
    const std::uint32_t slot = slotOf(*shape, cell);
    if (!shape->bit(node, shape->isChild, slot))
      return {nullptr, shape->log2Child, kind_->read(shape->entry(node, slot)),
              shape->bit(node, shape->isActive, slot)};
    node = voxc::childOf(*shape, node, slot);
  }
  return {node, nanovdb::kLog2Leaf, 0, false};
}

void NanoVdbGrid::forEach(const std::function<void(Int3, const std::byte *)> &visitLeaf,
                          const std::function<void(const ValueTile &)> &visitTile) const {
  const auto visitLower = [&](const std::byte *node, Int3 low) {
    for (std::uint32_t slot = 0; slot < kLowerShape.children(); ++slot) {
      const Int3 childLow = kLowerShape.lowOf(low, slot);
      if (kLowerShape.bit(node, kLowerShape.isChild, slot))
        visitLeaf(childLow, voxc::childOf(kLowerShape, node, slot));
      else
        visitTile({childLow, nanovdb::kLog2Leaf, kind_->read(kLowerShape.entry(node, slot)),
                   kLowerShape.bit(node, kLowerShape.isActive, slot)});
    }
  };
  for (const RootEntry &entry : root_) {
    if (!entry.upper) {
      visitTile({entry.low, nanovdb::kLog2Upper, entry.value, entry.isActive});
      continue;
    }
    for (std::uint32_t slot = 0; slot < kUpperShape.children(); ++slot) {
      const Int3 low = kUpperShape.lowOf(entry.low, slot);
      if (kUpperShape.bit(entry.upper, kUpperShape.isChild, slot))
        visitLower(voxc::childOf(kUpperShape, entry.upper, slot), low);
      else
        visitTile({low, nanovdb::kLog2Lower, kind_->read(kUpperShape.entry(entry.upper, slot)),
                   kUpperShape.bit(entry.upper, kUpperShape.isActive, slot)});
    }
  }
}

} // namespace voxc
