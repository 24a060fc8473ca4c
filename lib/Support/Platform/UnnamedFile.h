// Files that are made to take the place of others, without a name until then where the system has such.
#pragma once

#include <string>

namespace voxc::platform {

/// Who may open a new file.
enum class Access {
  Owner,
  Ordinary, ///< Whoever may open other files that this process makes.
};

/// Opens a file without a name in the folder of `path`, for reading and writing: nothing is left of it
/// however the process ends. -1 with `errno` where that fails.
int openUnnamed(const std::string &path, Access access);

/// True if an `errno` of `openUnnamed` says that the folder's file system, or the system, has no such files.
bool hasNoUnnamed(int error);

/// True if an unnamed file can be given a name here.
bool canBeNamed(int file);

/// Gives an unnamed file the name `path`, for whose folder it was opened: what has that name is replaced at
/// once, and is there until then. False with `errno` if that fails.
bool giveName(int file, const std::string &path);

/// Opens a new file, for reading and writing, whose name is `path` with a dot and six letters at its end. -1
/// with `errno` where that fails.
int openNew(std::string &path, Access access);

} // namespace voxc::platform
