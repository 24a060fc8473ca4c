// Arguments are bytes.
#include "Arguments.h"

namespace voxc::platform {

std::vector<std::string> argumentsOf(int count, char **values) { return {values + 1, values + count}; }

} // namespace voxc::platform
