// The samples of a dense volume as they are stored, and how they become words.
#pragma once

#include "voxc/Support/Error.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace voxc {

enum class SampleType : std::uint8_t {
  Int8,
  Uint8,
  Int16,
  Uint16,
  Int32,
  Uint32,
  Int64,
  Uint64,
  Float32,
  Float64
};

/// Bytes of one sample.
std::uint64_t byteSize(SampleType type);

/// How samples lie in memory, one after the other.
struct SampleLayout {
  SampleType type = SampleType::Uint8;
  bool bigEndian = false;
};

/// A type as "uint8", "int16le" or "float32be"; nothing if it is none of these.
std::optional<SampleLayout> parseSampleLayout(std::string_view text);
/// All types as `parseSampleLayout` takes them, for messages.
std::string sampleLayoutNames();
/// "int16", and "little-endian" or "big-endian" where that means something.
std::string toText(SampleLayout layout);
/// Whether samples are whole numbers.
bool isWhole(SampleType type);
/// The greatest number of a type of whole numbers.
double greatest(SampleType type);

/// The least and the greatest of numbers, but for those that are not finite.
struct SampleRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

/// NaN, and what is less than any number, as the logarithm of 0: files have it where there is nothing.
inline bool isNothing(double value) {
  return std::isnan(value) || value == -std::numeric_limits<double>::infinity();
}

/// What a sample means and looks like. All arithmetic is in float64.
struct SampleMap {
  double slope = 1; ///< A sample's value is slope * stored + intercept.
  double intercept = 0;
  /// Samples from here up are voxels; without it, all but 0 and -infinity. NaN is never one.
  std::optional<double> threshold;
  SampleRange window;                       ///< The values of the first and the last colour.
  std::array<std::uint32_t, 256> colours{}; ///< None of them 0.
  bool labels = false; ///< A voxel's word is its value in place of a colour; `kNoLabel` if it is no label.
  /// A voxel's word is its value as it is: the int32 of a whole number, or a float32.
  enum class Kept : std::uint8_t { No, Int32, Float32 } kept = Kept::No;

  /// The word of a value that is no whole number from 1 to 2^16 - 1.
  static constexpr std::uint32_t kNoLabel = 0xffffffff;

  double value(double stored) const { return slope * stored + intercept; }
  std::uint32_t wordOf(double value) const;
  std::uint32_t word(double stored) const { return wordOf(value(stored)); }
};

/// Writes the words of `count` samples.
void mapSamples(SampleLayout layout, const std::byte *samples, std::size_t count, const SampleMap &map,
                std::uint32_t *words);

/// Writes `count` samples as they are stored.
void loadSamples(SampleLayout layout, const std::byte *samples, std::size_t count, double *values);

/// Widens `range` by the values of `count` samples.
void addToRange(SampleLayout layout, const std::byte *samples, std::size_t count, const SampleMap &map,
                SampleRange &range);

} // namespace voxc
