// S: a sparse voxel octree. A node is [first child, masks], its non-empty children stand together; a leaf is
// [terminating integer, 0].
#include "Tree.h"

namespace voxc {
namespace {

constexpr std::array<ParameterKind, 1> kParameters = {{
    {"L", ParameterRole::Side, "depth: log2 of the cells along each axis"},
}};

constexpr std::array<const AttributeKind *, 1> kAttributes = {&kWalkAttribute};

struct SvoLayout {
  static constexpr std::uint64_t kLeafWords = 2;

  static NodeMasks masks(const WordReader &words, std::uint64_t node) { return {words[node + 1]}; }
  static std::uint64_t child(const WordReader &words, std::uint64_t node, std::uint32_t rank) {
    return words[node] + std::uint64_t{2} * rank;
  }
  static bool requireNode(WordReader &words, std::uint64_t node) {
    return words.require(node, 2, "a node of an octree");
  }
};

/// Siblings are pairs of a value and masks: without masks, the value is a terminating integer.
bool relocate(std::span<std::uint32_t> words, bool holdsVoxels, std::span<const std::uint32_t> newOffsets) {
  for (std::size_t i = 0; i + 1 < words.size(); i += 2)
    if (!(words[i + 1] == 0 && holdsVoxels) && !relocatePointer(words[i], newOffsets))
      return false;
  return true;
}

} // namespace

const LevelKind kSvo = {'S',
                        "svo",
                        "SVO",
                        "a sparse voxel octree: empty space costs nothing, two words a node",
                        Arrangement::Tree,
                        0,
                        kParameters,
                        kAttributes,
                        lookupTree<SvoLayout>,
                        walkTree<SvoLayout>,
                        relocate};

} // namespace voxc
