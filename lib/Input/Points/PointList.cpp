// Reading points: rows of one size are decoded where they lie, others are copied by the general reader.
#include "Input/Points/PointList.h"

#include "Input/Points/PointColour.h"
#include "Mesh/Ply/PlyBits.h"
#include "Support/Text.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>
#include <utility>

namespace voxc {

namespace {

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
constexpr std::uint64_t kPointsBetweenLooks = 1 << 12;
/// Words from here up have an alpha above 0.
constexpr std::uint32_t kLeastVisible = 1 << 24, kOpaque = 0xff000000;

/// What points of PLY files have in common.
class PlyPoints : public PointList {
public:
  PlyPoints(const PlyHeader &header, const PlyElement &vertices)
      : vertices_(vertices), colour_(vertices), header_(header) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      axes_[axis] = *findNumber(vertices, kAxes[axis]);
  }

  bool hasColours() const override { return bool(colour_); }
  std::string saysDropped(std::uint64_t count) const override { return colour_.saysDropped(count, size()); }

  std::vector<std::string> warnings() const override {
    std::vector<std::string> sentences = colour_.warnings();
    PlyUse use(header_);
    for (const std::size_t axis : axes_)
      use.take(vertices_, axis);
    colour_.take(use);
    for (std::string &sentence : use.warnings())
      sentences.push_back(std::move(sentence));
    if (areInvisible_)
      sentences.emplace_back("all colours are wholly transparent, and are taken for opaque");
    if (bytesBehind_ != 0)
      sentences.push_back(countedAre(bytesBehind_, "byte") + " left out, which lie behind the last element");
    return sentences;
  }

protected:
  const PlyElement &vertices_;
  PointColour colour_;
  std::array<std::size_t, 3> axes_{}; ///< The properties x, y and z.
  bool areInvisible_ = false;         ///< Points have colours, and all of them an alpha of 0.
  std::uint64_t bytesBehind_ = 0;     ///< The last element of the file.

  const PlyHeader &header_;
};

template <typename Stored, bool kSwap> double load(const char *bytes) {
  std::array<char, sizeof(Stored)> raw;
  std::memcpy(raw.data(), bytes, raw.size());
  if constexpr (kSwap)
    std::reverse(raw.begin(), raw.end());
  return widened(std::bit_cast<Stored>(raw));
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
  std::uint64_t bytesBehind = 0;      ///< The last element, where all have rows of one size.
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

Table tableAt(const char *rows, const PlyElement &element) {
  Table table{rows, 0, {}};
  for (const PlyProperty &property : element.properties) {
    table.offsets.push_back(table.stride);
    table.stride += byteSize(property.type);
  }
  return table;
}

std::optional<Table> findTable(const PlyReader &reader, const PlyElement &vertices) {
  if (reader.header().encoding == PlyEncoding::Ascii)
    return std::nullopt;
  std::optional<Table> table;
  std::string_view rest = reader.rest();
  for (const PlyElement &element : reader.header().elements) {
    const auto stride = strideOf(element);
    // The general reader says what is wrong with a count that does not fit.
    if (!stride || (element.count != 0 && (*stride == 0 || element.count > rest.size() / *stride)))
      return table;
    if (&element == &vertices)
      table = tableAt(rest.data(), element);
    rest.remove_prefix(element.count * *stride);
  }
  if (table)
    table->bytesBehind = rest.size();
  return table;
}

/// Points in the file.
class TablePoints final : public PlyPoints {
public:
  TablePoints(const PlyHeader &header, const PlyElement &vertices, Table table)
      : PlyPoints(header, vertices), encoding_(header.encoding), table_(std::move(table)),
        areBytes_(!colour_.areSplats() && colour_.colour().areBytes()) {
    for (std::size_t i = 0; i < channels_.size(); ++i)
      if (const auto channel = colour_.colour().channel(i); channel && areBytes_)
        channels_[i] = table_.offsets[*channel];
    hasAlpha_ = colour_.colour().channel(3).has_value();
    bytesBehind_ = table_.bytesBehind;
  }

  std::uint64_t size() const override { return vertices_.count; }

  void read(std::uint64_t first, std::span<PlyPoint> points) const override {
    const char *const rows = table_.rows + first * table_.stride;
    static_assert(sizeof(PlyPoint) % sizeof(double) == 0);
    for (std::size_t axis = 0; axis < 3; ++axis)
      loaderOf(vertices_.properties[axes_[axis]].type,
               encoding_)(rows + table_.offsets[axes_[axis]], table_.stride, points.size(),
                          &points[0].position[axis], sizeof(PlyPoint) / sizeof(double));
    PlyRow row;
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i].word = wordAt(rows + i * table_.stride, row) | (areInvisible_ ? kOpaque : 0);
  }

  /// Errors: interrupted.
  Expected<void> look(const Progress &progress) {
    PlyRow row;
    for (std::uint64_t i = 0; colour_.colour().needsLook() && i < vertices_.count; ++i) {
      if (i % kPointsBetweenLooks == 0 && progress.stopped())
        return Error::interrupted();
      load(table_.rows + i * table_.stride, row);
      colour_.colour().look(row);
    }
    if (!colour_ || colour_.areSplats())
      return {};
    std::uint64_t hidden = 0;
    while (hidden < vertices_.count && wordAt(table_.rows + hidden * table_.stride, row) < kLeastVisible)
      if (++hidden % kPointsBetweenLooks == 0 && progress.stopped())
        return Error::interrupted();
    areInvisible_ = hidden > 0 && hidden == vertices_.count && !header_.hasWords;
    return {};
  }

private:
  std::uint32_t wordAt(const char *row, PlyRow &values) const {
    return areBytes_ ? bytesOf(row) : colourOf(row, values);
  }

  /// Most files have a byte for each channel.
  std::uint32_t bytesOf(const char *row) const {
    const auto byte = [&](std::size_t channel) {
      return std::uint32_t{static_cast<unsigned char>(row[channels_[channel]])} << 8 * channel;
    };
    return byte(0) | byte(1) | byte(2) | (hasAlpha_ ? byte(3) : 0xff000000);
  }

  void load(const char *bytes, PlyRow &row) const {
    row.values.resize(vertices_.properties.size());
    for (std::size_t i = 0; i < row.values.size(); ++i)
      loaderOf(vertices_.properties[i].type, encoding_)(bytes + table_.offsets[i], 0, 1, &row.values[i], 1);
  }

  std::uint32_t colourOf(const char *bytes, PlyRow &row) const {
    if (!colour_)
      return 0xffffffff;
    load(bytes, row);
    return colour_(row);
  }

  PlyEncoding encoding_;
  Table table_;
  bool areBytes_;
  bool hasAlpha_ = false;
  std::array<std::uint64_t, 4> channels_{}; ///< Offsets of red, green, blue and alpha, if all are bytes.
};

/// Points that were copied.
class CopiedPoints final : public PlyPoints {
public:
  CopiedPoints(const PlyHeader &header, const PlyElement &vertices,
               const std::shared_ptr<WorkingMemory> &memory)
      : PlyPoints(header, vertices), memory_(memory), points_(memory) {}

  std::uint64_t size() const override { return points_.size(); }
  void read(std::uint64_t first, std::span<PlyPoint> points) const override {
    std::ranges::copy(points_.span().subspan(first, points.size()), points.begin());
  }

  Expected<void> fill(PlyReader &reader, const Progress &progress) {
    const auto pause = [&](std::uint64_t number) -> Expected<void> {
      if (number % kPointsBetweenLooks != 0)
        return {};
      memory_->relieve();
      return progress.stopped() ? Expected<void>(Error::interrupted()) : Expected<void>();
    };
    VOXC_TRY(lookAtColours(reader, vertices_, colour_.colour(), pause));
    std::uint64_t hidden = 0;
    VOXC_TRY(reader.readRows(
        [&](const PlyElement &element, std::uint64_t number, const PlyRow &row) -> Expected<void> {
          VOXC_TRY(pause(number));
          if (&element != &vertices_)
            return {};
          const std::uint32_t word = colour_(row);
          hidden += word < kLeastVisible ? 1 : 0;
          return points_.push({{row.values[axes_[0]], row.values[axes_[1]], row.values[axes_[2]]}, word});
        }));
    bytesBehind_ = reader.bytesBehind();
    areInvisible_ =
        colour_ && !colour_.areSplats() && hidden > 0 && hidden == points_.size() && !header_.hasWords;
    for (std::uint64_t i = 0; areInvisible_ && i < points_.size(); ++i)
      points_[i].word |= kOpaque;
    return {};
  }

private:
  std::shared_ptr<WorkingMemory> memory_;
  ScratchArray<PlyPoint> points_;
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
  if (auto table = findTable(reader, vertices)) {
    auto points = std::make_unique<TablePoints>(reader.header(), vertices, std::move(*table));
    VOXC_TRY(points->look(progress));
    return std::unique_ptr<PointList>(std::move(points));
  }
  auto copied = std::make_unique<CopiedPoints>(reader.header(), vertices, memory);
  VOXC_TRY(copied->fill(reader, progress));
  return std::unique_ptr<PointList>(std::move(copied));
}

} // namespace voxc
