// Volumes of which a few pages are resident at a time: hits are those of resident ones, bit by bit.
#include "PagingTesting.h"
#include "TestLength.h"

#include "testing/RandomFormat.h"
#include "voxc/Construct/EditableVolume.h"
#include "voxc/Oracle/VerifyRays.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace voxc {
namespace {

using namespace test;

Format withRayTraversals(Format format) {
  for (Level &level : format.levels)
    if (level.kind->isTree())
      level.setAttribute(kTraversalAttribute, "stack");
  format.setAttribute(kLevelsAttribute, "auto");
  format.setAttribute(kDetailAttribute, "full");
  return format;
}

/// Traces twice, as the second time pages are there already.
void expectSame(MadeTracer tracer, const std::vector<Ray> &rays, const std::vector<Hit> &expected,
                const std::string &what) {
  ASSERT_TRUE(tracer) << what << tracer.error().message;
  for (int time = 0; time < 2; ++time) {
    std::vector<Hit> hits(rays.size());
    const auto report = (*tracer)->trace(rays, hits);
    ASSERT_TRUE(report) << what << report.error().message;
    EXPECT_EQ(differences(expected, hits), "") << what;
  }
  const PagingReport paging = (*tracer)->paging();
  EXPECT_LE(paging.resident, paging.slots) << what;
  EXPECT_GE(paging.reads, paging.resident) << what;
}

/// On both back ends, with the least memory and with more. Nothing of Vulkan without llvmpipe.
void expectSameEverywhere(const Volume &volume, const PagedVolume &paged, const Format &format,
                          const std::vector<Ray> &rays) {
  const std::string what = printIr(format);
  const auto expected = residentHits(volume, format, rays);
  const std::uint64_t least = leastPagingBytes(paged);
  const CpuKernel kernel = cpuKernel(format);
  expectSame(createPagedCpuTracer(kernel, paged, {least, 2}), rays, expected, what + "cpu");
  expectSame(createPagedCpuTracer(kernel, paged, {4 * least, 2}), rays, expected, what + "cpu, more");
  auto device = Device::open("llvmpipe");
  if (device)
    expectSame(onVulkan(*device, paged, format, least), rays, expected, what + "vulkan");
}

TEST_F(Paging, GivesTheHitsOfResidentVolumesOfEveryKind) {
  std::size_t number = 0;
  for (const char *text : kFormats) {
    const Format format = *parseFormat(text);
    const HardScene scene = sceneOf(format, number++);
    const auto volume = build(format, scene);
    ASSERT_TRUE(volume) << volume.error().message;
    expectSameEverywhere(*volume, paged(*volume), withRayTraversals(format),
                         verifyRays(scene.extent, 600, number));
  }
}

TEST_F(Paging, GivesTheHitsOfResidentVolumesInRandomFormats) {
  std::mt19937 random(41);
  for (int i = 0; i < rounds(6); ++i) {
    const Format format = withRayTraversals(randomFormat(random, pick(random, 3, 6)));
    const HardScene scene = i % 2 == 0 ? noise(format.extent(), i) : sceneOf(format, random());
    const auto volume = build(format, scene);
    ASSERT_TRUE(volume) << volume.error().message;
    expectSameEverywhere(*volume, paged(*volume), format, verifyRays(scene.extent, 600, random()));
  }
}

/// Of one level, nothing but the packets asks for a word by its granule alone.
TEST_F(Paging, GivesTheHitsOfOneLevelThatCountsGranules) {
  for (const char *text :
       {"format granule=2 { level 1: raw(5, 5, 5) }", "format granule=4 { level 1: distance(5, 5, 5, 4) }"}) {
    const Format format = *parseFormat(text);
    const HardScene scene = noise(format.extent(), 5);
    const auto volume = build(format, scene);
    ASSERT_TRUE(volume) << volume.error().message;
    expectSameEverywhere(*volume, paged(*volume), format, verifyRays(scene.extent, 600, 5));
  }
}

/// Far more pages than there is room for.
TEST_F(Paging, LetsPagesComeAndGo) {
  for (const char *text :
       {"format { level 1: svdag(6) }", "format values=apart { level 1: svdag(6) }",
        "format values=apart granule=4 { level 1: raw(2, 2, 2) level 2: svdag(4) }",
        "format { level 1: raw(6, 6, 6) }", "format { level 1: raw(3, 3, 3) level 2: masked(3, 3, 3) }",
        "format { level 1: raw(2, 2, 2) level 2: hash(4, 4, 4) }"}) {
    const Format format = *parseFormat(text);
    const HardScene scene = noise(format.extent(), 7);
    const auto volume = build(format, scene);
    ASSERT_TRUE(volume) << volume.error().message;
    const PagedVolume pages = paged(*volume);
    const auto rays = verifyRays(scene.extent, 1000, 3);
    const auto expected = residentHits(*volume, format, rays);
    auto tracer = createPagedCpuTracer(cpuKernel(format), pages, {leastPagingBytes(pages), 2});
    ASSERT_TRUE(tracer) << tracer.error().message;
    std::vector<Hit> hits(rays.size());
    ASSERT_TRUE((*tracer)->trace(rays, hits)) << text;
    EXPECT_EQ(differences(expected, hits), "") << text;
    const PagingReport report = (*tracer)->paging();
    EXPECT_GT(report.reads, report.slots) << text;
    if (auto device = Device::open("llvmpipe"))
      expectSame(onVulkan(*device, pages, format, leastPagingBytes(pages)), rays, expected, text);
  }
}

/// Words that change, and more of them, with room for few pages.
void expectFollows(PagedTracer &tracer, EditableVolume &edited, const Format &format,
                   const std::vector<Ray> &rays, const std::string &what) {
  std::vector<Hit> hits(rays.size());
  ASSERT_TRUE(tracer.trace(rays, hits)) << what; // Pages are there that edits change.
  const auto before = edited.snapshot();
  for (int i = 0; i < 20; ++i)
    ASSERT_TRUE(edited.apply(
        *makeSphereChange({7 * i % 64, 11 * i % 64, 5 * i % 64}, i % 7, i % 3 == 0 ? 0 : 0xff0000ff)));
  for (const bool isUndone : {false, true}) {
    if (isUndone)
      edited.restore(before);
    const auto followed = tracer.follow(*edited.volume(), edited.takeChanges());
    ASSERT_TRUE(followed) << what << followed.error().message;
    ASSERT_TRUE(tracer.trace(rays, hits)) << what;
    EXPECT_EQ(differences(residentHits(*edited.volume(), format, rays), hits), "") << what;
  }
  EXPECT_GT(tracer.paging().reads, tracer.paging().slots) << what;
}

TEST_F(Paging, FollowsEdits) {
  constexpr std::uint64_t kMore = 1 << 19; // The grid of the first level is copied once.
  for (const char *text :
       {"format { level 1: svdag(6) }", "format { level 1: raw(3, 3, 3) level 2: masked(3, 3, 3) }",
        "format { level 1: raw(6, 6, 6) }"}) {
    const Format format = *parseFormat(text);
    const auto volume = build(format, noise(format.extent(), 7));
    ASSERT_TRUE(volume) << volume.error().message;
    const PagedVolume pages = paged(*volume);
    const auto rays = verifyRays(format.extent(), 1000, 3);
    const std::uint64_t bytes = leastPagingBytes(pages, kMore);
    const auto follow = [&](MadeTracer tracer, const std::string &what) {
      ASSERT_TRUE(tracer) << what << tracer.error().message;
      auto edited = EditableVolume::create(*volume);
      ASSERT_TRUE(edited) << what << edited.error().message;
      expectFollows(**tracer, *edited, format, rays, what);
    };
    PagingOptions options{bytes, 2};
    options.moreWords = kMore;
    follow(createPagedCpuTracer(cpuKernel(format), pages, options), std::string(text) + " cpu");
    if (auto device = Device::open("llvmpipe"))
      follow(onVulkan(*device, pages, format, options), std::string(text) + " vulkan");
  }
}

TEST_F(Paging, FollowsNoMoreWordsThanThereIsRoomFor) {
  const Format format = *parseFormat("format { level 1: svdag(6) }");
  const auto volume = build(format, noise(format.extent(), 7));
  ASSERT_TRUE(volume);
  const PagedVolume pages = paged(*volume);
  auto tracer = createPagedCpuTracer(cpuKernel(format), pages, {leastPagingBytes(pages), 2});
  auto edited = EditableVolume::create(*volume);
  ASSERT_TRUE(tracer && edited);
  for (int i = 0; i < 8; ++i)
    ASSERT_TRUE(edited->apply(*makeSphereChange({8 * i, 32, 32}, 6, 0xff000000u + unsigned(i))));
  const auto followed = (*tracer)->follow(*edited->volume(), edited->takeChanges());
  ASSERT_FALSE(followed);
  EXPECT_THAT(followed.error().message, testing::HasSubstr("; make a new tracer"));
}

/// A volume of many pages and its kernel on this processor.
class DamagedPages : public Paging {
protected:
  void SetUp() override {
    Paging::SetUp();
    const auto built = build(format_, noise(format_.extent(), 3));
    ASSERT_TRUE(built) << built.error().message;
    ASSERT_TRUE(built->save(path_, {.compress = true, .pageBytes = kSmallPage}));
    rays_ = verifyRays(format_.extent(), 500, 9);
  }

  Expected<TraceReport> trace(const PagedVolume &volume, std::uint64_t bytes) {
    auto tracer = createPagedCpuTracer(cpuKernel(format_), volume, {bytes, 2});
    if (!tracer)
      return tracer.error();
    std::vector<Hit> hits(rays_.size());
    return (*tracer)->trace(rays_, hits);
  }

  /// Flips a bit of every byte in the second half of the file.
  void damage() {
    std::fstream file(path_, std::ios::in | std::ios::out | std::ios::binary);
    const auto size = static_cast<std::streamoff>(std::filesystem::file_size(path_));
    for (std::streamoff at = size / 2; at < size; ++at) {
      file.seekg(at);
      const int byte = file.get();
      file.seekp(at);
      file.put(static_cast<char>(byte ^ 1));
    }
  }

  const Format format_ = *parseFormat("format { level 1: svdag(6) }");
  std::vector<Ray> rays_;
};

TEST_F(DamagedPages, EndTracing) {
  damage();
  auto volume = PagedVolume::open(path_);
  ASSERT_TRUE(volume); // Its head is as it was.
  const auto traced = trace(*volume, leastPagingBytes(*volume));
  ASSERT_FALSE(traced);
  EXPECT_EQ(traced.error().kind, ErrorKind::Input);
  EXPECT_NE(traced.error().message.find("is damaged: page "), std::string::npos) << traced.error().message;
}

TEST_F(DamagedPages, EndTracingWhenTheFileChangesMeanwhile) {
  auto volume = PagedVolume::open(path_);
  ASSERT_TRUE(volume);
  auto tracer = createPagedCpuTracer(cpuKernel(format_), *volume, {leastPagingBytes(*volume), 1});
  ASSERT_TRUE(tracer) << tracer.error().message;
  std::vector<Hit> hits(rays_.size());
  ASSERT_TRUE((*tracer)->trace(rays_, hits));
  damage();
  const auto traced = (*tracer)->trace(rays_, hits);
  ASSERT_FALSE(traced);
  EXPECT_NE(traced.error().message.find("is damaged: page "), std::string::npos) << traced.error().message;
}

TEST_F(DamagedPages, OfAFileThatIsCutShortAreRefused) {
  std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - 1);
  EXPECT_FALSE(PagedVolume::open(path_));
}

TEST_F(DamagedPages, AreNotReadWithTooLittleMemory) {
  auto volume = PagedVolume::open(path_);
  ASSERT_TRUE(volume);
  const auto traced = trace(*volume, leastPagingBytes(*volume) - 1);
  ASSERT_FALSE(traced);
  EXPECT_EQ(traced.error().kind, ErrorKind::Usage);
}

/// Words that lead anywhere, under checksums that are right: hits mean nothing, but tracing ends.
TEST_F(DamagedPages, ThatMisleadHarmNothing) {
  std::mt19937 random(5);
  for (const char *text : {"format { level 1: svdag(5) }",
                           "format values=apart { level 1: raw(2, 2, 2) level 2: masked(1, 1, 1) level 3: "
                           "masked(2, 2, 2) }",
                           "format { level 1: distance(2, 2, 2, 15) distances=in-slot metric=octant level 2: "
                           "masked(2, 2, 2) }"}) {
    const Format format = *parseFormat(text);
    const auto built = build(format, noise(format.extent(), 11));
    ASSERT_TRUE(built) << built.error().message;
    const CpuKernel kernel = cpuKernel(format);
    for (int round = 0; round < rounds(20); ++round) {
      std::vector<std::uint32_t> words(built->words().begin(), built->words().end());
      for (std::size_t i = 0; i < words.size(); i += 1 + random() % 64)
        words[i] = static_cast<std::uint32_t>(random());
      const Volume wild(built->info(), std::move(words));
      const PagedVolume volume = paged(wild);
      auto tracer = createPagedCpuTracer(kernel, volume, {leastPagingBytes(volume), 2});
      ASSERT_TRUE(tracer) << tracer.error().message;
      const auto rays = verifyRays(format.extent(), 200, random());
      std::vector<Hit> hits(rays.size());
      const auto traced = (*tracer)->trace(rays, hits);
      if (!traced) {
        EXPECT_NE(traced.error().kind, ErrorKind::Interrupted);
      }
    }
  }
}

TEST(PagedKernels, AreForPagedTracersAlone) {
  const Format format = *parseFormat("format { level 1: svdag(3) }");
  const auto volume = build(format, noise(format.extent(), 1));
  ASSERT_TRUE(volume);
  EXPECT_FALSE(createCpuTracer(cpuKernel(format), *volume, 1));
  EXPECT_FALSE(intersect(*volume, cpuKernel(format), Ray{}));
}

} // namespace
} // namespace voxc
