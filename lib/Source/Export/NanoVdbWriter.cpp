// NanoVDB files: one grid of RGBA8 values, its nodes level by level.
#include "Source/Export/NanoVdbTree.h"
#include "Source/Export/Writers.h"
#include "Source/NanoVdbLayout.h"
#include "voxc/Source/Sources.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

namespace {

constexpr std::string_view kGridName = "voxels";

/// Bytes from the grid's begin.
struct Places {
  explicit Places(const NanoVdbTree &tree)
      : root(sizeof(nanovdb::Grid) + sizeof(nanovdb::Tree)),
        uppers(root + sizeof(nanovdb::Root) + tree.root.size() * sizeof(nanovdb::RootTile)),
        lowers(uppers + tree.uppers.size() * sizeof(nanovdb::Upper)),
        leaves(lowers + tree.lowers.size() * sizeof(nanovdb::Lower)),
        end(leaves + tree.leaves * sizeof(nanovdb::Leaf)) {}

  std::uint64_t root;
  std::uint64_t uppers;
  std::uint64_t lowers;
  std::uint64_t leaves;
  std::uint64_t end;
};

std::array<std::int32_t, 6> boxOf(const ActiveBox &box) {
  // An empty box is inverted, as NanoVDB's own are.
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::lowest();
  if (box.isEmpty())
    return {kMost, kMost, kMost, kLeast, kLeast, kLeast};
  return {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z};
}

nanovdb::Map mapOf(const Transform &indexToWorld) {
  nanovdb::Map map;
  const glm::dmat3 matrix(indexToWorld);
  const glm::dmat3 inverse = glm::inverse(matrix);
  for (int row = 0; row < 3; ++row) {
    const auto at = static_cast<std::size_t>(row);
    map.origin[at] = indexToWorld[3][row];
    map.originF[at] = static_cast<float>(map.origin[at]);
    for (int column = 0; column < 3; ++column) {
      const auto entry = static_cast<std::size_t>(3 * row + column);
      map.matrix[entry] = matrix[column][row];
      map.inverse[entry] = inverse[column][row];
      map.matrixF[entry] = static_cast<float>(map.matrix[entry]);
      map.inverseF[entry] = static_cast<float>(map.inverse[entry]);
    }
  }
  return map;
}

/// From the middles of voxels, which NanoVDB's whole numbers are. A map that cannot be inverted becomes one
/// that moves nothing.
Transform indexToWorldOf(const Transform &voxelToModel) {
  const double volume = glm::determinant(glm::dmat3(voxelToModel));
  Transform map = isFinite(voxelToModel) && std::isnormal(volume) ? voxelToModel : Transform();
  map[3] = map * glm::dvec4(0.5, 0.5, 0.5, 1);
  return map;
}

/// The box of all corners of the active cells.
std::array<double, 6> worldBoxOf(const ActiveBox &box, const Transform &voxelToModel) {
  std::array<double, 6> world{};
  if (box.isEmpty())
    return world;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec4 point(0, 0, 0, 1);
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = corner >> axis & 1 ? box.high[axis] + 1.0 : box.low[axis];
    const glm::dvec3 at = voxelToModel * point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double value = at[static_cast<int>(axis)];
      world[axis] = corner == 0 ? value : std::min(world[axis], value);
      world[axis + 3] = corner == 0 ? value : std::max(world[axis + 3], value);
    }
  }
  return world;
}

std::uint64_t hashOf(std::string_view name) {
  std::uint64_t hash = 0;
  for (const char letter : name)
    hash = hash * 67 + static_cast<unsigned char>(letter) + (hash >> 56);
  return hash;
}

class NanoVdbFile {
public:
  NanoVdbFile(const Volume &volume, const NanoVdbTree &tree, OutputFile &file, const Progress &progress)
      : volume_(volume), tree_(tree), places_(tree), file_(file), progress_(progress) {}

  Expected<void> write() {
    VOXC_TRY(writeHeads());
    VOXC_TRY(writeRoot());
    if (auto written = writeInner<nanovdb::Upper>(tree_.uppers, tree_.ofUppers, nanovdb::kLog2Lower,
                                                  places_.uppers, places_.lowers, sizeof(nanovdb::Lower));
        !written)
      return written;
    if (auto written = writeInner<nanovdb::Lower>(tree_.lowers, tree_.ofLowers, nanovdb::kLog2Leaf,
                                                  places_.lowers, places_.leaves, sizeof(nanovdb::Leaf));
        !written)
      return written;
    return writeLeaves();
  }

private:
  template <typename T> Expected<void> put(const T &value) { return file_.write(&value, sizeof value); }

  Expected<void> writeHeads() {
    const Transform map = indexToWorldOf(volume_.info().voxelToModel);
    Transform corners = map;
    corners[3] = map * glm::dvec4(-0.5, -0.5, -0.5, 1);
    nanovdb::Grid grid;
    grid.bytes = places_.end;
    kGridName.copy(grid.name.data(), kGridName.size());
    grid.map = mapOf(map);
    grid.worldBox = worldBoxOf(tree_.box, corners);
    for (int axis = 0; axis < 3; ++axis)
      grid.voxelSize[static_cast<std::size_t>(axis)] = glm::length(map[axis]);
    grid.gridClass = nanovdb::kVoxelVolume;
    grid.type = nanovdb::kRgba8;
    const nanovdb::Tree tree = treeHead();
    nanovdb::FileGrid entry;
    entry.gridBytes = entry.fileBytes = places_.end;
    entry.nameHash = hashOf(kGridName);
    entry.voxels = tree_.voxels;
    entry.type = grid.type;
    entry.gridClass = grid.gridClass;
    entry.worldBox = grid.worldBox;
    entry.box = boxOf(tree_.box);
    entry.voxelSize = grid.voxelSize;
    entry.nameBytes = static_cast<std::uint32_t>(kGridName.size() + 1);
    entry.nodes = {tree.nodes[0], tree.nodes[1], tree.nodes[2], 1};
    entry.tiles = tree.tiles;
    std::string heads;
    const auto add = [&](const auto &value) {
      heads.append(reinterpret_cast<const char *>(&value), sizeof value);
    };
    add(nanovdb::FileHead());
    add(entry);
    heads.append(kGridName).push_back('\0');
    add(grid);
    add(tree);
    return file_.write(heads.data(), heads.size());
  }

  nanovdb::Tree treeHead() const {
    nanovdb::Tree tree;
    const auto fromTree = [](std::uint64_t place) { return place - sizeof(nanovdb::Grid); };
    const std::array<std::uint64_t, 3> counts{tree_.leaves, tree_.lowers.size(), tree_.uppers.size()};
    const std::array<std::uint64_t, 3> firsts{places_.leaves, places_.lowers, places_.uppers};
    for (std::size_t level = 0; level < 3; ++level) {
      tree.offsets[level] = counts[level] == 0 ? 0 : fromTree(firsts[level]);
      tree.nodes[level] = static_cast<std::uint32_t>(counts[level]);
      tree.tiles[level] = static_cast<std::uint32_t>(tree_.tiles[level]);
    }
    tree.offsets[3] = fromTree(places_.root);
    tree.voxels = tree_.voxels;
    return tree;
  }

  Expected<void> writeRoot() {
    nanovdb::Root root;
    root.box = boxOf(tree_.box);
    root.tiles = static_cast<std::uint32_t>(tree_.root.size());
    std::vector<nanovdb::RootTile> tiles;
    std::uint64_t nodes = 0;
    for (const TreeChild &child : tree_.root.span()) {
      nanovdb::RootTile tile;
      tile.key = nanovdb::keyOf(child.low);
      tile.isActive = child.tile != 0;
      tile.value = child.tile;
      if (child.tile == 0)
        tile.child =
            static_cast<std::int64_t>(places_.uppers + nodes++ * sizeof(nanovdb::Upper) - places_.root);
      tiles.push_back(tile);
    }
    std::ranges::sort(tiles, {}, &nanovdb::RootTile::key);
    VOXC_TRY(put(root));
    return file_.write(tiles.data(), tiles.size() * sizeof(nanovdb::RootTile));
  }

  /// The nodes of a level, whose children lie `bytesEach` apart from `firstChild` on.
  template <typename Node>
  Expected<void> writeInner(const ScratchArray<TreeNode> &nodes, const ScratchArray<TreeChild> &children,
                            int log2Child, std::uint64_t firstPlace, std::uint64_t firstChild,
                            std::uint64_t bytesEach) {
    const int log2Children = std::countr_zero(Node::kChildren) / 3;
    const auto node = std::make_unique<Node>();
    std::uint64_t place = firstPlace;
    for (const TreeNode &record : nodes.span()) {
      if (progress_.stopped())
        return Error::interrupted();
      *node = {};
      node->box = boxOf(record.box);
      std::uint64_t next = firstChild + record.firstNode * bytesEach;
      for (const TreeChild &child : children.span().subspan(record.firstChild, record.children)) {
        const std::uint32_t slot = nanovdb::childOf(child.low, log2Child, log2Children);
        if (child.tile != 0) {
          nanovdb::setBit(node->isActive, slot);
          node->table[slot] = child.tile;
          continue;
        }
        nanovdb::setBit(node->isChild, slot);
        node->table[slot] = static_cast<std::int64_t>(next - place);
        next += bytesEach;
      }
      VOXC_TRY(put(*node));
      place += sizeof(Node);
    }
    return {};
  }

  Expected<void> writeLeaves() {
    const auto source = makeVolumeSource(std::shared_ptr<const Volume>(std::shared_ptr<void>(), &volume_));
    std::array<std::uint32_t, 512> words;
    std::uint64_t looks = 0;
    for (const TreeChild &child : tree_.ofLowers.span()) {
      if (child.tile != 0)
        continue;
      if (++looks % 4096 == 0 && progress_.stopped())
        return Error::interrupted();
      VOXC_TRY(readBrickWithin(*source, child.low, words));
      VOXC_TRY(put(leafOf(child.low, words)));
    }
    return {};
  }

  static nanovdb::Leaf leafOf(Int3 low, const std::array<std::uint32_t, 512> &words) {
    nanovdb::Leaf leaf;
    ActiveBox box;
    for (std::uint64_t at = 0; at < words.size(); ++at) {
      if (words[at] == 0)
        continue;
      const Int3 cell = mortonCell(at);
      const std::uint32_t slot = nanovdb::childOf(cell, 0, nanovdb::kLog2Leaf);
      nanovdb::setBit(leaf.isActive, slot);
      leaf.values[slot] = words[at];
      box.add({low + cell, low + cell});
    }
    for (int axis = 0; axis < 3; ++axis) {
      leaf.low[static_cast<std::size_t>(axis)] = box.low[axis];
      leaf.steps[static_cast<std::size_t>(axis)] = static_cast<std::uint8_t>(box.high[axis] - box.low[axis]);
    }
    return leaf;
  }

  const Volume &volume_;
  const NanoVdbTree &tree_;
  Places places_;
  OutputFile &file_;
  const Progress &progress_;
};

} // namespace

Expected<void> writeNanoVdb(const Volume &volume, OutputFile &file, const ExportOptions &options,
                            Exported &) {
  const auto memory = options.save.memory ? options.save.memory : WorkingMemory::createDefault();
  const auto tree = VOXC_TRY(findNanoVdbTree(volume, memory, options.save.progress));
  constexpr std::uint64_t kMostNodes = std::uint64_t{1} << 31;
  if (tree.leaves > kMostNodes || tree.ofLowers.size() > kMostNodes)
    return Error::input("a .nvdb file cannot hold " + std::to_string(tree.ofLowers.size()) +
                        " bricks of 8^3 cells; at most 2^31 fit");
  return NanoVdbFile(volume, tree, file, options.save.progress).write();
}

} // namespace voxc
