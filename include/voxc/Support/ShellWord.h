// Words of a command as a shell takes them.
#pragma once

#include <string>

namespace voxc {

/// The word as it is, or in single quotes if a shell would take it for something else.
std::string shellWord(const std::string &word);

} // namespace voxc
