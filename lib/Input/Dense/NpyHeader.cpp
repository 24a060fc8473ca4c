// NumPy headers: a dictionary in Python's notation, of three keys.
#include "Input/Dense/NpyHeader.h"

#include "Support/Text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <optional>
#include <string>

namespace voxc {

namespace {

constexpr std::string_view kMagic = "\x93NUMPY";

/// What stands behind a key, from the first character that is no blank on.
std::optional<std::string_view> valueOf(std::string_view text, std::string_view key) {
  const std::size_t at = text.find("'" + std::string(key) + "'");
  const std::size_t colon = at == std::string_view::npos ? at : text.find(':', at);
  const std::size_t begin = colon == std::string_view::npos ? colon : text.find_first_not_of(' ', colon + 1);
  return begin == std::string_view::npos ? std::nullopt : std::optional(text.substr(begin));
}

struct TypeRow {
  std::string_view name; ///< Without its byte order.
  SampleType type;
};

constexpr std::array<TypeRow, 11> kNumpyTypes{{{"b1", SampleType::Uint8},
                                               {"i1", SampleType::Int8},
                                               {"u1", SampleType::Uint8},
                                               {"i2", SampleType::Int16},
                                               {"u2", SampleType::Uint16},
                                               {"i4", SampleType::Int32},
                                               {"u4", SampleType::Uint32},
                                               {"i8", SampleType::Int64},
                                               {"u8", SampleType::Uint64},
                                               {"f4", SampleType::Float32},
                                               {"f8", SampleType::Float64}}};

/// A type such as '<f4', in quotation marks.
Expected<void> readType(std::string_view value, NpyHeader &header) {
  const std::string_view word =
      value.starts_with('\'') ? value.substr(1, value.find('\'', 1) - 1) : value.substr(0, 16);
  const bool hasOrder = !word.empty() && std::string_view("<>|=").find(word[0]) != std::string_view::npos;
  const std::string_view name = word.substr(hasOrder ? 1 : 0);
  for (const TypeRow &row : kNumpyTypes)
    if (row.name == name) {
      header.layout = {row.type, word[0] == '>'};
      header.isBool = name == "b1";
      return {};
    }
  return Error::input("its values are of the type " + printable(word.substr(0, 40)) +
                      "; whole numbers of 8 to 64 bits are read, and floats of 32 and 64");
}

bool readShape(std::string_view value, NpyHeader &header) {
  const std::size_t end = value.find(')');
  if (!value.starts_with('(') || end == std::string_view::npos)
    return false;
  std::string_view inside = value.substr(1, end - 1);
  while (true) {
    inside.remove_prefix(std::min(inside.find_first_not_of(" ,"), inside.size()));
    if (inside.empty())
      return header.shape.size() <= 8;
    std::uint64_t size = 0;
    const auto parsed = std::from_chars(inside.data(), inside.data() + inside.size(), size);
    if (parsed.ec != std::errc())
      return false;
    header.shape.push_back(size);
    inside.remove_prefix(static_cast<std::size_t>(parsed.ptr - inside.data()));
  }
}

} // namespace

Expected<NpyHeader> readNpyHeader(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char *>(bytes.data()), bytes.size());
  if (!text.starts_with(kMagic) || text.size() < 12)
    return Error::input("it does not begin as NumPy arrays do");
  // Version 1 has the length of its text in 2 bytes, later ones in 4.
  const std::size_t lengthBytes = text[6] == 1 ? 2 : 4;
  std::uint64_t length = 0;
  for (std::size_t i = 0; i < lengthBytes; ++i)
    length |= std::uint64_t{static_cast<unsigned char>(text[8 + i])} << 8 * i;
  NpyHeader header;
  header.dataOffset = 8 + lengthBytes + length;
  if (header.dataOffset > text.size() || length > kMostNpyHeader)
    return Error::input("its header is cut short");
  const std::string_view fields = text.substr(8 + lengthBytes, length);
  const auto type = valueOf(fields, "descr"), order = valueOf(fields, "fortran_order"),
             shape = valueOf(fields, "shape");
  if (!type || !order || !shape || !readShape(*shape, header))
    return Error::input("its header needs the keys descr, fortran_order and shape");
  VOXC_TRY(readType(*type, header));
  header.isFortran = order->starts_with("True");
  return header;
}

} // namespace voxc
