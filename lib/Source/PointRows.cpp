// Reading points: rows of one size are decoded in place, others by the general reader.
#include "Source/PointRows.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace voxc {

namespace {

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
constexpr std::uint64_t kRowsBetweenLooks = 1 << 12;

template <typename Stored, bool kSwap> double load(const char *bytes) {
  std::array<char, sizeof(Stored)> raw;
  std::memcpy(raw.data(), bytes, raw.size());
  if constexpr (kSwap)
    std::reverse(raw.begin(), raw.end());
  return static_cast<double>(std::bit_cast<Stored>(raw));
}

using Load = double (*)(const char *);

/// In the order of `PlyType`: as they lie, and swapped.
template <bool kSwap>
constexpr std::array<Load, 8> kLoad{load<std::int8_t, kSwap>,  load<std::uint8_t, kSwap>,
                                    load<std::int16_t, kSwap>, load<std::uint16_t, kSwap>,
                                    load<std::int32_t, kSwap>, load<std::uint32_t, kSwap>,
                                    load<float, kSwap>,        load<double, kSwap>};

Load loadOf(PlyType type, PlyEncoding encoding) {
  constexpr bool kNativeLittle = std::endian::native == std::endian::little;
  const auto index = static_cast<std::size_t>(type);
  return (encoding == PlyEncoding::LittleEndian) == kNativeLittle ? kLoad<false>[index] : kLoad<true>[index];
}

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

} // namespace

PointRows::PointRows(PlyReader &reader)
    : reader_(reader), vertices_(reader.header().find("vertex")),
      colour_(vertices_ ? *vertices_ : PlyElement()) {
  for (std::size_t axis = 0; vertices_ && axis < 3; ++axis)
    axes_[axis] = vertices_->find(kAxes[axis]);
}

bool PointRows::areIndices() const {
  return std::all_of(axes_.begin(), axes_.end(),
                     [&](const auto &axis) { return isInteger(vertices_->properties[*axis].type); });
}

std::optional<PointRows::Table> PointRows::findTable() const {
  const PlyHeader &header = reader_.header();
  if (header.encoding == PlyEncoding::Ascii)
    return std::nullopt;
  std::uint64_t left = reader_.rest().size();
  for (const PlyElement &element : header.elements) {
    const auto stride = strideOf(element);
    // The general reader says what is wrong with a count that does not fit.
    if (!stride || (element.count != 0 && (*stride == 0 || element.count > left / *stride)))
      return std::nullopt;
    if (&element == vertices_) {
      Table table{reader_.rest().data() + (reader_.rest().size() - left), *stride, {}};
      std::uint64_t offset = 0;
      for (const PlyProperty &property : element.properties) {
        table.offsets.push_back(offset);
        offset += byteSize(property.type);
      }
      return table;
    }
    left -= element.count * *stride;
  }
  return std::nullopt;
}

PointRow PointRows::pointOf(const PlyRow &row, std::uint64_t number) const {
  return {{row.values[*axes_[0]], row.values[*axes_[1]], row.values[*axes_[2]]}, number, colour_(row)};
}

Expected<void> PointRows::readTable(const Table &table, const Visit &visit, WorkingMemory &memory,
                                    const Progress &progress) const {
  const std::size_t properties = vertices_->properties.size();
  std::vector<Load> loads(properties);
  for (std::size_t i = 0; i < properties; ++i)
    loads[i] = loadOf(vertices_->properties[i].type, reader_.header().encoding);
  PlyRow row{std::vector<double>(properties), {}};
  for (std::uint64_t number = 0; number < vertices_->count; ++number) {
    if (number % kRowsBetweenLooks == 0) {
      progress.at("load", static_cast<double>(number) / static_cast<double>(vertices_->count));
      if (progress.stopped())
        return Error::interrupted();
      memory.relieve();
    }
    const char *const bytes = table.rows + number * table.stride;
    for (std::size_t i = 0; i < properties; ++i)
      row.values[i] = loads[i](bytes + table.offsets[i]);
    if (auto visited = visit(pointOf(row, number)); !visited)
      return visited;
  }
  return {};
}

Expected<void> PointRows::read(const Visit &visit, WorkingMemory &memory, const Progress &progress) {
  memory.watch(reader_.bytes());
  Expected<void> result;
  if (const auto table = findTable()) {
    result = readTable(*table, visit, memory, progress);
  } else {
    result = reader_.readRows(
        [&](const PlyElement &element, std::uint64_t number, const PlyRow &row) -> Expected<void> {
          if (number % kRowsBetweenLooks == 0) {
            if (progress.stopped())
              return Error::interrupted();
            memory.relieve();
          }
          return &element == vertices_ ? visit(pointOf(row, number)) : Expected<void>();
        });
  }
  memory.unwatch(reader_.bytes());
  return result;
}

} // namespace voxc
