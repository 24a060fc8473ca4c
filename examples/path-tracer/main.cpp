// path-tracer FILE.png [WIDTH HEIGHT PATHS]: a picture of the hall, with so many paths a pixel.
#include "Compute.h"
#include "Hall.h"
#include "path_spirv.h"

#include <voxc/Construct/Constructor.h>
#include <voxc/Source/Sources.h>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace {

constexpr float kHalfHeight = 0.62f; // Of the picture, at distance 1.

/// The shader's push constants.
struct Frame {
  glm::vec4 eye, right, up, forward;
  std::uint32_t width, height, number;
};

Frame makeFrame(std::uint32_t width, std::uint32_t height) {
  const glm::vec3 eye(178.5f, 60.5f, 4.5f), target(117.0f, 42.0f, 140.0f);
  const glm::vec3 forward = glm::normalize(target - eye);
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
  const float halfWidth = kHalfHeight * static_cast<float>(width) / static_cast<float>(height);
  return {glm::vec4(eye, 0),
          glm::vec4(right * halfWidth, 0),
          glm::vec4(glm::cross(right, forward) * kHalfHeight, 0),
          glm::vec4(forward, 0),
          width,
          height,
          0};
}

voxc::Expected<voxc::Volume> buildHall() {
  std::ifstream file(HALL_FORMAT);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto format = voxc::parseFormat(text);
  if (!format)
    return format.error();
  const auto constructor = voxc::Constructor::compile(*format);
  if (!constructor)
    return constructor.error();
  auto built = constructor->build(*voxc::makeFunctionSource(kHallSize, hallVoxel));
  if (!built)
    return built.error();
  return std::move(built->volume);
}

/// Light to bytes: the filmic curve of Hejl and Burgess-Dawson, which has the exponent of displays in it.
png_byte byteOf(float light) {
  const float x = std::max(light - 0.004f, 0.0f);
  const float y = x * (6.2f * x + 0.5f) / (x * (6.2f * x + 1.7f) + 0.06f);
  return static_cast<png_byte>(std::lround(255.0f * std::min(y, 1.0f)));
}

bool writePng(const char *path, const Frame &frame, const glm::vec4 *sums) {
  std::vector<png_byte> bytes;
  for (std::size_t i = 0; i < std::size_t{frame.width} * frame.height; ++i)
    for (int channel = 0; channel < 3; ++channel)
      bytes.push_back(byteOf(0.75f * sums[i][channel] / sums[i].w));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = frame.width;
  image.height = frame.height;
  image.format = PNG_FORMAT_RGB;
  return png_image_write_to_file(&image, path, 0, bytes.data(), 0, nullptr) != 0;
}

} // namespace

int main(int count, char **arguments) {
  if (count != 2 && count != 5) {
    std::fprintf(stderr, "usage: path-tracer FILE.png [WIDTH HEIGHT PATHS]\n");
    return 2;
  }
  const auto number = [&](int i, std::uint32_t fallback) {
    return count == 5 ? static_cast<std::uint32_t>(std::strtoul(arguments[i], nullptr, 10)) : fallback;
  };
  Frame frame = makeFrame(std::clamp(number(2, 640), 1u, 8192u), std::clamp(number(3, 360), 1u, 8192u));
  const std::uint32_t paths = std::max(number(4, 32), 1u);

  const auto volume = buildHall();
  if (!volume) {
    std::fprintf(stderr, "path-tracer: %s\n", volume.error().message.c_str());
    return 1;
  }
  const auto words = volume->words();
  std::printf("%zu words\n", words.size());

  const std::array sizes{words.size_bytes(), std::size_t{16} * frame.width * frame.height};
  Compute compute(path_spirv, sizeof frame, sizes);
  std::memcpy(compute.memory(0), words.data(), words.size_bytes());
  for (frame.number = 0; frame.number < paths; ++frame.number)
    compute.run(&frame, (frame.width + 7) / 8, (frame.height + 7) / 8);

  if (!writePng(arguments[1], frame, static_cast<const glm::vec4 *>(compute.memory(1)))) {
    std::fprintf(stderr, "path-tracer: %s cannot be written\n", arguments[1]);
    return 1;
  }
  std::printf("%u x %u pixels of %u paths in %s\n", frame.width, frame.height, paths, arguments[1]);
}
