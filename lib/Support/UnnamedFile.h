// Files without a name: nothing is left of them however the process ends.
#pragma once

#include <string>

#include <sys/types.h>

namespace voxc {

/// The folder that a path lies in; "." for a name alone.
std::string folderOf(const std::string &path);

/// Opens one in a folder for reading and writing; -1 with `errno` where that fails.
int openUnnamed(const std::string &folder, mode_t mode);

/// True if an `errno` of `openUnnamed` says that the folder's file system has no such files.
bool hasNoUnnamed(int error);

/// True if an unnamed file can be given a name here.
bool canBeNamed(int file);

/// Gives an unnamed file the name `path`, in the folder that it was opened in: what has that name is
/// replaced at once, and is there until then. False with `errno` if that fails.
bool giveName(int file, const std::string &path);

} // namespace voxc
