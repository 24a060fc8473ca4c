// A compiled intersection kernel: SPIR-V that says which volumes it fits.
#pragma once

#include "voxc/Layout/Addressing.h"
#include "voxc/Support/Error.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// Invocations in a workgroup of every kernel; local_size_x of the GLSL.
inline constexpr std::uint32_t kWorkgroupSize = 64;

/// SPIR-V with its voxc facts, which travel inside the module as an OpModuleProcessed string: "voxc kernel 2
/// storage=<16 hex digits> addressing=<buffer|segments> loops=<whole|cut>".
///
/// Interface of a kernel, descriptor set 0: binding 0 the rays (6 floats each), 1 the hits (6 words each), 2
/// the words (`Buffer`), or a table of up to 16 64-bit segment addresses (`Segments`). Push constants: uint
/// first_ray, uint ray_count and, with `Loops::Cut`, uint resumes. Specialization constants: 0 (bool) count
/// lookups; 1 (float) the cone's spread, in kernels of `detail=cone` (`TraceOptions::spread`); 2 (bool) count
/// words read. `Loops::Cut`: rays whose loops the device cuts short are left with a hit of -2 - cell; a
/// dispatch with `resumes` 1 goes on with these alone.
struct Kernel {
  std::vector<std::uint32_t> spirv;
  std::uint64_t storageDigest = 0;
  Addressing addressing = Addressing::Buffer;
  Loops loops = Loops::Cut; ///< `Whole`: only for devices that run every loop to its end.

  /// Reads the facts out of a module. Errors: not SPIR-V, truncated, or not made by voxc.
  static Expected<Kernel> fromSpirv(std::vector<std::uint32_t> spirv);
  static Expected<Kernel> load(const std::string &path);
};

/// The facts as the module's string.
std::string kernelFacts(std::uint64_t storageDigest, Addressing addressing, Loops loops);

} // namespace voxc
