// Words of a surface where its cells are inside.
#include "Mesh/Solid/CentreSource.h"

#include "Source/CubeTools.h"

#include <algorithm>
#include <utility>

namespace voxc {

namespace {

using Sets = std::array<std::shared_ptr<const CellSet>, 2>;

class CentreSource final : public VoxelSource {
public:
  CentreSource(std::unique_ptr<VoxelSource> surface, Sets cells, std::uint32_t word)
      : surface_(std::move(surface)), cells_(std::move(cells)), word_(word) {}

  Int3 extent() const override { return surface_->extent(); }
  Transform voxelToModel() const override { return surface_->voxelToModel(); }
  int log2Chunk() const override { return surface_->log2Chunk(); }
  double readSeconds() const override { return surface_->readSeconds(); }

  std::unique_ptr<VoxelSource> view() const override {
    auto view = surface_->view();
    return view ? makeCentreSource(std::move(view), cells_, word_) : nullptr;
  }

  bool empty(const Cube &cube) override { return cells_[0]->none(cube) && cells_[1]->none(cube); }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    VOXC_TRY(surface_->read(cube, words));
    const std::uint64_t count = cellCount(cube.log2Side);
    std::array<std::uint32_t, 512> inside;
    std::fill_n(inside.begin(), count, 0u);
    for (const auto &set : cells_)
      set->paint(cube, 1, inside.data());
    for (std::uint64_t i = 0; i < count; ++i)
      words[i] = inside[i] == 0 ? 0 : words[i] != 0 ? words[i] : word_;
    return {};
  }

private:
  std::unique_ptr<VoxelSource> surface_;
  Sets cells_;
  std::uint32_t word_;
};

} // namespace

std::unique_ptr<VoxelSource> makeCentreSource(std::unique_ptr<VoxelSource> surface, Sets cells,
                                              std::uint32_t word) {
  return std::make_unique<CentreSource>(std::move(surface), std::move(cells), word);
}

} // namespace voxc
