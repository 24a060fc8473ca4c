// The table of types.
#include "Input/NanoVdb/ValueKind.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace voxc {

namespace {

constexpr std::uint32_t kLeafMask = 16;

template <typename T> T load(const std::byte *at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <typename T> double readNumber(const std::byte *at) { return static_cast<double>(load<T>(at)); }

/// Values lie behind the head of a leaf, at a multiple of 32 bytes.
template <typename T, std::uint32_t Head> double readPlain(const std::byte *leaf, std::uint32_t cell) {
  return readNumber<T>(leaf + Head + cell * sizeof(T));
}

bool bitOf(const std::byte *bits, std::uint32_t bit) {
  return (std::to_integer<unsigned>(bits[bit / 8]) >> bit % 8 & 1) != 0;
}

double readActive(const std::byte *leaf, std::uint32_t cell) { return bitOf(leaf + kLeafMask, cell) ? 1 : 0; }
double readBit(const std::byte *leaf, std::uint32_t cell) { return bitOf(leaf + 96, cell) ? 1 : 0; }

/// Whole numbers of `Bits` bits that stand for floats between a least one and that plus a multiple of a
/// quantum.
template <int Bits> double readQuantized(const std::byte *leaf, std::uint32_t cell) {
  const auto least = load<float>(leaf + 80);
  const auto quantum = load<float>(leaf + 84);
  const std::byte *values = leaf + 96;
  std::uint32_t step = 0;
  if constexpr (Bits == 16)
    step = load<std::uint16_t>(values + std::size_t{2} * cell);
  else if constexpr (Bits == 8)
    step = std::to_integer<std::uint32_t>(values[cell]);
  else
    step = std::to_integer<std::uint32_t>(values[cell / 2]) >> 4 * (cell % 2) & 15;
  return static_cast<double>(static_cast<float>(step) * quantum + least);
}

using enum ValueMeaning;

constexpr std::array<ValueKind, 12> kKinds{
    {{1, "float", Sample, 64, 28, 20, 2144, readNumber<float>, readPlain<float, 96>},
     {2, "double", Sample, 96, 32, 24, 4224, readNumber<double>, readPlain<double, 128>},
     {3, "int16", Sample, 64, 28, 20, 1120, readNumber<std::int16_t>, readPlain<std::int16_t, 96>, true},
     {4, "int32", Sample, 64, 28, 20, 2144, readNumber<std::int32_t>, readPlain<std::int32_t, 96>, true},
     {5, "int64", Sample, 96, 32, 24, 4224, readNumber<std::int64_t>, readPlain<std::int64_t, 128>, true},
     {8, "mask", Flag, 64, 28, 20, 96, readNumber<std::uint8_t>, readActive},
     {10, "uint32", Sample, 64, 28, 20, 2144, readNumber<std::uint32_t>, readPlain<std::uint32_t, 96>, true},
     {11, "bool", Flag, 64, 28, 20, 160, readNumber<std::uint8_t>, readBit},
     {12, "RGBA8", Colour, 64, 28, 20, 2144, readNumber<std::uint32_t>, readPlain<std::uint32_t, 96>, true},
     {13, "Float4", Sample, 64, 28, 20, 352, readNumber<float>, readQuantized<4>},
     {14, "Float8", Sample, 64, 28, 20, 608, readNumber<float>, readQuantized<8>},
     {15, "Float16", Sample, 64, 28, 20, 1120, readNumber<float>, readQuantized<16>}}};

} // namespace

const ValueKind *findValueKind(std::uint32_t type) {
  const auto *kind = std::ranges::find(kKinds, type, &ValueKind::type);
  return kind == kKinds.end() ? nullptr : kind;
}

std::string nameOfType(std::uint32_t type) {
  struct Name {
    std::uint32_t type;
    const char *name;
  };
  constexpr std::array<Name, 10> kOthers{{{6, "vectors of 3 floats"},
                                          {7, "vectors of 3 doubles"},
                                          {9, "half floats"},
                                          {16, "floats of varying bits"},
                                          {17, "vectors of 4 floats"},
                                          {18, "vectors of 4 doubles"},
                                          {19, "indices"},
                                          {20, "indices"},
                                          {21, "indices"},
                                          {22, "indices"}}};
  if (const ValueKind *const kind = findValueKind(type))
    return kind->name;
  const auto *const other = std::ranges::find(kOthers, type, &Name::type);
  return other == kOthers.end() ? "type " + std::to_string(type) : other->name;
}

bool isActiveInLeaf(const std::byte *leaf, std::uint32_t cell) { return bitOf(leaf + kLeafMask, cell); }

} // namespace voxc
