// Hard rays through volumes that were edited in place, on tracers that follow the edits: exactly the hits of
// the voxels that the edits leave.
#include "DeviceTesting.h"
#include "TestLength.h"

#include "testing/HardRays.h"
#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/EditableVolume.h"
#include "voxc/IR/Attribute.h"
#include "voxc/Layout/Edits.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Source/Sources.h"

#include <random>
#include <set>

namespace voxc {
namespace {

constexpr int kLog2Side = 5, kSide = 1 << kLog2Side;
constexpr Int3 kExtent = {kSide, kSide, kSide};
/// Between two looks at the hits, and how many rays look.
constexpr int kEdits = 100;
constexpr std::size_t kRaysOfClass = 400;

/// A random format of all voxels that can be edited, with exact hits of voxels.
Format editableFormat(std::mt19937 &random) {
  for (;;) {
    const Format format = test::randomFormat(random, kLog2Side);
    if (format.extent() == kExtent && whyNoEdits(layoutOf(format)).empty() &&
        format.attributes.value(kPrecisionAttribute) != "fast" && !layoutOf(format).hasLabels())
      return format;
  }
}

std::unique_ptr<VoxelChange> randomChange(std::mt19937 &random) {
  const auto pick = [&](int least, int most) { return test::pick(random, least, most); };
  const std::uint32_t word = pick(0, 1) == 0 ? 0 : 0xff0000ff;
  const Int3 at = {pick(0, kSide - 1), pick(0, kSide - 1), pick(0, kSide - 1)};
  return pick(0, 1) == 0 ? makeBoxChange(at, {pick(1, 6), pick(1, 6), pick(1, 6)}, word)
                         : makeSphereChange(at, pick(0, 8), word);
}

std::vector<Ray> hardRaysOf(std::uint64_t seed) {
  std::vector<Ray> rays;
  for (const test::HardRayClass &row : test::hardRayClasses()) {
    const std::vector<Ray> more = test::hardRays(kExtent, row.name, kRaysOfClass, seed);
    rays.insert(rays.end(), more.begin(), more.end());
  }
  return rays;
}

/// The voxels of a volume, one by one, and the changes that it went through.
class Voxels {
public:
  explicit Voxels(const Volume &volume) : payload_(volume.layout().payload) {
    forEach([&](Int3 at) { words_.push_back(volume.lookup(at).value); });
  }
  void apply(VoxelChange &change) {
    std::size_t i = 0;
    forEach([&](Int3 at) {
      const std::uint32_t word = change.voxel(at, words_[i]);
      words_[i++] = kindOf(payload_).varies || word == 0 ? word : kOccupied;
    });
  }
  /// In a format that has nothing to do with the one that is edited.
  Volume built() const {
    const auto source = makeFunctionSource(kExtent, [this](Int3 at) {
      return words_[static_cast<std::size_t>(at.x + kSide * (at.y + kSide * at.z))];
    });
    return std::move(Constructor::compile(*parseFormat("R(5^3)"))->build(*source)->volume);
  }

private:
  template <typename Visit> static void forEach(const Visit &visit) {
    for (int i = 0; i < kSide * kSide * kSide; ++i)
      visit(Int3{i & (kSide - 1), i >> kLog2Side & (kSide - 1), i >> 2 * kLog2Side});
  }
  Payload payload_;
  std::vector<std::uint32_t> words_;
};

class EditedRays : public test::OnDevice {};

TEST_P(EditedRays, AreThoseOfTheEditedVoxels) {
  std::mt19937 random(45);
  for (int i = 0; i < test::rounds(5); ++i) {
    const Format format = editableFormat(random);
    const auto scenes = test::hardScenes(kExtent);
    const auto &scene = scenes[std::size_t(test::pick(random, 0, int(scenes.size()) - 1))];
    const auto built = Constructor::compile(format)->build(*scene.source());
    if (!built) // The scene has more colours than the payload keeps.
      continue;
    auto edited = EditableVolume::create(built->volume);
    ASSERT_TRUE(edited) << edited.error().message;
    Voxels voxels(built->volume);
    auto tracer = tracerOf(*edited->volume(), format);
    ASSERT_TRUE(tracer) << tracer.error().message;
    for (int step = 0; step < 2; ++step) {
      for (int edit = 0; edit < kEdits; ++edit) {
        const auto change = randomChange(random);
        if (edited->apply(*change)) // Else the payload has no such colour.
          voxels.apply(*change);
      }
      const std::vector<WordRange> changes = edited->takeChanges();
      ASSERT_TRUE((*tracer)->follow(*edited->volume(), changes));
      const std::vector<Ray> rays = hardRaysOf(random());
      std::vector<Hit> hits(rays.size());
      ASSERT_TRUE((*tracer)->trace(rays, hits));
      const Volume reference = voxels.built();
      const ErrorFigures figures = compare(*Oracle::of(reference), rays, hits);
      const std::string what = printIr(format) + scene.name;
      EXPECT_EQ(figures.missed + figures.ghost + figures.wrong, 0u) << what;
      EXPECT_EQ(figures.maxUlpDt, 0u) << what;
      if (kindOf(layoutOf(format).payload).varies) {
        EXPECT_EQ(figures.colour, 0u) << what;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Devices, EditedRays, ::testing::Values("cpu", "llvmpipe"), test::deviceName);

} // namespace
} // namespace voxc
