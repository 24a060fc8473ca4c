// Attributes: choices that passes and options set on a level, or on a format as a whole.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// Whether an attribute changes the volume's words, and is kept with them, or the kernel alone.
enum class AttributeEffect { Storage, Traversal };

/// Attributes that are chosen together, by one option that lists those which shall be `yes`.
struct AttributeList {
  std::string_view name;
  std::string_view summary;
};

struct AttributeKind;

/// One value of a choice.
struct AttributeValue {
  const AttributeKind *kind;
  std::string_view value;
};

/// A choice that may be set, as text knows it. The first value is the default and is not printed.
struct AttributeKind {
  std::string_view name;
  AttributeEffect effect;
  std::span<const std::string_view> values;
  std::string_view summary;
  const AttributeList *list = nullptr; ///< Its values are then yes and no.
  std::string_view byPasses = {};      ///< The passes that set it; a format's has no option of its name then.
  const AttributeKind *needs = nullptr; ///< It can be chosen only beside one of this kind; null: always.
  std::span<const AttributeValue> excludes = {}; ///< Of levels: what their format cannot have beside it.
  bool amongSubVolumes = false; ///< It says what sub-volumes share: nothing of the first level, which is one.
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

/// A choice among values of a type: what code asks for, where text has names.
template <typename T> struct TypedAttribute : AttributeKind {
  T (*read)(std::size_t value); ///< The value of this number in `values`.
};

enum class Alpha;
enum class VoxelCountsOf;
enum class Descent;
enum class Detail;
enum class DistancePlace;
enum class LeafPlace;
enum class Metric;
enum class Precision;
enum class Query;
enum class Sharing;
enum class Stack;
enum class Values;
enum class LevelTraversal;

// Attributes of levels, whichever kinds take them.
extern const TypedAttribute<Sharing> kDedupAttribute;           ///< dedup: sub-volume | level
extern const TypedAttribute<Sharing> kShareAttribute;           ///< share: none | level
extern const TypedAttribute<Descent> kTraversalAttribute;       ///< traversal: stack | restart | unrolled
extern const TypedAttribute<bool> kMirrorAttribute;             ///< mirror: no | yes
extern const TypedAttribute<LeafPlace> kLeavesAttribute;        ///< leaves: apart | in-slot
extern const TypedAttribute<DistancePlace> kDistancesAttribute; ///< distances: beside | in-slot
extern const TypedAttribute<Metric> kMetricAttribute;           ///< metric: l1 | octant
extern const TypedAttribute<int> kPointersAttribute;            ///< pointers: word (0) | 8 | 9 | ... | 24
extern const TypedAttribute<VoxelCountsOf> kCountsAttribute;    ///< counts: each | octant
extern const TypedAttribute<bool> kMasksAttribute;              ///< masks: whole (no) | octants (yes)

// Attributes of formats.
extern const TypedAttribute<Precision> kPrecisionAttribute;   ///< precision: exact | fast
extern const TypedAttribute<Detail> kDetailAttribute;         ///< detail: full | cone
extern const TypedAttribute<LevelTraversal> kLevelsAttribute; ///< levels: auto | nested | flat | direct
extern const TypedAttribute<Stack> kStackAttribute;           ///< stack: private | shared
extern const TypedAttribute<Query> kQueryAttribute;           ///< query: closest | any | occupancy | distance
extern const TypedAttribute<bool> kBoundsAttribute;           ///< bounds: no | yes
extern const TypedAttribute<bool> kVoxelAttribute;            ///< voxel: yes | no
extern const TypedAttribute<bool> kTAttribute;                ///< t: yes | no
extern const TypedAttribute<bool> kFaceAttribute;             ///< face: no | yes
extern const TypedAttribute<bool> kColourAttribute;           ///< colour: yes | no
extern const TypedAttribute<bool> kIndexAttribute;            ///< index: no | yes
/// payload: rgba8 | occupancy | constant | palette(n) | rgb565 | material(n), which a layout reads.
extern const AttributeKind kPayloadAttribute;
extern const TypedAttribute<Alpha> kAlphaAttribute;   ///< alpha: any | positive
extern const TypedAttribute<Values> kValuesAttribute; ///< values: in-place | apart
extern const TypedAttribute<int>
    kGranuleAttribute; ///< granule: word (0) | 2 (1) | 4 (2) | ... | 256 (8): as log2

/// The attributes that a format takes.
AttributeKinds formatAttributes();

/// The attributes of one level or format that differ from their defaults.
class AttributeSet {
public:
  /// The value of an attribute: its default if it was not set.
  std::string_view value(const AttributeKind &kind) const { return kind.values[number(kind)]; }
  template <typename T> T get(const TypedAttribute<T> &attribute) const {
    return attribute.read(number(attribute));
  }
  /// Sets one of `taken` to one of its values; a default removes it. True if the set changed: it stays as it
  /// is where `taken` has no such kind, or the kind no such value.
  bool set(AttributeKinds taken, const AttributeKind &kind, std::string_view value);
  /// Removes what concerns the kernel alone.
  void eraseTraversal();

  bool operator==(const AttributeSet &) const = default;

private:
  struct Chosen {
    const AttributeKind *kind;
    std::size_t value; // Index into kind->values, at least 1.

    bool operator==(const Chosen &) const = default;
  };
  /// The number of an attribute's value.
  std::size_t number(const AttributeKind &kind) const;

  std::vector<Chosen> attributes_; // In the order of the kinds that are taken.
};

/// The attributes of `set` as IR text, " name=value" each, in the order of `taken`.
std::string printAttributes(const AttributeSet &set, AttributeKinds taken);

} // namespace voxc
