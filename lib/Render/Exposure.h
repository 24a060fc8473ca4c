// From light to what a screen shows.
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>

namespace voxc {

/// The factor for the light of a picture, four numbers a pixel as in `Rendering::light`: it lifts dark
/// scenes and lowers bright ones half of the way, so that black stays darker than white, and keeps all but
/// the brightest hundredth of the pixels below white. 1 if nothing was hit.
float exposureOf(std::span<const float> light);

/// The factor for the shares of the sky that the pixels of a picture see, as red in `Rendering::light`: it
/// brings the greatest hundredth to the whole sky, up to a factor of 4. 1 if nothing was hit.
float skyExposureOf(std::span<const float> light);

/// The linear grey of clay that sees this share of the sky, up to 1. Most of what is seen from outside sees
/// most of the sky; the curve spreads these shares, and the brightest is well below white.
float clayOf(float share);

/// Brings light into [0, 1]: as it is up to 0.7, then more and more compressed, as film does; what is far too
/// bright turns white.
glm::vec3 compress(const glm::vec3 &light);

/// A linear channel as one of the screen (sRGB), and back.
float toScreen(float linear);
float toLinear(float screen);

/// An opaque pixel of linear channels in [0, 1].
std::uint32_t screenPixel(const glm::vec3 &linear);
/// The linear colour of a pixel or a voxel's word; alpha is left out.
glm::vec3 linearColour(std::uint32_t word);

} // namespace voxc
