// Colours in binary .stl files, which have two bytes a triangle for them and two conventions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace voxc {

/// What the bytes of an .stl mean: as VisCAM and SolidView have it, the highest bit says that there is a
/// colour, whose blue is in the low five bits; as Materialise Magics has it, whose header says "COLOR=" and
/// the colour of the object, the highest bit says that the triangle has that, and red is in the low five
/// bits.
class StlColours {
public:
  /// The 80 bytes of the header.
  explicit StlColours(std::span<const std::byte> header);

  /// Looks at the bytes of a triangle; to be called for all before anything is asked.
  void look(std::uint16_t bytes) { all_ |= bytes; }

  /// True if the triangles have colours.
  bool areThere() const { return object_ || (all_ & kFlag) != 0; }
  /// RGBA8 of a triangle with these bytes.
  std::uint32_t operator()(std::uint16_t bytes) const;
  /// What is in the file and not used; or empty.
  std::string warning() const;

private:
  static constexpr std::uint16_t kFlag = 0x8000;

  std::optional<std::uint32_t> object_; ///< The colour of the object, if the header has one.
  bool hasMaterial_ = false;
  std::uint16_t all_ = 0; ///< All bits that a triangle has.
};

} // namespace voxc
