// The bytes of NanoVDB files of version 32: a file's head, then grids that are used in memory as they lie.
//
// A grid is a tree of fixed depth: a root with a table, upper nodes of 32^3 children, lower ones of 16^3, and
// leaves of 8^3 values. Cells of a node are numbered with z fastest. Offsets are from the node that holds
// them, and everything begins at a multiple of 32 bytes.
#pragma once

#include "voxc/Support/Geometry.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace voxc::nanovdb {

inline constexpr std::uint64_t kMagic = 0x304244566f6e614e;     ///< "NanoVDB0", of files and grids.
inline constexpr std::uint64_t kMagicGrid = 0x314244566f6e614e; ///< "NanoVDB1", of grids since 32.6.
inline constexpr std::uint64_t kMagicFile = 0x324244566f6e614e; ///< "NanoVDB2", of files since 32.6.

inline constexpr std::uint32_t kMajorVersion = 32;
constexpr std::uint32_t majorOf(std::uint32_t version) { return version >> 21; }
/// What is written: the first version of this layout that Debian has.
inline constexpr std::uint32_t kVersion = kMajorVersion << 21 | 4 << 10 | 2;

inline constexpr int kLog2Leaf = 3;
inline constexpr int kLog2Lower = 7;
inline constexpr int kLog2Upper = 12;

enum Codec : std::uint16_t { kUncompressed = 0, kZip = 1, kBlosc = 2 };

enum GridClass : std::uint32_t { kLevelSet = 1, kVoxelVolume = 7 };

inline constexpr std::uint32_t kRgba8 = 12; ///< The type of a grid.
inline constexpr std::uint32_t kHasBox = 1 << 1;
inline constexpr std::uint32_t kIsBreadthFirst = 1 << 5;
inline constexpr std::uint8_t kLeafHasBox = 1 << 1;
inline constexpr std::uint64_t kNoChecksum = ~std::uint64_t{0};

struct FileHead {
  std::uint64_t magic = kMagic;
  std::uint32_t version = kVersion;
  std::uint16_t grids = 1;
  std::uint16_t codec = kUncompressed;
};
static_assert(sizeof(FileHead) == 16);

/// One for each grid behind the head, each with the grid's name behind it.
struct FileGrid {
  std::uint64_t gridBytes = 0; ///< In memory,
  std::uint64_t fileBytes = 0; ///< and in the file.
  std::uint64_t nameHash = 0;
  std::uint64_t voxels = 0;
  std::uint32_t type = 0;
  std::uint32_t gridClass = 0;
  std::array<double, 6> worldBox{};
  std::array<std::int32_t, 6> box{};
  std::array<double, 3> voxelSize{};
  std::uint32_t nameBytes = 0; ///< With its 0.
  std::array<std::uint32_t, 4> nodes{};
  std::array<std::uint32_t, 3> tiles{};
  std::uint16_t codec = kUncompressed;
  std::uint16_t padding = 0;
  std::uint32_t version = kVersion;
};
static_assert(sizeof(FileGrid) == 176);

/// From index space, in which whole numbers are the middles of voxels, to the world.
struct Map {
  std::array<float, 9> matrixF{}; ///< Row by row.
  std::array<float, 9> inverseF{};
  std::array<float, 3> originF{};
  float taperF = 1;
  std::array<double, 9> matrix{};
  std::array<double, 9> inverse{};
  std::array<double, 3> origin{};
  double taper = 1;
};

struct Grid {
  std::uint64_t magic = kMagic;
  std::uint64_t checksum = kNoChecksum;
  std::uint32_t version = kVersion;
  std::uint32_t flags = kHasBox | kIsBreadthFirst;
  std::uint32_t index = 0;
  std::uint32_t count = 1;
  std::uint64_t bytes = 0;
  std::array<char, 256> name{};
  Map map;
  std::array<double, 6> worldBox{};
  std::array<double, 3> voxelSize{};
  std::uint32_t gridClass = 0;
  std::uint32_t type = 0;
  std::int64_t blindOffset = 0;
  std::uint32_t blindCount = 0;
  std::uint32_t padding = 0;
  std::array<std::uint64_t, 2> more{};
};
static_assert(sizeof(Grid) == 672 && offsetof(Grid, map) == 296 && offsetof(Grid, type) == 636);

/// Follows the grid.
struct Tree {
  std::array<std::uint64_t, 4> offsets{}; ///< Of the first leaf, lower and upper node, and of the root.
  std::array<std::uint32_t, 3> nodes{};
  std::array<std::uint32_t, 3> tiles{}; ///< Active ones of lower and upper nodes and of the root.
  std::uint64_t voxels = 0;
};
static_assert(sizeof(Tree) == 64);

/// Of values of 32 bits, as what follows. Boxes are of active cells: the least and the greatest of them.
struct Root {
  std::array<std::int32_t, 6> box{};
  std::uint32_t tiles = 0;
  std::uint32_t background = 0;
  std::array<std::uint32_t, 4> statistics{};
  std::array<std::uint32_t, 4> padding{};
};
static_assert(sizeof(Root) == 64);

struct RootTile {
  std::uint64_t key = 0;
  std::int64_t child = 0; ///< From the root; 0: a tile.
  std::uint32_t isActive = 0;
  std::uint32_t value = 0;
  std::uint64_t padding = 0;
};
static_assert(sizeof(RootTile) == 32);

/// The key of the upper node around a cell.
constexpr std::uint64_t keyOf(Int3 cell) {
  const auto part = [](std::int32_t v) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(v) >> kLog2Upper);
  };
  return part(cell.z) | part(cell.y) << 21 | part(cell.x) << 42;
}

/// The number of the child around a cell, in a node of 2^(3 * log2Children) children of 2^log2Child cells.
constexpr std::uint32_t childOf(Int3 cell, int log2Child, int log2Children) {
  const auto part = [&](std::int32_t v) {
    return static_cast<std::uint32_t>(v >> log2Child) & ((1u << log2Children) - 1);
  };
  return part(cell.x) << 2 * log2Children | part(cell.y) << log2Children | part(cell.z);
}

/// A node of 2^(3 * Log2) children or tiles.
template <int Log2> struct Inner {
  static constexpr std::size_t kChildren = std::size_t{1} << 3 * Log2;

  std::array<std::int32_t, 6> box{};
  std::uint64_t flags = 0;
  std::array<std::uint64_t, kChildren / 64> isActive{};
  std::array<std::uint64_t, kChildren / 64> isChild{};
  std::array<std::uint32_t, 4> statistics{};
  std::array<std::uint32_t, 4> padding{};
  std::array<std::int64_t, kChildren> table{}; ///< The offset of a child, or a value.
};
using Upper = Inner<kLog2Upper - kLog2Lower>;
using Lower = Inner<kLog2Lower - kLog2Leaf>;
static_assert(sizeof(Upper) == 270400 && sizeof(Lower) == 33856);

struct Leaf {
  std::array<std::int32_t, 3> low{};   ///< Of the box,
  std::array<std::uint8_t, 3> steps{}; ///< and from there to its last cell.
  std::uint8_t flags = kLeafHasBox;
  std::array<std::uint64_t, 8> isActive{};
  std::array<std::uint32_t, 4> statistics{};
  std::array<std::uint32_t, 512> values{};
};
static_assert(sizeof(Leaf) == 2144);

template <std::size_t N> void setBit(std::array<std::uint64_t, N> &bits, std::uint32_t bit) {
  bits[bit / 64] |= std::uint64_t{1} << bit % 64;
}

} // namespace voxc::nanovdb
