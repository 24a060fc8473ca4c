// The arguments of a program.
#pragma once

#include <string>
#include <vector>

namespace voxc::platform {

/// Those of `main`, without the program's name, in UTF-8.
std::vector<std::string> argumentsOf(int count, char **values);

} // namespace voxc::platform
