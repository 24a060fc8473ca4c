// Shapes, voxel by voxel.
#include "voxc/Volume/ShapeReader.h"

#include "Decode.h"
#include "PagedWords.h"

namespace voxc {

ShapeReader::ShapeReader(const Volume &volume)
    : layout_(&volume.layout()), words_(layout_->reader(volume.words())), extent_(volume.info().extent) {}

ShapeReader::ShapeReader(const PagedVolume &volume, std::shared_ptr<PageShelf> shelf)
    : pages_(std::make_unique<PagedWords>(volume, std::move(shelf))),
      ownLayout_(std::make_unique<Layout>(layoutOf(volume.info().format))), layout_(ownLayout_.get()),
      words_(layout_->reader(*pages_)), extent_(volume.info().extent) {}

ShapeReader::~ShapeReader() = default;
ShapeReader::ShapeReader(ShapeReader &&) noexcept = default;

ShapeCube ShapeReader::at(Int3 voxel) const {
  const Lookup found = lookUpShape(words_, *layout_, voxel);
  return {found.value != 0, found.log2Side};
}

std::uint64_t ShapeReader::brick(Int3 low) const {
  std::uint64_t bits = 0;
  visitCube(words_, *layout_, {low, 2},
            [&](std::uint64_t first, std::uint64_t count, std::uint32_t, std::uint64_t) {
              for (std::uint64_t place = first; place < first + count; ++place) {
                const Int3 cell = mortonCell(place);
                bits |= std::uint64_t{1} << (cell.x + 4 * cell.y + 16 * cell.z);
              }
            });
  return bits;
}

std::optional<Error> ShapeReader::problem() const { return pages_ ? pages_->problem() : std::nullopt; }

std::uint64_t ShapeReader::pagesRead() const { return pages_ ? pages_->pagesRead() : 0; }

} // namespace voxc
