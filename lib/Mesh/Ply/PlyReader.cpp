// Rows of ASCII and binary PLY files.
#include "Mesh/Ply/PlyReader.h"

#include "Mesh/Ply/PlyBits.h"
#include "Support/Text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <utility>

namespace voxc {

namespace {

constexpr std::string_view kBlanks = " \t\r\n";

template <typename Stored> double decode(const char *bytes) {
  Stored stored;
  std::memcpy(&stored, bytes, sizeof stored);
  return widened(stored);
}

/// In the order of `PlyType`.
constexpr std::array<double (*)(const char *), 8> kDecode{
    decode<std::int8_t>,  decode<std::uint8_t>,  decode<std::int16_t>, decode<std::uint16_t>,
    decode<std::int32_t>, decode<std::uint32_t>, decode<float>,        decode<double>};

/// Whether an integer of PLY, of at most 32 bits, could have this value; texts mix those with a sign and
/// without.
bool fitsInteger(double value) { return value == std::floor(value) && value >= -0x1p31 && value < 0x1p32; }

} // namespace

PlyReader::PlyReader(std::string path, MappedFile file)
    : path_(std::move(path)), file_(std::move(file)),
      rest_(reinterpret_cast<const char *>(file_.bytes().data()), file_.bytes().size()) {}

Expected<PlyReader> PlyReader::open(const std::string &path) {
  auto file = VOXC_TRY(MappedFile::open(path));
  PlyReader reader(path, std::move(file));
  auto header = readPlyHeader(reader.rest_);
  if (!header)
    return reader.broken(header.error().message);
  reader.header_ = std::move(*header);
  return reader;
}

Error PlyReader::broken(const std::string &what) const {
  return Error::input("'" + path_ + "' is not a usable PLY file: " + what);
}

std::uint64_t PlyReader::leastSize(PlyType type) const {
  // A digit and a blank.
  return header_.encoding == PlyEncoding::Ascii ? 2 : byteSize(type);
}

std::uint64_t PlyReader::capacity(std::uint64_t bytes) const {
  // The last number of a text needs no blank behind it.
  return (rest_.size() + (header_.encoding == PlyEncoding::Ascii)) / bytes;
}

Expected<void> PlyReader::readRows(const Visit &visit) {
  for (const PlyElement &element : header_.elements)
    VOXC_TRY(readElement(element, visit));
  return {};
}

std::uint64_t PlyReader::bytesBehind() const {
  return header_.encoding == PlyEncoding::Ascii ? trimmed(rest_).size() : rest_.size();
}

Expected<void> PlyReader::readElement(const PlyElement &element, const Visit &visit) {
  std::uint64_t rowSize = 0;
  for (const PlyProperty &property : element.properties)
    rowSize += leastSize(property.countType.value_or(property.type));
  if (element.count != 0 && (rowSize == 0 || element.count > capacity(rowSize)))
    return broken("it claims " + std::to_string(element.count) + " rows of '" + element.name +
                  "', but has only " + std::to_string(rest_.size()) + " bytes for them");
  PlyRow row{std::vector<double>(element.properties.size()),
             std::vector<std::vector<double>>(element.properties.size())};
  for (std::uint64_t index = 0; index < element.count; ++index) {
    if (!readRow(element, row))
      return broken("row " + std::to_string(index) + " of '" + element.name + "' is cut short or malformed");
    VOXC_TRY(visit(element, index, row));
  }
  return {};
}

bool PlyReader::readRow(const PlyElement &element, PlyRow &row) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty &property = element.properties[i];
    if (!readValue(property.countType.value_or(property.type), row.values[i]))
      return false;
    if (property.countType && !readList(property, row.values[i], row.lists[i]))
      return false;
  }
  return true;
}

bool PlyReader::readList(const PlyProperty &property, double length, std::vector<double> &list) {
  if (length < 0 || length > static_cast<double>(capacity(leastSize(property.type))))
    return false;
  list.resize(static_cast<std::size_t>(length));
  return std::all_of(list.begin(), list.end(),
                     [&](double &value) { return readValue(property.type, value); });
}

bool PlyReader::readValue(PlyType type, double &value) {
  return header_.encoding == PlyEncoding::Ascii ? readText(type, value) : readBinary(type, value);
}

bool PlyReader::readText(PlyType type, double &value) {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(kBlanks), rest_.size()));
  std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
  rest_.remove_prefix(word.size());
  const auto parsed = parseNumber(word);
  value = parsed.value_or(0);
  return parsed && (!isInteger(type) || fitsInteger(value));
}

bool PlyReader::readBinary(PlyType type, double &value) {
  const std::size_t size = byteSize(type);
  if (rest_.size() < size)
    return false;
  std::array<char, 8> bytes{};
  rest_.copy(bytes.data(), size);
  rest_.remove_prefix(size);
  constexpr bool kNativeLittle = std::endian::native == std::endian::little;
  const bool isSwapped = (header_.encoding == PlyEncoding::LittleEndian) != kNativeLittle;
  // All eight, of which the value's are the last then: g++ 12 takes fewer for a write behind them.
  if (isSwapped)
    std::reverse(bytes.begin(), bytes.end());
  value = kDecode[static_cast<std::size_t>(type)](bytes.data() + (isSwapped ? bytes.size() - size : 0));
  return true;
}

} // namespace voxc
