// Reading points: rows of one size are decoded where they lie, others are copied by the general reader.
#include "Input/Points/PointList.h"

#include "Mesh/Ply/PlyColour.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <utility>

namespace voxc {

namespace {

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
constexpr std::array<std::string_view, 4> kChannels{"red", "green", "blue", "alpha"};

/// The number of the property, unless it is a list.
std::optional<std::size_t> findNumber(const PlyElement &element, std::string_view name) {
  const auto found = element.find(name);
  return found && !element.properties[*found].countType ? found : std::nullopt;
}

template <typename Stored, bool kSwap> double load(const char *bytes) {
  std::array<char, sizeof(Stored)> raw;
  std::memcpy(raw.data(), bytes, raw.size());
  if constexpr (kSwap)
    std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<Stored>(raw));
}

/// A property of every row: writes it for `count` rows to every `step`th double.
using LoadAll = void (*)(const char *rows, std::uint64_t stride, std::size_t count, double *values,
                         std::size_t step);

template <typename Stored, bool kSwap>
void loadAll(const char *rows, std::uint64_t stride, std::size_t count, double *values, std::size_t step) {
  for (std::size_t i = 0; i < count; ++i)
    values[i * step] = load<Stored, kSwap>(rows + i * stride);
}

/// In the order of `PlyType`.
template <bool kSwap>
constexpr std::array<LoadAll, 8> kLoad{loadAll<std::int8_t, kSwap>,  loadAll<std::uint8_t, kSwap>,
                                       loadAll<std::int16_t, kSwap>, loadAll<std::uint16_t, kSwap>,
                                       loadAll<std::int32_t, kSwap>, loadAll<std::uint32_t, kSwap>,
                                       loadAll<float, kSwap>,        loadAll<double, kSwap>};

LoadAll loaderOf(PlyType type, PlyEncoding encoding) {
  constexpr bool kNativeLittle = std::endian::native == std::endian::little;
  const auto index = static_cast<std::size_t>(type);
  return (encoding == PlyEncoding::LittleEndian) == kNativeLittle ? kLoad<false>[index] : kLoad<true>[index];
}

/// Where the rows of an element lie, if all of them have one size.
struct Table {
  const char *rows;
  std::uint64_t stride;
  std::vector<std::uint64_t> offsets; ///< Of each property in a row.
};

/// The bytes of a row; nothing if it has a list, whose size differs from row to row.
std::optional<std::uint64_t> strideOf(const PlyElement &element) {
  std::uint64_t stride = 0;
  for (const PlyProperty &property : element.properties) {
    if (property.countType)
      return std::nullopt;
    stride += byteSize(property.type);
  }
  return stride;
}

std::optional<Table> findTable(const PlyReader &reader, const PlyElement &vertices) {
  if (reader.header().encoding == PlyEncoding::Ascii)
    return std::nullopt;
  std::string_view rest = reader.rest();
  for (const PlyElement &element : reader.header().elements) {
    const auto stride = strideOf(element);
    // The general reader says what is wrong with a count that does not fit.
    if (!stride || (element.count != 0 && (*stride == 0 || element.count > rest.size() / *stride)))
      return std::nullopt;
    if (&element != &vertices) {
      rest.remove_prefix(element.count * *stride);
      continue;
    }
    Table table{rest.data(), *stride, {}};
    std::uint64_t offset = 0;
    for (const PlyProperty &property : element.properties) {
      table.offsets.push_back(offset);
      offset += byteSize(property.type);
    }
    return table;
  }
  return std::nullopt;
}

/// Points in the file.
class TablePoints final : public PointList {
public:
  TablePoints(const PlyElement &vertices, PlyEncoding encoding, Table table)
      : vertices_(vertices), encoding_(encoding), table_(std::move(table)), colour_(vertices) {
    findByteChannels();
  }

  std::uint64_t size() const override { return vertices_.count; }
  bool hasColours() const override { return bool(colour_); }

  void read(std::uint64_t first, std::span<PlyPoint> points) const override {
    const char *const rows = table_.rows + first * table_.stride;
    static_assert(sizeof(PlyPoint) % sizeof(double) == 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t property = *findNumber(vertices_, kAxes[axis]);
      loaderOf(vertices_.properties[property].type, encoding_)(rows + table_.offsets[property], table_.stride,
                                                               points.size(), &points[0].position[axis],
                                                               sizeof(PlyPoint) / sizeof(double));
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i].word =
          hasByteChannels_ ? bytesOf(rows + i * table_.stride) : colourOf(rows + i * table_.stride);
  }

private:
  /// Most files have a byte for each channel.
  void findByteChannels() {
    for (std::size_t i = 0; i < kChannels.size(); ++i) {
      const auto found = findNumber(vertices_, kChannels[i]);
      if (!found || vertices_.properties[*found].type != PlyType::Uint8)
        return;
      channels_[i] = table_.offsets[*found];
    }
    hasByteChannels_ = true;
  }

  std::uint32_t bytesOf(const char *row) const {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < channels_.size(); ++i)
      word |= std::uint32_t{static_cast<unsigned char>(row[channels_[i]])} << 8 * i;
    return word;
  }

  std::uint32_t colourOf(const char *bytes) const {
    if (!colour_)
      return 0xffffffff;
    PlyRow row{std::vector<double>(vertices_.properties.size()), {}};
    for (std::size_t i = 0; i < row.values.size(); ++i)
      loaderOf(vertices_.properties[i].type, encoding_)(bytes + table_.offsets[i], 0, 1, &row.values[i], 1);
    return colour_(row);
  }

  const PlyElement &vertices_;
  PlyEncoding encoding_;
  Table table_;
  PlyColour colour_;
  std::array<std::uint64_t, 4> channels_{}; ///< Offsets of red, green, blue and alpha, if all are bytes.
  bool hasByteChannels_ = false;
};

/// Points that were copied.
class CopiedPoints final : public PointList {
public:
  CopiedPoints(const PlyElement &vertices, const std::shared_ptr<WorkingMemory> &memory)
      : memory_(memory), points_(memory), colour_(vertices) {}

  std::uint64_t size() const override { return points_.size(); }
  bool hasColours() const override { return bool(colour_); }
  void read(std::uint64_t first, std::span<PlyPoint> points) const override {
    std::ranges::copy(points_.span().subspan(first, points.size()), points.begin());
  }

  Expected<void> fill(PlyReader &reader, const PlyElement &vertices, const Progress &progress) {
    constexpr std::uint64_t kRowsBetweenLooks = 1 << 12;
    std::array<std::size_t, 3> axes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      axes[axis] = *findNumber(vertices, kAxes[axis]);
    return reader.readRows([&](const PlyElement &element, std::uint64_t number,
                               const PlyRow &row) -> Expected<void> {
      if (number % kRowsBetweenLooks == 0) {
        if (progress.stopped())
          return Error::interrupted();
        memory_->relieve();
      }
      if (&element != &vertices)
        return {};
      return points_.push({{row.values[axes[0]], row.values[axes[1]], row.values[axes[2]]}, colour_(row)});
    });
  }

private:
  std::shared_ptr<WorkingMemory> memory_;
  ScratchArray<PlyPoint> points_;
  PlyColour colour_;
};

} // namespace

bool hasPoints(const PlyHeader &header) {
  const PlyElement *vertices = header.find("vertex");
  return vertices && std::ranges::all_of(kAxes, [&](std::string_view axis) {
           return findNumber(*vertices, axis).has_value();
         });
}

bool areIndices(const PlyHeader &header) {
  const PlyElement *vertices = header.find("vertex");
  return vertices && std::ranges::all_of(kAxes, [&](std::string_view axis) {
           const auto found = findNumber(*vertices, axis);
           return found && isInteger(vertices->properties[*found].type);
         });
}

Expected<std::unique_ptr<PointList>>
readPointList(PlyReader &reader, const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  const PlyElement &vertices = *reader.header().find("vertex");
  if (auto table = findTable(reader, vertices))
    return std::unique_ptr<PointList>(
        std::make_unique<TablePoints>(vertices, reader.header().encoding, std::move(*table)));
  auto copied = std::make_unique<CopiedPoints>(vertices, memory);
  if (auto filled = copied->fill(reader, vertices, progress); !filled)
    return filled.error();
  return std::unique_ptr<PointList>(std::move(copied));
}

} // namespace voxc
