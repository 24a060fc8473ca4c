// The option that says in which order rays are taken.
#pragma once

#include "common/CommandLine.h"
#include "voxc/Trace/RayOrder.h"

#include <string>

namespace voxc::tool {

/// The name of the order that is chosen for the rays at hand.
inline constexpr const char *kAutoOrder = "auto";

/// Adds --order to a command, which sets `order` to a name that `rayOrderFrom` knows.
void addOrderArgument(const CommandLine &command, std::string &order);

} // namespace voxc::tool
