// A lock of an open file, which children share.
#include "cluster/PlanLock.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace voxc::tool::cluster {
namespace {

constexpr std::chrono::milliseconds kPause{20};

Error cannotLock(const std::string &path) {
  return Error::environment("'" + path + "' cannot be locked: " + std::strerror(errno));
}

} // namespace

Expected<PlanLock> PlanLock::take(const std::string &folder, const Progress &progress,
                                  const std::function<void()> &waits) {
  const std::string path = folder + "/lock";
  // Not O_CLOEXEC: whom this process starts has it too.
  PlanLock lock(::open(path.c_str(), O_RDWR | O_CREAT, 0666));
  if (lock.file_ < 0)
    return cannotLock(path);
  for (bool isFirst = true; ::flock(lock.file_, LOCK_EX | LOCK_NB) != 0; isFirst = false) {
    if (errno == ENOLCK || errno == EOPNOTSUPP || errno == ENOSYS)
      return lock;
    if (errno != EWOULDBLOCK && errno != EINTR)
      return cannotLock(path);
    if (isFirst)
      waits();
    VOXC_TRY(progress.check());
    std::this_thread::sleep_for(kPause);
  }
  return lock;
}

PlanLock::PlanLock(PlanLock &&other) noexcept : file_(std::exchange(other.file_, -1)) {}

PlanLock::~PlanLock() {
  if (file_ >= 0)
    ::close(file_);
}

} // namespace voxc::tool::cluster
