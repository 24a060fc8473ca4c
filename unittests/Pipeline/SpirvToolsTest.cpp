#include "Kernel/Stages.h"

#include "voxc/Kernel/Compile.h"

#include <gtest/gtest.h>

namespace voxc {
namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kTypeVoid = 19, kLoad = 61; // Opcodes.

/// A module whose first load is said to give no value.
SpirvWords withoutValue(SpirvWords module) {
  std::uint32_t nothing = 0;
  for (std::size_t at = kHeaderWords; at < module.size(); at += module[at] >> 16) {
    const std::uint32_t opcode = module[at] & 0xffff;
    if (opcode == kTypeVoid)
      nothing = module[at + 1];
    if (opcode != kLoad)
      continue;
    module[at + 1] = nothing;
    break;
  }
  return module;
}

TEST(SpirvTools, WhatIsWrongIsNamed) {
  const auto kernel = compileKernel(*parseFormat("R(2, 2, 2)"));
  ASSERT_TRUE(kernel) << kernel.error().message;
  EXPECT_TRUE(validateSpirv(kernel->spirv));
  const auto valid = validateSpirv(withoutValue(kernel->spirv));
  ASSERT_FALSE(valid);
  // Names cost time, and are made only where they are told.
  EXPECT_NE(valid.error().message.find("%void"), std::string::npos) << valid.error().message;
}

} // namespace
} // namespace voxc
