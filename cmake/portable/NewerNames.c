/* What the archives of this system ask for and older C libraries lack: each name with the version of glibc that brought it. A library
 * that is linked with this has them within, hidden, and runs where they are missing. */
#define _GNU_SOURCE
#include <errno.h>
#include <link.h>
#include <malloc.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <time.h>

/* Archives that are for programs alone reach these where a program has copies of them; a library has its own. */
#undef stdin
#undef stdout
#undef stderr
extern char _IO_2_1_stdin_[], _IO_2_1_stdout_[], _IO_2_1_stderr_[];
FILE *stdin = (FILE *)_IO_2_1_stdin_, *stdout = (FILE *)_IO_2_1_stdout_, *stderr = (FILE *)_IO_2_1_stderr_;

/* 2.32: whether there is one thread alone, where shared pointers then count without locking. False is always right. */
char __libc_single_threaded = 0;

/* 2.33: before, these were inlined into each program, and called functions that are told the shape of the structure. */
#ifdef __aarch64__
enum { kStatVersion = 0, kNodeVersion = 0 };
#else
enum { kStatVersion = 1, kNodeVersion = 0 };
#endif
int __xstat(int version, const char *path, struct stat *into);
int __fxstat(int version, int file, struct stat *into);
int __lxstat(int version, const char *path, struct stat *into);
int __fxstatat(int version, int folder, const char *path, struct stat *into, int flags);
int __xmknod(int version, const char *path, mode_t mode, dev_t *device);

int stat(const char *restrict path, struct stat *restrict into) { return __xstat(kStatVersion, path, into); }
int fstat(int file, struct stat *into) { return __fxstat(kStatVersion, file, into); }
int lstat(const char *restrict path, struct stat *restrict into) { return __lxstat(kStatVersion, path, into); }
int fstatat(int folder, const char *restrict path, struct stat *restrict into, int flags) {
  return __fxstatat(kStatVersion, folder, path, into, flags);
}
int mknod(const char *path, mode_t mode, dev_t device) { return __xmknod(kNodeVersion, path, mode, &device); }
/* With 64-bit numbers for the places of files, both structures are one. */
int stat64(const char *restrict path, struct stat64 *restrict into) { return stat(path, (struct stat *)into); }
int fstat64(int file, struct stat64 *into) { return fstat(file, (struct stat *)into); }
int lstat64(const char *restrict path, struct stat64 *restrict into) { return lstat(path, (struct stat *)into); }
int fstatat64(int folder, const char *restrict path, struct stat64 *restrict into, int flags) {
  return fstatat(folder, path, (struct stat *)into, flags);
}

/* 2.33: the same figures in numbers of 64 bits; LLVM tells of memory by them. */
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
struct mallinfo2 mallinfo2(void) {
  const struct mallinfo small = mallinfo();
  struct mallinfo2 large = {0};
  large.arena = (unsigned)small.arena;
  large.hblkhd = (unsigned)small.hblkhd;
  large.uordblks = (unsigned)small.uordblks;
  large.fordblks = (unsigned)small.fordblks;
  return large;
}

/* 2.30: waits until a time by a clock, where older ones know the clock of days alone: as long from now on by that. */
int pthread_cond_clockwait(pthread_cond_t *condition, pthread_mutex_t *mutex, clockid_t clock, const struct timespec *end) {
  enum { kSecond = 1000000000 };
  struct timespec now, today;
  if (clock_gettime(clock, &now) != 0 || clock_gettime(CLOCK_REALTIME, &today) != 0)
    return EINVAL;
  today.tv_sec += end->tv_sec - now.tv_sec;
  today.tv_nsec += end->tv_nsec - now.tv_nsec;
  if (today.tv_nsec >= kSecond) {
    today.tv_nsec -= kSecond;
    ++today.tv_sec;
  } else if (today.tv_nsec < 0) {
    today.tv_nsec += kSecond;
    --today.tv_sec;
  }
  return pthread_cond_timedwait(condition, mutex, &today);
}

/* 2.36: numbers that nobody can predict; Expat begins its tables with one. Where the kernel has none, they are not that good. */
void arc4random_buf(void *into, size_t size) {
  for (size_t filled = 0; filled < size;) {
    const ssize_t more = getrandom((char *)into + filled, size - filled, 0);
    if (more > 0)
      filled += (size_t)more;
    else if (errno != EINTR)
      ((unsigned char *)into)[filled++] = (unsigned char)(clock() ^ time(NULL));
  }
}

unsigned arc4random(void) {
  unsigned number;
  arc4random_buf(&number, sizeof number);
  return number;
}

/* 2.35: where the tables lie by which the code at a place is unwound, for GCC's unwinder; found as it did before. */
struct dl_find_object;
struct Found {
  unsigned long long flags;
  void *mapStart, *mapEnd;
  struct link_map *linkMap;
  void *frames;
  unsigned long long reserved[7];
};

struct Wanted {
  ElfW(Addr) place;
  struct Found *found;
};

static int looksAt(struct dl_phdr_info *object, size_t size, void *user) {
  (void)size;
  const struct Wanted *const wanted = (const struct Wanted *)user;
  const ElfW(Phdr) *frames = NULL;
  int isHere = 0;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr) *const part = &object->dlpi_phdr[i];
    const ElfW(Addr) begin = object->dlpi_addr + part->p_vaddr;
    if (part->p_type == PT_GNU_EH_FRAME)
      frames = part;
    if (part->p_type != PT_LOAD || wanted->place < begin || wanted->place - begin >= part->p_memsz)
      continue;
    isHere = 1;
    wanted->found->mapStart = (void *)begin;
    wanted->found->mapEnd = (void *)(begin + part->p_memsz);
  }
  if (!isHere || !frames)
    return isHere ? -1 : 0;
  wanted->found->frames = (void *)(object->dlpi_addr + frames->p_vaddr);
  return 1;
}

int _dl_find_object(void *place, struct dl_find_object *into) {
  struct Found *const found = (struct Found *)into;
  memset(found, 0, sizeof *found);
  const struct Wanted wanted = {(ElfW(Addr))place, found};
  return dl_iterate_phdr(looksAt, (void *)&wanted) > 0 ? 0 : -1;
}
