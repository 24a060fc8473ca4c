// The machine that a sweep runs on.
#pragma once

#include "voxc/Measure/Record.h"

#include <cstdint>
#include <string>

namespace voxc::measure {

/// This voxc, its libraries and the machine; `command` is what was typed.
MadeByPart madeBy(std::string command);

/// Bytes of memory that the machine has.
std::uint64_t machineMemory();

/// Turns off the caches in which drivers keep compiled kernels, so that every run compiles. Before a device
/// is opened.
void disableShaderCaches();

} // namespace voxc::measure
