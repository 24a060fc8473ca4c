// Handles of Windows behind the numbers that its C library has for open files.
#pragma once

#include "WindowsApi.h"

#include <string>

namespace voxc::platform {

HANDLE handleOf(int file);

/// `CreateFile`, such that others may read, write and rename the file meanwhile, as under POSIX. -1 with
/// `errno` where that fails.
int openFile(const std::string &path, DWORD access, DWORD disposition);

} // namespace voxc::platform
