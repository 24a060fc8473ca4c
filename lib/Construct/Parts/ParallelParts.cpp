// A pool of builders around a window of parts.
#include "ParallelParts.h"

#include <algorithm>
#include <new>
#include <string>
#include <system_error>

namespace voxc {

Expected<std::unique_ptr<ParallelParts>>
ParallelParts::start(const VoxelSource &source, const ConstructCode &code, const Layout &layout,
                     const PartGrid &grid, std::uint64_t begin, std::uint64_t end, unsigned threads,
                     const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  auto view = source.view();
  if (!view)
    return Error::input("this input can be read by one thread only");
  std::unique_ptr<ParallelParts> parts(
      new ParallelParts(std::move(view), grid, begin, end, threads, progress));
  std::vector<PartBuilder> builders;
  for (unsigned i = 0; i < threads; ++i) {
    auto builder = VOXC_TRY(PartBuilder::create(source.view(), code, layout, memory));
    builders.push_back(std::move(builder));
  }
  VOXC_TRY(parts->startThreads(std::move(builders)));
  return parts;
}

/// As many as the system gives, at least one.
Expected<void> ParallelParts::startThreads(std::vector<PartBuilder> builders) {
  try {
    for (PartBuilder &builder : builders)
      threads_.emplace_back(&ParallelParts::work, this, std::move(builder));
  } catch (const std::system_error &failure) {
    if (threads_.empty())
      return Error::environment("cannot start a thread: " + failure.code().message() +
                                "; a build with one thread needs none");
  }
  return {};
}

ParallelParts::~ParallelParts() {
  {
    const std::lock_guard lock(mutex_);
    abandoned_ = true;
  }
  changed_.notify_all();
  for (std::thread &thread : threads_)
    thread.join();
}

std::optional<ParallelParts::Job> ParallelParts::nextJob() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return abandoned_ || end_ || started_ < taken_ + window_; });
  if (abandoned_ || end_)
    return std::nullopt;
  if (const auto cube = sequence_.next())
    return Job{started_++, *cube};
  end_ = started_;
  changed_.notify_all();
  return std::nullopt;
}

/// A thread that ends by an exception would end the process; what it was to do is never taken for done.
void ParallelParts::work(PartBuilder builder) {
  try {
    buildAll(builder);
  } catch (const std::bad_alloc &) {
    const std::lock_guard lock(mutex_);
    failure_ = Error::environment("out of memory");
    changed_.notify_all();
  }
}

void ParallelParts::buildAll(PartBuilder &builder) {
  while (const auto job = nextJob()) {
    auto fragment = builder.build(job->cube, progress_);
    const std::lock_guard lock(mutex_);
    if (!fragment) // What follows will not be taken.
      end_ = std::min(end_.value_or(job->number + 1), job->number + 1);
    built_.emplace(job->number, Built{job->cube, std::move(fragment)});
    changed_.notify_all();
  }
}

Next<Cube> ParallelParts::next() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return built_.contains(taken_) || failure_ || (end_ && taken_ >= *end_); });
  if (const auto found = built_.find(taken_); found != built_.end()) {
    const auto &[cube, fragment] = found->second;
    return fragment ? Next<Cube>(cube) : fragment.error();
  }
  if (failure_)
    return *failure_;
  if (sequence_.looked() != share_)
    return Error::environment("of " + std::to_string(share_) + " cubes only " +
                              std::to_string(sequence_.looked()) + " were looked at");
  return End{};
}

std::uint64_t ParallelParts::looked() {
  const std::lock_guard lock(mutex_);
  return sequence_.looked();
}

Expected<Fragment> ParallelParts::take() {
  const std::lock_guard lock(mutex_);
  Built part = std::move(built_.extract(taken_).mapped());
  ++taken_;
  changed_.notify_all();
  return std::move(part.fragment);
}

} // namespace voxc
