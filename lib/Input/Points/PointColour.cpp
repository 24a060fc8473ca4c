// Spherical harmonics and opacities of splats, as their training leaves them.
#include "Input/Points/PointColour.h"

#include "Support/Text.h"

#include <algorithm>
#include <cmath>

namespace voxc {

namespace {

/// The zeroth real spherical harmonic: 1 / (2 sqrt(pi)).
constexpr double kHarmonic = 0.28209479177387814;

/// Splats below are faint: most of them are haze.
constexpr double kLeastOpacity = 0.1;

constexpr std::array<std::string_view, 3> kHarmonicNames{"f_dc_0", "f_dc_1", "f_dc_2"};

/// What makes up a splat beside its place, colour and opacity.
constexpr std::array<std::string_view, 3> kShapePrefixes{"f_rest_", "scale_", "rot_"};

bool isShape(const PlyProperty &property) {
  return std::ranges::any_of(
      kShapePrefixes, [&](std::string_view prefix) { return lowerCase(property.name).starts_with(prefix); });
}

} // namespace

PointColour::PointColour(const PlyElement &vertices)
    : vertices_(vertices), colour_(vertices), opacity_(findNumber(vertices, "opacity")) {
  for (std::size_t i = 0; i < harmonics_.size(); ++i)
    harmonics_[i] = findNumber(vertices, kHarmonicNames[i]);
  areSplats_ = harmonics_[0] && harmonics_[1] && harmonics_[2];
}

std::uint32_t PointColour::operator()(const PlyRow &row) const {
  if (!areSplats_)
    return colour_(row);
  // What is kept is the logit. Written so that NaN is faint.
  if (opacity_ && !(1 / (1 + std::exp(-row.values[*opacity_])) >= kLeastOpacity))
    return 0;
  std::uint32_t word = 0xff000000;
  for (std::size_t i = 0; i < harmonics_.size(); ++i) {
    const double share = 0.5 + kHarmonic * row.values[*harmonics_[i]];
    const double bounded = share > 0 ? std::fmin(share, 1) : 0;
    word |= static_cast<std::uint32_t>(std::lround(bounded * 255)) << 8 * i;
  }
  return word;
}

void PointColour::take(PlyUse &use) const {
  if (!areSplats_)
    return colour_.take(use);
  for (const auto &harmonic : harmonics_)
    use.take(vertices_, harmonic);
  use.take(vertices_, opacity_);
  for (std::size_t i = 0; i < vertices_.properties.size(); ++i)
    if (isShape(vertices_.properties[i]))
      use.take(vertices_, i);
}

std::vector<std::string> PointColour::warnings() const {
  if (areSplats_)
    return {"the points are Gaussian splats: each is one voxel of the colour that it has from all sides; "
            "their sizes, turns and higher harmonics are not used"};
  std::string warning = colour_.warning();
  return warning.empty() ? std::vector<std::string>() : std::vector{std::move(warning)};
}

std::string PointColour::saysDropped(std::uint64_t count, std::uint64_t all) const {
  if (areSplats_)
    return "left out are " + std::to_string(count) + " of " + counted(all, "splat") +
           ", whose opacity is below 0.1";
  return countedAre(count, "point") + " dropped, of the colour 0, which means empty";
}

} // namespace voxc
