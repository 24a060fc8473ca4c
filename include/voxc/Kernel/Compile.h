// From a format to a kernel: GLSL to SPIR-V, validated always, optimised by choice.
#pragma once

#include "voxc/Emit/Emit.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Support/CompileCache.h"
#include "voxc/Trace/Kernel.h"

#include <string>
#include <string_view>

namespace voxc {

struct KernelOptions {
  Addressing addressing = Addressing::Buffer;
  Loops loops = Loops::Cut; ///< `DeviceInfo::loops`; the safe choice, where the device is not known.
  Arithmetic arithmetic = Arithmetic::Any; ///< `DeviceInfo::arithmetic`; the safe choice too.
  bool optimise = false;               ///< spirv-opt -O: may help a GPU's driver; lavapipe is slower with it.
  const CompileCache *cache = nullptr; ///< Where it is looked for first.
};

/// Emits, compiles and validates the kernel of `format`. An error here is a defect of voxc and says so.
Expected<Kernel> compileKernel(const Format &format, const KernelOptions &options = {});

/// The same of a finished plan for `EmitTarget::Device`; `Input` if it is none.
Expected<Kernel> compileKernel(const Plan &plan, bool optimise = false, const CompileCache *cache = nullptr);

/// Compiles GLSL that `emitIntersect` made of `plan`.
Expected<Kernel> compileGlsl(std::string_view glsl, const Plan &plan, bool optimise = false);

/// Compiles what `emitRayShader` makes of a plan of `kHeaderPlan` to SPIR-V 1.5, and validates it. An error
/// here is a defect of voxc and says so.
Expected<std::vector<std::uint32_t>> compileRayShader(const Plan &plan, std::string_view name,
                                                      RayStage stage);

/// The module as SPIR-V assembly.
Expected<std::string> disassemble(const Kernel &kernel);

} // namespace voxc
