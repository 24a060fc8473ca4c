// What is told of a kernel's interface is what its module has.
#include "voxc/Trace/KernelInterface.h"
#include "Trace/Kernel/Spirv.h"
#include "voxc/Kernel/Compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace voxc {
namespace {

using testing::ElementsAre;

/// What a module declares, by the numbers of SPIR-V.
struct Declared {
  std::map<std::uint32_t, std::uint32_t> bindings; ///< The bound variables, by their numbers.
  std::set<std::uint32_t> sets, constants, pushOffsets;
  std::vector<std::uint32_t> localSize;
};

Declared declaredIn(const Kernel &kernel) {
  constexpr std::uint32_t kExecutionMode = 16, kLocalSize = 17, kDecorate = 71, kMemberDecorate = 72;
  constexpr std::uint32_t kSpecId = 1, kBinding = 33, kDescriptorSet = 34, kOffset = 35;
  constexpr std::uint32_t kVariable = 59, kPointer = 32, kPushConstant = 9;
  std::map<std::uint32_t, std::uint32_t> pointees;
  std::map<std::uint32_t, std::set<std::uint32_t>> offsets;
  std::uint32_t pushType = 0;
  Declared declared;
  EXPECT_TRUE(spirv::forEachInstruction(kernel.spirv, [&](const spirv::Instruction &i) {
    const auto is = [&](std::uint32_t opcode, std::size_t operand, std::uint32_t value) {
      return i.opcode == opcode && i.operands.size() > operand && i.operands[operand] == value;
    };
    if (is(kExecutionMode, 1, kLocalSize))
      declared.localSize.assign(i.operands.begin() + 2, i.operands.end());
    if (is(kDecorate, 1, kBinding))
      declared.bindings[i.operands[2]]++;
    if (is(kDecorate, 1, kDescriptorSet))
      declared.sets.insert(i.operands[2]);
    if (is(kDecorate, 1, kSpecId))
      declared.constants.insert(i.operands[2]);
    if (is(kMemberDecorate, 2, kOffset))
      offsets[i.operands[0]].insert(i.operands[3]);
    if (i.opcode == kPointer)
      pointees[i.operands[0]] = i.operands[2];
    if (is(kVariable, 2, kPushConstant))
      pushType = pointees[i.operands[0]];
  }));
  declared.pushOffsets = offsets[pushType];
  return declared;
}

void expectWhatIsDeclared(const char *format, const KernelOptions &options) {
  SCOPED_TRACE(format);
  const auto kernel = compileKernel(*parseFormat(format), options);
  ASSERT_TRUE(kernel) << kernel.error().message;
  const auto interface = interfaceOf(*kernel);
  ASSERT_TRUE(interface) << interface.error().message;
  const Declared declared = declaredIn(*kernel);
  EXPECT_THAT(declared.sets, ElementsAre(interface->descriptorSet));
  EXPECT_THAT(declared.localSize, ElementsAre(interface->workgroupSize, 1, 1));
  for (const auto &[binding, variables] : declared.bindings) {
    ASSERT_LT(binding, interface->bindings.size());
    EXPECT_EQ(interface->bindings[binding].binding, binding);
  }
  EXPECT_EQ(declared.bindings.size(), interface->bindings.size());
  std::set<std::uint32_t> constants, offsets;
  for (const KernelConstant &constant : interface->constants)
    constants.insert(constant.id);
  for (const std::uint32_t id : declared.constants)
    EXPECT_TRUE(constants.contains(id)) << id;
  for (const KernelField &field : interface->pushConstants)
    offsets.insert(field.offset);
  EXPECT_EQ(declared.pushOffsets, offsets);
}

TEST(KernelInterface, IsWhatTheModuleHas) {
  expectWhatIsDeclared("R(2,2,2) G(2)", {});
  expectWhatIsDeclared("R(2,2,2) G(2)", {.addressing = Addressing::Segments});
  expectWhatIsDeclared("R(2,2,2) G(2)", {.arithmetic = Arithmetic::Nearest});
  expectWhatIsDeclared("R(2,2,2) G(2)", {.arithmetic = Arithmetic::Ieee});
  expectWhatIsDeclared("format detail=cone { level 1: svdag(2) }", {});
  expectWhatIsDeclared("format query=any { level 1: svdag(2) }", {});
}

TEST(KernelInterface, TellsTheFeaturesThatAreNeeded) {
  const Format format = *parseFormat("G(3)");
  EXPECT_THAT(interfaceOf(*compileKernel(format))->features, ElementsAre());
  EXPECT_THAT(interfaceOf(*compileKernel(format, {.arithmetic = Arithmetic::Nearest}))->features,
              ElementsAre("shaderRoundingModeRTEFloat32"));
  EXPECT_THAT(interfaceOf(*compileKernel(format, {.arithmetic = Arithmetic::Ieee}))->features,
              ElementsAre("shaderRoundingModeRTEFloat32"));
  const Format stepsInDoubles = *parseFormat("R(8,1,1) G(3)");
  EXPECT_THAT(interfaceOf(*compileKernel(stepsInDoubles, {.arithmetic = Arithmetic::Ieee}))->features,
              ElementsAre("shaderFloat64"));
  EXPECT_THAT(interfaceOf(*compileKernel(format, {.addressing = Addressing::Segments}))->features,
              testing::Contains("bufferDeviceAddress"));
}

TEST(KernelInterface, OfABrokenModuleIsAnError) {
  Kernel kernel = *compileKernel(*parseFormat("G(3)"));
  kernel.spirv.resize(6); // In the middle of an instruction.
  EXPECT_FALSE(interfaceOf(kernel));
}

} // namespace
} // namespace voxc
