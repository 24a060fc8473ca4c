// From a format to a kernel for this processor, or to object code for a program that has no compiler.
#pragma once

#include "voxc/Plan/Plan.h"
#include "voxc/Support/CompileCache.h"
#include "voxc/Support/EnumText.h"
#include "voxc/Trace/CpuKernel.h"

#include <array>
#include <string>
#include <string_view>

namespace voxc {

/// How much of a kernel is compiled before its first ray. The hits are the same, and so is the speed in the
/// end.
enum class CpuStart {
  Soon,  ///< What traces rays one by one. Exact arithmetic, which few rays need, is compiled for the first of
         ///< these, and packets once there were some 260,000 rays: rays then wait for that.
  Fast,  ///< Packets too: for many rays.
  Whole, ///< All of it: for what is timed.
};

struct CpuKernelOptions {
  bool countWords = false;             ///< A kernel for `TraceOptions::countWords` and nothing else.
  const CompileCache *cache = nullptr; ///< Where it is looked for first; copied.
  /// `Paged` makes one for `createPagedCpuTracer`; the others are one here. A plan has its own.
  Addressing addressing = Addressing::Buffer;
  CpuStart start = CpuStart::Soon;
};

/// Emits and compiles the kernel of `format` for this very processor, in the process. An error here is a
/// defect of voxc and says so.
Expected<CpuKernel> compileCpuKernel(const Format &format, const CpuKernelOptions &options = {});

/// The same of a finished plan for `EmitTarget::Processor`; `Input` if it is none.
Expected<CpuKernel> compileCpuKernel(const Plan &plan, const CpuKernelOptions &options = {});

/// The system whose programs an object is for: another has another kind of files and of calls.
enum class ObjectSystem { Own, Windows };

template <> inline constexpr std::array<std::string_view, 2> kEnumNames<ObjectSystem> = {"own", "windows"};

struct CpuObjectOptions {
  /// The kernel's extern "C" function, of the type `CpuKernel::Function`; a program with several kernels
  /// gives each a name of its own. A C identifier.
  std::string symbol = "voxc_intersect";
  /// The processor to compile for, as Clang names it ("x86-64-v3", "znver4"); "native" is this very one. ""
  /// is any of this architecture: on x86-64 the object has a variant for each of x86-64-v4 (32 rays at once),
  /// x86-64-v3 (8) and the baseline (ray by ray), and picks when it is first called.
  std::string processor;
  ObjectSystem system = ObjectSystem::Own;
};

/// Emits and compiles the kernel of `format` to a relocatable object file, which needs no
/// library but C's for mathematics; `emitIntersectHeader` declares what is in it. Errors: `symbol` is no
/// `isFunctionName`, or the system has other processors than this one (`Usage`); Clang knows no such
/// processor
/// (`Input`).
Expected<std::string> compileCpuObject(const Format &format, const CpuObjectOptions &options = {});

/// The same of a finished plan for `EmitTarget::Processor`; `Input` if it is none.
Expected<std::string> compileCpuObject(const Plan &plan, const CpuObjectOptions &options = {});

} // namespace voxc
