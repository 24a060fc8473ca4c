// Slices as PNG pictures.
#include "Source/Export/NumberedFiles.h"
#include "Source/Export/SliceAxes.h"
#include "Source/Export/VoxelVisit.h"
#include "Source/Export/Writers.h"
#include "Support/ParallelFor.h"
#include "voxc/Image/Encode.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace voxc {

namespace {

/// What a reader takes, too.
constexpr std::int64_t kMostCells = std::int64_t{1} << 26;

/// Slices that are read at once take this many cells, or are one: of those that lie across the rows of a
/// volume each reads all rows.
constexpr std::int64_t kCellsAtOnce = std::int64_t{1} << 24;

/// The slices of a volume, some at a time.
class Slices {
public:
  Slices(const Volume &volume, SlicePlane plane)
      : volume_(volume), extent_(volume.info().extent), axes_(sliceAxes(plane, volume.info().voxelToModel)) {}

  std::int32_t width() const { return extent_[axes_.right.axis]; }
  std::int32_t height() const { return extent_[axes_.down.axis]; }
  std::int32_t count() const { return extent_[axes_.through.axis]; }
  std::int64_t cells() const { return std::int64_t{width()} * height(); }
  std::int32_t atOnce() const {
    const auto room = std::clamp<std::int64_t>(kCellsAtOnce / std::max<std::int64_t>(cells(), 1), 1, count());
    return std::int32_t(room < kCubeAtOnce ? room : room & -kCubeAtOnce);
  }

  /// Reads so many slices from `first` on into `words`, one behind another.
  void read(std::int32_t first, std::int32_t count, std::span<std::uint32_t> words) const;

private:
  void place(Int3 from, Int3 to, std::span<const std::uint32_t> box, std::int32_t first,
             std::span<std::uint32_t> words) const;

  /// Where along what an axis goes along a cell lies.
  std::int32_t placeOf(const SliceAxis &axis, Int3 cell) const {
    return axis.isBackward ? extent_[axis.axis] - 1 - cell[axis.axis] : cell[axis.axis];
  }

  const Volume &volume_;
  Int3 extent_;
  SliceAxes axes_;
};

void Slices::read(std::int32_t first, std::int32_t count, std::span<std::uint32_t> words) const {
  Int3 low{}, high = extent_;
  const int through = axes_.through.axis;
  low[through] = axes_.through.isBackward ? extent_[through] - first - count : first;
  high[through] = low[through] + count;
  std::vector<std::uint32_t> rows;
  for (Int3 from = low; from.z < high.z; from.z = (from.z & -kCubeAtOnce) + kCubeAtOnce)
    for (from.y = low.y; from.y < high.y; from.y = (from.y & -kCubeAtOnce) + kCubeAtOnce) {
      const Int3 to{high.x, std::min((from.y & -kCubeAtOnce) + kCubeAtOnce, high.y),
                    std::min((from.z & -kCubeAtOnce) + kCubeAtOnce, high.z)};
      const Int3 size = to - from;
      rows.resize(static_cast<std::size_t>(std::int64_t{size.x} * size.y * size.z));
      readBox(volume_, from, to, rows);
      place(from, to, rows, first, words);
    }
}

/// Puts the cells of a box where those of the slices from `first` on lie.
void Slices::place(Int3 from, Int3 to, std::span<const std::uint32_t> box, std::int32_t first,
                   std::span<std::uint32_t> words) const {
  const std::uint32_t *word = box.data();
  for (std::int32_t z = from.z; z < to.z; ++z)
    for (std::int32_t y = from.y; y < to.y; ++y)
      for (std::int32_t x = from.x; x < to.x; ++x) {
        const Int3 cell{x, y, z};
        const std::int64_t at = placeOf(axes_.through, cell) - first;
        const std::int64_t row = (at * height() + placeOf(axes_.down, cell)) * width();
        words[static_cast<std::size_t>(row + placeOf(axes_.right, cell))] = *word++;
      }
}

} // namespace

Expected<void> writeSlices(const Volume &volume, const std::string &path, const ExportOptions &options,
                           Exported &exported) {
  const Slices slices(volume, options.slices);
  const auto pattern = NumberedPath::parse(path);
  if (!pattern && slices.count() != 1)
    return Error::usage("'" + path + "' is one picture, but the volume has " +
                        std::to_string(slices.count()) +
                        " slices; write ### or %04d where the number of each shall stand");
  if (slices.cells() > kMostCells)
    return Error::input("a slice of " + std::to_string(slices.width()) + "x" +
                        std::to_string(slices.height()) +
                        " cells is too large for a picture; it may have 2^26");
  std::optional<NumberedFiles> files;
  if (pattern)
    files.emplace(*pattern);
  const auto cells = static_cast<std::size_t>(slices.cells());
  std::vector<std::uint32_t> words(cells * static_cast<std::size_t>(slices.atOnce()));
  std::vector<std::string> pictures(static_cast<std::size_t>(slices.atOnce()));
  for (std::int32_t first = 0; first < slices.count(); first += slices.atOnce()) {
    const auto count = static_cast<std::size_t>(std::min(slices.atOnce(), slices.count() - first));
    slices.read(first, static_cast<std::int32_t>(count), words);
    auto encoded = parallelTry(count, options.save.threads, [&](std::uint64_t i) -> Expected<void> {
      VOXC_TRY(options.save.progress.check());
      pictures[i] =
          VOXC_TRY(encodePng(std::span(words).subspan(i * cells, cells), slices.width(), slices.height()));
      return {};
    });
    if (!encoded)
      return encoded;
    for (std::size_t i = 0; i < count; ++i) {
      VOXC_TRY(options.save.progress.check());
      options.save.progress.at("write", static_cast<double>(first + std::int32_t(i)) / slices.count());
      VOXC_TRY(files ? files->add(pictures[i]) : writeFile(path, pictures[i]));
    }
  }
  exported.files = static_cast<std::uint64_t>(slices.count());
  if (!files)
    return {};
  if (std::string left = files->leftover(); !left.empty())
    exported.warnings.push_back(std::move(left));
  return files->finish();
}

} // namespace voxc
