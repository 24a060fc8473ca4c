// The JSON type of the tools: keys stay in the order in which they were written.
#pragma once

#include <nlohmann/json.hpp>

// Compiled once, in Json.cpp.
extern template class nlohmann::basic_json<nlohmann::ordered_map>;

namespace voxc::tool {

using Json = nlohmann::ordered_json;

} // namespace voxc::tool
