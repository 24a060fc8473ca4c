// The level IR: a hybrid format as a list of levels with their parameters and attributes.
#pragma once

#include "voxc/IR/Attribute.h"
#include "voxc/IR/LevelKind.h"
#include "voxc/Layout/Layout.h"
#include "voxc/Support/Diagnostic.h"
#include "voxc/Support/Geometry.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// One level: a base format, its parameters in the order of its kind, and its attributes in that order too.
struct Level {
  const LevelKind *kind = nullptr;
  std::vector<std::uint32_t> parameters;
  AttributeSet attributes;
  SourceRange range; ///< Where it was written, for diagnostics; not compared.

  /// log2 of the cells along each axis.
  Int3 log2Size() const;
  /// The value of the parameter with this role, or 0 if the kind has none.
  std::uint32_t parameter(ParameterRole role) const;
  bool isCubic() const;
  /// True for a tree whose traversal keeps the nodes above a cell.
  bool keepsNodes() const;
  /// The value of an attribute: its default if it was not set or does not apply.
  std::string_view attribute(const AttributeKind &kind) const { return attributes.value(kind); }
  template <typename T> T get(const TypedAttribute<T> &attribute) const { return attributes.get(attribute); }
  /// Sets an attribute that the kind takes; a default value removes it. True if the level changed: it stays
  /// as it is where the kind has no such attribute, or the attribute no such value.
  bool setAttribute(const AttributeKind &kind, std::string_view value);

  bool operator==(const Level &other) const {
    return kind == other.kind && parameters == other.parameters && attributes == other.attributes;
  }
};

/// A hybrid format: levels from the highest (level 1) to the lowest.
struct Format {
  std::vector<Level> levels;
  AttributeSet attributes; ///< Of `formatAttributes()`: what concerns the kernel as a whole.
  /// What it was parsed from, which the ranges of levels speak of; null if it was not. Not compared.
  std::shared_ptr<const SourceText> source;

  /// log2 of the voxels along each axis of the whole format.
  Int3 log2Extent() const;
  /// Voxels along each axis of the whole format.
  Int3 extent() const;
  /// log2 of the voxels along a side of a cell of levels[index]: 0 for the last level.
  int log2CellSide(std::size_t index) const;
  /// Sets an attribute of `formatAttributes()`, as `Level::setAttribute` does.
  bool setAttribute(const AttributeKind &kind, std::string_view value);

  bool operator==(const Format &other) const {
    return levels == other.levels && attributes == other.attributes;
  }
};

/// Parses a format string such as "R(4, 4, 4) G(8)"; see docs/formats.md for its grammar. Every error in it
/// is reported. The result is verified; it is only meaningful if no error was added to `diagnostics`.
Format parseFormat(std::string_view text, Diagnostics &diagnostics);

/// Parses a format string, or IR text if it starts with the word `format`; errors come rendered.
Expected<Format> parseFormat(std::string_view text, std::string_view name = "format");

/// The format as a string of the grammar; attributes have no spelling there and are left out.
std::string toString(const Format &format);

/// Checks every rule of docs/formats.md on the levels, whatever made them: lower levels are cubes, no axis
/// has more than 2^21 voxels, no grid alone more words than a volume. Ranges are those of the levels.
void verify(const Format &format, Diagnostics &diagnostics);

/// Parses IR text; see docs/ir.md for its grammar. The result is verified.
Format parseIr(std::string_view text, Diagnostics &diagnostics);

/// Prints canonical IR text: parsing it gives the same format, printing that the same text.
std::string printIr(const Format &format);

/// The format without its traversal attributes: what a volume is stored as.
Format storageFormat(Format format);

/// True if the words of voxels are labels and no colours (`PayloadKind::labels`).
bool hasLabels(const Format &format);

/// How the words of its volumes lie. The format must be verified.
Layout layoutOf(const Format &format);

/// The same without the text and the digest of the format. Errors are choices that have nothing to stand on;
/// the rules of layouts are `verify`'s.
Layout lowerLevels(const Format &format, Diagnostics &diagnostics);

/// The format as it is stored, without choices that change no word: sharing on the first level.
Format canonicalFormat(Format format);

/// 64-bit digest of the text of the canonical format; a kernel carries that of the volumes it fits.
std::uint64_t storageDigest(const Format &format);

} // namespace voxc
