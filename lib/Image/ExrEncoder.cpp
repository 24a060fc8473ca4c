// Pictures of light as OpenEXR, in the plainest form that the format has ("OpenEXR File Layout", version 2).
#include "voxc/Image/Encode.h"

#include "Support/Srgb.h"

#include <bit>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace voxc {

namespace {

void addWord(std::string &out, std::uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8)
    out += char(word >> shift & 255);
}

void addLong(std::string &out, std::uint64_t word) {
  addWord(out, std::uint32_t(word));
  addWord(out, std::uint32_t(word >> 32));
}

void addFloat(std::string &out, float value) { addWord(out, std::bit_cast<std::uint32_t>(value)); }

void addName(std::string &out, std::string_view name) {
  out += name;
  out += '\0';
}

void addAttribute(std::string &out, std::string_view name, std::string_view type, const std::string &value) {
  addName(out, name);
  addName(out, type);
  addWord(out, std::uint32_t(value.size()));
  out += value;
}

/// The channels of a file stand in the order of their names.
struct Channel {
  char name;
  std::size_t place; ///< In the numbers of a pixel.
};
constexpr Channel kChannels[] = {{'A', 3}, {'B', 2}, {'G', 1}, {'R', 0}};

std::string channelList() {
  std::string list;
  for (const Channel &channel : kChannels) {
    addName(list, {&channel.name, 1});
    constexpr std::uint32_t kFloat = 2, kNotPerceptual = 0, kEveryPixel = 1;
    for (const std::uint32_t word : {kFloat, kNotPerceptual, kEveryPixel, kEveryPixel})
      addWord(list, word);
  }
  return list + '\0';
}

std::string header(int width, int height) {
  constexpr std::uint32_t kMagic = 20000630, kVersion = 2;
  std::string out, window, centre, one;
  for (const int corner : {0, 0, width - 1, height - 1})
    addWord(window, std::uint32_t(corner));
  addFloat(centre, 0);
  addFloat(centre, 0);
  addFloat(one, 1);
  addWord(out, kMagic);
  addWord(out, kVersion);
  addAttribute(out, "channels", "chlist", channelList());
  addAttribute(out, "compression", "compression", std::string(1, '\0')); // None.
  addAttribute(out, "dataWindow", "box2i", window);
  addAttribute(out, "displayWindow", "box2i", window);
  addAttribute(out, "lineOrder", "lineOrder", std::string(1, '\0')); // From the top.
  addAttribute(out, "pixelAspectRatio", "float", one);
  addAttribute(out, "screenWindowCenter", "v2f", centre);
  addAttribute(out, "screenWindowWidth", "float", one);
  return out + '\0';
}

} // namespace

std::string encodeExr(std::span<const float> light, int width, int height) {
  std::string out = header(width, height);
  const std::uint64_t lineBytes = std::uint64_t(width) * std::size(kChannels) * sizeof(float);
  const std::uint64_t chunkBytes = 2 * sizeof(std::uint32_t) + lineBytes;
  const std::uint64_t first = out.size() + std::uint64_t(height) * sizeof(std::uint64_t);
  out.reserve(first + std::uint64_t(height) * chunkBytes);
  for (int row = 0; row < height; ++row)
    addLong(out, first + std::uint64_t(row) * chunkBytes);
  for (int row = 0; row < height; ++row) {
    addWord(out, std::uint32_t(row));
    addWord(out, std::uint32_t(lineBytes));
    for (const Channel &channel : kChannels)
      for (int column = 0; column < width; ++column)
        addFloat(out,
                 light[4 * (std::size_t(row) * std::size_t(width) + std::size_t(column)) + channel.place]);
  }
  return out;
}

std::string encodeExr(std::span<const std::uint32_t> words, int width, int height) {
  std::vector<float> light;
  light.reserve(4 * words.size());
  const auto linear = [](std::uint32_t channel) { return float(kLinearLight[channel & 255]); };
  for (const std::uint32_t word : words)
    light.insert(light.end(), {linear(word), linear(word >> 8), linear(word >> 16), 1.0f});
  return encodeExr(light, width, height);
}

} // namespace voxc
