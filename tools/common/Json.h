// The JSON type of the tools: keys stay in the order in which they were written.
#pragma once

#include <nlohmann/json.hpp>

namespace voxc::tool {

using Json = nlohmann::ordered_json;

} // namespace voxc::tool
