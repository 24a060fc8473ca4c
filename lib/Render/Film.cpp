// The share of the sky, from pixels that looked in different directions.
#include "Film.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

/// How much pixel `b` tells of the sky over pixel `a`: nothing where they lie on different surfaces. `reach`
/// is how far apart neighbouring points of one surface may be, along it.
float bilateralWeight(const FilmPixel &a, const FilmPixel &b) {
  const float along = glm::dot(a.normal, b.normal);
  if (along < 0.5f)
    return 0;
  const glm::vec3 apart = b.point - a.point;
  const float off = std::abs(glm::dot(apart, a.normal));
  // A surface of voxels is a voxel or so thick, and bends.
  const float thickness = 1.5f + 0.35f * glm::length(apart);
  return off < thickness ? along : 0;
}

} // namespace

std::uint32_t skyPattern(int column, int row) {
  constexpr std::uint32_t kOrder[kSkyPattern][kSkyPattern] = {
      {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
  return kOrder[row % kSkyPattern][column % kSkyPattern];
}

std::vector<float> skyShares(const Film &film, int row, bool isSpread) {
  std::vector<float> shares(std::size_t(film.width), 0.0f);
  const int top = std::max(row - kFilmMargin, film.firstRow);
  const int bottom = std::min(row + kSkyPattern - kFilmMargin, film.firstRow + film.rows);
  for (int column = 0; column < film.width; ++column) {
    const FilmPixel &pixel = film.pixels[film.index(column, row)];
    if (pixel.hits == 0)
      continue;
    float &share = shares[std::size_t(column)];
    share = pixel.sky / pixel.hits;
    if (!isSpread)
      continue;
    float sum = 0;
    float weights = 0;
    for (int y = top; y < bottom; ++y)
      for (int x = std::max(column - kFilmMargin, 0);
           x < std::min(column + kSkyPattern - kFilmMargin, film.width); ++x) {
        const FilmPixel &other = film.pixels[film.index(x, y)];
        if (other.hits == 0)
          continue;
        const float weight = bilateralWeight(pixel, other);
        sum += weight * other.sky;
        weights += weight * other.hits;
      }
    if (weights > 0)
      share = sum / weights;
  }
  return shares;
}

} // namespace voxc
