// A layout: the strata of a whole format, and the rules that they keep.
#pragma once

#include "voxc/Layout/Addressing.h"
#include "voxc/Layout/Stratum.h"
#include "voxc/Layout/WordReader.h"
#include "voxc/Support/Diagnostic.h"
#include "voxc/Support/Geometry.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// What a voxel is, as a value of the lowest stratum's cells.
enum class Payload {
  Rgba8,     ///< A colour of four bytes, R lowest. The word 0 is no voxel.
  Occupancy, ///< It is there, or not: all have the value `kOccupied`.
  Constant,  ///< It is there, or not: all have the colour in word 1 of the volume, and `kOccupied` in its
             ///< place.
  Palette,   ///< One of at most 2^n colours, which stand in a table once (voxc/Layout/PaletteBlocks.h).
  Rgb565,    ///< An opaque colour of 5, 6 and 5 bits (voxc/Layout/Rgb565.h).
  Material,  ///< No colour but a label from 1 to 2^n - 1, which hits answer in place of one.
};

/// What a payload asks of a layout.
struct PayloadKind {
  bool varies;    ///< Voxels have values of their own, which may stand apart,
  bool inPlace;   ///< or in the cells of the lowest stratum, as words.
  int mostBits;   ///< The greatest n of those that have one; 0: none has.
  bool oneColour; ///< All voxels have the colour in word 1 of the volume.
  bool labels;    ///< Values are labels and no colours.
  /// What blocks keep of a colour, and the colour of that: null, and colours are kept as they are.
  std::uint32_t (*code)(std::uint32_t colour);
  std::uint32_t (*decode)(std::uint32_t code);
  std::string_view hit; ///< The file of shaders-runtime/payload that makes a hit's colour of a voxel's value,
  std::string_view
      blocks; ///< and that of shaders-runtime/values that decodes values apart; "": they never are.

  bool isShapeAlone() const { return !varies && !oneColour; }
};

const PayloadKind &kindOf(Payload payload);

/// The value of a voxel of which no more is kept than that it is there; of `Payload::Occupancy` an opaque
/// white.
inline constexpr std::uint32_t kOccupied = 0xffffffff;

/// What is known of the alpha of voxels.
enum class Alpha {
  Any,
  Positive, ///< No voxel has an alpha of 0; a build of one that has fails.
};

/// Where the values of voxels stand.
enum class Values {
  InPlace, ///< In the cells of the lowest stratum.
  Apart,   ///< In blocks behind all nodes, by rank (voxc/Layout/Values.h); cells say no more than that a
           ///< voxel is there.
};

/// What is known of all voxels.
struct VoxelFacts {
  Payload payload = Payload::Rgba8;
  int payloadBits = 0; ///< The n of `Payload::Palette` and `Payload::Material`.
  Alpha alpha = Alpha::Any;

  /// That there are at most 2^bits colours, and no more.
  static constexpr VoxelFacts ofPalette(int bits) { return {Payload::Palette, bits, Alpha::Any}; }
};

/// The most words that a kernel reaches from where a reference leads to, where references count granules: an
/// offset that is added to the last place of a segment stays a word. What has more, moves the reference on.
inline constexpr std::uint64_t kMaxNodeWords = kMaxWords - kSegmentWords;

/// Where the words of a volume lie, for all voxels of it.
struct Layout {
  std::string format;              ///< As a string of the grammar, for people.
  std::uint64_t storageDigest = 0; ///< Of the level IR that it comes from: what kernels and volumes agree on.
  Payload payload = Payload::Rgba8;
  int payloadBits = 0; ///< The n of a payload that has one; 0 of others.
  Alpha alpha = Alpha::Any;
  Values values = Values::InPlace;
  /// log2 of the words of a granule, `kMaxLog2Granule` at most: references count granules, and what they lead
  /// to begins at one.
  int log2Granule = 0;
  std::vector<Stratum> strata; ///< From the highest to the lowest, one a level.

  bool operator==(const Layout &) const = default;

  /// Fills in what follows from the rest: of each stratum whether its cells are voxels, whether their values
  /// are implied and have ranks, and where the arrays of numbers begin.
  void complete();
  /// True if nodes count voxels, so that each has a rank, by which its value is found.
  bool ranksVoxels() const { return values == Values::Apart; }
  bool hasOneColour() const { return kindOf(payload).oneColour; }
  bool hasLabels() const { return kindOf(payload).labels; }
  VoxelFacts voxelFacts() const { return {payload, payloadBits, alpha}; }
  /// The payload as IR and plans write it: "rgba8", "palette(4)".
  std::string payloadText() const;
  /// Takes such a text. False, and no change, if it is none.
  bool setPayload(std::string_view text);
  /// Words before the first node: where the root is; with values apart, where their blocks begin, or the one
  /// colour of all voxels; where the array of indexed sub-volumes begins, if there is one; zeros up to a
  /// whole granule.
  std::uint64_t headWords() const;
  /// True if sub-volumes of a stratum stand in an array.
  bool hasArray() const;
  /// True if numbers in slots of strata[index] lead to sub-volumes of an array; else offsets lead to nodes.
  bool leadsIntoArray(std::size_t index) const { return !holdsVoxels(index) && strata[index + 1].inArray(); }
  /// log2 of the voxels along each axis.
  Int3 log2Extent() const;
  /// The first word at or after `word` to which a reference can lead.
  std::uint64_t granuleAfter(std::uint64_t word) const {
    const std::uint64_t granule = std::uint64_t{1} << log2Granule;
    return (word + granule - 1) & ~(granule - 1);
  }
  /// The bits of references that say where something is; the others stay when it moves.
  Ref placeMask() const;
  /// What leads to a word at which a granule begins.
  Ref refOf(std::uint64_t word) const { return static_cast<Ref>(word >> log2Granule); }
  /// log2 of the words from one reference that can lead to nodes of strata[index] to the next.
  int log2UnitOf(std::size_t index) const {
    return strata[index].inArray() ? kLog2IndexedWords : log2Granule;
  }
  /// True if zeros may follow a node, up to where the next can begin.
  bool padsNodes() const { return log2Granule > 0; }
  /// The most words that a kernel reaches from where a reference leads to.
  std::uint64_t maxNodeWords() const { return padsNodes() ? kMaxNodeWords : ~std::uint64_t{0}; }
  /// The same layout with references that count words.
  Layout countingWords() const {
    Layout layout = *this;
    layout.log2Granule = 0;
    return layout;
  }
  /// Words of a volume of this layout, or those that a source has, which must outlive the reader.
  WordReader reader(std::span<const std::uint32_t> words) const { return WordReader(words, log2Granule); }
  WordReader reader(const WordSource &source) const { return WordReader(source, log2Granule); }
  /// True if the cells of strata[index] are voxels.
  bool holdsVoxels(std::size_t index) const { return index + 1 == strata.size(); }
  /// The most words that a volume may have: references may be narrower than a word.
  std::uint64_t maxWords() const;
  /// The smallest cubes, of 2^n voxels a side, n at least `log2Side`, that are whole nodes or cells
  /// somewhere: volumes can be built of such parts. The bounding cube at most.
  int partSide(int log2Side) const;
  /// The stratum, by index, that has nodes of 2^log2Side voxels a side, or whose cells such cubes cover.
  std::size_t stratumOfPart(int log2Side) const;
};

/// What would let references reach more words, as the beginning of a list, or "" if nothing would.
std::string adviceOfReach(const Layout &layout);

/// Checks every rule of strata: shapes, masks, slots, cells and distances fit each other, and the sizes add
/// up. `ranges`, where they are given, say where each stratum was written.
void verify(const Layout &layout, Diagnostics &diagnostics, const std::vector<SourceRange> &ranges = {});

template <>
inline constexpr std::array<std::string_view, 6> kEnumNames<Payload> = {"rgba8",   "occupancy", "constant",
                                                                        "palette", "rgb565",    "material"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Alpha> = {"any", "positive"};
template <> inline constexpr std::array<std::string_view, 2> kEnumNames<Values> = {"in-place", "apart"};

/// Lowers the reach of a stratum's distances to what their bits can encode, and to what can occur.
void fitReach(Stratum &stratum);

} // namespace voxc
