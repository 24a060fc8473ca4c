// fault.so, to be preloaded: system calls that fail, as a full disk, a broken one and a busy machine make
// them. VOXC_FAULT=CALL:N:ERRNO lets the calls before the Nth (from 1) pass and fails all from there on;
// CALL:N:kill ends the process there as kill -9 does; CALL:N:slow makes each wait for 100 ms. malloc fails in
// helping threads alone.
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

namespace {

std::atomic<long> calls = 0;

/// True if this call shall fail, with errno set.
bool fails(const char *call) {
  const char *const plan = std::getenv("VOXC_FAULT");
  const std::size_t length = std::strlen(call);
  if (!plan || std::strncmp(plan, call, length) != 0 || plan[length] != ':')
    return false;
  char *rest = nullptr;
  const long first = std::strtol(plan + length + 1, &rest, 10);
  if (++calls < first || *rest != ':')
    return false;
  if (std::strcmp(rest + 1, "kill") == 0)
    ::raise(SIGKILL);
  if (std::strcmp(rest + 1, "slow") == 0)
    return ::usleep(100000), false;
  errno = std::atoi(rest + 1);
  return true;
}

/// True in every thread but the first, in which nobody could go on without memory.
bool isHelper() { return ::syscall(SYS_gettid) != ::getpid(); }

template <typename Function> Function next(Function, const char *name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

void *__libc_malloc(size_t size);

// Looked up by dlsym, it would be asked for memory meanwhile.
void *malloc(size_t size) {
  static const bool isPlanned =
      std::getenv("VOXC_FAULT") && std::strncmp(std::getenv("VOXC_FAULT"), "malloc:", 7) == 0;
  return isPlanned && isHelper() && fails("malloc") ? nullptr : __libc_malloc(size);
}

int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*start)(void *),
                   void *argument) {
  return fails("pthread_create")
             ? errno
             : next(&pthread_create, "pthread_create")(thread, attributes, start, argument);
}

// Memory without a file is never refused.
void *mmap(void *at, size_t size, int protection, int flags, int file, off_t offset) noexcept {
  if (!(flags & MAP_ANONYMOUS) && fails("mmap"))
    return MAP_FAILED;
  return next(&mmap, "mmap")(at, size, protection, flags, file, offset);
}

ssize_t read(int file, void *to, size_t size) {
  return fails("read") ? -1 : next(&read, "read")(file, to, size);
}

ssize_t pread(int file, void *to, size_t size, off_t offset) {
  return fails("pread") ? -1 : next(&pread, "pread")(file, to, size, offset);
}

ssize_t pwrite(int file, const void *from, size_t size, off_t offset) {
  return fails("pwrite") ? -1 : next(&pwrite, "pwrite")(file, from, size, offset);
}

int fdatasync(int file) { return fails("fdatasync") ? -1 : next(&fdatasync, "fdatasync")(file); }

int linkat(int from, const char *old, int to, const char *name, int flags) noexcept {
  return fails("linkat") ? -1 : next(&linkat, "linkat")(from, old, to, name, flags);
}

int rename(const char *old, const char *name) noexcept {
  return fails("rename") ? -1 : next(&rename, "rename")(old, name);
}
}
