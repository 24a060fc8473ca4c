// Cubes of a volume that are read in one traversal are what lookups of each voxel tell.
#include "TestLength.h"

#include "Volume/Decode.h"
#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Passes/Pass.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace voxc {
namespace {

/// Every aligned cube of each size in the extent of the format, and one cube around it.
void expectCubes(const Volume &volume, const std::string &what) {
  const Int3 log2 = volume.layout().log2Extent();
  std::array<std::uint32_t, 512> words;
  for (int log2Side = 0; log2Side <= 3; ++log2Side) {
    const int side = 1 << log2Side;
    Cube cube{{}, log2Side};
    for (cube.low.z = -side; cube.low.z <= 1 << log2.z; cube.low.z += side)
      for (cube.low.y = -side; cube.low.y <= 1 << log2.y; cube.low.y += side)
        for (cube.low.x = -side; cube.low.x <= 1 << log2.x; cube.low.x += side) {
          words.fill(77);
          readCube(volume, cube, words.data());
          for (std::uint64_t i = 0; i < std::uint64_t{1} << 3 * log2Side; ++i) {
            const Int3 voxel = cube.low + mortonCell(i);
            ASSERT_EQ(words[i], volume.lookup(voxel).value)
                << what << ": voxel " << voxel.x << ", " << voxel.y << ", " << voxel.z
                << " in a cube of side " << side;
          }
        }
  }
}

void expectScenes(const Format &format) {
  const auto constructor = Constructor::compile(format);
  ASSERT_TRUE(constructor) << constructor.error().message;
  const Int3 log2 = layoutOf(format).log2Extent();
  for (const test::HardScene &scene : test::hardScenes({1 << log2.x, 1 << log2.y, 1 << log2.z})) {
    auto built = constructor->build(*scene.source());
    if (!built) // Scenes of more colours than the format has room for.
      continue;
    expectCubes(built->volume, printIr(format) + scene.name);
  }
}

class CubesOf : public ::testing::TestWithParam<const char *> {};

TEST_P(CubesOf, AreWhatLookupsTell) { expectScenes(*parseFormat(GetParam())); }

INSTANTIATE_TEST_SUITE_P(ReadCube, CubesOf,
                         ::testing::Values("R(4^3)", "D(4^3, 6)", "S(4)", "G(4)", "H(4^3)", "R(2,3,1)",
                                           "R(1,0,2) G(2)", "R(1^3) G(3)", "G(2) R(2^3)", "S(2) G(2)",
                                           "D(2^3, 3) M(2^3)", "M(3^3) S(1)"));

TEST(ReadCube, OfRandomFormatsIsWhatLookupsTell) {
  std::mt19937 random(5);
  for (int round = 0; round < test::rounds(12); ++round)
    expectScenes(test::randomFormat(random, 4));
}

} // namespace
} // namespace voxc
