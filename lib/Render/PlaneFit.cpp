// The plane that runs through a neighbourhood of voxels: the least axis of their moments of inertia.
#include "PlaneFit.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace voxc {

namespace {

/// Voxels count less the further off the middle they are: by a bell curve on each axis.
constexpr float kWeights[kReach + 1] = {1.0f, 0.9f, 0.64f, 0.37f, 0.17f};

constexpr float weightOf(int offset) { return kWeights[offset < 0 ? -offset : offset]; }

/// Weighted count, sum and sum of squares of the x of the bits of a row.
struct RowMoments {
  float count = 0;
  float sum = 0;
  float squares = 0;
};

constexpr auto kRows = [] {
  std::array<RowMoments, 1 << kNeighbours> rows{};
  for (int bits = 0; bits < 1 << kNeighbours; ++bits)
    for (int x = -kReach; x <= kReach; ++x)
      if (bits >> (x + kReach) & 1) {
        RowMoments &row = rows[std::size_t(bits)];
        row.count += weightOf(x);
        row.sum += weightOf(x) * float(x);
        row.squares += weightOf(x) * float(x * x);
      }
  return rows;
}();

/// A symmetric matrix, of which the upper half is kept in order.
struct Covariance {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

/// The three eigenvalues, ascending: roots of the characteristic polynomial by the cosine formula.
glm::dvec3 eigenvalues(const Covariance &c) {
  const double mean = (c.xx + c.yy + c.zz) / 3;
  const double xx = c.xx - mean, yy = c.yy - mean, zz = c.zz - mean;
  const double off = c.xy * c.xy + c.xz * c.xz + c.yz * c.yz;
  const double p = std::sqrt((xx * xx + yy * yy + zz * zz + 2 * off) / 6);
  if (p < 1e-12)
    return {mean, mean, mean};
  const double determinant =
      xx * (yy * zz - c.yz * c.yz) - c.xy * (c.xy * zz - c.yz * c.xz) + c.xz * (c.xy * c.yz - yy * c.xz);
  const double cosine = std::fmin(std::fmax(determinant / (2 * p * p * p), -1.0), 1.0);
  constexpr double kThird = 2.0943951023931953;
  const double angle = std::acos(cosine) / 3;
  const double high = mean + 2 * p * std::cos(angle);
  const double low = mean + 2 * p * std::cos(angle + kThird);
  return {low, 3 * mean - high - low, high};
}

/// The eigenvector of a simple eigenvalue: orthogonal to the rows of the matrix less that value.
glm::dvec3 eigenvector(const Covariance &c, double value) {
  const glm::dvec3 rows[3] = {
      {c.xx - value, c.xy, c.xz}, {c.xy, c.yy - value, c.yz}, {c.xz, c.yz, c.zz - value}};
  glm::dvec3 best{};
  double longest = 0;
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 across = glm::cross(rows[i], rows[(i + 1) % 3]);
    const double length = glm::dot(across, across);
    if (length > longest) {
      longest = length;
      best = across;
    }
  }
  return longest > 0 ? best / std::sqrt(longest) : glm::dvec3{};
}

} // namespace

glm::vec3 planeNormal(const Neighbourhood &voxels) {
  double count = 0, x = 0, y = 0, z = 0;
  Covariance moments;
  for (int row = 0; row < kNeighbours * kNeighbours; ++row) {
    const RowMoments &part = kRows[voxels[std::size_t(row)]];
    if (part.count == 0)
      continue;
    const int dy = row % kNeighbours - kReach;
    const int dz = row / kNeighbours - kReach;
    const double weight = weightOf(dy) * weightOf(dz);
    const double n = weight * part.count, sx = weight * part.sum;
    count += n;
    x += sx;
    y += n * dy;
    z += n * dz;
    moments.xx += weight * part.squares;
    moments.xy += sx * dy;
    moments.xz += sx * dz;
    moments.yy += n * dy * dy;
    moments.yz += n * dy * dz;
    moments.zz += n * dz * dz;
  }
  constexpr double kFewest = 3; // Of weighted voxels.
  if (count < kFewest)
    return {};
  const Covariance spread = {
      moments.xx / count - x * x / (count * count), moments.xy / count - x * y / (count * count),
      moments.xz / count - x * z / (count * count), moments.yy / count - y * y / (count * count),
      moments.yz / count - y * z / (count * count), moments.zz / count - z * z / (count * count)};
  const glm::dvec3 values = eigenvalues(spread);
  constexpr double kEven = 0.85; // Above, the least axis is not much less than the next.
  if (values[0] > kEven * values[1])
    return {};
  return glm::vec3(eigenvector(spread, values[0]));
}

} // namespace voxc
