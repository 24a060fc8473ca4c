// The header of a PLY file: which elements follow, and the properties of each.
#pragma once

#include "voxc/Support/Error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

/// Bytes of one value in a binary file.
std::uint64_t byteSize(PlyType type);
/// False for floats.
bool isInteger(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> countType; ///< Of a list: the type of its length.
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  /// Index of the property with this name.
  std::optional<std::size_t> find(std::string_view property) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> textures; ///< Images that comments "TextureFile NAME" name, in their order.
  std::vector<std::string> warnings; ///< One sentence each.
  bool hasWords = false;             ///< voxc wrote it: colours are words, labels among them.

  /// The element with this name, or null.
  const PlyElement *find(std::string_view element) const;
};

/// True if the file holds faces or triangle strips: it is a mesh, not points.
bool hasFaces(const PlyHeader &header);

/// Reads up to and including the line `end_header`, and takes that off the front of `text`. Errors: not a PLY
/// file, or a line that makes no sense, which is quoted.
Expected<PlyHeader> readPlyHeader(std::string_view &text);

} // namespace voxc
