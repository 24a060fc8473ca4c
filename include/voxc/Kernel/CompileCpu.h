// From a format to a kernel for this processor, or to object code for a program that has no compiler.
#pragma once

#include "voxc/Plan/Plan.h"
#include "voxc/Support/CompileCache.h"
#include "voxc/Trace/CpuKernel.h"

#include <string>

namespace voxc {

/// Emits and compiles the kernel of `format` for this very processor, in the process. An error here is a
/// defect of voxc and says so. `countWords`: a kernel for `TraceOptions::countWords` and nothing else. It is
/// looked for in `cache` first. `addressing`: `Paged` makes one for `createPagedCpuTracer`; the others are
/// one here.
Expected<CpuKernel> compileCpuKernel(const Format &format, bool countWords = false,
                                     const CompileCache *cache = nullptr,
                                     Addressing addressing = Addressing::Buffer);

/// The same of a finished plan for `EmitTarget::Processor`; `Input` if it is none.
Expected<CpuKernel> compileCpuKernel(const Plan &plan, bool countWords = false,
                                     const CompileCache *cache = nullptr);

struct CpuObjectOptions {
  /// The kernel's extern "C" function, of the type `CpuKernel::Function`; a program with several kernels
  /// gives each a name of its own. A C identifier.
  std::string symbol = "voxc_intersect";
  /// The processor to compile for, as Clang names it ("x86-64-v3", "znver4"); "native" is this very one. ""
  /// is any of this architecture: on x86-64 the object has a variant for each of x86-64-v4 (32 rays at once),
  /// x86-64-v3 (8) and the baseline (ray by ray), and picks when it is first called.
  std::string processor;
};

/// Emits and compiles the kernel of `format` to a relocatable object file of this platform, which needs no
/// library but C's for mathematics; `emitIntersectHeader` declares what is in it. Errors: `symbol` is no
/// identifier (`Usage`); Clang knows no such processor (`Input`).
Expected<std::string> compileCpuObject(const Format &format, const CpuObjectOptions &options = {});

/// The same of a finished plan for `EmitTarget::Processor`; `Input` if it is none.
Expected<std::string> compileCpuObject(const Plan &plan, const CpuObjectOptions &options = {});

} // namespace voxc
