// One job after another.
#include "view/JobThread.h"

#include <utility>

namespace voxc::view {

JobThread::~JobThread() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void JobThread::post(Job job) {
  {
    const std::lock_guard lock(mutex_);
    next_ = std::move(job);
    stop_ = true;
    isBusy_ = true;
  }
  changed_.notify_all();
}

void JobThread::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return isEnding_ || next_; });
    if (isEnding_)
      return;
    const Job job = std::exchange(next_, nullptr);
    stop_ = false;
    lock.unlock();
    job(stop_);
    lock.lock();
    isBusy_ = next_ != nullptr;
  }
}

} // namespace voxc::view
