// Pictures of a scene in the steps of their refinement, and what a click tells.
#include "Hill.h"

#include "view/OracleCheck.h"
#include "view/Painting.h"
#include "view/SlicedTracer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <set>
#include <thread>

namespace voxc::view {
namespace {

Shot shotOf(std::shared_ptr<const Scene> scene, Style style = Style::Flat) {
  const Int3 extent = scene->model.volume->info().extent;
  return {scene, frameExtent(extent, 64, 48), Look{style}};
}

TEST(Paint, IsAlwaysAsLargeAsTheWindow) {
  const Shot shot = shotOf(makeHill());
  for (const int divisor : {1, 2, 5, 100}) {
    const Expected<Picture> picture = paint(shot, {divisor, 1, true}, {});
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 64);
    EXPECT_EQ(picture->height, 48);
    EXPECT_EQ(picture->pixels.size(), 64u * 48u);
  }
}

TEST(Paint, EnlargesPixelsToSquares) {
  const Picture picture = *paint(shotOf(makeHill()), {4, 1, true}, {});
  std::set<std::uint32_t> colours;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      EXPECT_EQ(picture.pixels[std::size_t(y * 64 + x)],
                picture.pixels[std::size_t(y / 4 * 4 * 64 + x / 4 * 4)]);
      colours.insert(picture.pixels[std::size_t(y * 64 + x)]);
    }
  EXPECT_GT(colours.size(), 5u);
}

TEST(Paint, TheLegendOfAMapIsReadableInAnyStep) {
  // Every ray takes as many lookups, so that nothing but the legend could differ.
  Shot shot = shotOf(makeHill(), Style::Heatmap);
  shot.camera.width = 320;
  shot.camera.height = 200;
  EXPECT_EQ(paint(shot, {8, 1, true}, {})->pixels, paint(shot, {1, 1, false}, {})->pixels);
}

TEST(Paint, TheFinestStepIsTheRenderedPicture) {
  const Shot shot = shotOf(makeHill(), Style::Lit);
  OracleTracer tracer(shot.scene->model.volume);
  const auto trace = [&](std::span<const Ray> rays, std::span<Hit> hits,
                         const TraceOptions &options) -> Expected<void> {
    const auto report = tracer.trace(rays, hits, options);
    return report ? Expected<void>() : report.error();
  };
  const Expected<Rendering> rendering =
      render(*shot.scene->model.volume, shot.camera, {trace, trace}, {.style = Style::Lit, .samples = 4});
  ASSERT_TRUE(rendering);
  EXPECT_EQ(paint(shot, {1, 4, false}, {})->pixels, rendering->picture.pixels);
}

TEST(Paint, EndsWhenItIsToldTo) {
  const std::atomic<bool> stop = true;
  const Expected<Picture> picture = paint(shotOf(makeHill()), {1, 1, false}, {.stop = &stop});
  ASSERT_FALSE(picture);
  EXPECT_EQ(picture.error().kind, ErrorKind::Interrupted);
}

TEST(Pick, TellsTheVoxelOfThePixel) {
  const Shot shot = shotOf(makeHill());
  const Expected<Pick> middle = pick(shot, 32, 30);
  ASSERT_TRUE(middle);
  ASSERT_TRUE(middle->hit.isHit());
  const std::string text = describe(middle->hit);
  const auto &voxel = middle->hit.voxel;
  EXPECT_THAT(text,
              ::testing::StartsWith("voxel " + std::to_string(voxel[0]) + "," + std::to_string(voxel[1]) +
                                    "," + std::to_string(voxel[2]) + ", colour #"));
  EXPECT_EQ(describe(pick(shot, 0, 0)->hit), "no voxel");
}

CheckedHit check(const Pick &picked) {
  std::atomic<bool> isThere = false;
  OracleCheck oracleCheck([&] { isThere = true; });
  oracleCheck.ask(picked);
  while (!isThere)
    std::this_thread::yield();
  return **oracleCheck.take();
}

TEST(OracleCheck, AgreesWithTheExactHit) {
  const Shot shot = shotOf(makeHill());
  EXPECT_THAT(describe(check(*pick(shot, 32, 30))),
              ::testing::ContainsRegex(
                  "; the oracle agrees: entered by the face [-+][xyz], the last of [0-9]+ cell"));
  EXPECT_THAT(describe(check(*pick(shot, 0, 0))),
              ::testing::MatchesRegex("no voxel; the oracle agrees, after [0-9]+ cells"));
}

TEST(OracleCheck, SaysWhatIsRightWhereTheKernelIsNot) {
  Pick wrong = *pick(shotOf(makeHill()), 32, 30);
  const std::string right = describe(wrong.hit);
  wrong.hit.t *= 2;
  EXPECT_THAT(describe(check(wrong)), ::testing::HasSubstr("; the oracle says: " + right + ": entered by"));
}

/// Counts the rays of each call.
class CountingTracer final : public Tracer {
public:
  explicit CountingTracer(std::vector<std::size_t> &calls) : calls_(calls) {}
  Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &) override {
    calls_.push_back(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i].t = rays[i].origin[0];
    return TraceReport{};
  }

private:
  std::vector<std::size_t> &calls_;
};

TEST(SlicedTracer, TracesEveryRayOnce) {
  std::vector<std::size_t> calls;
  const auto tracer = inSlices(std::make_unique<CountingTracer>(calls), 1e-9);
  std::vector<Ray> rays(50000);
  for (std::size_t i = 0; i < rays.size(); ++i)
    rays[i].origin[0] = float(i);
  std::vector<Hit> hits(rays.size());
  ASSERT_TRUE(tracer->trace(rays, hits));
  EXPECT_EQ(std::accumulate(calls.begin(), calls.end(), std::size_t{0}), rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    ASSERT_EQ(hits[i].t, float(i));
  EXPECT_GT(calls.size(), 3u);
  const std::atomic<bool> stop = true;
  TraceOptions options;
  options.progress.stop = &stop;
  EXPECT_FALSE(tracer->trace(rays, hits, options));
  EXPECT_TRUE(tracer->trace({}, {}));
}

} // namespace
} // namespace voxc::view
