// Painting cells of a source.
#include "Source/Interior/PaintedSource.h"

#include <utility>

namespace voxc {

namespace {

class PaintedSource final : public VoxelSource {
public:
  PaintedSource(std::unique_ptr<VoxelSource> source, std::shared_ptr<const CellSet> cells, std::uint32_t word)
      : source_(std::move(source)), cells_(std::move(cells)), word_(word) {}

  Int3 extent() const override { return source_->extent(); }
  Transform voxelToModel() const override { return source_->voxelToModel(); }
  int log2Chunk() const override { return source_->log2Chunk(); }
  double readSeconds() const override { return source_->readSeconds(); }

  std::unique_ptr<VoxelSource> view() const override {
    auto view = source_->view();
    return view ? paint(std::move(view), cells_, word_) : nullptr;
  }

  bool empty(const Cube &cube) override {
    return word_ == 0 ? cells_->all(cube) || source_->empty(cube)
                      : cells_->none(cube) && source_->empty(cube);
  }

  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    VOXC_TRY(source_->read(cube, words));
    cells_->paint(cube, word_, words);
    return {};
  }

private:
  std::unique_ptr<VoxelSource> source_;
  std::shared_ptr<const CellSet> cells_;
  std::uint32_t word_;
};

} // namespace

std::unique_ptr<VoxelSource> paint(std::unique_ptr<VoxelSource> source, std::shared_ptr<const CellSet> cells,
                                   std::uint32_t word) {
  return std::make_unique<PaintedSource>(std::move(source), std::move(cells), word);
}

} // namespace voxc
