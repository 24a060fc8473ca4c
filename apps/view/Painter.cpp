// Painting on a thread.
#include "view/Painter.h"

#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc::view {
namespace {

/// Whether pictures of both take about as long.
bool areAlike(const Shot &a, const Shot &b) {
  return a.scene == b.scene && a.look == b.look && a.camera.width == b.camera.width &&
         a.camera.height == b.camera.height;
}

} // namespace

Painter::Painter(const Refinement &refinement, std::function<void()> wake)
    : wake_(std::move(wake)), refinement_(refinement), thread_([this] { run(); }) {}

Painter::~Painter() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::uint64_t Painter::show(Shot shot) {
  const std::lock_guard lock(mutex_);
  stop_ = stop_ || !refinement_.isFirst();
  if (shot_ && areAlike(*shot_, shot))
    refinement_.restart();
  else
    refinement_.forgetTimes();
  shot_ = std::move(shot);
  changed_.notify_all();
  return ++number_;
}

void Painter::ask(Question question) { put(question_, std::move(question)); }

void Painter::insist(Question question) { put(insisted_, std::move(question)); }

void Painter::put(Question &place, Question question) {
  const std::lock_guard lock(mutex_);
  place = std::move(question);
  stop_ = stop_ || !refinement_.isFirst();
  changed_.notify_all();
}

void Painter::answer(std::unique_lock<std::mutex> &lock) {
  const Question question = std::exchange(insisted_ ? insisted_ : question_, nullptr);
  const Shot shot = *shot_;
  lock.unlock();
  question(shot);
  lock.lock();
}

void Painter::paintStep(std::unique_lock<std::mutex> &lock) {
  const Shot shot = *shot_;
  const std::uint64_t number = number_;
  const RefinementStep step = *refinement_.next();
  stop_ = false;
  lock.unlock();
  const Stopwatch watch;
  Expected<Picture> picture = paint(shot, step, {.stop = &stop_});
  const double seconds = watch.seconds();
  const auto &paging = shot.scene->paging;
  const auto pages = paging ? std::optional(paging()) : std::nullopt;
  lock.lock();
  if (!picture && picture.error().kind == ErrorKind::Interrupted)
    return;
  if (areAlike(shot, *shot_))
    refinement_.took(step, seconds);
  if (number == number_)
    refinement_.done(step);
  if (!picture && number == number_)
    shot_.reset(); // It would fail again.
  painting_.put({number, std::move(picture), step, seconds, !shot_ || !refinement_.next(), pages});
}

void Painter::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock,
                  [this] { return isEnding_ || (shot_ && (insisted_ || question_ || refinement_.next())); });
    if (isEnding_)
      return;
    if (insisted_ || question_)
      answer(lock);
    else
      paintStep(lock);
    lock.unlock();
    wake_();
    lock.lock();
  }
}

} // namespace voxc::view
