// What tests of dense volumes share: bytes of samples, and where voxels lie in the model.
#pragma once

#include "Input/InputTesting.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>

namespace voxc {

/// Of numbers that lie behind each other.
template <typename Value>
inline std::string bytesOf(std::initializer_list<Value> values, bool bigEndian = false) {
  std::string bytes;
  for (const Value value : values) {
    std::array<char, sizeof value> raw;
    std::memcpy(raw.data(), &value, sizeof value);
    if (bigEndian)
      std::ranges::reverse(raw);
    bytes.append(raw.data(), raw.size());
  }
  return bytes;
}

class DenseVolumes : public OpenedInputs {
protected:
  Voxels raw(const std::string &what, const std::string &content) {
    return take(openInput("raw:" + what + ":" + folder_.file("samples.bin", content), options_));
  }
  /// A point of voxels in the model.
  std::array<double, 3> toModel(double x, double y, double z) const {
    const glm::dvec3 point = map_ * glm::dvec4(x, y, z, 1);
    return {point.x, point.y, point.z};
  }
};

inline constexpr std::uint32_t kBlack = 0xff000000;
inline constexpr std::uint32_t kWhite = 0xffffffff;

/// Voxels of the samples 1 to 6 of 3 x 2 x 1.
inline const Voxels kSix{{0, kBlack},     {1, 0xff333333}, {8, 0xff666666},
                         {2, 0xff999999}, {3, 0xffcccccc}, {10, kWhite}};

} // namespace voxc
