// Samples of all types and byte orders: one table, with the two loops over samples for each of its rows.
#include "Input/Dense/Samples.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace voxc {

namespace {

template <typename Stored, bool kSwap> double load(const std::byte *sample) {
  std::array<std::byte, sizeof(Stored)> bytes;
  std::memcpy(bytes.data(), sample, sizeof(Stored));
  if constexpr (kSwap)
    std::reverse(bytes.begin(), bytes.end());
  return static_cast<double>(std::bit_cast<Stored>(bytes));
}

template <typename Stored, bool kSwap>
void mapAll(const std::byte *samples, std::size_t count, const SampleMap &map, std::uint32_t *words) {
  for (std::size_t i = 0; i < count; ++i)
    words[i] = map.word(load<Stored, kSwap>(samples + i * sizeof(Stored)));
}

template <typename Stored, bool kSwap>
void loadAll(const std::byte *samples, std::size_t count, double *values) {
  for (std::size_t i = 0; i < count; ++i)
    values[i] = load<Stored, kSwap>(samples + i * sizeof(Stored));
}

template <typename Stored, bool kSwap>
void rangeOfAll(const std::byte *samples, std::size_t count, const SampleMap &map, SampleRange &range) {
  for (std::size_t i = 0; i < count; ++i) {
    const double value = map.value(load<Stored, kSwap>(samples + i * sizeof(Stored)));
    if (!std::isfinite(value))
      continue;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
}

struct TypeRow {
  std::string_view name;
  std::uint64_t bytes;
  using Map = void (*)(const std::byte *, std::size_t, const SampleMap &, std::uint32_t *);
  using Range = void (*)(const std::byte *, std::size_t, const SampleMap &, SampleRange &);
  using Load = void (*)(const std::byte *, std::size_t, double *);
  std::array<Map, 2> map; ///< As they lie, and swapped.
  std::array<Range, 2> range;
  std::array<Load, 2> load;
  double greatest;
};

template <typename Stored> constexpr TypeRow row(std::string_view name) {
  return {name,
          sizeof(Stored),
          {mapAll<Stored, false>, mapAll<Stored, true>},
          {rangeOfAll<Stored, false>, rangeOfAll<Stored, true>},
          {loadAll<Stored, false>, loadAll<Stored, true>},
          static_cast<double>(std::numeric_limits<Stored>::max())};
}

/// In the order of `SampleType`.
constexpr std::array<TypeRow, 10> kTypes{row<std::int8_t>("int8"),   row<std::uint8_t>("uint8"),
                                         row<std::int16_t>("int16"), row<std::uint16_t>("uint16"),
                                         row<std::int32_t>("int32"), row<std::uint32_t>("uint32"),
                                         row<std::int64_t>("int64"), row<std::uint64_t>("uint64"),
                                         row<float>("float32"),      row<double>("float64")};

const TypeRow &rowOf(SampleType type) { return kTypes[static_cast<std::size_t>(type)]; }

std::size_t isSwapped(SampleLayout layout) {
  return layout.bigEndian == (std::endian::native == std::endian::little);
}

} // namespace

std::uint64_t byteSize(SampleType type) { return rowOf(type).bytes; }

std::optional<SampleLayout> parseSampleLayout(std::string_view text) {
  for (std::size_t i = 0; i < kTypes.size(); ++i) {
    if (!text.starts_with(kTypes[i].name))
      continue;
    const std::string_view order = text.substr(kTypes[i].name.size());
    const bool hasOrder = kTypes[i].bytes > 1;
    if (hasOrder ? order == "le" || order == "be" : order.empty())
      return SampleLayout{static_cast<SampleType>(i), order == "be"};
  }
  return std::nullopt;
}

std::string sampleLayoutNames() {
  std::string names;
  for (const TypeRow &type : kTypes) {
    const std::string name(type.name);
    if (!names.empty())
      names += ' ';
    names += name;
    if (type.bytes != 1)
      names.append("le ").append(name).append("be");
  }
  return names;
}

std::string toText(SampleLayout layout) {
  const std::string name(rowOf(layout.type).name);
  return byteSize(layout.type) == 1 ? name : name + (layout.bigEndian ? ", big-endian" : ", little-endian");
}

double greatest(SampleType type) { return rowOf(type).greatest; }

bool isWhole(SampleType type) { return type != SampleType::Float32 && type != SampleType::Float64; }

std::uint32_t SampleMap::wordOf(double value) const {
  if (kept == Kept::Int32)
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::clamp(value, -0x1p31, 0x1p31 - 1)));
  if (kept == Kept::Float32)
    return value == 0 ? 0 : std::bit_cast<std::uint32_t>(static_cast<float>(value));
  const bool isVoxel = threshold ? value >= *threshold : value != 0 && !isNothing(value);
  if (!isVoxel)
    return 0;
  if (labels) {
    const bool isLabel = value >= 1 && value < 1 << 16 && value == std::floor(value);
    return isLabel ? static_cast<std::uint32_t>(value) : kNoLabel;
  }
  if (!(value < window.high))
    return colours.back();
  // In this order a quotient that is NaN becomes 0.
  const double share = std::max(0.0, (value - window.low) / (window.high - window.low));
  return colours[static_cast<std::size_t>(std::lround(share * 255))];
}

void mapSamples(SampleLayout layout, const std::byte *samples, std::size_t count, const SampleMap &map,
                std::uint32_t *words) {
  rowOf(layout.type).map[isSwapped(layout)](samples, count, map, words);
}

void loadSamples(SampleLayout layout, const std::byte *samples, std::size_t count, double *values) {
  rowOf(layout.type).load[isSwapped(layout)](samples, count, values);
}

void addToRange(SampleLayout layout, const std::byte *samples, std::size_t count, const SampleMap &map,
                SampleRange &range) {
  rowOf(layout.type).range[isSwapped(layout)](samples, count, map, range);
}

} // namespace voxc
