// Counting down the levels.
#include "VoxelTally.h"

namespace voxc {
namespace {

using construct::Node;

/// What a node is known by: references have 32 bits, layers five, levels the rest.
std::uint64_t keyOf(unsigned level, int layers, Ref ref) {
  return std::uint64_t{level} << 40 | static_cast<std::uint64_t>(layers) << 32 | ref;
}

} // namespace

std::uint64_t VoxelTally::ofCell(unsigned level, std::uint32_t value) {
  return nodes_.layout().holdsVoxels(level - 1) ? (value != 0 ? 1 : 0) : ofSubVolume(level + 1, value);
}

std::uint64_t VoxelTally::ofGrid(unsigned level, Ref ref) {
  std::uint64_t voxels = 0;
  nodes_.cells(level, ref, [&](std::uint64_t, std::uint32_t value) { voxels += ofCell(level, value); });
  return voxels;
}

std::uint64_t VoxelTally::ofNode(unsigned level, int layers, const Node &node) {
  if (node.kind == Node::Empty)
    return 0;
  if (node.kind == Node::Leaf)
    return ofCell(level, node.value) << nodes_.stratum(level).log2Children() * layers;
  const std::uint64_t key = keyOf(level, layers, node.value);
  if (const auto known = known_.find(key); known != known_.end())
    return known->second;
  std::uint64_t voxels = 0;
  nodes_.children(level, node,
                  [&](std::uint64_t, const Node &child) { voxels += ofNode(level, layers - 1, child); });
  return known_[key] = voxels;
}

std::uint64_t VoxelTally::ofSubVolume(unsigned level, Ref ref) {
  if (ref == 0)
    return 0;
  const Stratum &stratum = nodes_.stratum(level);
  if (!stratum.isGrid())
    return ofNode(level, stratum.depth, nodes_.root(level, ref));
  const std::uint64_t key = keyOf(level, 0, ref);
  if (const auto known = known_.find(key); known != known_.end())
    return known->second;
  return known_[key] = ofGrid(level, ref);
}

} // namespace voxc
