// Volumes of several frames: each is its own voxels, what is equal is there once, and what a file claims is
// proved.
#include "Source/SourceTesting.h"
#include "TestLength.h"

#include "testing/HardScenes.h"
#include "testing/RandomFormat.h"
#include "voxc/Construct/EditableVolume.h"
#include "voxc/Construct/Frames.h"
#include "voxc/Layout/Edits.h"
#include "voxc/Source/Sources.h"
#include "voxc/Volume/Frames.h"
#include "voxc/Volume/PagedVolume.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

namespace voxc {
namespace {

using ::testing::HasSubstr;
using Scene = std::function<std::uint32_t(Int3)>;

Expected<BuiltFrames> build(const Format &format, Int3 extent, const std::vector<Scene> &scenes,
                            const BuildOptions &options = {}) {
  return buildFrames(
      format, scenes.size(),
      [&](std::size_t i) -> Expected<std::unique_ptr<VoxelSource>> {
        return makeFunctionSource(extent, scenes[i]);
      },
      options);
}

Scene ball(Int3 centre, int radius, std::uint32_t word) {
  return [=](Int3 at) {
    const Int3 from = at - centre;
    return from.x * from.x + from.y * from.y + from.z * from.z <= radius * radius ? word : 0;
  };
}

const Scene kNothing = [](Int3) { return 0u; };

template <typename Visit> void forEach(Int3 extent, const Visit &visit) {
  for (int z = 0; z < extent.z; ++z)
    for (int y = 0; y < extent.y; ++y)
      for (int x = 0; x < extent.x; ++x)
        visit(Int3{x, y, z});
}

/// How many voxels are not what the scene says, as the payload keeps it.
int differences(const Volume &volume, const Scene &scene) {
  const bool isColoured = kindOf(volume.layout().payload).varies;
  int wrong = 0;
  std::uint64_t voxels = 0;
  forEach(volume.info().extent, [&](Int3 at) {
    const std::uint32_t word = scene(at);
    wrong += volume.lookup(at).value != (isColoured || word == 0 ? word : kOccupied) ? 1 : 0;
    voxels += word != 0 ? 1 : 0;
  });
  return wrong + (voxels != volume.info().voxels ? 1 : 0);
}

class Frames : public ::testing::Test {
protected:
  std::string pathOf(const std::string &name) const { return folder_.path(name); }

  Expected<Volume> load(const std::string &name, int frame) const {
    LoadOptions options;
    options.frame = frame;
    return Volume::load(pathOf(name), options);
  }

  /// Writes a volume whose frames are these.
  void saveWith(const Volume &volume, const std::vector<Frame> &frames, const std::string &name) const {
    const Volume other(volume.info(), {wordStream(volume.words()), frameStream(frames)}, nullptr);
    ASSERT_TRUE(other.save(pathOf(name)));
  }

  TemporaryFolder folder_;
};

TEST_F(Frames, AreTheVoxelsOfEach) {
  std::mt19937 random(50);
  for (int i = 0, built = 0; built < test::rounds(12); ++i) {
    ASSERT_LT(i, test::rounds(12) * 40) << "too few random formats can be edited";
    const Format format = test::randomFormat(random, test::pick(random, 3, 5));
    if (!whyNoEdits(layoutOf(format)).empty() || layoutOf(format).hasLabels())
      continue;
    ++built;
    const Int3 extent = format.extent();
    const std::uint32_t red = 0xff0000ff;
    std::vector<Scene> scenes = {ball({3, 3, 3}, 3, red), kNothing, ball({5, 4, 3}, 2, red),
                                 ball({extent.x - 2, 2, 2}, 4, red), ball({3, 3, 3}, 3, red)};
    if (test::pick(random, 0, 3) == 0)
      scenes.insert(scenes.begin(), kNothing);
    const auto frames = build(format, extent, scenes);
    const std::string what = printIr(format);
    ASSERT_TRUE(frames) << what << frames.error().message;
    ASSERT_TRUE(frames->volume.save(pathOf("plain.hvx"))) << what;
    ASSERT_TRUE(frames->volume.save(pathOf("pages.hvx"), {.compress = true, .pageBytes = 4096})) << what;
    for (std::size_t n = 0; n < scenes.size(); ++n)
      for (const char *name : {"plain.hvx", "pages.hvx"}) {
        const auto volume = load(name, int(n) + 1);
        ASSERT_TRUE(volume) << what << volume.error().message;
        EXPECT_EQ(differences(*volume, scenes[n]), 0) << what << " frame " << n + 1 << " of " << name;
        EXPECT_TRUE(framesOf(*volume).empty());
        // A frame alone is a volume of its own.
        ASSERT_TRUE(volume->save(pathOf("again.hvx")));
        const auto again = load("again.hvx", 0);
        ASSERT_TRUE(again) << what << " frame " << n + 1 << ": " << again.error().message;
        EXPECT_EQ(differences(*again, scenes[n]), 0) << what << " frame " << n + 1;
      }
    const auto whole = load("plain.hvx", 0);
    ASSERT_TRUE(whole) << whole.error().message;
    EXPECT_EQ(framesOf(*whole).size(), scenes.size());
    EXPECT_EQ(differences(*whole, scenes[0]), 0) << what;
  }
}

/// What else a file has is of the voxels of its first frame.
TEST_F(Frames, OthersHaveNoStreamsOfTheFirst) {
  const auto frames = build(*parseFormat("R(1, 1, 1) G(2)"), {8, 8, 8},
                            {ball({3, 3, 3}, 2, 0xff0000ff), ball({4, 3, 3}, 2, 0xff0000ff)});
  ASSERT_TRUE(frames) << frames.error().message;
  const std::vector<std::uint32_t> lights(frames->volume.info().voxels, 7);
  std::vector<Stream> streams(frames->volume.streams().begin(), frames->volume.streams().end());
  streams.push_back({"emission", sizeof(std::uint32_t), std::as_bytes(std::span(lights))});
  const Volume lit(frames->volume.info(), streams, nullptr);
  ASSERT_TRUE(lit.save(pathOf("plain.hvx")));
  ASSERT_TRUE(lit.save(pathOf("pages.hvx"), {.compress = true, .pageBytes = 4096}));
  for (const char *name : {"plain.hvx", "pages.hvx"}) {
    EXPECT_TRUE(load(name, 1)->findStream("emission")) << name;
    EXPECT_EQ(load(name, 2)->streams().size(), 1u) << name;
  }
  auto paged = PagedVolume::open(pathOf("pages.hvx"));
  ASSERT_TRUE(paged) << paged.error().message;
  ASSERT_TRUE(paged->chooseFrame(2));
  EXPECT_EQ(paged->streams().size(), 2u);
  EXPECT_EQ(paged->streams().back().name, kFrameStream);
  ASSERT_TRUE(paged->chooseFrame(1));
}

TEST_F(Frames, ThatAreEqualAreOne) {
  const Format format = *parseFormat("format { level 1: raw(1, 1, 1) level 2: svdag(4) dedup=level }");
  const Scene first = ball({10, 10, 10}, 8, 0xff0000ff), second = ball({12, 10, 10}, 8, 0xff0000ff);
  const auto frames = build(format, {32, 32, 32}, {first, second, first});
  ASSERT_TRUE(frames) << frames.error().message;
  EXPECT_GT(frames->frames[1].words, 0u);
  EXPECT_LT(frames->frames[1].words, frames->frames[0].words);
  EXPECT_LE(frames->frames[2].words, 8u) << "the grid of the first level alone";
  EXPECT_EQ(frames->frames[1].changed, frames->frames[2].changed);
}

/// An editable volume goes on from the frames of a file, and writes them again with what became of them.
TEST_F(Frames, CanBeEdited) {
  const Format format = *parseFormat("R(2^3) G(3)");
  const std::vector<Scene> scenes = {ball({9, 9, 9}, 6, 0xff00ff00), ball({20, 9, 9}, 6, 0xff00ff00)};
  const auto frames = build(format, {32, 32, 32}, scenes);
  ASSERT_TRUE(frames) << frames.error().message;
  auto edited = EditableVolume::create(frames->volume);
  ASSERT_TRUE(edited) << edited.error().message;
  auto states = edited->frames();
  ASSERT_EQ(states.size(), 2u);
  edited->restore(states[1]);
  EXPECT_EQ(differences(*edited->volume(), scenes[1]), 0);
  ASSERT_TRUE(edited->apply(*makeBoxChange({0, 0, 0}, {2, 2, 2}, 0xff0000ff)));
  states[1] = edited->snapshot();
  edited->restore(states[0]);
  EXPECT_EQ(differences(*edited->volume(), scenes[0]), 0);
  const auto framed = edited->framed(states);
  ASSERT_TRUE(framed && framed->save(pathOf("edited.hvx")));
  const auto first = load("edited.hvx", 1), second = load("edited.hvx", 2);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(differences(*first, scenes[0]), 0);
  const auto withBox = [&](Int3 at) { return at.x < 2 && at.y < 2 && at.z < 2 ? 0xff0000ff : scenes[1](at); };
  EXPECT_EQ(differences(*second, withBox), 0);
}

TEST_F(Frames, OfPagesAreInTheFirst) {
  const Format format = *parseFormat("G(5)");
  const std::vector<Scene> scenes = {ball({9, 9, 9}, 6, 0xff00ff00), ball({20, 9, 9}, 6, 0xff00ff00)};
  BuildOptions options;
  options.path = pathOf("pages.hvx");
  options.compress = true;
  const auto frames = build(format, {32, 32, 32}, scenes, options);
  ASSERT_TRUE(frames) << frames.error().message;
  auto pages = PagedVolume::open(options.path);
  ASSERT_TRUE(pages) << pages.error().message;
  const std::string missing = pages->chooseFrame(3).error().message;
  EXPECT_THAT(missing, HasSubstr("it has no frame 3; there are 2"));
  ASSERT_TRUE(pages->chooseFrame(2));
  std::vector<std::byte> page(pages->streams()[0].bytesOf(0));
  ASSERT_TRUE(pages->decode(0, 0, page));
  const auto second = load("pages.hvx", 2);
  ASSERT_TRUE(second);
  EXPECT_EQ(std::memcmp(page.data(), second->words().data(), page.size()), 0);
  EXPECT_EQ(pages->info().voxels, second->info().voxels);
}

TEST_F(Frames, OfLaterPagesAreFound) {
  const std::vector<Scene> scenes = {ball({9, 9, 9}, 6, 0xff00ff00), kNothing,
                                     ball({9, 9, 9}, 3, 0xff00ff00)};
  std::vector<Scene> played;
  for (std::size_t i = 0; i < 300; ++i) // 4,800 bytes: two pages.
    played.push_back(scenes[i % scenes.size()]);
  const auto frames = build(*parseFormat("G(5)"), {32, 32, 32}, played);
  ASSERT_TRUE(frames) << frames.error().message;
  ASSERT_TRUE(frames->volume.save(pathOf("many.hvx"), {.compress = true, .pageBytes = 4096}));
  auto pages = PagedVolume::open(pathOf("many.hvx"));
  ASSERT_TRUE(pages) << pages.error().message;
  for (const int number : {1, 2, 256, 257, 300}) {
    ASSERT_TRUE(pages->chooseFrame(number));
    EXPECT_EQ(pages->info().voxels, framesOf(frames->volume)[std::size_t(number) - 1].voxels) << number;
  }
  EXPECT_FALSE(pages->chooseFrame(301));
}

TEST_F(Frames, ThatAFileClaimsAreProved) {
  const Format format = *parseFormat("G(4)");
  const auto frames = build(format, {16, 16, 16}, {ball({5, 5, 5}, 4, 0xff0000ff), kNothing});
  ASSERT_TRUE(frames);
  const Frame first = framesOf(frames->volume)[0];
  const auto message = [&](const std::vector<Frame> &claimed) {
    saveWith(frames->volume, claimed, "claimed.hvx");
    const auto loaded = load("claimed.hvx", 0);
    return loaded ? "" : loaded.error().message;
  };
  EXPECT_EQ(message({first, {0, 0, 0}}), "");
  EXPECT_THAT(message({first, {0, 0, 1}}), HasSubstr("frame 2 holds 0 voxels, and is said to hold 1"));
  EXPECT_THAT(message({first, {first.root, 0, 3}}), HasSubstr("frame 2 holds"));
  EXPECT_THAT(message({first, {0x00ffffff, 0, 3}}), HasSubstr("structure is broken"));
  EXPECT_THAT(message({{0, 0, 0}, first}), HasSubstr("its words do not begin with its first frame"));
  EXPECT_THAT(message({}), HasSubstr("its stream of frames has no elements"));
  EXPECT_THAT(load("claimed.hvx", 1).error().message, HasSubstr("its stream of frames has no elements"));
}

TEST_F(Frames, SayWhatTheyCannotBe) {
  const Format format = *parseFormat("format values=apart { level 1: svdag(4) }");
  EXPECT_THAT(build(format, {16, 16, 16}, {kNothing}).error().message,
              HasSubstr("frames are edits of one another; "));
  const auto larger =
      buildFrames(*parseFormat("G(4)"), 2, [](std::size_t i) -> Expected<std::unique_ptr<VoxelSource>> {
        const int side = i == 0 ? 8 : 9;
        return makeFunctionSource({side, 8, 8}, kNothing);
      });
  EXPECT_THAT(larger.error().message,
              HasSubstr("frame 2: it is larger than the first, and would be cut off"));
}

} // namespace
} // namespace voxc
