// A candidate in words: what it is called, and the command that builds it.
#pragma once

#include "options/InputArguments.h"
#include "voxc/Search/Candidate.h"

#include <string>

namespace voxc::tool {

/// "G(7) M(2^3) with short pointers, direct-traversal": what sets it apart from other candidates of a scene.
std::string nameOf(const Candidate &candidate);

/// "voxc build 'G(9)' scene.ply --resolution=512 --whole-level-dedup -o scene.hvx".
std::string buildCommand(const std::string &input, const InputArguments &arguments,
                         const Candidate &candidate);

/// "voxc search scene.ply --resolution=512 --device cpu -o found".
std::string searchCommand(const std::string &input, const InputArguments &arguments,
                          const std::string &device);

} // namespace voxc::tool
