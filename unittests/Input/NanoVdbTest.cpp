// NanoVDB files: what is exported is what NanoVDB's own reader finds, and what ours reads back; grids of
// every type that NanoVDB's tools write; broken files.
#include "Source/SourceTesting.h"

#include "voxc/Input/Input.h"
#include "voxc/Source/Export.h"

#include <blosc.h>
#include <gmock/gmock.h>
#include <zlib.h>

#include <bit>
#include <cstring>
#include <random>

#if __has_include(<nanovdb/NanoVDB.h>)
#define VOXC_HAS_NANOVDB
#include <nanovdb/util/GridBuilder.h>
#include <nanovdb/util/GridValidator.h>
#include <nanovdb/util/IO.h>
#include <nanovdb/util/Primitives.h>
#endif

namespace voxc {
namespace {

using ::testing::HasSubstr;

/// Some voxels, and some bricks of one colour, which become tiles.
Voxels someVoxels(Int3 extent, unsigned seed) {
  std::mt19937 random(seed);
  Voxels voxels;
  const auto cell = [&] {
    Int3 at;
    for (int axis = 0; axis < 3; ++axis)
      at[axis] = static_cast<int>(random() % static_cast<unsigned>(extent[axis]));
    return at;
  };
  for (int i = 0; i < 50; ++i)
    voxels[mortonCode(cell())] = 1 + random() % 0xffffffff;
  for (int brick = 0; brick < 3; ++brick) {
    const Int3 low = (cell() >> 3) * 8;
    for (std::uint64_t at = 0; at < 512; ++at)
      if (contains(extent, low + mortonCell(at)))
        voxels[mortonCode(low + mortonCell(at))] = 0xff00ff00 + static_cast<std::uint32_t>(brick);
  }
  return voxels;
}

/// The least cell on each axis, which becomes 0 when a grid is read.
Voxels movedToOrigin(const Voxels &voxels) {
  Int3 low{1 << 21, 1 << 21, 1 << 21};
  for (const auto &[code, word] : voxels)
    for (int axis = 0; axis < 3; ++axis)
      low[axis] = std::min(low[axis], mortonCell(code)[axis]);
  Voxels moved;
  for (const auto &[code, word] : voxels)
    moved[mortonCode(mortonCell(code) - low)] = word;
  return moved;
}

InputOptions largeOptions() {
  InputOptions options;
  options.formatExtent = {1 << 14, 1 << 14, 1 << 14};
  return options;
}

constexpr std::array<Int3, 4> kExtents{{{1, 1, 1}, {40, 9, 3}, {130, 200, 17}, {5000, 3, 2}}};

TEST(NanoVdb, ComesBackAsItWas) {
  const TemporaryFolder folder;
  for (const Int3 extent : kExtents) {
    const Voxels voxels = someVoxels(extent, 4);
    const Transform map = transformOfRows({0, 0, 3, 1, 0, 3, 0, 2, -3, 0, 0, 5});
    const auto written = exportVoxels(denseVolume(voxels, extent, map), folder.path("v.nvdb"));
    ASSERT_TRUE(written) << written.error().message;
    const auto input = openInput(folder.path("v.nvdb"), largeOptions());
    ASSERT_TRUE(input) << input.error().message;
    EXPECT_EQ(voxelsOf(*input->source), movedToOrigin(voxels));
    EXPECT_EQ(rowsOf(input->source->voxelToModel())[2], 3);
  }
}

TEST(NanoVdb, OfNothingIsAGridWithoutVoxels) {
  const TemporaryFolder folder;
  ASSERT_TRUE(exportVoxels(denseVolume({}, {4, 4, 4}), folder.path("v.nvdb")));
  EXPECT_THAT(openInput(folder.path("v.nvdb"), {}).error().message, HasSubstr("has no active voxel"));
}

std::string contentOf(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A small file and where its parts begin.
struct SmallFile {
  explicit SmallFile(const TemporaryFolder &folder) {
    EXPECT_TRUE(exportVoxels(denseVolume({{0, 7}, {mortonCode({3, 2, 1}), 8}}, {4, 4, 4}),
                             folder.path("small.nvdb")));
    bytes = contentOf(folder.path("small.nvdb"));
  }

  template <typename T> std::string with(std::size_t at, T value) const {
    std::string changed = bytes;
    std::memcpy(changed.data() + at, &value, sizeof value);
    return changed;
  }

  std::string bytes;
  std::size_t grid = 16 + 176 + 7;
  std::size_t root = grid + 672 + 64;
  std::size_t upper = root + 64 + 32;
  std::size_t lower = upper + 270400;
};

TEST(NanoVdb, ZipIsInflated) {
  const TemporaryFolder folder;
  const SmallFile small(folder);
  const std::string plain = small.bytes.substr(small.grid);
  uLongf size = compressBound(plain.size());
  std::string packed(size, '\0');
  ASSERT_EQ(compress(reinterpret_cast<Bytef *>(packed.data()), &size,
                     reinterpret_cast<const Bytef *>(plain.data()), plain.size()),
            Z_OK);
  const std::uint64_t bytes = size;
  std::string file = small.with<std::uint16_t>(14, 1).substr(0, small.grid);
  file.append(reinterpret_cast<const char *>(&bytes), sizeof bytes).append(packed, 0, size);
  const auto input = openInput(folder.file("zip.nvdb", file), {});
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(voxelsOf(*input->source).size(), 2u);
  EXPECT_FALSE(openInput(folder.file("cut.nvdb", file.substr(0, file.size() - 9)), {}));
}

TEST(NanoVdb, BloscIsInflated) {
  const TemporaryFolder folder;
  const SmallFile small(folder);
  const std::string plain = small.bytes.substr(small.grid);
  std::string packed(plain.size() + BLOSC_MAX_OVERHEAD, '\0');
  const int size = blosc_compress_ctx(9, 1, sizeof(float), plain.size(), plain.data(), packed.data(),
                                      packed.size(), BLOSC_LZ4_COMPNAME, 1 << 18, 1);
  ASSERT_GT(size, 0);
  const auto bytes = static_cast<std::uint64_t>(size);
  std::string file = small.with<std::uint16_t>(14, 2).substr(0, small.grid);
  file.append(reinterpret_cast<const char *>(&bytes), sizeof bytes).append(packed, 0, bytes);
  const auto input = openInput(folder.file("blosc.nvdb", file), {});
  ASSERT_TRUE(input) << input.error().message;
  EXPECT_EQ(voxelsOf(*input->source).size(), 2u);
  EXPECT_FALSE(openInput(folder.file("cut.nvdb", file.substr(0, file.size() - 9)), {}));
  // Its head says another size than that of the grid.
  file[small.grid + 8 + 4] ^= 1;
  EXPECT_THAT(openInput(folder.file("other.nvdb", file), {}).error().message,
              HasSubstr("is damaged, or is not as large"));
}

TEST(NanoVdb, OfSeveralGridsAndSegmentsOneIsTakenByName) {
  const TemporaryFolder folder;
  nanovdb::GridBuilder<nanovdb::Vec3f> arrows(nanovdb::Vec3f(0.0f));
  arrows.getAccessor().setValue(nanovdb::Coord(0, 0, 0), nanovdb::Vec3f(1.0f));
  nanovdb::GridBuilder<float> few(0.0f), many(0.0f);
  few.getAccessor().setValue(nanovdb::Coord(0, 0, 0), 1.0f);
  auto accessor = many.getAccessor();
  for (int x = 0; x < 5; ++x)
    accessor.setValue(nanovdb::Coord(x, 0, 0), 1.0f);
  std::vector<nanovdb::GridHandle<>> handles;
  handles.push_back(arrows.getHandle<>(1.0, nanovdb::Vec3d(0.0), "velocity"));
  handles.push_back(few.getHandle<>(1.0, nanovdb::Vec3d(0.0), "few"));
  nanovdb::io::writeGrids(folder.path("a.nvdb"), handles);
  nanovdb::io::writeGrid(folder.path("b.nvdb"), many.getHandle<>(1.0, nanovdb::Vec3d(0.0), "many of it"));
  const auto bytesOf = [&](const char *name) {
    std::ifstream file(folder.path(name), std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  };
  // Two files joined are two segments of one.
  const std::string path = folder.file("c.nvdb", bytesOf("a.nvdb") + bytesOf("b.nvdb"));
  InputOptions options;
  const auto first = openInput(path, options);
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(voxelsOf(*first->source).size(), 1u);
  ASSERT_EQ(first->warnings.size(), 1u);
  EXPECT_THAT(first->warnings[0],
              HasSubstr("it holds 3 grids; 'few' is taken, and left out are velocity (vectors of "
                        "3 floats), many of it (float)"));
  options.grid = "many of it";
  const auto named = openInput(path, options);
  ASSERT_TRUE(named) << named.error().message;
  EXPECT_EQ(voxelsOf(*named->source).size(), 5u);
  EXPECT_TRUE(named->warnings.empty());
  EXPECT_THAT(named->provenance, HasSubstr("grid=many%20of%20it"));
  options.grid = "smoke";
  EXPECT_THAT(
      openInput(path, options).error().message,
      HasSubstr("it has no grid 'smoke'; there are velocity (vectors of 3 floats), few (float), many of it"));
}

TEST(NanoVdb, BrokenFilesAreErrors) {
  const TemporaryFolder folder;
  const SmallFile small(folder);
  const auto message = [&](const std::string &bytes) {
    const auto input = openInput(folder.file("b.nvdb", bytes), {});
    return input ? std::string("fine") : input.error().message;
  };
  EXPECT_EQ(message(small.bytes), "fine");
  EXPECT_THAT(message("nonsense and more of it"), HasSubstr("does not begin as NanoVDB files do"));
  EXPECT_THAT(message(small.with<std::uint32_t>(8, 29u << 21)), HasSubstr("version 29"));
  EXPECT_THAT(message(small.with<std::uint16_t>(14, 2)), HasSubstr("cut short"));
  EXPECT_THAT(message(small.with<std::uint16_t>(14, 9)), HasSubstr("number 9"));
  EXPECT_THAT(message(small.with<std::uint16_t>(12, 0)), HasSubstr("has no grid"));
  EXPECT_THAT(message(small.with<std::uint64_t>(16, 1ull << 60)), HasSubstr("cut short"));
  EXPECT_THAT(message(small.with<std::uint32_t>(small.grid + 636, 6)), HasSubstr("type 6"));
  EXPECT_THAT(message(small.with<std::uint64_t>(small.grid + 672 + 24, 1ull << 62)), HasSubstr("its root"));
  EXPECT_THAT(message(small.with<std::uint32_t>(small.root + 24, 1u << 31)),
              HasSubstr("more than there are"));
  for (const std::int64_t offset : {std::int64_t{-1} << 62, std::int64_t{1} << 62, std::int64_t{1} << 20})
    EXPECT_THAT(message(small.with(small.root + 64 + 8, offset)), HasSubstr("outside of the grid"));
  EXPECT_THAT(message(small.with(small.upper + 8256, std::int64_t{1} << 20)),
              HasSubstr("outside of the grid"));
  EXPECT_THAT(message(small.with(small.lower + 1088, std::int64_t{1} << 20)),
              HasSubstr("outside of the grid"));
  // Every child is the one lower node.
  std::string many = small.bytes;
  std::memset(many.data() + small.upper + 4128, 0xff, 4096);
  for (std::size_t i = 0; i < 32768; ++i)
    std::memcpy(many.data() + small.upper + 8256 + 8 * i, "\x40\x20\4\0\0\0\0\0", 8);
  EXPECT_THAT(message(many), HasSubstr("used more than once"));
  for (std::size_t size = 0; size < small.bytes.size(); size += 40009)
    EXPECT_NE(message(small.bytes.substr(0, size)), "fine");
}

#ifdef VOXC_HAS_NANOVDB

TEST(NanoVdb, ItsOwnReaderAgreesOnEveryVoxel) {
  const TemporaryFolder folder;
  for (const Int3 extent : kExtents) {
    const Voxels voxels = someVoxels(extent, 9);
    const Transform map = transformOfRows({0, 0, 3, 1, 0, 3, 0, 2, -3, 0, 0, 5});
    const std::string path = folder.path("v.nvdb");
    ASSERT_TRUE(exportVoxels(denseVolume(voxels, extent, map), path));
    const auto handle = nanovdb::io::readGrid(path, std::string("voxels"));
    const auto *grid = handle.grid<nanovdb::Rgba8>();
    ASSERT_TRUE(grid);
    EXPECT_TRUE(nanovdb::isValid(*grid, true, true));
    EXPECT_EQ(grid->activeVoxelCount(), voxels.size());
    auto accessor = grid->getAccessor();
    Int3 cell;
    for (cell.z = -1; cell.z <= extent.z; ++cell.z)
      for (cell.y = -1; cell.y <= extent.y; ++cell.y)
        for (cell.x = -1; cell.x <= extent.x; ++cell.x) {
          const nanovdb::Coord at(cell.x, cell.y, cell.z);
          const auto found = contains(extent, cell) ? voxels.find(mortonCode(cell)) : voxels.end();
          const std::uint32_t word = found == voxels.end() ? 0 : found->second;
          ASSERT_EQ(accessor.getValue(at).packed(), word);
          ASSERT_EQ(accessor.isActive(at), word != 0);
        }
    // The middle of voxel (0, 0, 0).
    const nanovdb::Vec3d middle = grid->indexToWorld(nanovdb::Vec3d(0, 0, 0));
    EXPECT_EQ(middle, nanovdb::Vec3d(1 + 1.5, 2 + 1.5, 5 - 1.5));
    const nanovdb::Vec3d back = grid->worldToIndex(middle);
    EXPECT_NEAR(back.length(), 0, 1e-12);
    EXPECT_EQ(nanovdb::io::readGridMetaData(path)[0].voxelCount, voxels.size());
  }
}

/// A grid of `Value` built by NanoVDB itself, and what our reader makes of it.
template <typename Value, typename Built = Value> void expectSamples(double tolerance) {
  const TemporaryFolder folder;
  nanovdb::GridBuilder<Value, Built> builder(Value(0));
  auto accessor = builder.getAccessor();
  std::mt19937 random(2);
  std::map<std::uint64_t, int> values;
  for (int i = 0; i < 300; ++i) {
    const Int3 cell{static_cast<int>(random() % 40), static_cast<int>(random() % 300),
                    static_cast<int>(random() % 20)};
    const int value = 1 + static_cast<int>(random() % 100);
    values[mortonCode(cell)] = value;
    accessor.setValue(nanovdb::Coord(cell.x - 13, cell.y - 200, cell.z + 5), Value(value));
  }
  const auto handle = builder.template getHandle<>();
  nanovdb::io::writeGrid(folder.path("g.nvdb"), handle);
  InputOptions options = largeOptions();
  options.threshold = 50.5;
  const auto input = openInput(folder.path("g.nvdb"), options);
  ASSERT_TRUE(input) << input.error().message;
  Voxels voxels = voxelsOf(*input->source);
  Voxels all;
  for (const auto &[code, value] : values)
    all[code] = static_cast<std::uint32_t>(value);
  std::size_t expected = 0;
  for (const auto &[code, value] : movedToOrigin(all)) {
    expected += value > 50;
    if (std::abs(static_cast<double>(value) - 50.5) > tolerance) {
      ASSERT_EQ(voxels.contains(code), value > 50) << value;
    }
  }
  if (tolerance < 0.5) {
    EXPECT_EQ(voxels.size(), expected);
  }
}

TEST(NanoVdb, NumbersOfEveryTypeAreSamples) {
  expectSamples<float>(0);
  expectSamples<double>(0);
  expectSamples<std::int32_t>(0);
  expectSamples<std::int64_t>(0);
  expectSamples<float, nanovdb::Fp16>(0.1);
  expectSamples<float, nanovdb::Fp8>(0.45);
  expectSamples<float, nanovdb::Fp4>(10);
}

TEST(NanoVdb, LevelSetsAreFilled) {
  const TemporaryFolder folder;
  const auto handle = nanovdb::createLevelSetSphere<float>(20, nanovdb::Vec3f(-3, 5, 7));
  nanovdb::io::writeGrid(folder.path("g.nvdb"), handle);
  const auto input = openInput(folder.path("g.nvdb"), largeOptions());
  ASSERT_TRUE(input) << input.error().message;
  const auto *grid = handle.grid<float>();
  auto accessor = grid->getAccessor();
  const auto box = grid->indexBBox();
  std::size_t inside = 0;
  for (auto at = box.begin(); at; ++at)
    inside += accessor.getValue(*at) <= 0.5;
  EXPECT_EQ(voxelsOf(*input->source).size(), inside);
  EXPECT_GT(inside, 30000u);
  EXPECT_EQ(input->provenance, "coverage=inside up=y");
}

#else

TEST(NanoVdb, ItsOwnReaderAgreesOnEveryVoxel) { GTEST_SKIP() << "libnanovdb-dev is not installed"; }

#endif

} // namespace
} // namespace voxc
