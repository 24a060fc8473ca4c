// Reading and writing of texts about inputs.
#include "Input/Openers/InputText.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <utility>

namespace voxc {

Error notUsable(const Error &error, const std::string &path, std::string_view kind) {
  if (error.kind != ErrorKind::Input)
    return error;
  return Error::input("'" + path + "' is not a usable " + std::string(kind) + ": " + error.message);
}

int longestAxis(Int3 extent) { return std::max({extent.x, extent.y, extent.z}); }

std::string byThree(const std::array<double, 3> &numbers) {
  std::array<char, 96> text;
  std::snprintf(text.data(), text.size(), "%.6g x %.6g x %.6g", numbers[0], numbers[1], numbers[2]);
  return text.data();
}

InputFact sizeFact(std::string name, Int3 size) {
  const std::array<double, 3> numbers{double(size.x), double(size.y), double(size.z)};
  const std::string text =
      std::to_string(size.x) + " x " + std::to_string(size.y) + " x " + std::to_string(size.z);
  return {std::move(name), text, {numbers.begin(), numbers.end()}};
}

InputFact boxFact(std::string name, const std::array<double, 3> &low, const std::array<double, 3> &high) {
  std::array<char, 192> text;
  std::snprintf(text.data(), text.size(), "(%.6g, %.6g, %.6g) to (%.6g, %.6g, %.6g)", low[0], low[1], low[2],
                high[0], high[1], high[2]);
  return {std::move(name), text.data(), {low[0], low[1], low[2], high[0], high[1], high[2]}};
}

InputFact countFact(std::string name, std::uint64_t count) {
  return {std::move(name), std::to_string(count), {double(count)}};
}

Int3 modelExtent(const InputOptions &options) {
  return options.resolution > 0 ? options.mostExtent() : options.formatExtent;
}

std::optional<int> parseCount(std::string_view text) {
  int value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  if (parsed.ec != std::errc() || parsed.ptr != text.data() + text.size() || value < 1)
    return std::nullopt;
  return value;
}

std::optional<Int3> parseExtent(std::string_view text) {
  Int3 extent;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t end = axis < 2 ? text.find('x') : text.size();
    const auto size = end == std::string_view::npos ? std::nullopt : parseCount(text.substr(0, end));
    if (!size)
      return std::nullopt;
    extent[axis] = *size;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return extent;
}

std::string toText(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string upProvenance(const InputOptions &options) { return options.zUp ? " up=z" : " up=y"; }

std::string withProvenance(const std::string &provenance, std::string_view key, const std::string &value) {
  const std::string start = std::string(key) + "=";
  std::string text;
  for (std::size_t begin = 0; begin < provenance.size();) {
    const std::size_t end = std::min(provenance.find(' ', begin), provenance.size());
    const std::string_view word = std::string_view(provenance).substr(begin, end - begin);
    if (!word.starts_with(start))
      text += std::string(word) + " ";
    begin = end + 1;
  }
  return text + start + value;
}

Expected<double> voxelSide(const InputOptions &options, double unit) {
  const Length &size = options.voxelSize;
  if (size.value == 0 || size.metres == 0)
    return size.value;
  const double metres = options.unit > 0 ? options.unit : unit;
  if (!(metres > 0))
    return Error::usage("the input does not say how long its unit is, and a voxel cannot be " +
                        toText(size.value) + " " + unitName(size.metres).value_or("units") +
                        " of it; --unit says it, one of " + unitNames());
  return size.value * (size.metres / metres);
}

std::string gridProvenance(double side, const InputOptions &options) {
  std::string text;
  if (side > 0)
    text += " voxel-size=" + toText(side);
  for (std::size_t i = 0; options.align && i < 3; ++i)
    text += (i == 0 ? " align=" : ",") + toText((*options.align)[i]);
  return text;
}

std::string provenanceWord(std::string_view text) {
  std::string word;
  for (const char c : text)
    word += c == ' ' ? "%20" : c == '%' ? "%25" : std::string(1, c);
  return word;
}

std::string modelProvenance(std::string_view coverage, int resolution, const InputOptions &options) {
  std::string text = "resolution=" + std::to_string(resolution) + " coverage=" + std::string(coverage);
  if (options.bounds) {
    text += " bounds=";
    for (std::size_t i = 0; i < options.bounds->size(); ++i)
      text += (i == 0 ? "" : ",") + toText((*options.bounds)[i]);
  }
  return text + upProvenance(options);
}

} // namespace voxc
