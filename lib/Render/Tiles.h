// In which order the pixels of a picture are traced: square by square, for the rays of a packet to stay
// together in both directions. Hits lie in that order; what a pixel gathers lies in rows.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace voxc {

/// The orders of the pixels of a tile.
enum class TileOrder {
  Near,  ///< Along the Morton curve: 4, 8, 16 or 32 pixels that follow each other are neighbours.
  Alike, ///< Pixels that look for the sky in one direction follow each other, 16 of them.
};

struct TiledPixel {
  std::uint32_t ray;   ///< Its number among the rays of the film, tile by tile.
  std::uint32_t pixel; ///< And among the film's pixels, row by row.
  int column;
  int row; ///< From the film's first on.
};

/// Places in a tile by their Morton codes.
class TilePlaces {
public:
  static constexpr int kSide = 16;
  static constexpr unsigned kCount = kSide * kSide;

  constexpr TilePlaces() {
    for (unsigned code = 0; code < kCount; ++code)
      for (unsigned bit = 0; bit < 4; ++bit) {
        columns[code] |= std::uint8_t((code >> 2 * bit & 1) << bit);
        rows[code] |= std::uint8_t((code >> (2 * bit + 1) & 1) << bit);
      }
  }

  std::array<std::uint8_t, kCount> columns{};
  std::array<std::uint8_t, kCount> rows{};
};
inline constexpr TilePlaces kTilePlaces;

/// The tiles of so many rows; those at the edges hold fewer pixels.
class Tiles {
public:
  Tiles(int width, int rows) : width_(width), rows_(rows) {}

  int strips() const { return (rows_ + kSide - 1) / kSide; }

  /// Calls `visit(pixel)` for each pixel of a strip of tiles, tile by tile from left to right. In the order
  /// `Near` the numbers of their rays follow each other.
  template <TileOrder kOrder, typename Visit> void visitStrip(int strip, const Visit &visit) const {
    const int top = strip * kSide, high = std::min(kSide, rows_ - top);
    std::uint32_t first = std::uint32_t(top) * std::uint32_t(width_);
    for (int left = 0; left < width_; left += kSide) {
      const int wide = std::min(kSide, width_ - left);
      if (wide == kSide && high == kSide)
        visitWhole<kOrder>({first, 0, left, top}, visit);
      else
        visitPart<kOrder>({first, 0, left, top}, wide, high, visit);
      first += std::uint32_t(wide * high);
    }
  }

  template <TileOrder kOrder, typename Visit> void visitAll(const Visit &visit) const {
    for (int strip = 0; strip < strips(); ++strip)
      visitStrip<kOrder>(strip, visit);
  }

private:
  static constexpr int kSide = TilePlaces::kSide;
  static constexpr unsigned kCount = TilePlaces::kCount;

  static constexpr unsigned codeAt(TileOrder order, unsigned place) {
    return order == TileOrder::Near ? place : (place << 4 | place >> 4) % kCount;
  }

  /// The pixel that has this code in the tile that begins with `first`, and so many of its rays before it.
  TiledPixel pixelAt(const TiledPixel &first, unsigned code, std::uint32_t before) const {
    const int column = first.column + kTilePlaces.columns[code], row = first.row + kTilePlaces.rows[code];
    return {first.ray + before, std::uint32_t(row) * std::uint32_t(width_) + std::uint32_t(column), column,
            row};
  }

  template <TileOrder kOrder, typename Visit>
  void visitWhole(const TiledPixel &first, const Visit &visit) const {
    for (unsigned place = 0; place < kCount; ++place) {
      const unsigned code = codeAt(kOrder, place);
      visit(pixelAt(first, code, code));
    }
  }

  template <TileOrder kOrder, typename Visit>
  void visitPart(const TiledPixel &first, int wide, int high, const Visit &visit) const {
    const auto isIn = [&](unsigned code) {
      return kTilePlaces.columns[code] < wide && kTilePlaces.rows[code] < high;
    };
    std::array<std::uint8_t, kCount> before{};
    for (unsigned code = 1; code < kCount; ++code)
      before[code] = std::uint8_t(before[code - 1] + isIn(code - 1));
    for (unsigned place = 0; place < kCount; ++place) {
      const unsigned code = codeAt(kOrder, place);
      if (isIn(code))
        visit(pixelAt(first, code, before[code]));
    }
  }

  int width_;
  int rows_;
};

} // namespace voxc
