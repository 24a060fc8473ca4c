// What a plan decides of a level that construction code asks for, by name: constants of the level's struct.
#pragma once

#include "voxc/Plan/Plan.h"

#include <cstddef>
#include <string>
#include <vector>

namespace voxc {

struct ConstructConstant {
  std::string name;
  std::string text; ///< "int LAYERS = 8;"
};

/// All of a level: of its shape and how it is built, then those of kernels (`levelConstants`), then those of
/// its kind of slots.
std::vector<ConstructConstant> constructConstants(const Plan &plan, std::size_t index);

} // namespace voxc
