// The constants that leaves of kernels are written over: what a plan decides, by name. A leaf asks for them
// in plain GLSL, `if (PAGED)` or `LEVEL_SLOT_WORDS * i`; a kernel has their values, and what follows from
// these.
#pragma once

#include "Glsl/Passes.h"

#include "voxc/Plan/Plan.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace voxc {

using ConstantValue = std::variant<bool, int, std::uint32_t>;

/// Of a plan as a whole.
struct PlanConstant {
  std::string_view name;
  ConstantValue (*of)(const Plan &plan);
};

/// Of one of its strata. In leaves LEVEL_ stands before the name.
struct LevelConstant {
  std::string_view name;
  ConstantValue (*of)(const Plan &plan, std::size_t index);
};

std::span<const PlanConstant> planConstants();
std::span<const LevelConstant> levelConstants();

/// "true", "3", "3u": as GLSL writes it.
std::string literal(const ConstantValue &value);

/// "bool PAGED = false;": as C++ writes it.
std::string constantText(std::string_view name, const ConstantValue &value);

/// All by their names and values. Those of a stratum have what its kind of slots brings beside the rows
/// above.
glsl::Constants constantsOf(const Plan &plan);
glsl::Constants constantsOf(const Plan &plan, std::size_t index);

} // namespace voxc
