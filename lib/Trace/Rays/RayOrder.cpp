// In which order a tracer takes its rays.
#include "voxc/Trace/RayOrder.h"

#include "RayBins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace voxc {
namespace {

/// A bin's number, from the high bits down: the octant, the Morton number of the cell of origin in a grid of
/// 16^3, and that of the direction's place in its octant, in a grid of 4x4. Finer cells and directions were
/// no faster, coarser ones slower (docs/notes/2026-11-22-walks.md).
constexpr unsigned kOriginBits = 4;
constexpr unsigned kDirectionBits = 2;
constexpr unsigned kBinBits = 3 + 3 * kOriginBits + 2 * kDirectionBits;

/// Of a sort by two digits.
constexpr unsigned kDigitBits = (kBinBits + 1) / 2;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;

/// Below this, packets of one bin are rare.
constexpr std::size_t kFewestRays = std::size_t{1} << 15;

/// What a sample looks at: so many groups of neighbours.
constexpr std::size_t kSampledGroups = 256;
constexpr std::size_t kGroupRays = 16;

/// The cell of [0, 1) that holds `x`; the nearest one if none does, the first if `x` is no number.
unsigned cellOf(float x, unsigned bits) {
  const auto cells = static_cast<float>(1u << bits);
  return x > 0 ? static_cast<unsigned>(std::min(x * cells, cells - 1)) : 0;
}

unsigned octantOf(const Ray &ray) {
  unsigned octant = 0;
  for (unsigned axis = 0; axis < 3; ++axis)
    octant |= static_cast<unsigned>(std::signbit(ray.direction[axis])) << axis;
  return octant;
}

/// The Morton number of `Axes` cells, with so many bits each.
template <std::size_t Axes> unsigned mortonOf(const std::array<unsigned, Axes> &cells, unsigned bits) {
  unsigned morton = 0;
  for (unsigned bit = 0; bit < bits; ++bit)
    for (std::size_t axis = 0; axis < Axes; ++axis)
      morton |= ((cells[axis] >> bit) & 1u) << (Axes * bit + axis);
  return morton;
}

unsigned originCellOf(const Ray &ray, float scale) {
  return mortonOf<3>({cellOf(ray.origin[0] * scale, kOriginBits), cellOf(ray.origin[1] * scale, kOriginBits),
                      cellOf(ray.origin[2] * scale, kOriginBits)},
                     kOriginBits);
}

/// Where the direction meets the octant's triangle of |x| + |y| + |z| = 1.
unsigned directionCellOf(const Ray &ray) {
  const float x = std::abs(ray.direction[0]);
  const float y = std::abs(ray.direction[1]);
  const float scale = 1 / (x + y + std::abs(ray.direction[2]));
  return mortonOf<2>({cellOf(x * scale, kDirectionBits), cellOf(y * scale, kDirectionBits)}, kDirectionBits);
}

unsigned binOf(const Ray &ray, float scale) {
  return ((octantOf(ray) << (3 * kOriginBits) | originCellOf(ray, scale)) << (2 * kDirectionBits)) |
         directionCellOf(ray);
}

/// How many items of a thread's share have a digit; then where the first of them goes.
using Places = std::array<std::uint32_t, kDigits>;

/// Makes counts places: digit by digit, and share by share within one, so that the sort is stable.
void placeDigits(std::vector<Places> &shares) {
  std::uint32_t next = 0;
  for (std::size_t digit = 0; digit < kDigits; ++digit)
    for (Places &places : shares)
      next += std::exchange(places[digit], next);
}

} // namespace

RayOrder rayOrderFrom(std::string_view name) {
  return name == "given" ? RayOrder::Given : name == "binned" ? RayOrder::Binned : RayOrder::Auto;
}

bool areScattered(const RaySpan &rays, int edge) {
  if (rays.size() < kFewestRays)
    return false;
  const float scale = 1 / static_cast<float>(edge);
  const std::size_t stride = rays.size() / kSampledGroups;
  std::size_t changes = 0;
  for (std::size_t group = 0; group < kSampledGroups; ++group) {
    const auto neighbours = rays.subspan(group * stride, kGroupRays);
    for (std::size_t i = 1; i < kGroupRays; ++i)
      changes += octantOf(neighbours[i]) != octantOf(neighbours[i - 1]) ||
                 originCellOf(neighbours[i], scale) != originCellOf(neighbours[i - 1], scale);
  }
  return changes > kSampledGroups * (kGroupRays - 1) / 4;
}

/// One pass of the sort: sends each item of [0, count) by a digit of its bin to `put(place, item)`.
template <typename Item, typename Put>
void RayBins::sendByDigit(const ThreadTeam &team, std::size_t count, unsigned shift, const Item &item,
                          const Put &put) {
  std::vector<Places> shares(team.size(), Places{});
  const auto digitOf = [shift](const BinnedRay &ray) { return (ray.bin >> shift) % kDigits; };
  team.share(count, [&](std::size_t first, std::size_t last, unsigned share) {
    for (std::size_t i = first; i < last; ++i)
      ++shares[share][digitOf(item(i))];
  });
  placeDigits(shares);
  team.share(count, [&](std::size_t first, std::size_t last, unsigned share) {
    for (std::size_t i = first; i < last; ++i) {
      const BinnedRay ray = item(i);
      put(shares[share][digitOf(ray)]++, ray);
    }
  });
}

std::span<const std::uint32_t> RayBins::order(const RaySpan &rays, int edge, const ThreadTeam &team) {
  const float scale = 1 / static_cast<float>(edge);
  if (rays.size() > order_.size()) {
    given_.resize(rays.size());
    half_.resize(rays.size());
    order_.resize(rays.size());
  }
  team.share(rays.size(), [&](std::size_t first, std::size_t last, unsigned) {
    for (std::size_t i = first; i < last; ++i)
      given_[i] = {binOf(rays[i], scale), static_cast<std::uint32_t>(i)};
  });
  sendByDigit(
      team, rays.size(), 0, [&](std::size_t i) { return given_[i]; },
      [&](std::size_t place, BinnedRay ray) { half_[place] = ray; });
  sendByDigit(
      team, rays.size(), kDigitBits, [&](std::size_t i) { return half_[i]; },
      [&](std::size_t place, BinnedRay ray) { order_[place] = ray.number; });
  return std::span(order_).first(rays.size());
}

std::vector<std::uint32_t> binnedOrder(const RaySpan &rays, int edge, unsigned threads) {
  RayBins bins;
  const auto order = bins.order(rays, edge, ThreadTeam(threads));
  return {order.begin(), order.end()};
}

} // namespace voxc
