// From light to what a screen shows.
#include "Exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace voxc {

namespace {

/// The mean (of logarithms) and the brightest hundredth that a well-exposed picture has.
constexpr float kMiddle = 0.25f;
constexpr float kBright = 0.88f;

/// Between which factors of that the brightest may lie.
constexpr float kLeast = 0.85f;
constexpr float kMost = 2.5f;

/// How far the exposure goes from 1 at most.
constexpr float kMostFactor = 16;

constexpr float kShoulder = 0.7f; ///< Where compression begins.

float luminance(float red, float green, float blue) {
  return 0.2126f * red + 0.7152f * green + 0.0722f * blue;
}

constexpr float kClay = 0.8f;         ///< What white clay sends back.
constexpr float kClayContrast = 2.5f; ///< As an exponent.
constexpr float kMostSkyFactor = 4;

constexpr float kMostlyHit = 0.5f; ///< The share of a pixel from which on it has a say.

/// Of numbers, that which a hundredth of them exceeds. Precondition: there are some.
float brightestOf(std::vector<float> &numbers) {
  const auto top = numbers.begin() + std::ptrdiff_t(numbers.size() - 1 - numbers.size() / 100);
  std::ranges::nth_element(numbers, top);
  return *top;
}

} // namespace

float skyExposureOf(std::span<const float> light) {
  std::vector<float> shares;
  for (std::size_t i = 0; i + 3 < light.size(); i += 4)
    if (light[i + 3] >= kMostlyHit)
      shares.push_back(light[i] / light[i + 3]);
  if (shares.empty())
    return 1;
  const float most = brightestOf(shares);
  return most > 0 ? std::clamp(1 / most, 1.0f, kMostSkyFactor) : 1;
}

float clayOf(float share) { return kClay * std::pow(std::clamp(share, 0.0f, 1.0f), kClayContrast); }

float exposureOf(std::span<const float> light) {
  std::vector<float> bright;
  for (std::size_t i = 0; i + 3 < light.size(); i += 4)
    if (light[i + 3] >= kMostlyHit)
      bright.push_back(luminance(light[i], light[i + 1], light[i + 2]) / light[i + 3]);
  if (bright.empty())
    return 1;
  // What is black stays black, whatever the exposure, and has no say.
  const float brightest = brightestOf(bright);
  const float darkest = 0.02f * brightest;
  double logarithms = 0, count = 0;
  for (const float value : bright)
    if (value > darkest) {
      logarithms += std::log(double(value));
      count += 1;
    }
  if (count == 0)
    return 1;
  const float middle = float(std::exp(logarithms / count));
  const float factor = std::sqrt(kMiddle / middle * (kBright / brightest));
  // Not so little that the brightest are grey, nor so much that they burn.
  const float fitted = std::clamp(factor, kLeast * kBright / brightest, kMost * kBright / brightest);
  return std::clamp(fitted, 1 / kMostFactor, kMostFactor);
}

glm::vec3 compress(const glm::vec3 &light) {
  const float peak = std::max({light.x, light.y, light.z});
  if (peak <= kShoulder)
    return light;
  constexpr float kRest = 1 - kShoulder;
  const float compressed = 1 - kRest * kRest / (peak - kShoulder + kRest);
  const glm::vec3 colour = light * (compressed / peak);
  const float excess = peak - compressed;
  const float whiten = excess / (excess + 3);
  return colour + (glm::vec3(compressed) - colour) * whiten;
}

float toScreen(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1 / 2.4f) - 0.055f;
}

float toLinear(float screen) {
  return screen <= 0.04045f ? screen / 12.92f : std::pow((screen + 0.055f) / 1.055f, 2.4f);
}

std::uint32_t screenPixel(const glm::vec3 &linear) {
  const auto channel = [](float value) {
    return std::uint32_t(std::lround(toScreen(std::clamp(value, 0.0f, 1.0f)) * 255));
  };
  return channel(linear.x) | channel(linear.y) << 8 | channel(linear.z) << 16 | 0xff000000u;
}

glm::vec3 linearColour(std::uint32_t word) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = toLinear(float(i) / 255);
    return values;
  }();
  return {table[word & 0xff], table[word >> 8 & 0xff], table[word >> 16 & 0xff]};
}

} // namespace voxc
