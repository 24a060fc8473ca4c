// Slices of PNG pictures, and what slices of every kind share.
#include "Image/PngReader.h"
#include "Input/Dense/Slice.h"

#include "Support/Text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>

namespace voxc {

namespace {

class PngSlice final : public SliceReader {
public:
  explicit PngSlice(std::unique_ptr<PngReader> reader) : reader_(std::move(reader)) {
    const PngHeader &header = reader_->header();
    if (auto sentence = saysOblong(header.pixelsAUnit))
      warnings.push_back(std::move(*sentence));
    if (header.hasFrames)
      warnings.emplace_back("it is an animation, of which the first picture is taken");
    if (header.bytesBehind != 0)
      warnings.push_back(countedAre(header.bytesBehind, "byte") + " left out, which lie behind the picture");
  }

  Expected<bool> next(Slice &slice) override {
    const PngHeader &header = reader_->header();
    slice = {static_cast<std::int32_t>(header.width), static_cast<std::int32_t>(header.height), header.isGrey,
             header.isGrey && header.isWide() ? SampleType::Uint16 : SampleType::Uint8,
             header.isGrey ? std::min(header.bits, 8u) : 8};
    return !std::exchange(isRead_, true);
  }

  Expected<void> decode(std::span<std::byte> target) override {
    if (auto decoded = reader_->decode(target); !decoded)
      return Error::input("it is broken: " + decoded.error().message);
    if (!reader_->header().isGrey && !reader_->header().hasAlpha)
      clearBlack(target);
    return {};
  }

private:
  std::unique_ptr<PngReader> reader_;
  bool isRead_ = false;
};

} // namespace

Expected<void> checkSlice(std::uint64_t width, std::uint64_t height, std::uint64_t bytes) {
  constexpr std::uint64_t kMostCells = std::uint64_t{1} << 26;
  // No PNG has more texels a byte: deflate makes 1032 bytes of one, of one bit a texel.
  constexpr std::uint64_t kMostCellsAByte = 8400;
  constexpr std::uint64_t kFewCells = 1 << 16;
  const bool isPossible = width > 0 && height > 0 && width <= kMostCells && height <= kMostCells;
  if (isPossible && width * height <= kMostCells && width * height <= kFewCells + kMostCellsAByte * bytes)
    return {};
  return Error::input("it has " + std::to_string(width) + "x" + std::to_string(height) +
                      " cells, more than the 2^26 that a slice may have, or than its " +
                      std::to_string(bytes) + " bytes can hold");
}

std::optional<std::string> saysOblong(const std::array<double, 2> &pixelsAUnit) {
  const auto [x, y] = pixelsAUnit;
  constexpr double kSame = 1e-3;
  if (!(x > 0 && y > 0) || std::abs(x / y - 1) <= kSame)
    return std::nullopt;
  std::array<char, 64> sides;
  std::snprintf(sides.data(), sides.size(), "1 : %.4g", x / y);
  return "its pixels are no squares (" + std::string(sides.data()) +
         ", width to height), which is left out: voxels are cubes";
}

void clearBlack(std::span<std::byte> cells) {
  constexpr std::uint32_t kBlack = 0xff000000;
  for (std::size_t at = 0; at < cells.size(); at += 4) {
    std::uint32_t word = 0;
    std::memcpy(&word, cells.data() + at, sizeof word);
    if (word == kBlack)
      std::memset(cells.data() + at, 0, sizeof word);
  }
}

Expected<std::unique_ptr<SliceReader>> openPngSlice(std::span<const std::byte> bytes) {
  auto reader = openPng(bytes, PngForm::Samples);
  if (!reader)
    return reader.error();
  const PngHeader &header = (*reader)->header();
  if (auto checked = checkSlice(header.width, header.height, bytes.size()); !checked)
    return checked.error();
  return std::unique_ptr<SliceReader>(std::make_unique<PngSlice>(std::move(*reader)));
}

} // namespace voxc
