// Reading a graph as a source.
#include "voxc/Search/SceneSource.h"

#include "OctantMask.h"

#include <algorithm>
#include <bit>
#include <optional>

namespace voxc {
namespace {

class SceneSource final : public VoxelSource {
public:
  SceneSource(const SceneDag &dag, Int3 extent, const Transform &voxelToModel)
      : dag_(dag), extent_(extent), voxelToModel_(voxelToModel) {}

  Int3 extent() const override { return extent_; }
  Transform voxelToModel() const override { return voxelToModel_; }
  std::unique_ptr<VoxelSource> view() const override { return std::make_unique<SceneSource>(*this); }

  bool empty(const Cube &cube) override {
    if (cube.log2Side > dag_.log2Side())
      return dag_.isEmpty() || (cube.low.x | cube.low.y | cube.low.z) != 0;
    return !find(cube);
  }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    std::fill_n(words, std::size_t{1} << 3 * cube.log2Side, 0u);
    if (const auto number = find(cube))
      write(cube.log2Side, *number, words);
    return {};
  }

private:
  /// The number of the cube in the graph; none if it is empty.
  std::optional<std::uint32_t> find(const Cube &cube) const {
    const int root = dag_.log2Side();
    if (dag_.isEmpty() || ((cube.low.x | cube.low.y | cube.low.z) >> root) != 0)
      return std::nullopt;
    std::uint32_t number = 0;
    for (int height = root; height > cube.log2Side; --height) {
      const SceneDag::Node node = dag_.node(height, number);
      const int below = height - 1;
      const auto child = static_cast<unsigned>((cube.low.x >> below & 1) | (cube.low.y >> below & 1) << 1 |
                                               (cube.low.z >> below & 1) << 2);
      if ((node.mask >> child & 1) == 0)
        return std::nullopt;
      number = node.children[octantsBefore(node.mask, child)];
    }
    return number;
  }

  void write(int height, std::uint32_t number, std::uint32_t *words) const {
    if (height == 0) {
      *words = dag_.voxel(number);
      return;
    }
    const SceneDag::Node node = dag_.node(height, number);
    std::uint32_t mask = node.mask;
    for (const std::uint32_t child : node.children) {
      write(height - 1, child,
            words + (static_cast<std::size_t>(std::countr_zero(mask)) << 3 * (height - 1)));
      mask &= mask - 1;
    }
  }

  const SceneDag &dag_;
  Int3 extent_;
  Transform voxelToModel_;
};

} // namespace

std::unique_ptr<VoxelSource> makeSceneSource(const SceneDag &dag, Int3 extent,
                                             const Transform &voxelToModel) {
  return std::make_unique<SceneSource>(dag, extent, voxelToModel);
}

} // namespace voxc
