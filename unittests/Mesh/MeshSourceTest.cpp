// The voxels of scenes: no choice of sizes, order or place decides them, and the reference finds the same.
#include "SceneTesting.h"
#include "Source/SourceTesting.h"
#include "TestLength.h"

#include "Mesh/Voxelize/MeshVoxels.h"

#include <atomic>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <thread>

namespace voxc {
namespace {

using test::HandPart;
using test::sceneOf;
using test::soupOf;
using Corner = std::array<float, 3>;
using Scene = std::shared_ptr<const TriangleScene>;

std::shared_ptr<WorkingMemory> enough() { return WorkingMemory::create(std::uint64_t{64} << 20); }

std::unique_ptr<VoxelSource> opened(const Scene &scene, const VoxelizeOptions &options,
                                    const MeshTuning &tuning = {},
                                    const std::shared_ptr<WorkingMemory> &memory = enough()) {
  auto source = makeMeshSource(scene, options, memory, tuning);
  EXPECT_TRUE(source) << source.error().message;
  return source ? std::move(*source) : nullptr;
}

Voxels voxelizedWith(const Scene &scene, const VoxelizeOptions &options, const MeshTuning &tuning = {}) {
  const auto source = opened(scene, options, tuning);
  return source ? voxelsOf(*source) : Voxels{};
}

Voxels reference(const Scene &scene, const VoxelizeOptions &options) {
  auto source = makeReferenceMeshSource(*scene, options);
  EXPECT_TRUE(source) << source.error().message;
  return source ? voxelsOf(**source) : Voxels{};
}

VoxelizeOptions optionsOf(int resolution, Coverage coverage = Coverage::Conservative) {
  VoxelizeOptions options;
  options.resolution = resolution;
  options.coverage = coverage;
  return options;
}

constexpr std::array<Coverage, 2> kCoverages{Coverage::Conservative, Coverage::Thin};

/// And that by which halves of the volume are not alike.
constexpr std::array<Coverage, 3> kAllCoverages{Coverage::Conservative, Coverage::Thin, Coverage::Inner};

std::set<std::uint64_t> placesOf(const Voxels &voxels) {
  std::set<std::uint64_t> places;
  for (const auto &[code, word] : voxels)
    places.insert(code);
  return places;
}

/// Triangles of all sizes in the unit cube, with random vertex colours.
HandPart randomPart(std::mt19937 &random, int triangles) {
  const auto unit = [&] { return static_cast<float>(random() % 4097) / 4096; };
  HandPart part;
  for (int i = 0; i < triangles; ++i) {
    const Corner centre{unit(), unit(), unit()};
    const float size = std::ldexp(1.0f, -static_cast<int>(random() % 9));
    for (int corner = 0; corner < 3; ++corner) {
      Corner at = centre;
      for (float &coordinate : at)
        coordinate += size * (unit() - 0.5f);
      part.positions.push_back(at);
      part.colours.push_back({unit(), unit(), unit(), 1});
    }
  }
  return part;
}

TEST(MeshSource, IsWhatTheReferenceSaysForEverySize) {
  std::mt19937 random(1);
  for (int i = 0; i < test::rounds(3); ++i) {
    const Scene scene = sceneOf({randomPart(random, 40), randomPart(random, 40)});
    for (const Coverage coverage : kAllCoverages) {
      const VoxelizeOptions options = optionsOf(50 + i * 31, coverage);
      const Voxels expected = reference(scene, options);
      EXPECT_GT(expected.size(), 1000u);
      for (const MeshTuning tuning : {MeshTuning{6, 7}, MeshTuning{5, 7}, MeshTuning{3, 7}, MeshTuning{3, 1},
                                      MeshTuning{4, 0}, MeshTuning{6, 0}})
        EXPECT_EQ(voxelizedWith(scene, options, tuning), expected)
            << tuning.log2Chunk << " " << tuning.log2Grid;
    }
  }
}

/// Strips join their parts by triangles without an area, and a node of scale 0 hides what it has.
TEST(MeshSource, TrianglesWithTwoCornersInOnePlaceAreNotSeen) {
  const std::vector<Corner> two{{0, 0, 0}, {1, 0, 0}, {0, 1, 0},  {1, 1, 0}, {1, 1, 0},
                                {9, 0, 0}, {9, 0, 0}, {10, 0, 0}, {9, 1, 0}, {10, 1, 0}};
  const auto strip = sceneOf({{two}});
  strip->parts[0].mode = PrimitiveMode::TriangleStrip;
  std::vector<Corner> plain;
  for (const std::size_t corner : {0, 1, 2, 2, 1, 3, 6, 7, 8, 8, 7, 9})
    plain.push_back(two[corner]);
  const Scene soup = soupOf(plain);
  for (const Coverage coverage : kAllCoverages) {
    const Voxels expected = voxelizedWith(soup, optionsOf(30, coverage));
    EXPECT_EQ(voxelizedWith(strip, optionsOf(30, coverage)), expected);
    EXPECT_EQ(reference(strip, optionsOf(30, coverage)), expected);
  }
  const auto hidden = sceneOf({{plain}, {plain}});
  hidden->instances[1].toModel =
      Transform(glm::dvec3(0), glm::dvec3(0), glm::dvec3(0), glm::dvec3(500, 0, 0));
  EXPECT_EQ(voxelizedWith(hidden, optionsOf(30)), voxelizedWith(soup, optionsOf(30)));
  hidden->instances.erase(hidden->instances.begin());
  const auto nothing = makeMeshSource(hidden, optionsOf(30), enough());
  ASSERT_FALSE(nothing);
  EXPECT_NE(nothing.error().message.find("no triangle with an area"), std::string::npos);
}

TEST(MeshSource, LinesAndPointsAreTheSameByEveryRule) {
  const auto lines = sceneOf({{{{0, 0, 0}, {10, 7.3f, 3.1f}, {2, 2, 2}, {2, 2, 9}}}, {{{5, 0, 9}}}});
  lines->parts[0].mode = PrimitiveMode::Lines;
  lines->parts[1].mode = PrimitiveMode::Points;
  const Voxels expected = voxelizedWith(lines, optionsOf(40));
  EXPECT_GT(expected.size(), 80u);
  for (const Coverage coverage : kAllCoverages) {
    EXPECT_EQ(voxelizedWith(lines, optionsOf(40, coverage)), expected);
    EXPECT_EQ(reference(lines, optionsOf(40, coverage)), expected);
  }
}

TEST(MeshSource, CroppedIsWhatTheReferenceSays) {
  std::mt19937 random(2);
  const Scene scene = sceneOf({randomPart(random, 60)});
  for (const bool zUp : {false, true}) {
    VoxelizeOptions options = optionsOf(70);
    options.bounds = {{0.3, 0.25, 0.4, 0.8, 0.9, 0.5}};
    options.zUp = zUp;
    for (const Coverage coverage : kAllCoverages) {
      options.coverage = coverage;
      EXPECT_EQ(voxelizedWith(scene, options), reference(scene, options));
    }
    EXPECT_EQ(voxelizedWith(scene, options, {3, 2}), reference(scene, options));
  }
}

TEST(MeshSource, MemoryBoundDoesNotMatter) {
  std::mt19937 random(3);
  const Scene scene = sceneOf({randomPart(random, 20000)});
  const auto tight = WorkingMemory::create(1 << 16);
  const auto source = opened(scene, optionsOf(100), {3, 7}, tight);
  EXPECT_EQ(voxelsOf(*source), voxelizedWith(scene, optionsOf(100)));
  EXPECT_GT(tight->scratchPeak(), 0u);
}

TEST(MeshSource, EmptyIsExactInsideAChunk) {
  std::mt19937 random(4);
  const Scene scene = sceneOf({randomPart(random, 30)});
  const Voxels voxels = voxelizedWith(scene, optionsOf(64));
  const auto source = opened(scene, optionsOf(64));
  for (int log2Side = 5; log2Side >= 0; --log2Side)
    for (int i = 0; i < 300; ++i) {
      const std::uint64_t cells = std::uint64_t{1} << 3 * log2Side;
      const std::uint64_t begin = random() % (1 << 18) / cells * cells;
      const auto next = voxels.lower_bound(begin);
      const bool isEmpty = next == voxels.end() || next->first >= begin + cells;
      EXPECT_EQ(source->empty({mortonCell(begin), log2Side}), isEmpty);
    }
  EXPECT_TRUE(source->empty({{64, 0, 0}, 6}));
  EXPECT_FALSE(source->empty({{}, 10}));
  EXPECT_EQ(source->log2Chunk(), 6);
}

TEST(MeshSource, AnyOrderOfAskingIsAnswered) {
  std::mt19937 random(5);
  const Scene scene = sceneOf({randomPart(random, 50)});
  const MeshTuning tuning{4, 1};
  const Voxels voxels = voxelizedWith(scene, optionsOf(100), tuning);
  const auto source = opened(scene, optionsOf(100), tuning);
  for (int i = 0; i < 400; ++i) {
    const Int3 low{static_cast<int>(random() % 17) * 8, static_cast<int>(random() % 17) * 8,
                   static_cast<int>(random() % 17) * 8};
    std::array<std::uint32_t, 512> words;
    ASSERT_TRUE(source->read({low, 3}, words.data()));
    for (std::uint64_t cell = 0; cell < 512; ++cell) {
      const auto found = voxels.find(mortonCode(low) + cell);
      ASSERT_EQ(words[cell], found == voxels.end() ? 0 : found->second);
    }
  }
}

TEST(MeshSource, ViewsInThreadsReadTheSame) {
  std::mt19937 random(6);
  const Scene scene = sceneOf({randomPart(random, 200)});
  std::array<Voxels, 3> read;
  std::vector<std::thread> threads;
  auto source = opened(scene, optionsOf(128), {4, 1});
  for (Voxels &voxels : read)
    threads.emplace_back(
        [&voxels, view = std::shared_ptr<VoxelSource>(source->view())] { voxels = voxelsOf(*view); });
  const Voxels voxels = voxelsOf(*source);
  source.reset();
  for (std::thread &thread : threads)
    thread.join();
  for (const Voxels &other : read)
    EXPECT_EQ(other, voxels);
}

TEST(MeshSource, TellsTheTimeOfAllViews) {
  std::mt19937 random(7);
  const auto source = opened(sceneOf({randomPart(random, 200)}), optionsOf(128));
  EXPECT_EQ(source->readSeconds(), 0);
  voxelsOf(*source->view());
  EXPECT_GT(source->readSeconds(), 0);
}

TEST(MeshSource, OrderAndWindingDoNotDecideWhichVoxels) {
  std::mt19937 random(8);
  HandPart part = randomPart(random, 100);
  for (const Coverage coverage : kCoverages) {
    const auto places = placesOf(voxelizedWith(sceneOf({part}), optionsOf(90, coverage)));
    HandPart shuffled = part;
    std::vector<std::size_t> order(part.positions.size() / 3);
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t i = 0; i < order.size(); ++i) {
      std::array<std::size_t, 3> corners{0, 1, 2};
      std::shuffle(corners.begin(), corners.end(), random);
      for (std::size_t corner = 0; corner < 3; ++corner)
        shuffled.positions[3 * i + corner] = part.positions[3 * order[i] + corners[corner]];
    }
    EXPECT_EQ(placesOf(voxelizedWith(sceneOf({shuffled}), optionsOf(90, coverage))), places);
  }
}

TEST(MeshSource, IndicesAndModesAreFollowed) {
  const std::vector<Corner> corners{{0, 0, 0}, {4, 0, 1}, {0, 3, 2}, {5, 4, 3}, {1, 6, 6}};
  HandPart plain;
  for (const std::size_t i : {0, 1, 2, 1, 3, 2, 2, 3, 4})
    plain.positions.push_back(corners[i]);
  const auto expected = placesOf(voxelizedWith(sceneOf({plain}), optionsOf(40)));
  const auto indexed = sceneOf({{corners, {0, 1, 2, 1, 3, 2, 2, 3, 4}}});
  EXPECT_EQ(placesOf(voxelizedWith(indexed, optionsOf(40))), expected);
  const auto strip = sceneOf({{corners}});
  strip->parts[0].mode = PrimitiveMode::TriangleStrip;
  EXPECT_EQ(placesOf(voxelizedWith(strip, optionsOf(40))), expected);
  const std::vector<std::uint16_t> indices{0, 1, 2, 1, 3, 2, 2, 3, 4};
  const auto small = sceneOf({{corners}});
  small->parts[0].indices = test::viewOf(indices, AttributeView::Type::Uint16, 1);
  EXPECT_EQ(placesOf(voxelizedWith(small, optionsOf(40))), expected);
}

/// A quarter turn about z, twice the size, moved by (3, -1, 0.5): exact in floats.
const Transform kMove = transformOfRows({0, -2, 0, 3, 2, 0, 0, -1, 0, 0, 2, 0.5});

TEST(MeshSource, InstancesAreTheirTrianglesWrittenOut) {
  std::mt19937 random(9);
  const HandPart part = randomPart(random, 60);
  HandPart moved = part;
  for (Corner &p : moved.positions)
    p = {3 - 2 * p[1], 2 * p[0] - 1, 2 * p[2] + 0.5f};
  const auto instanced = sceneOf({part});
  instanced->instances.push_back({0, kMove});
  EXPECT_EQ(voxelizedWith(instanced, optionsOf(100)), voxelizedWith(sceneOf({part, moved}), optionsOf(100)));
  EXPECT_EQ(reference(instanced, optionsOf(100)), voxelizedWith(instanced, optionsOf(100)));
}

TEST(MeshSource, HasAllVoxelsOfTheRegionThatIsAskedFor) {
  std::mt19937 random(12);
  // Small things in many places, some of them turned: most instances do not reach into a region.
  const auto scene = sceneOf({randomPart(random, 30)});
  const Transform turn{{0, 0.1, 0}, {-0.1, 0, 0}, {0, 0, 0.1}, {0, 0, 0}};
  for (int i = 0; i < 60; ++i) {
    Transform place = turn;
    for (int axis = 0; axis < 3; ++axis)
      place[3][axis] = static_cast<double>(random() % 1000) / 500;
    scene->instances.push_back({0, place});
  }
  scene->instances.erase(scene->instances.begin());
  for (const bool zUp : {false, true}) {
    VoxelizeOptions options = optionsOf(120);
    options.zUp = zUp;
    const Voxels all = voxelizedWith(scene, options);
    for (int i = 0; i < test::rounds(8); ++i) {
      options.regions.resize(1 + random() % 3);
      for (auto &[low, high] : options.regions)
        for (int axis = 0; axis < 3; ++axis) {
          low[axis] = static_cast<int>(random() % 100);
          high[axis] = low[axis] + 1 + static_cast<int>(random() % 40);
        }
      const auto inside = [&](const Voxels &voxels) {
        Voxels those;
        for (const auto &voxel : voxels) {
          const Int3 cell = mortonCell(voxel.first);
          if (std::ranges::any_of(options.regions,
                                  [&](const auto &box) { return contains(box[1] - box[0], cell - box[0]); }))
            those.insert(those.end(), voxel);
        }
        return those;
      };
      for (const MeshTuning tuning : {MeshTuning{6, 7}, MeshTuning{3, 7}, MeshTuning{4, 1}})
        EXPECT_EQ(inside(voxelizedWith(scene, options, tuning)), inside(all)) << "region " << i;
    }
  }
}

TEST(MeshSource, TellsTheTrianglesOfACube) {
  std::mt19937 random(13);
  const Scene scene = sceneOf({randomPart(random, 50)});
  const auto source = opened(scene, optionsOf(200), {3, 7});
  std::uint64_t small = 0;
  for (std::uint64_t code = 0; code < 64; ++code)
    small += source->records({mortonCell(code) * 64, 6});
  EXPECT_EQ(small, source->records({{}, 8}));
  EXPECT_GE(small, 50u);
  EXPECT_EQ(source->records({{256, 0, 0}, 6}), 0u);
}

/// The six orders of axes by the eight choices of signs.
struct Symmetry {
  std::array<int, 3> axes;
  int signs;

  template <typename Point>
  Point operator()(const Point &point, std::type_identity_t<decltype(point[0])> side) const {
    Point image = point;
    for (int i = 0; i < 3; ++i) {
      const auto to = static_cast<std::size_t>(i);
      const auto from = static_cast<std::size_t>(axes[to]);
      image[to] = signs >> i & 1 ? side - point[from] : point[from];
    }
    return image;
  }
};

TEST(MeshSource, TurnedAndMirroredMeshesGiveTurnedAndMirroredVoxels) {
  std::mt19937 random(10);
  constexpr float kSide = 24;
  // Halves of the grid's steps: half of all coordinates are rounded.
  const auto coordinate = [&] { return static_cast<float>(random() % (24 << 13)) / (1 << 13); };
  std::vector<Corner> corners;
  for (int i = 0; i < 90; ++i)
    corners.push_back({coordinate(), coordinate(), coordinate()});
  std::array<int, 3> axes{0, 1, 2};
  for (const Coverage coverage : kCoverages) {
    VoxelizeOptions options = optionsOf(24, coverage);
    options.bounds = {{0, 0, 0, kSide, kSide, kSide}};
    const auto places = placesOf(voxelizedWith(soupOf(corners), options));
    do
      for (int signs = 0; signs < 8; ++signs) {
        const Symmetry symmetry{axes, signs};
        std::vector<Corner> images;
        for (const Corner &corner : corners)
          images.push_back(symmetry(corner, kSide));
        std::set<std::uint64_t> expected;
        for (const std::uint64_t code : places) {
          const Int3 cell = mortonCell(code);
          const auto image = symmetry(std::array<int, 3>{cell.x, cell.y, cell.z}, 23);
          expected.insert(mortonCode({image[0], image[1], image[2]}));
        }
        ASSERT_EQ(placesOf(voxelizedWith(soupOf(images), options)), expected);
      }
    while (std::next_permutation(axes.begin(), axes.end()));
  }
}

TEST(MeshSource, UpTurnsTheMesh) {
  std::mt19937 random(11);
  HandPart part = randomPart(random, 40);
  VoxelizeOptions options = optionsOf(60);
  options.zUp = true;
  const Voxels turned = voxelizedWith(sceneOf({part}), options);
  for (Corner &p : part.positions)
    p = {p[0], p[2], -p[1]};
  EXPECT_EQ(voxelizedWith(sceneOf({part}), optionsOf(60)), turned);
}

} // namespace
} // namespace voxc
