// The thread that goes ahead: what it has seen is read no more, and what is shown is left alone.
#include "Hill.h"

#include "Pipeline/PagingTesting.h"

#include "view/PrefetchThread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace voxc::view {
namespace {

using namespace test;

constexpr std::uint64_t kPlenty = std::uint64_t{1} << 30;

/// A scene in pages of which all or few have room, and what paging does for it.
class PrefetchThreadTest : public Paging {
protected:
  void SetUp() override {
    Paging::SetUp();
    auto built = build(format_, noise(format_.extent(), 3));
    ASSERT_TRUE(built) << built.error().message;
    pages_.emplace(paged(*built));
    volume_ = std::make_shared<const Volume>(pages_->info(), std::vector<std::uint32_t>(2));
  }

  std::unique_ptr<PagedTracer> tracer(PagingOptions options) {
    options.threads = 1;
    auto made = createPagedCpuTracer(kernel_, *pages_, std::move(options));
    EXPECT_TRUE(made) << made.error().message;
    return std::move(*made);
  }

  /// `bytes`: of the shelf.
  std::shared_ptr<Scene> scene(std::uint64_t budget = kPlenty, std::uint64_t bytes = kPlenty) {
    const auto shelf = std::make_shared<PageShelf>(bytes);
    SceneMaker maker;
    maker.makeModel = [this](const std::string &, const Progress &) -> Expected<Model> {
      return Model{volume_, format_, "", 1};
    };
    maker.makeTracers = [&](const Model &, std::string &device) -> Expected<Tracers> {
      device = "cpu";
      auto first = tracer({.memoryBytes = budget, .takesFrom = shelf});
      auto paging = [&first = *first] { return first.paging(); };
      return Tracers{std::move(first), tracer({.memoryBytes = budget, .putsOn = shelf}), std::move(paging)};
    };
    return *makeScene(maker, {}, nullptr, {});
  }

  /// A picture of 64 x 48, from where the camera stands after `turns` of a tenth of a radian.
  static Shot shot(const std::shared_ptr<Scene> &scene, double turns = 0) {
    ViewCamera camera = start();
    camera.turn(0.1 * turns, 0);
    return {scene, camera.camera(64, 48), Look{Style::Lit}};
  }
  static ViewCamera start() {
    return ViewCamera({.eye = {32, 40, 32}, .look = {92, 64, 100}, .verticalFov = 40});
  }
  static Shot ofPrefetch(Shot shot) {
    shot.scene = shot.scene->prefetch;
    return shot;
  }
  static std::vector<std::uint32_t> painted(const Shot &shot) {
    const auto picture = paint(shot, {}, {});
    EXPECT_TRUE(picture) << picture.error().message;
    return picture ? picture->pixels : std::vector<std::uint32_t>{};
  }

  const Format format_ = *parseFormat("format { level 1: svdag(7) }");
  const CpuKernel kernel_ = cpuKernel(format_);
  std::optional<PagedVolume> pages_;
  std::shared_ptr<const Volume> volume_;
  const std::atomic<bool> never_ = false;
};

TEST_F(PrefetchThreadTest, WhatItHasSeenIsNotReadFromTheFile) {
  for (const std::uint64_t budget : {leastPagingBytes(*pages_), kPlenty}) {
    const auto with = scene(budget), without = scene(budget);
    const PagingReport before = with->paging();
    ASSERT_TRUE(prefetch(ofPrefetch(shot(with)), never_));
    EXPECT_EQ(with->paging().reads, before.reads);
    EXPECT_EQ(painted(shot(with)), painted(shot(without)));
    const PagingReport after = with->paging();
    EXPECT_GT(after.reads, before.reads + 20);
    EXPECT_EQ(after.ahead, after.reads - before.reads);
    EXPECT_EQ(without->paging().reads, after.reads);
    EXPECT_EQ(without->paging().ahead, 0);
  }
}

TEST_F(PrefetchThreadTest, LeavesThePagesOfWhatIsShown) {
  const auto scene = this->scene();
  painted(shot(scene));
  const PagingReport before = scene->paging();
  for (int turns = 1; turns < 20; ++turns)
    ASSERT_TRUE(prefetch(ofPrefetch(shot(scene, turns)), never_));
  painted(shot(scene));
  EXPECT_EQ(scene->paging().reads, before.reads);
  EXPECT_EQ(scene->paging().resident, before.resident);
}

/// Each frame is predicted by those before.
TEST_F(PrefetchThreadTest, FindsMostPagesOfAFlightAhead) {
  const auto scene = this->scene();
  CameraPrediction prediction;
  ViewCamera camera = start();
  PagingReport begin;
  for (int frame = 0; frame < 16; ++frame, camera.move(0, 0, 4)) {
    Shot now = shot(scene);
    now.camera = camera.camera(64, 48);
    painted(now);
    if (prediction.saw(camera, 0.1) != Course::GoesOn) {
      begin = scene->paging();
      continue;
    }
    Shot ahead = ofPrefetch(now);
    ahead.camera = prediction.in(0.1).camera(64, 48);
    ASSERT_TRUE(prefetch(ahead, never_));
  }
  const PagingReport end = scene->paging();
  EXPECT_GT(end.reads, begin.reads + 20);
  // All but those of the first frame that was predicted by none.
  EXPECT_GT(double(end.ahead), 0.8 * double(end.reads - begin.reads));
}

TEST_F(PrefetchThreadTest, IsStoppedAtOnce) {
  const auto scene = this->scene();
  const std::atomic<bool> stop = true;
  const auto stopped = prefetch(ofPrefetch(shot(scene)), stop);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::Interrupted);
}

/// Its thread works while another paints, and pictures stay as they are.
TEST_F(PrefetchThreadTest, GoesAheadWhileOthersPaint) {
  const auto with = scene(2 * leastPagingBytes(*pages_), 40 * kSmallPage), without = scene();
  PrefetchThread prefetch;
  ViewCamera camera = start();
  for (int frame = 0; frame < 12; ++frame, camera.turn(0.05, 0)) {
    Shot now = shot(with);
    now.camera = camera.camera(64, 48);
    prefetch.follow(now, camera, 0.1);
    const auto seen = painted(now);
    now.scene = without;
    EXPECT_EQ(seen, painted(now)) << "frame " << frame;
  }
}

/// Waits until it is told to stop.
class EndlessTracer final : public Tracer {
public:
  Expected<TraceReport> trace(RaySpan, std::span<Hit>, const TraceOptions &options) override {
    ++calls;
    while (!options.progress.stopped())
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return Error::interrupted();
  }
  std::atomic<int> calls = 0;
};

class PrefetchThreadAtWork : public ::testing::Test {
protected:
  PrefetchThreadAtWork() : scene_(makeHill()) {
    auto ahead = std::make_shared<Scene>();
    ahead->model = scene_->model;
    auto tracer = std::make_unique<EndlessTracer>();
    tracer_ = tracer.get();
    ahead->tracer = std::move(tracer);
    ahead->normals = std::make_unique<SurfaceNormals>(*scene_->model.volume, 1);
    ahead->threads = 1;
    scene_->prefetch = ahead;
  }

  void see(double turn, double seconds = 0.1) {
    camera_.turn(turn, 0);
    prefetch_.follow({scene_, camera_.camera(32, 24), look_}, camera_, seconds);
  }
  /// Goes on as before, until the prefetch is under way.
  void setOut() {
    while (tracer_->calls == 0)
      see(0.01);
  }
  void waitForEnd() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (prefetch_.isBusy() && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_FALSE(prefetch_.isBusy());
  }

  std::shared_ptr<Scene> scene_;
  EndlessTracer *tracer_ = nullptr;
  ViewCamera camera_{{.eye = {0, 20, 0}, .look = {8, 4, 8}, .verticalFov = 50}};
  Look look_{Style::Flat};
  PrefetchThread prefetch_;
};

TEST_F(PrefetchThreadAtWork, DoesNotSetOutWhenTheCameraRests) {
  for (int i = 0; i < 5; ++i)
    see(0);
  EXPECT_FALSE(prefetch_.isBusy());
}

TEST_F(PrefetchThreadAtWork, StopsWhenTheCameraRests) {
  setOut();
  see(0, 0.05);
  EXPECT_TRUE(prefetch_.isBusy());
  see(0, 0.2);
  waitForEnd();
  EXPECT_EQ(tracer_->calls, 1);
}

TEST_F(PrefetchThreadAtWork, StopsWhenTheCameraTurnsOtherwise) {
  setOut();
  see(0.01);
  EXPECT_TRUE(prefetch_.isBusy());
  see(-0.02);
  waitForEnd();
  EXPECT_EQ(tracer_->calls, 1);
}

TEST_F(PrefetchThreadAtWork, StopsWhenAnotherLookIsShown) {
  setOut();
  look_.style = Style::Lit;
  see(0.01);
  waitForEnd();
  EXPECT_EQ(tracer_->calls, 1);
}

TEST_F(PrefetchThreadAtWork, StopsWhenItEnds) { setOut(); }

} // namespace
} // namespace voxc::view
