// Reading the numbers of views, and the corners of primitives.
#include "voxc/Mesh/TriangleScene.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace voxc {

namespace {

template <typename Stored> Stored stored(const std::byte *at) {
  Stored value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <typename Stored> double number(const std::byte *at) {
  return static_cast<double>(stored<Stored>(at));
}

/// An integer that stands for [0, 1] or [-1, 1]; the lowest signed one is -1 as the next is.
template <typename Stored> double fraction(const std::byte *at) {
  return std::max(number<Stored>(at) / static_cast<double>(std::numeric_limits<Stored>::max()), -1.0);
}

template <typename Stored> std::uint32_t index(const std::byte *at) {
  return static_cast<std::uint32_t>(stored<Stored>(at));
}

struct TypeRow {
  std::size_t bytes;
  double (*number)(const std::byte *);
  double (*fraction)(const std::byte *);
  std::uint32_t (*index)(const std::byte *);
};

template <typename Stored>
constexpr TypeRow kInteger{sizeof(Stored), number<Stored>, fraction<Stored>, index<Stored>};
template <typename Stored>
constexpr TypeRow kFloat{sizeof(Stored), number<Stored>, number<Stored>, index<Stored>};

/// In the order of `AttributeView::Type`.
constexpr std::array<TypeRow, 8> kTypes{
    kInteger<std::int8_t>,  kInteger<std::uint8_t>,  kInteger<std::int16_t>, kInteger<std::uint16_t>,
    kInteger<std::int32_t>, kInteger<std::uint32_t>, kFloat<float>,          kFloat<double>};

const TypeRow &rowOf(AttributeView::Type type) { return kTypes[static_cast<std::size_t>(type)]; }

using Corners = std::array<std::uint64_t, 3>;

/// How many primitives `n` vertices make, and which vertices the primitive `i` has; those of lines and points
/// repeat.
struct ModeRow {
  std::uint64_t (*count)(std::uint64_t n);
  Corners (*corners)(std::uint64_t i, std::uint64_t n);
};

using Number = std::uint64_t;

/// In the order of `PrimitiveMode`.
constexpr std::array<ModeRow, 7> kModes{
    {{[](Number n) { return n; }, [](Number i, Number) { return Corners{i, i, i}; }},
     {[](Number n) { return n / 2; }, [](Number i, Number) { return Corners{2 * i, 2 * i + 1, 2 * i + 1}; }},
     {[](Number n) { return n < 2 ? 0 : n; },
      [](Number i, Number n) { return Corners{i, (i + 1) % n, (i + 1) % n}; }},
     {[](Number n) { return n < 2 ? 0 : n - 1; }, [](Number i, Number) { return Corners{i, i + 1, i + 1}; }},
     {[](Number n) { return n / 3; }, [](Number i, Number) { return Corners{3 * i, 3 * i + 1, 3 * i + 2}; }},
     {[](Number n) { return n < 3 ? 0 : n - 2; },
      [](Number i, Number) { return Corners{i, i + 1 + i % 2, i + 2 - i % 2}; }},
     {[](Number n) { return n < 3 ? 0 : n - 2; },
      [](Number i, Number) { return Corners{0, i + 1, i + 2}; }}}};

const ModeRow &rowOf(PrimitiveMode mode) { return kModes[static_cast<std::size_t>(mode)]; }

std::uint64_t vertexCount(const MeshPart &part) {
  return part.indices ? part.indices.count : part.positions.count;
}

} // namespace

template <int N> std::array<double, N> readRow(const AttributeView &view, std::uint64_t row) {
  const TypeRow &type = rowOf(view.type);
  const auto read = view.normalized ? type.fraction : type.number;
  const std::byte *at = view.data + row * view.stride;
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < std::min<std::size_t>(N, view.components); ++i)
    numbers[i] = read(at + i * type.bytes);
  return numbers;
}

template std::array<double, 2> readRow<2>(const AttributeView &, std::uint64_t);
template std::array<double, 3> readRow<3>(const AttributeView &, std::uint64_t);
template std::array<double, 4> readRow<4>(const AttributeView &, std::uint64_t);
template std::array<double, 16> readRow<16>(const AttributeView &, std::uint64_t);

std::uint32_t readIndex(const AttributeView &view, std::uint64_t row) {
  return rowOf(view.type).index(view.data + row * view.stride);
}

std::uint64_t MeshPart::triangles() const { return rowOf(mode).count(vertexCount(*this)); }

std::array<std::uint32_t, 3> MeshPart::corners(std::uint64_t triangle) const {
  std::array<std::uint32_t, 3> corners;
  const Corners places = rowOf(mode).corners(triangle, vertexCount(*this));
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = indices ? readIndex(indices, places[i]) : static_cast<std::uint32_t>(places[i]);
  return corners;
}

std::uint64_t triangleCount(const TriangleScene &scene) {
  std::uint64_t count = 0;
  for (const MeshInstance &instance : scene.instances)
    count += scene.parts[instance.part].triangles();
  return count;
}

} // namespace voxc
