// The thread that paints: what is shown, what is ended, and in which order.
#include "Hill.h"

#include "view/Painter.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

namespace voxc::view {
namespace {

/// Hits nothing, and waits for leave before each call; until it is told to stop, if it may be.
class GatedTracer final : public Tracer {
public:
  Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &options) override {
    std::unique_lock lock(mutex_);
    ++waiting_;
    changed_.notify_all();
    while (leaves_ == 0 && !options.progress.stopped())
      changed_.wait_for(lock, std::chrono::milliseconds(1));
    --waiting_;
    if (isBroken)
      return Error::environment("broken");
    if (options.progress.stopped())
      return Error::interrupted();
    --leaves_;
    for (std::size_t i = 0; i < rays.size(); ++i)
      hits[i] = {{-1, -1, -1}, 0, 0, 0};
    return TraceReport{};
  }

  void waitForCall() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_ > 0; });
  }
  void leave(int calls) {
    const std::lock_guard lock(mutex_);
    leaves_ += calls;
    changed_.notify_all();
  }

  std::atomic<bool> isBroken = false;

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int leaves_ = 0, waiting_ = 0;
};

class PainterTest : public ::testing::Test {
protected:
  PainterTest() : scene_(makeHill()) {
    auto tracer = std::make_unique<GatedTracer>();
    gate_ = tracer.get();
    scene_->tracer = std::move(tracer);
    shot_ = {scene_, frameExtent({16, 16, 16}, 64, 48), Look{Style::Flat}};
    painter_ = std::make_unique<Painter>(Refinement(0.04, 1), [] {});
  }
  ~PainterTest() override { painter_.reset(); }

  Painting next() {
    std::optional<Painting> painting;
    while (!(painting = painter_->take()))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::move(*painting);
  }

  std::shared_ptr<Scene> scene_;
  GatedTracer *gate_ = nullptr;
  Shot shot_;
  std::unique_ptr<Painter> painter_;
};

TEST_F(PainterTest, ADraftIsNotEndedByTheNextShot) {
  const std::uint64_t first = painter_->show(shot_);
  gate_->waitForCall();
  const std::uint64_t second = painter_->show(shot_);
  gate_->leave(1);
  const Painting shown = next();
  EXPECT_EQ(shown.number, first);
  EXPECT_TRUE(shown.picture);
  // The next one begins with a draft of its own.
  gate_->leave(1);
  const Painting draft = next();
  EXPECT_EQ(draft.number, second);
  EXPECT_TRUE(draft.step.isDraft);
  EXPECT_FALSE(draft.isLast);
}

TEST_F(PainterTest, AFinerStepIsEndedByTheNextShot) {
  painter_->show(shot_);
  gate_->leave(1);
  EXPECT_TRUE(next().step.isDraft);
  gate_->waitForCall(); // The finer step, which gets no leave.
  const std::uint64_t second = painter_->show(shot_);
  gate_->waitForCall();
  gate_->leave(1);
  const Painting draft = next();
  EXPECT_EQ(draft.number, second);
  EXPECT_TRUE(draft.step.isDraft);
}

TEST_F(PainterTest, WhatIsInsistedOnIsAskedWhateverIsAskedLater) {
  std::mutex mutex;
  std::vector<std::string> asked;
  const auto question = [&](const char *name) {
    return [&, name](const Shot &) {
      const std::lock_guard lock(mutex);
      asked.emplace_back(name);
    };
  };
  // There is nothing to show yet, so that all wait.
  painter_->insist(question("replaced"));
  painter_->ask(question("replaced"));
  painter_->insist(question("first"));
  painter_->ask(question("second"));
  painter_->show(shot_);
  gate_->leave(1);
  next();
  const std::lock_guard lock(mutex);
  EXPECT_EQ(asked, (std::vector<std::string>{"first", "second"}));
}

TEST_F(PainterTest, AQuestionEndsAFinerStepAndPaintingGoesOnAfterIt) {
  painter_->show(shot_);
  gate_->leave(1);
  const RefinementStep draft = next().step;
  gate_->waitForCall();
  std::atomic<bool> isAsked = false;
  painter_->ask([&](const Shot &shot) { isAsked = shot.scene == scene_; });
  while (!isAsked)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  gate_->leave(1);
  const Painting finer = next();
  EXPECT_LT(finer.step.divisor, draft.divisor);
  EXPECT_FALSE(finer.step.isDraft);
}

TEST_F(PainterTest, AnErrorIsToldOnceAndTheNextShotIsTriedAgain) {
  gate_->isBroken = true;
  painter_->show(shot_);
  gate_->leave(1);
  const Painting failed = next();
  ASSERT_FALSE(failed.picture);
  EXPECT_EQ(failed.picture.error().message, "broken");
  EXPECT_TRUE(failed.isLast);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_FALSE(painter_->take());
  gate_->isBroken = false;
  painter_->show(shot_);
  gate_->leave(1);
  EXPECT_TRUE(next().picture);
}

TEST_F(PainterTest, EndsInTheMiddleOfAStep) {
  painter_->show(shot_);
  gate_->waitForCall();
}

} // namespace
} // namespace voxc::view
