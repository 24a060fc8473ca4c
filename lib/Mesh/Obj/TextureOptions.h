// Textures as .mtl files name them.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace voxc {

/// A texture as an .mtl names it.
struct MtlTexture {
  std::string image; ///< As it is written, without options; empty if there is none.
  std::string
      otherwise; ///< The same with options that are not known, which may belong to the name; or empty.
  bool clamp = false;
  std::uint8_t channel = 0; ///< Of a mask: red, green, blue or alpha.
  std::array<float, 2> scale{1, 1};
  std::array<float, 2> offset{0, 0};
};

/// Reads what follows "map_Kd" and the like: options, then the image. An option that is not known is skipped
/// with its numbers or its word. What would change the colours and is not used is added to `unused`.
MtlTexture readTexture(std::string_view text, std::set<std::string> &unused);

} // namespace voxc
