// Pictures made small.
#include "SmallPicture.h"

#include "voxc/Image/Encode.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace voxc::tool {
namespace {

/// Widths and qualities that are tried, best first.
struct Trial {
  int width, quality;
};
constexpr Trial kTrials[] = {{960, 80}, {880, 78}, {800, 76}, {720, 76}, {640, 74},
                             {560, 74}, {480, 72}, {480, 50}, {400, 60}, {400, 45},
                             {320, 60}, {320, 45}, {320, 30}, {240, 40}, {160, 60}};
constexpr int kMostHeight = 2048;

std::string base64(std::string_view bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

/// The mean of a block of pixels, opaque.
std::uint32_t mean(const Picture &picture, int left, int top, int right, int bottom) {
  std::uint64_t sums[3] = {};
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      for (int channel = 0; channel < 3; ++channel)
        sums[channel] +=
            picture.pixels[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)] >> 8 * channel & 255;
  const auto count = static_cast<std::uint64_t>(right - left) * static_cast<std::uint64_t>(bottom - top);
  std::uint32_t pixel = 0xff000000u;
  for (int channel = 0; channel < 3; ++channel)
    pixel |= static_cast<std::uint32_t>((sums[channel] + count / 2) / count) << 8 * channel;
  return pixel;
}

} // namespace

Picture shrunk(const Picture &picture, int width) {
  if (picture.width <= width)
    return picture;
  Picture small{
      width, std::max(1, static_cast<int>(std::int64_t{picture.height} * width / picture.width)), {}};
  const auto edge = [](int i, int from, int to) { return static_cast<int>(std::int64_t{i} * from / to); };
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      small.pixels.push_back(mean(picture, edge(x, picture.width, width),
                                  edge(y, picture.height, small.height), edge(x + 1, picture.width, width),
                                  edge(y + 1, picture.height, small.height)));
  return small;
}

std::string pictureAddress(const Picture &picture, std::size_t mostBytes) {
  for (const Trial &trial : kTrials) {
    const Picture small = shrunk(picture, trial.width);
    if (small.height > kMostHeight)
      continue;
    const auto jpeg = encodeJpeg(small.pixels, small.width, small.height, trial.quality);
    std::string address = jpeg ? "data:image/jpeg;base64," + base64(*jpeg) : std::string();
    if (jpeg && address.size() <= mostBytes)
      return address;
  }
  return {};
}

} // namespace voxc::tool
