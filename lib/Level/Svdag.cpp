// G: a sparse voxel DAG. A node is [masks, child pointers...], equal nodes share storage; a leaf is
// [terminating integer].
#include "Tree.h"

namespace voxc {
namespace {

constexpr std::array<ParameterKind, 1> kParameters = {{
    {"L", ParameterRole::Side, "depth: log2 of the cells along each axis"},
}};

constexpr std::array<const AttributeKind *, 2> kAttributes = {&kDedupAttribute, &kWalkAttribute};

struct SvdagLayout {
  static constexpr std::uint64_t kLeafWords = 1;

  static NodeMasks masks(const WordReader &words, std::uint64_t node) { return {words[node]}; }
  static std::uint64_t child(const WordReader &words, std::uint64_t node, std::uint32_t rank) {
    return words[node + 1 + rank];
  }
  static bool requireNode(WordReader &words, std::uint64_t node) {
    return words.require(node, 1, "a node of a DAG") &&
           words.require(node, std::uint64_t{1} + masks(words, node).rank(8), "a node of a DAG");
  }
};

bool relocate(std::span<std::uint32_t> words, bool holdsVoxels, std::span<const std::uint32_t> newOffsets) {
  if (words.size() == 1)
    return holdsVoxels || relocatePointer(words[0], newOffsets);
  return std::ranges::all_of(words.subspan(1),
                             [&](std::uint32_t &child) { return relocatePointer(child, newOffsets); });
}

} // namespace

const LevelKind kSvdag = {'G',
                          "svdag",
                          "SVDAG",
                          "a sparse voxel DAG: an octree whose equal nodes share storage",
                          Arrangement::Tree,
                          0,
                          kParameters,
                          kAttributes,
                          lookupTree<SvdagLayout>,
                          walkTree<SvdagLayout>,
                          relocate};

} // namespace voxc
