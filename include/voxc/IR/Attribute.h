// Attributes: choices that passes and options set on a level, or on a format as a whole.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// Whether an attribute changes the volume's words, and is kept with them, or the kernel alone.
enum class AttributeEffect { Storage, Walk };

/// Attributes that are chosen together, by one option that lists those which shall be `yes`.
struct AttributeList {
  std::string_view name;
  std::string_view summary;
};

/// A choice that may be set. The first value is the default and is not printed.
struct AttributeKind {
  std::string_view name;
  AttributeEffect effect;
  std::span<const std::string_view> values;
  std::string_view summary;
  const AttributeList *list = nullptr; ///< Its values are then yes and no.
};

/// Values that differ by a number alone, and follow each other; or one value.
struct ValueRange {
  std::string_view first;
  std::string_view last;

  /// "first", or "first to last", each between `mark`s.
  std::string text(std::string_view mark = "") const;
};

/// The values of a kind in their order, those that follow each other in one.
std::vector<ValueRange> valueRanges(const AttributeKind &kind);

/// The kinds that a level or a format takes, in the order in which they are printed.
using AttributeKinds = std::span<const AttributeKind *const>;

// Attributes of levels, whichever kinds take them.
extern const AttributeKind kDedupAttribute;     ///< dedup: sub-volume | level
extern const AttributeKind kShareAttribute;     ///< share: none | level
extern const AttributeKind kWalkAttribute;      ///< walk: stack | restart | unrolled
extern const AttributeKind kLeavesAttribute;    ///< leaves: apart | in-slot
extern const AttributeKind kDistancesAttribute; ///< distances: beside | in-slot
extern const AttributeKind kMetricAttribute;    ///< metric: l1 | octant
extern const AttributeKind kPointersAttribute;  ///< pointers: word | 8 | 9 | ... | 24
extern const AttributeKind kCountsAttribute;    ///< counts: each | octant
extern const AttributeKind kMasksAttribute;     ///< masks: whole | octants

// Attributes of formats.
extern const AttributeKind kPrecisionAttribute; ///< precision: exact | fast
extern const AttributeKind kDetailAttribute;    ///< detail: full | cone
extern const AttributeKind kLevelsAttribute;    ///< levels: auto | nested | flat | direct
extern const AttributeKind kQueryAttribute;     ///< query: closest | any | occupancy | distance
extern const AttributeKind kBoundsAttribute;    ///< bounds: no | yes
extern const AttributeKind kVoxelAttribute;     ///< voxel: yes | no
extern const AttributeKind kTAttribute;         ///< t: yes | no
extern const AttributeKind kFaceAttribute;      ///< face: no | yes
extern const AttributeKind kColourAttribute;    ///< colour: yes | no
extern const AttributeKind kIndexAttribute;     ///< index: no | yes
extern const AttributeKind
    kPayloadAttribute; ///< payload: rgba8 | occupancy | constant | palette(n) | rgb565 | material(n)
extern const AttributeKind kAlphaAttribute;   ///< alpha: any | positive
extern const AttributeKind kValuesAttribute;  ///< values: in-place | apart
extern const AttributeKind kGranuleAttribute; ///< granule: word | 2 | 4 | ... | 256

/// The attributes that a format takes.
AttributeKinds formatAttributes();

/// The attributes of one level or format that differ from their defaults.
class AttributeSet {
public:
  /// The value of an attribute: its default if it was not set.
  std::string_view value(const AttributeKind &kind) const;
  /// Sets one of `taken` to one of its values; a default removes it. True if the set changed: it stays as it
  /// is where `taken` has no such kind, or the kind no such value.
  bool set(AttributeKinds taken, const AttributeKind &kind, std::string_view value);
  /// Removes what concerns the kernel alone.
  void eraseWalk();

  bool operator==(const AttributeSet &) const = default;

private:
  struct Attribute {
    const AttributeKind *kind;
    std::size_t value; // Index into kind->values, at least 1.

    bool operator==(const Attribute &) const = default;
  };
  std::vector<Attribute> attributes_; // In the order of the kinds that are taken.
};

/// The attributes of `set` as IR text, " name=value" each, in the order of `taken`.
std::string printAttributes(const AttributeSet &set, AttributeKinds taken);

} // namespace voxc
