// Code and its folders by POSIX.
#include "Code.h"

#include <cerrno>
#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

namespace voxc::platform {

std::string identityOfCode(const void *function) {
  Dl_info info{};
  struct stat file{};
  const bool isKnown = ::dladdr(function, &info) != 0 && info.dli_fname && ::stat(info.dli_fname, &file) == 0;
  if (!isKnown && ::stat("/proc/self/exe", &file) != 0)
    return "";
  return std::to_string(file.st_size) + " " + std::to_string(file.st_mtim.tv_sec) + " " +
         std::to_string(file.st_mtim.tv_nsec);
}

bool makeOwnFolder(const std::string &path) { return ::mkdir(path.c_str(), 0700) == 0 || errno == EEXIST; }

Folder ownershipOf(const std::string &path) {
  struct stat status{};
  if (::stat(path.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
    return Folder::None;
  const bool isOwn = status.st_uid == ::geteuid() && (status.st_mode & (S_IWGRP | S_IWOTH)) == 0;
  return isOwn ? Folder::Own : Folder::OfOthers;
}

} // namespace voxc::platform
