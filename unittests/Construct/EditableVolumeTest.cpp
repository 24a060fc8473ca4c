// An edited volume holds what the edits make of its voxels, in words that a loader takes, and comes back to
// what a build makes of them.
#include "EditTesting.h"
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/EditableVolume.h"
#include "voxc/Layout/Edits.h"
#include "voxc/Source/Sources.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace voxc {
namespace {

using Words = std::vector<std::uint32_t>;

/// All voxels of an extent, one by one: what an edited volume is held against.
class EditedVoxels {
public:
  EditedVoxels(Int3 extent, const std::function<std::uint32_t(Int3)> &voxel) : extent_(extent) {
    forEach([&](Int3 at) { words_.push_back(voxel(at)); });
  }

  void apply(VoxelChange &change, bool isColoured) {
    std::size_t i = 0;
    forEach([&](Int3 at) {
      const std::uint32_t word = change.voxel(at, words_[i]);
      words_[i++] = isColoured || word == 0 ? word : kOccupied;
    });
  }

  std::uint32_t at(Int3 cell) const {
    return words_[static_cast<std::size_t>(cell.x + extent_.x * (cell.y + extent_.y * cell.z))];
  }
  std::uint64_t count() const {
    return words_.size() - static_cast<std::uint64_t>(std::ranges::count(words_, 0u));
  }
  template <typename Visit> void forEach(const Visit &visit) const {
    for (int z = 0; z < extent_.z; ++z)
      for (int y = 0; y < extent_.y; ++y)
        for (int x = 0; x < extent_.x; ++x)
          visit(Int3{x, y, z});
  }
  std::unique_ptr<VoxelSource> source() const {
    return makeFunctionSource(extent_, [this](Int3 cell) { return at(cell); });
  }
  Int3 extent() const { return extent_; }

private:
  Int3 extent_;
  Words words_;
};

std::unique_ptr<VoxelChange> randomList(std::mt19937 &random, Int3 extent, std::uint32_t word) {
  std::vector<VoxelWord> voxels;
  for (int i = test::pick(random, 1, 20); i > 0; --i)
    voxels.push_back(
        {test::within(random, extent - Int3{1, 1, 1}), test::pick(random, 0, 2) == 0 ? 0 : word});
  return makeListChange(voxels);
}

std::unique_ptr<VoxelChange> randomPaste(std::mt19937 &random, Int3 extent) {
  const auto scenes = test::hardScenes({8, 8, 8});
  const auto source = scenes[std::size_t(test::pick(random, 0, int(scenes.size()) - 1))].source();
  return makePasteChange(test::buildVolume(*parseFormat("R(1^3) G(2)"), *source),
                         test::within(random, extent));
}

std::unique_ptr<VoxelChange> randomChange(std::mt19937 &random, Int3 extent) {
  constexpr std::uint32_t kWords[] = {0, 0xff0000ff, 0x7f102030, 0xffffffff};
  const std::uint32_t word = kWords[test::pick(random, 0, 3)];
  const Int3 low = test::within(random, extent);
  switch (test::pick(random, 0, 4)) {
  case 0:
    return makeBoxChange(low, test::within(random, extent - low), word);
  case 1:
    return makeSphereChange(low, test::pick(random, 0, 12), word);
  case 2:
    return randomList(random, extent, word);
  case 3:
    return randomPaste(random, extent);
  default:
    return makeFunctionChange(low, test::within(random, extent - low), [word](Int3 at, std::uint32_t old) {
      return (at.x + at.y + at.z) % 3 == 0 ? word : old;
    });
  }
}

/// Words that follow a volume by what it says has changed.
class Follower {
public:
  explicit Follower(EditableVolume &volume) : words_(test::wordsOf(*volume.volume())) {}

  void follow(EditableVolume &volume) {
    const auto words = volume.volume()->words();
    words_.resize(std::max(words_.size(), words.size())); // A device's memory stays, too.
    for (const WordRange &range : volume.takeChanges())
      for (std::uint64_t i = range.first; i < range.end; ++i)
        words_[i] = words[i];
    EXPECT_TRUE(std::equal(words.begin(), words.end(), words_.begin()));
  }

private:
  Words words_;
};

void expectHolds(EditableVolume &edited, const EditedVoxels &voxels, const std::string &what) {
  const Volume &volume = *edited.volume();
  const auto counted = checkStructure(volume.format(), volume.words());
  ASSERT_TRUE(counted) << what << ": " << counted.error().message;
  EXPECT_EQ(*counted, voxels.count()) << what;
  EXPECT_EQ(edited.voxels(), voxels.count()) << what;
  int wrong = 0;
  voxels.forEach([&](Int3 at) { wrong += volume.lookup(at).value != voxels.at(at) ? 1 : 0; });
  EXPECT_EQ(wrong, 0) << what;
}

void expectCompacts(const EditableVolume &edited, const Format &format, const EditedVoxels &voxels,
                    const std::string &what) {
  const auto compacted = edited.compact();
  ASSERT_TRUE(compacted) << what << ": " << compacted.error().message;
  const auto built = test::buildVolume(format, *voxels.source());
  ASSERT_TRUE(built) << what;
  EXPECT_EQ(test::wordsOf(compacted->volume), test::wordsOf(*built)) << what;
}

void editAtRandom(const Format &format, const test::HardScene &scene, std::mt19937 &random) {
  const auto volume = test::buildVolume(format, *scene.source());
  if (!volume) // The scene has more than the format's payload keeps.
    return;
  const std::string what = printIr(format) + " " + scene.name;
  auto edited = EditableVolume::create(*volume);
  ASSERT_TRUE(edited) << what << ": " << edited.error().message;
  EditedVoxels voxels(scene.extent, [&](Int3 at) { return volume->lookup(at).value; });
  Follower follower(*edited);
  for (int i = test::pick(random, 2, 8); i > 0; --i) {
    const auto snapshot = edited->snapshot();
    const EditedVoxels before = voxels;
    const auto change = randomChange(random, scene.extent);
    const auto report = edited->apply(*change);
    if (report)
      voxels.apply(*change, kindOf(volume->layout().payload).varies);
    expectHolds(*edited, voxels, what);
    if (i % 3 == 0) // A device that could not copy them.
      edited->putBackChanges(edited->takeChanges());
    follower.follow(*edited);
    if (test::pick(random, 0, 3) == 0) {
      const auto after = edited->snapshot();
      edited->restore(snapshot);
      expectHolds(*edited, before, what + ", undone");
      if (test::pick(random, 0, 1) == 0)
        voxels = before;
      else
        edited->restore(after);
      follower.follow(*edited);
    }
  }
  expectCompacts(*edited, format, voxels, what);
}

TEST(EditableVolume, HoldsWhatEditsMakeOfItsVoxels) {
  std::mt19937 random(44);
  for (int i = 0, edited = 0; edited < test::rounds(12); ++i) {
    ASSERT_LT(i, test::rounds(12) * 40) << "too few random formats can be edited";
    const Format format = test::randomFormat(random, test::pick(random, 3, 6));
    if (!whyNoEdits(layoutOf(format)).empty())
      continue;
    ++edited;
    const auto scenes = test::hardScenes(format.extent());
    editAtRandom(format, scenes[std::size_t(test::pick(random, 0, int(scenes.size()) - 1))], random);
  }
}

/// The words of a grid of the first level, which holds voxels.
Words gridOf(const Volume &volume) {
  const auto words = volume.words();
  const Stratum &stratum = volume.layout().strata[0];
  const std::uint64_t size = static_cast<std::uint64_t>(stratum.slotWords()) << stratum.log2Children();
  const auto begin = words.begin() + std::ptrdiff_t(words[0]);
  return {begin, begin + std::ptrdiff_t(size)};
}

struct DistanceCase {
  const char *format;
  std::vector<std::string> passes;
};

/// Distances are mended, not only safe.
TEST(EditableVolume, KeepsDistancesExact) {
  std::mt19937 random(4);
  for (const DistanceCase &each :
       std::vector<DistanceCase>{{"D(4^3,6)", {}},
                                 {"D(5,4,3,9)", {}},
                                 {"D(4^3,1)", {}},
                                 {"D(4^3,4)", {"octant-distances"}},
                                 {"D(3,4,5,7)", {"octant-distances"}},
                                 {"D(4^3,6)", {"visible-voxels", "df-packing"}},
                                 {"D(4^3,6)", {"visible-voxels", "octant-distances", "df-packing"}}}) {
    const Format format = test::formatWith(each.format, each.passes);
    const Int3 extent = format.extent();
    const auto source = test::hardScenes(extent)[5].source();
    const auto volume = test::buildVolume(format, *source);
    ASSERT_TRUE(volume);
    auto edited = EditableVolume::create(*volume);
    ASSERT_TRUE(edited) << edited.error().message;
    for (int i = 0; i < test::rounds(30); ++i) {
      ASSERT_TRUE(edited->apply(*makeBoxChange(test::within(random, extent), test::within(random, {3, 3, 3}),
                                               test::pick(random, 0, 1) == 0 ? 0 : 0xff102030)));
      if (edited->voxels() > 0) {
        ASSERT_EQ(gridOf(*edited->volume()), gridOf(edited->compact()->volume))
            << each.format << " edit " << i;
      }
    }
  }
}

TEST(EditableVolume, ASphereFarAwayChangesNothing) {
  const auto source = makeBuiltinSource("full", 8);
  const auto volume = test::buildVolume(*parseFormat("G(3)"), **source);
  auto editable = EditableVolume::create(*volume);
  ASSERT_TRUE(editable) << editable.error().message;
  constexpr int kLow = std::numeric_limits<int>::min(), kHigh = std::numeric_limits<int>::max();
  for (const int far : {kLow, kHigh})
    for (const int radius : {5, kMostSphereRadius})
      ASSERT_TRUE(editable->apply(*makeSphereChange({far, far, far}, radius, 0)));
  EXPECT_EQ(editable->voxels(), 512u);
  ASSERT_TRUE(editable->apply(*makeSphereChange({-1000, 4, 4}, kMostSphereRadius, 0)));
  EXPECT_EQ(editable->voxels(), 0u);
}

TEST(EditableVolume, ASphereOfANegativeRadiusIsNone) {
  const auto source = makeBuiltinSource("full", 16);
  const auto volume = test::buildVolume(*parseFormat("G(4)"), **source);
  auto edited = EditableVolume::create(*volume);
  ASSERT_TRUE(edited) << edited.error().message;
  ASSERT_TRUE(edited->apply(*makeSphereChange({8, 8, 8}, -3, 0)));
  EXPECT_EQ(edited->voxels(), 4096u);
  ASSERT_TRUE(edited->apply(*makeSphereChange({8, 8, 8}, 0, 0)));
  EXPECT_EQ(edited->voxels(), 4095u);
}

TEST(EditableVolume, SaysWhichFormatsCannotBeEdited) {
  const auto source = makeBuiltinSource("terrain", 16);
  const auto volume = test::buildVolume(test::formatWith("M(2^3) M(2^3)", {"values-apart"}), **source);
  ASSERT_TRUE(volume);
  const auto edited = EditableVolume::create(*volume);
  ASSERT_FALSE(edited);
  EXPECT_EQ(
      edited.error().message,
      "the format M(2, 2, 2) M(2, 2, 2) cannot be edited: values stand apart from the levels, by their place "
      "among all voxels, and an edit would move those of every voxel behind it; a build without values-apart "
      "can be edited");
}

TEST(EditableVolume, KeepsNodesSharedWithTheFirst) {
  const auto source = makeBuiltinSource("terrain", 64);
  const auto volume = test::buildVolume(*parseFormat("G(6)"), **source);
  auto edited = EditableVolume::create(*volume);
  ASSERT_TRUE(edited);
  const std::uint32_t old = volume->lookup({10, 3, 10}).value;
  const std::uint64_t words = edited->words();
  ASSERT_TRUE(edited->apply(*makeBoxChange({10, 3, 10}, {1, 1, 1}, old == 0 ? 0xff0000ff : 0)));
  EXPECT_GT(edited->words(), words);
  const std::uint64_t edits = edited->words();
  ASSERT_TRUE(edited->apply(*makeBoxChange({10, 3, 10}, {1, 1, 1}, old)));
  EXPECT_EQ(edited->words(), edits) << "all nodes are there already";
  EXPECT_EQ(test::wordsOf(*edited->volume())[0], volume->words()[0]);
}

/// A view is of its snapshot, whatever edits follow.
TEST(EditableVolume, ViewsStayWhatTheyWere) {
  const auto source = makeBuiltinSource("terrain", 64);
  const auto volume = test::buildVolume(*parseFormat("R(2^3) D(2^3,4) G(2)"), **source);
  auto edited = EditableVolume::create(*volume);
  ASSERT_TRUE(edited);
  const auto first = edited->snapshot();
  const auto view = edited->view(first);
  ASSERT_TRUE(view);
  ASSERT_TRUE(edited->apply(*makeBoxChange({0, 0, 0}, {64, 64, 64}, 0)));
  ASSERT_TRUE(edited->apply(*makeSphereChange({30, 30, 30}, 20, 0xff0000ff)));
  const auto later = edited->view(edited->snapshot());
  ASSERT_TRUE(later);
  ASSERT_TRUE(edited->apply(*makeBoxChange({0, 0, 0}, {40, 40, 40}, 0)));
  int wrong = 0;
  for (int i = 0; i < 64 * 64 * 64; ++i) {
    const Int3 at = {i & 63, i >> 6 & 63, i >> 12};
    wrong += view->lookup(at).value != volume->lookup(at).value ? 1 : 0;
    const Int3 from = at - Int3{30, 30, 30};
    const bool isInside = from.x * from.x + from.y * from.y + from.z * from.z <= 400;
    wrong += later->lookup(at).value != (isInside ? 0xff0000ff : 0) ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(view->info().voxels, volume->info().voxels);
}

} // namespace
} // namespace voxc
