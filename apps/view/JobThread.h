// A thread for work of which only the last that was asked for matters.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace voxc::view {

class JobThread {
public:
  /// Work that may look at `stop`, which is set when other work is asked for or the thread ends.
  using Job = std::function<void(const std::atomic<bool> &stop)>;

  JobThread() : thread_([this] { run(); }) {}
  ~JobThread();

  /// Does `job` as soon as the job at hand has stopped, and in place of one that has not begun.
  void post(Job job);
  /// Whether a job is at hand or waits.
  bool isBusy() const { return isBusy_; }

private:
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<bool> stop_ = false;
  std::atomic<bool> isBusy_ = false;
  bool isEnding_ = false;
  Job next_;
  std::thread thread_; // The last: it uses all others.
};

} // namespace voxc::view
