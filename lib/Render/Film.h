// What the samples of a band of a picture gather, and the light that it comes to.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace voxc {

/// Sums over the samples of a pixel.
struct FilmPixel {
  glm::vec3 light{};    ///< Linear; of the sun, or whatever the style shows.
  glm::vec3 skyLit{};   ///< What an open sky would give on top of that.
  float sky = 0;        ///< Of that, the share that is not hidden, in sum over the hits.
  float hits = 0;       ///< Samples that hit.
  float value = 0;      ///< Of maps.
  glm::vec3 backdrop{}; ///< Behind the samples that missed.
  glm::vec3 normal{};   ///< Of the first hit;
  glm::vec3 point{};    ///< and where it lies.
};

/// Rows of a picture, from `firstRow` on.
struct Film {
  int width = 0;
  int firstRow = 0;
  int rows = 0;
  std::vector<FilmPixel> pixels;

  Film(int width, int firstRow, int rows)
      : width(width), firstRow(firstRow), rows(rows), pixels(std::size_t(width) * std::size_t(rows)) {}
  std::size_t index(int column, int row) const {
    return std::size_t(row - firstRow) * std::size_t(width) + std::size_t(column);
  }
};

/// From so many samples on, a pixel has looked at the sky in directions enough of its own; with fewer, it and
/// its neighbours tell each other.
inline constexpr unsigned kManySamples = 32;
inline bool isSkySpread(unsigned samples) { return samples < kManySamples; }

/// Pixels whose directions to the sky are different lie in squares of so many a side.
inline constexpr int kSkyPattern = 4;
/// Which of the directions to the sky a pixel takes: those of such a square are all different.
std::uint32_t skyPattern(int column, int row);
/// Rows that `smoothSky` looks at beyond those it is asked for, on either side.
inline constexpr int kFilmMargin = kSkyPattern / 2;

/// The share of the sky of each pixel of a row: its own, or, `isSpread`, the mean over the square of pixels
/// around it that lie on the same surface.
std::vector<float> skyShares(const Film &film, int row, bool isSpread);

} // namespace voxc
