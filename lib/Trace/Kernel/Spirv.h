// SPIR-V modules as sequences of instructions, read with every word checked.
#pragma once

#include "voxc/Support/Error.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

namespace voxc::spirv {

/// One instruction; the operands lie in the module.
struct Instruction {
  std::uint32_t opcode = 0;
  std::span<const std::uint32_t> operands;
};

inline constexpr std::uint32_t kOpCapability = 17;
inline constexpr std::uint32_t kOpModuleProcessed = 330;

/// Checks the module's header and visits every instruction. Errors (`Input`): not SPIR-V, the other byte
/// order, an instruction of no words or one that runs over the end.
Expected<void> forEachInstruction(std::span<const std::uint32_t> module,
                                  const std::function<void(const Instruction &)> &visit);

/// The literal string at the start of `operands`; nothing if it does not end within them.
std::optional<std::string> literalString(std::span<const std::uint32_t> operands);

} // namespace voxc::spirv
