// The colour of a PLY row.
#pragma once

#include "Mesh/ColourScale.h"
#include "Mesh/Ply/PlyNames.h"
#include "Mesh/Ply/PlyReader.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace voxc {

/// Finds an element's red, green, blue and alpha, whichever of their common names they have, and packs those
/// of a row. Numbers count to 1, 255, 65535 or 2^32 - 1: bytes to 255, all others as `look` finds it out.
class PlyColour {
public:
  explicit PlyColour(const PlyElement &element);

  /// True if the element has red, green and blue.
  explicit operator bool() const { return isPacked_ || (channels_[0] && channels_[1] && channels_[2]); }

  bool hasAlpha() const { return bool(*this) && !isPacked_ && channels_[3]; }

  /// True if all rows have to be looked at before the first colour is asked for.
  bool needsLook() const { return bool(*this) && !isPacked_ && (!isByte(0) || !isByte(3)); }
  void look(const PlyRow &row);

  /// RGBA8 of a row. Opaque white without colour.
  std::uint32_t operator()(const PlyRow &row) const;

  /// The property of red, green, blue or alpha, if they are unsigned bytes each (or alpha is absent).
  bool areBytes() const;
  std::optional<std::size_t> channel(std::size_t i) const { return channels_[i]; }

  /// Marks the properties as used.
  void take(PlyUse &use) const;
  /// A sentence if the numbers count to something that is not what their type says, else empty.
  std::string warning() const;

private:
  bool isByte(std::size_t channel) const;
  double value(std::size_t channel, const PlyRow &row) const;
  double wholeOf(std::size_t channel) const;
  std::uint32_t unpacked(double value) const;

  const PlyElement &element_;
  std::array<std::optional<std::size_t>, 4> channels_;
  bool isPacked_ = false;             ///< The first channel is a word of all.
  std::array<ColourScale, 2> scales_; ///< Of colours, and of alpha.
};

/// Has `colour` look at all rows of `element`, which the file must have, if it needs to: by reading them from
/// a reader of its own. Errors: those of `PlyReader::readRows`, and what `stopped` returns.
Expected<void> lookAtColours(const PlyReader &reader, const PlyElement &element, PlyColour &colour,
                             const std::function<Expected<void>(std::uint64_t row)> &stopped);

} // namespace voxc
