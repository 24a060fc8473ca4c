// The terrain as a source: a skin of ground and water without holes, trees on it, and walls around it.
#include "Source/Builtin/Scenes.h"
#include "Source/Builtin/TerrainColours.h"
#include "Source/Builtin/TerrainColumns.h"
#include "Source/Builtin/TerrainShape.h"
#include "Source/CubeTools.h"

#include <algorithm>

namespace voxc {

namespace {

class Terrain final : public VoxelSource {
public:
  explicit Terrain(int side) : shape_(side), colours_(shape_), columns_(shape_) {}

  Int3 extent() const override { return {shape_.side(), shape_.side(), shape_.side()}; }
  std::unique_ptr<VoxelSource> view() const override { return std::make_unique<Terrain>(shape_.side()); }

  bool empty(const Cube &cube) override {
    if (isOutside(cube, extent()))
      return true;
    const int last = shape_.side() - 1;
    const auto side = static_cast<std::int32_t>(cube.side());
    const Int3 high{std::min(cube.low.x + side - 1, last), cube.low.y + side - 1,
                    std::min(cube.low.z + side - 1, last)};
    // The skin of a column reaches down to its lowest neighbour; at the walls to the floor.
    const Rectangle area{cube.low.x - 1, cube.low.z - 1, high.x + 1, high.z + 1};
    const Range ground = shape_.groundOver(area);
    const bool atWall = cube.low.x == 0 || cube.low.z == 0 || high.x == last || high.z == last;
    const std::int64_t water = shape_.waterLevel();
    return (!atWall && high.y < std::max(ground.low, water)) ||
           cube.low.y > std::max({ground.high, water, treeTop(cube, ground.high)});
  }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    const std::optional<Tree> tree = treeAround(cube);
    const auto side = static_cast<std::int32_t>(cube.side());
    for (std::int32_t z = 0; z < side; ++z)
      for (std::int32_t x = 0; x < side; ++x)
        readColumn(cube, {x, 0, z}, tree, words);
    return {};
  }

private:
  void readColumn(const Cube &cube, Int3 offset, const std::optional<Tree> &tree, std::uint32_t *words) {
    Int3 cell = cube.low + offset;
    const bool isInside = cell.x < shape_.side() && cell.z < shape_.side();
    const TerrainColumn column = isInside ? columns_.at(cell.x, cell.z) : TerrainColumn{};
    for (; offset.y < cube.side(); ++offset.y, ++cell.y)
      words[mortonCode(offset)] = isInside && cell.y < shape_.side() ? word(cell, column, tree) : 0;
  }

  std::uint32_t word(Int3 cell, const TerrainColumn &column, const std::optional<Tree> &tree) const {
    if (cell.y > column.surface)
      return tree && tree->holds(cell) ? colours_.tree(cell, *tree) : 0;
    if (cell.y < column.bottom)
      return 0;
    if (cell.y > column.ground)
      return colours_.water(cell, cell.y - column.ground);
    return colours_.ground(cell, column.ground, column.drop);
  }

  std::optional<Tree> treeAround(const Cube &cube) const {
    return shape_.tree(cube.low.x >> shape_.log2Tile(), cube.low.z >> shape_.log2Tile());
  }

  /// Above this there is no tree in the cube's columns, whose ground lies at `ground` at most.
  std::int64_t treeTop(const Cube &cube, std::int64_t ground) const {
    if (cube.log2Side > shape_.log2Tile())
      return ground + (1 << shape_.log2Tile());
    const std::optional<Tree> tree = treeAround(cube);
    return tree ? tree->foot.y + tree->height : 0;
  }

  TerrainShape shape_;
  TerrainColours colours_;
  TerrainColumns columns_;
};

} // namespace

std::unique_ptr<VoxelSource> makeTerrain(int side) { return std::make_unique<Terrain>(side); }

} // namespace voxc
