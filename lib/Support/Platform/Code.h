// The code of this process, and folders that hold code that it may execute.
#pragma once

#include <string>

namespace voxc::platform {

/// Which program or library a function is in: its size and its time. "" where that cannot be told.
std::string identityOfCode(const void *function);

enum class Folder { Own, OfOthers, None };

/// Makes a folder for this user alone, unless it is there. False with `errno` if that fails.
bool makeOwnFolder(const std::string &path);

/// Whether there is a folder, which nobody else may write to.
Folder ownershipOf(const std::string &path);

} // namespace voxc::platform
