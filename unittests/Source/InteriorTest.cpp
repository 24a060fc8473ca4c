// Dropping and filling what is hidden, held against floods cell by cell and against rays.
#include "voxc/Source/Interior.h"
#include "FloodTesting.h"
#include "TestLength.h"

#include "testing/HardRays.h"
#include "testing/HardScenes.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Source/Sources.h"

#include <atomic>
#include <cmath>
#include <cstring>

namespace voxc::test {
namespace {

std::unique_ptr<VoxelSource> sourceOf(const Grid &grid) { return makeGridSource(grid.extent, grid.words); }

InteriorOptions someMeans(unsigned threads = 1, std::uint64_t memory = std::uint64_t{1} << 26) {
  return {WorkingMemory::create(memory), threads, {}};
}

constexpr std::uint32_t kFill = 0xff123456;

/// The grid without the voxels that no step comes to; `dropped` counts them.
Grid withoutHidden(const Grid &grid, std::uint64_t &dropped) {
  const std::vector<char> touched = touchedFromOutside(grid, raySteps());
  Grid kept = grid;
  for (std::size_t i = 0; i < kept.words.size(); ++i)
    if (!touched[i]) {
      dropped += kept.words[i] != 0;
      kept.words[i] = 0;
    }
  return kept;
}

Grid filled(const Grid &grid, std::uint64_t &added) {
  const std::vector<char> touched = touchedFromOutside(grid, faceSteps());
  Grid full = grid;
  for (std::size_t i = 0; i < full.words.size(); ++i)
    if (!touched[i] && full.words[i] == 0) {
      ++added;
      full.words[i] = kFill;
    }
  return full;
}

void expectDropped(const Grid &grid) {
  std::uint64_t count = 0;
  const Grid expected = withoutHidden(grid, count);
  auto dropped = dropInterior(sourceOf(grid), someMeans());
  ASSERT_TRUE(dropped) << dropped.error().message;
  EXPECT_EQ(dropped->voxels, count);
  EXPECT_EQ(voxelsOf(*dropped->source), voxelsOf(expected));
}

void expectFilled(const Grid &grid) {
  std::uint64_t count = 0;
  const Grid expected = filled(grid, count);
  auto full = fillInterior(sourceOf(grid), kFill, someMeans());
  ASSERT_TRUE(full) << full.error().message;
  EXPECT_EQ(full->voxels, count);
  EXPECT_EQ(voxelsOf(*full->source), voxelsOf(expected));
}

std::vector<Grid> someGrids(unsigned seed) {
  std::vector<Grid> grids{hollowGrid({40, 31, 17}, seed), hollowGrid({70, 66, 65}, seed),
                          hollowGrid({8, 8, 8}, seed), hollowGrid({64, 64, 64}, seed),
                          hollowGrid({1, 90, 3}, seed)};
  // Where dust begins to leave no way through, faces first, then edges and corners.
  for (const unsigned percent : {50u, 65u, 70u, 78u, 85u, 90u})
    grids.push_back(dustGrid({33, 40, 26}, percent, seed));
  return grids;
}

TEST(Interior, DropAndFillAreFloodsByTheDefinition) {
  for (int round = 0; round < rounds(3); ++round)
    for (const Grid &grid : someGrids(static_cast<unsigned>(round))) {
      SCOPED_TRACE(std::to_string(grid.extent.x) + " round " + std::to_string(round));
      expectDropped(grid);
      expectFilled(grid);
    }
}

TEST(Interior, OfSolidAndEmptyScenes) {
  for (const Int3 extent :
       {Int3{1, 1, 1}, Int3{8, 8, 8}, Int3{9, 16, 64}, Int3{65, 64, 63}, Int3{100, 9, 100}}) {
    expectDropped(Grid(extent));
    expectFilled(Grid(extent));
    expectDropped(dustGrid(extent, 100, 1));
    expectFilled(dustGrid(extent, 100, 1));
  }
}

/// A hollow box of 2^19 voxels a side, of which every 64th cube of 8^3 is looked at: memory follows what is
/// there.
TEST(Interior, OfVastScenes) {
  constexpr int kSide = 1 << kMaxLog2Extent;
  // A shell around one far corner, and one voxel in the other.
  const auto voxel = [](Int3 cell) -> std::uint32_t {
    const Int3 at = cell - Int3{1, 1, 1} * (kSide - 40);
    if (cell == Int3{})
      return 7;
    const int reach = std::max({std::abs(at.x - 20), std::abs(at.y - 20), std::abs(at.z - 20)});
    return reach == 15 ? 9 : reach == 3 ? 5 : 0;
  };
  const auto empty = [](const Cube &cube) {
    const bool isLow = cube.low == Int3{};
    const bool isHigh = std::min({cube.low.x, cube.low.y, cube.low.z}) + cube.side() > kSide - 40;
    return !isLow && !isHigh;
  };
  const auto make = [&] { return makeFunctionSource({kSide, kSide, kSide}, voxel, empty); };
  auto dropped = dropInterior(make(), someMeans());
  ASSERT_TRUE(dropped) << dropped.error().message;
  EXPECT_EQ(dropped->voxels, 7u * 7 * 7 - 5 * 5 * 5);
  EXPECT_EQ(voxelsOf(*dropped->source).size(), 1u + 31 * 31 * 31 - 29 * 29 * 29);
  auto full = fillInterior(make(), kFill, someMeans());
  ASSERT_TRUE(full) << full.error().message;
  EXPECT_EQ(voxelsOf(*full->source).size(), 1u + 31 * 31 * 31);
}

bool isHidden(const Grid &grid, const std::vector<char> &touched, const Ray &ray) {
  Int3 cell;
  for (int axis = 0; axis < 3; ++axis) {
    const float at = ray.origin[axis];
    if (!(at >= 0 && at < static_cast<float>(grid.extent[axis])))
      return false;
    cell[axis] = static_cast<int>(std::floor(at));
  }
  const auto index =
      std::size_t(cell.x) +
      std::size_t(grid.extent.x) * (std::size_t(cell.y) + std::size_t(grid.extent.y) * std::size_t(cell.z));
  return !touched[index];
}

/// No ray that begins where one from outside may come to tells the difference.
void expectSameHits(const Grid &grid, std::uint64_t seed) {
  auto dropped = dropInterior(sourceOf(grid), someMeans());
  ASSERT_TRUE(dropped);
  const auto source = sourceOf(grid);
  const auto before = Oracle::of(*source);
  const auto after = Oracle::of(*dropped->source);
  ASSERT_TRUE(before && after);
  const std::vector<char> touched = touchedFromOutside(grid, raySteps());
  const std::vector<Int3> voxels = before->sampleVoxels(500);
  std::uint64_t compared = 0;
  for (const HardRayClass &kind : hardRayClasses())
    for (const Ray &ray : hardRays({grid.extent, voxels}, kind.name, 300, seed)) {
      if (isHidden(grid, touched, ray))
        continue;
      const Hit a = before->trace(ray);
      const Hit b = after->trace(ray);
      ++compared;
      ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0)
          << kind.name << " from " << ray.origin[0] << " " << ray.origin[1] << " " << ray.origin[2]
          << " along " << ray.direction[0] << " " << ray.direction[1] << " " << ray.direction[2];
    }
  EXPECT_GT(compared, 1000u);
}

TEST(Interior, DroppingChangesNoRayFromOutside) {
  for (int round = 0; round < rounds(2); ++round) {
    const auto seed = static_cast<unsigned>(round);
    for (const Grid &grid : someGrids(100 + seed))
      expectSameHits(grid, seed);
    // Small and dense: rays go through edges and corners all the time.
    for (const unsigned percent : {60u, 75u, 85u})
      for (unsigned i = 0; i < 5; ++i)
        expectSameHits(dustGrid({7, 6, 8}, percent, 10 * seed + i), i);
  }
}

/// A diagonal wall lets rays through that rise on both axes, and stops those that rise on one and fall on the
/// other if it leans the other way: what lies behind it stays, or goes.
TEST(Interior, RaysPassBetweenVoxelsThatShareAnEdge) {
  const auto room = [](bool leansUp) {
    Grid grid({5, 5, 1});
    grid.forEach([&](Int3 cell) { grid.at(cell) = 1; });
    // An empty cell inside that touches the outer world over an edge of the cell in the corner alone.
    grid.at({1, leansUp ? 1 : 3, 0}) = 0;
    grid.at({0, leansUp ? 0 : 4, 0}) = 0;
    return grid;
  };
  // Closed in z, so that the only way leads over the edge.
  const auto closed = [&](bool leansUp) {
    const Grid flat = room(leansUp);
    Grid grid({5, 5, 5});
    grid.forEach([&](Int3 cell) { grid.at(cell) = cell.z == 2 ? flat.at({cell.x, cell.y, 0}) : 1; });
    return grid;
  };
  const auto droppedOf = [](const Grid &grid) { return dropInterior(sourceOf(grid), someMeans())->voxels; };
  // From (0, 0) up to (1, 1): x and y rise together, and the cell's voxels are seen.
  const std::uint64_t rising = droppedOf(closed(true));
  // From (0, 4) to (1, 3): x rises first, into a voxel.
  const std::uint64_t falling = droppedOf(closed(false));
  EXPECT_LT(rising, falling);
  const auto source = sourceOf(closed(true));
  const Ray ray{{0.5f, 0.5f, 2.5f}, {1, 1, 0}};
  EXPECT_EQ(Oracle::of(*source)->trace(ray).voxel[0], 2);
}

TEST(Interior, HidesNothingFromViews) {
  const Grid grid = hollowGrid({70, 66, 65}, 3);
  auto dropped = dropInterior(sourceOf(grid), someMeans());
  ASSERT_TRUE(dropped);
  const Voxels expected = voxelsOf(*dropped->source);
  const auto view = dropped->source->view();
  dropped->source.reset();
  EXPECT_EQ(voxelsOf(*view), expected);
}

/// Asked for cubes of every size, `empty` is never wrong.
TEST(Interior, KnowsWhatIsEmpty) {
  const Grid grid = hollowGrid({70, 66, 65}, 5);
  for (const bool drops : {true, false}) {
    auto changed =
        drops ? dropInterior(sourceOf(grid), someMeans()) : fillInterior(sourceOf(grid), kFill, someMeans());
    ASSERT_TRUE(changed);
    const Voxels voxels = voxelsOf(*changed->source);
    for (int log2Side = 0; log2Side <= 7; ++log2Side)
      for (std::uint64_t code = 0; code < std::uint64_t{1} << 3 * (7 - log2Side); code += 1 + code / 97) {
        const Cube cube{mortonCell(code) * (1 << log2Side), log2Side};
        const auto first = voxels.lower_bound(mortonCode(cube.low));
        const bool holds = first != voxels.end() && first->first - mortonCode(cube.low) < std::uint64_t{1}
                                                                                              << 3 * log2Side;
        if (holds) {
          ASSERT_FALSE(changed->source->empty(cube)) << log2Side << " " << code;
        }
      }
  }
}

TEST(Interior, PassesErrorsOn) {
  std::atomic<bool> stop = true;
  InteriorOptions stopped = someMeans();
  stopped.progress.stop = &stop;
  const Grid grid = hollowGrid({70, 66, 65}, 5);
  for (const auto &changed :
       {dropInterior(sourceOf(grid), stopped), fillInterior(sourceOf(grid), kFill, stopped)}) {
    ASSERT_FALSE(changed);
    EXPECT_EQ(changed.error().kind, ErrorKind::Interrupted);
  }
}

/// A source whose readers fail in one place.
class FailingSource final : public VoxelSource {
public:
  Int3 extent() const override { return {200, 200, 200}; }
  bool empty(const Cube &) override { return false; }
  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    std::fill_n(words, std::size_t{1} << 3 * cube.log2Side, 0u);
    words[0] = 1;
    return cube.low == Int3{128, 64, 0} ? Expected<void>(Error::environment("it broke")) : Expected<void>();
  }
  std::unique_ptr<VoxelSource> view() const override { return std::make_unique<FailingSource>(); }
};

TEST(Interior, OnSeveralThreadsIsTheSame) {
  for (const Grid &grid : {hollowGrid({130, 150, 65}, 9), hollowGrid({70, 300, 3}, 2),
                           dustGrid({80, 80, 80}, 100, 1), Grid({100, 100, 100})}) {
    auto one = dropInterior(sourceOf(grid), someMeans(1));
    auto three = dropInterior(sourceOf(grid), someMeans(3, 0));
    ASSERT_TRUE(one && three);
    EXPECT_EQ(one->voxels, three->voxels);
    EXPECT_EQ(voxelsOf(*one->source), voxelsOf(*three->source));
    auto full = fillInterior(sourceOf(grid), kFill, someMeans(1));
    auto filled = fillInterior(sourceOf(grid), kFill, someMeans(3));
    ASSERT_TRUE(full && filled);
    EXPECT_EQ(voxelsOf(*full->source), voxelsOf(*filled->source));
  }
  for (const unsigned threads : {1u, 3u}) {
    const auto broken = dropInterior(std::make_unique<FailingSource>(), someMeans(threads));
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.error().message, "it broke");
  }
}

/// A bound of nothing puts all into the scratch file, and changes nothing.
TEST(Interior, WithinAnyBound) {
  const Grid grid = hollowGrid({130, 66, 65}, 9);
  auto wide = dropInterior(sourceOf(grid), someMeans());
  auto narrow = dropInterior(sourceOf(grid), someMeans(1, 0));
  ASSERT_TRUE(wide && narrow);
  EXPECT_EQ(voxelsOf(*wide->source), voxelsOf(*narrow->source));
}

} // namespace
} // namespace voxc::test
