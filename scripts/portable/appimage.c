// The program at the front of the AppImage, behind which lies a squashfs with the tree of the tarball. It
// unpacks that once, into the user's cache, and starts AppRun in it: no FUSE is needed, so that it runs in
// containers too. Linked statically, it asks for no library.
#define _GNU_SOURCE
#include <elf.h>
#include <errno.h>
#include <fcntl.h>
#include <ftw.h>
#include <limits.h>
#include <squashfuse/squashfuse.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { kPath = PATH_MAX, kBlock = 1 << 16, kNoImage = 3 };

static const char kHelp[] =
    "Options of the AppImage; all others are the program's:\n"
    "  --appimage-extract  unpack all into ./squashfs-root\n"
    "  --appimage-offset   print at which byte the squashfs begins\n"
    "  --appimage-help     print this\n"
    "It is unpacked once into $XDG_CACHE_HOME or ~/.cache, as voxc-appimage-DIGEST.\n";

__attribute__((noreturn, format(printf, 1, 2))) static void fail(const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  fputs("voxc: error: ", stderr);
  vfprintf(stderr, format, arguments);
  fputc('\n', stderr);
  exit(kNoImage);
}

__attribute__((format(printf, 2, 3))) static void join(char path[kPath], const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  if (vsnprintf(path, kPath, format, arguments) >= kPath)
    fail("a path of the AppImage is longer than %d bytes", kPath);
  va_end(arguments);
}

// The library also reads images of other compressions than zstd's, which these would be asked for; ours is
// none of them.
int uncompress(void) { return -1; }
int lzma_stream_buffer_decode(void) { return -1; }
int lzo1x_decompress_safe(void) { return -1; }
int LZ4_decompress_safe(void) { return -1; }

// The sections' headers end this program; what follows is the squashfs.
static off_t offset_of(const char *image) {
  Elf64_Ehdr head;
  const int file = open(image, O_RDONLY | O_CLOEXEC);
  if (file < 0 || read(file, &head, sizeof head) != (ssize_t)sizeof head)
    fail("cannot read '%s': %s", image, strerror(errno));
  close(file);
  return (off_t)(head.e_shoff + (Elf64_Off)head.e_shentsize * head.e_shnum);
}

static void unpack_file(sqfs *image, sqfs_inode *inode, const char *path) {
  static char block[kBlock];
  const int file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, inode->base.mode & 0777);
  if (file < 0)
    fail("cannot write '%s': %s", path, strerror(errno));
  for (uint64_t done = 0; done < inode->xtra.reg.file_size;) {
    sqfs_off_t bytes = kBlock;
    if (sqfs_read_range(image, inode, (sqfs_off_t)done, &bytes, block) != SQFS_OK || bytes == 0)
      fail("the AppImage is damaged at '%s'", path);
    if (write(file, block, (size_t)bytes) != (ssize_t)bytes)
      fail("cannot write '%s': %s", path, strerror(errno));
    done += (uint64_t)bytes;
  }
  if (close(file) != 0)
    fail("cannot write '%s': %s", path, strerror(errno));
}

static void unpack_link(sqfs *image, sqfs_inode *inode, const char *path) {
  char target[kPath];
  size_t bytes = sizeof target;
  if (sqfs_readlink(image, inode, target, &bytes) != SQFS_OK || symlink(target, path) != 0)
    fail("cannot make the link '%s'", path);
}

static void unpack(sqfs *image, const char *folder) {
  sqfs_traverse entries;
  sqfs_err problem = SQFS_OK;
  if (mkdir(folder, 0700) != 0)
    fail("cannot make the folder '%s': %s", folder, strerror(errno));
  if (sqfs_traverse_open(&entries, image, sqfs_inode_root(image)) != SQFS_OK)
    fail("the AppImage is damaged");
  while (sqfs_traverse_next(&entries, &problem)) {
    if (entries.dir_end)
      continue;
    char path[kPath];
    join(path, "%s/%s", folder, entries.path);
    sqfs_inode inode;
    if (sqfs_inode_get(image, &inode, sqfs_dentry_inode(&entries.entry)) != SQFS_OK)
      fail("the AppImage is damaged at '%s'", path);
    if (S_ISDIR(inode.base.mode) ? mkdir(path, 0755) != 0 : false)
      fail("cannot make the folder '%s': %s", path, strerror(errno));
    if (S_ISREG(inode.base.mode))
      unpack_file(image, &inode, path);
    if (S_ISLNK(inode.base.mode))
      unpack_link(image, &inode, path);
  }
  sqfs_traverse_close(&entries);
  if (problem != SQFS_OK)
    fail("the AppImage is damaged");
}

// Where the tree of this image, by its digest, lies once it is unpacked; the folder above is made.
static void place_of(char place[kPath]) {
  const char *cache = getenv("XDG_CACHE_HOME"), *home = getenv("HOME");
  char above[kPath];
  if (cache && *cache)
    join(above, "%s", cache);
  else if (home && *home)
    join(above, "%s/.cache", home);
  else
    fail("there is no folder to unpack the AppImage into; set HOME or XDG_CACHE_HOME");
  mkdir(above, 0700);
  join(place, "%s/voxc-appimage-%s", above, DIGEST);
}

static int remove_entry(const char *path, const struct stat *status, int kind, struct FTW *place) {
  (void)status, (void)kind, (void)place;
  return remove(path);
}

// Unpacked beside and renamed: whoever starts the program meanwhile finds all of it, or nothing.
static void unpack_once(sqfs *image, const char *place) {
  if (access(place, X_OK) == 0)
    return;
  char beside[kPath];
  join(beside, "%s.%ld", place, (long)getpid());
  unpack(image, beside);
  if (rename(beside, place) == 0)
    return;
  const int problem = errno;
  nftw(beside, remove_entry, 16, FTW_DEPTH | FTW_PHYS);
  if (access(place, X_OK) != 0) // Else another was first.
    fail("cannot rename '%s': %s", beside, strerror(problem));
}

int main(int count, char **arguments) {
  char image[kPath], place[kPath], program[kPath];
  const ssize_t bytes = readlink("/proc/self/exe", image, sizeof image - 1);
  if (bytes < 0)
    fail("/proc is needed to find the AppImage");
  image[bytes] = 0;
  const char *const option = count > 1 ? arguments[1] : "";
  const off_t offset = offset_of(image);
  if (strcmp(option, "--appimage-help") == 0)
    return fputs(kHelp, stdout) < 0;
  if (strcmp(option, "--appimage-offset") == 0)
    return printf("%lld\n", (long long)offset) < 0;
  sqfs files;
  if (sqfs_open_image(&files, image, (size_t)offset) != SQFS_OK)
    return kNoImage;
  if (strcmp(option, "--appimage-extract") == 0) {
    unpack(&files, "squashfs-root");
    return 0;
  }
  place_of(place);
  unpack_once(&files, place);
  setenv("APPIMAGE", image, 1);
  setenv("APPDIR", place, 1);
  join(program, "%s/AppRun", place);
  execv(program, arguments);
  fail("cannot start '%s': %s", program, strerror(errno));
}
