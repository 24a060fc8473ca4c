// Boxes over cells of one level, wrapped.
#include "Mesh/Voxelize/TexelBox.h"

#include "Mesh/Voxelize/TexelPlace.h"
#include "Support/Srgb.h"

#include <algorithm>

namespace voxc {

namespace {

/// So many cells are looked at for a box, and so many along its shorter side; more are finer, and cost more.
constexpr double kMostCells = 64;
constexpr double kMostCellsAcross = 3.5;

/// Narrower than this, in texels, a box is a line.
constexpr double kLine = 1e-6;

/// A box that spans this many copies of a texture has the mean of the whole.
constexpr double kManyCopies = 4;

/// Copies after which a wrapped texture begins anew: mirrored, every other copy is turned.
int copiesOf(TextureWrap wrap) { return wrap == TextureWrap::MirroredRepeat ? 2 : 1; }

bool isWhole(double length, TextureWrap wrap, int size) {
  return wrap != TextureWrap::ClampToEdge && length >= kManyCopies * copiesOf(wrap) * size;
}

/// Texels that are looked at along an axis.
double texelsAlong(double length, TextureWrap wrap, int size) {
  return wrap == TextureWrap::ClampToEdge || isWhole(length, wrap, size) ? std::min<double>(length, size)
                                                                         : length;
}

/// The finest level of which a box has few enough cells.
int levelFor(const TexelBox &box, const std::array<TextureWrap, 2> &wrap, const TextureMeans &means) {
  const double width = texelsAlong(box.high[0] - box.low[0], wrap[0], means.width());
  const double height = texelsAlong(box.high[1] - box.low[1], wrap[1], means.height());
  const auto isTooFine = [&](double cell) {
    return std::min(width, height) > kMostCellsAcross * cell ||
           (width / cell + 1) * (height / cell + 1) > kMostCells;
  };
  int level = 0;
  for (double cell = 1; level < means.levels() && isTooFine(cell); cell *= 2)
    ++level;
  return level;
}

} // namespace

/// Adds what lies inside of the texture.
void BoxMeans::addPiece(double low, double high, int size, int level, std::vector<Tap> &taps) {
  const double side = static_cast<double>(std::int64_t{1} << level);
  const double end = std::min<double>(high, size);
  for (auto cell = static_cast<std::uint64_t>(std::max(low, 0.0) / side);
       static_cast<double>(cell) * side < end; ++cell) {
    const double from = std::max(low, static_cast<double>(cell) * side);
    const double to = std::min(end, static_cast<double>(cell + 1) * side);
    if (to > from)
      taps.push_back({cell, to - from});
  }
}

void BoxMeans::addTaps(const Axis &axis, int level, std::vector<Tap> &taps) {
  taps.clear();
  const double size = axis.size;
  const auto last = static_cast<std::uint64_t>(axis.size - 1);
  if (axis.wrap == TextureWrap::ClampToEdge) {
    addPiece(axis.low, axis.high, axis.size, level, taps);
    if (axis.low < 0)
      taps.push_back({0, std::min(axis.high, 0.0) - axis.low});
    if (axis.high > size)
      taps.push_back({last >> level, axis.high - std::max(axis.low, size)});
    return;
  }
  const int copies = copiesOf(axis.wrap);
  if (isWhole(axis.high - axis.low, axis.wrap, axis.size))
    return addPiece(0, size, axis.size, level, taps);
  const double begin = fractionOf(axis.low / (copies * size)) * (copies * size);
  const double end = begin + (axis.high - axis.low);
  for (int copy = 0; copy * size < end; ++copy) {
    const double low = std::max(begin - copy * size, 0.0);
    const double high = std::min(end - copy * size, size);
    if (low < high && copies == 2 && copy % 2 == 1)
      addPiece(size - high, size - low, axis.size, level, taps);
    else if (low < high)
      addPiece(low, high, axis.size, level, taps);
  }
}

std::optional<std::uint32_t> BoxMeans::of(const TextureMeans &means, const std::array<TextureWrap, 2> &wrap,
                                          const TexelBox &box) {
  const int level = levelFor(box, wrap, means);
  const std::array<int, 2> sizes{means.width(), means.height()};
  for (std::size_t axis = 0; axis < 2; ++axis)
    addTaps({box.low[axis], std::max(box.high[axis], box.low[axis] + kLine), wrap[axis], sizes[axis]}, level,
            axis == 0 ? columns_ : rows_);
  TextureMeans::Light sum{};
  for (const Tap &row : rows_)
    means.addRow(level, row.cell, columns_, row.weight, sum);
  if (!(sum[3] > 0))
    return std::nullopt;
  return srgbByte(sum[0] / sum[3]) | srgbByte(sum[1] / sum[3]) << 8 | srgbByte(sum[2] / sum[3]) << 16;
}

} // namespace voxc
