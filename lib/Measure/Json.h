// The JSON type of records: keys stay in the order in which they were written.
#pragma once

#include <nlohmann/json.hpp>

namespace voxc::measure {

using Json = nlohmann::ordered_json;

} // namespace voxc::measure
