// A compiled intersection kernel: SPIR-V that says which volumes it fits.
#pragma once

#include "voxc/Layout/Addressing.h"
#include "voxc/Support/Error.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// Invocations in a workgroup of every kernel, unless a host says otherwise; local_size_x of the GLSL.
inline constexpr std::uint32_t kWorkgroupSize = 64;

/// SPIR-V with its voxc facts, which travel inside the module as an OpModuleProcessed string: "voxc kernel 3
/// storage=<16 hex digits> addressing=<buffer|segments|paged> loops=<whole|cut>
/// arithmetic=<any|nearest|ieee>", and " bounds=yes" behind it if rays have bounds.
///
/// Interface of a kernel, descriptor set 0: binding 0 the rays (6 floats each, `Ray`; with bounds 8,
/// `BoundedRay`), 1 the hits (6 words each), 2
/// the words (`Buffer`), or a table of up to 16 64-bit segment addresses (`Segments`),
/// or slots of pages (`Paged`), 3 a list of rays: three words of workgroups as `vkCmdDispatchIndirect` takes
/// them, their number, and the rays' own numbers, 4 the page table (`Paged`; docs/paging.md).
/// Push constants: uint first_ray, uint ray_count, uint task. Specialization constants: 0 (bool) count
/// lookups; 1 (float) the cone's spread, in kernels of `detail=cone` (`TraceOptions::spread`); 2 (bool) count
/// words read; 3 (bool) exact fallback; 4 (uint) log2 of a page's words and 5 (uint) pages of the volume
/// (`Paged`); 6 (bool) rays may begin far away; 7 (uint) invocations of a workgroup, by default
/// `kWorkgroupSize`.
///
/// A dispatch of task 0 traces the rays from their beginning. One that resolves, as by default, traces all to
/// their end and needs no list. One that does not is faster: rays that it cannot decide it defers with a
/// hit of -2 - cell, and puts them on the list, which must have been 0, 1, 1, 0; a dispatch that resolves,
/// with task 1, goes on with the rays of the list, and is started with its first words. `Loops::Cut`: rays
/// whose loops the device cuts short stay with a hit of -2 - cell, and with `Paged` those that wait for a
/// page; a dispatch that resolves, with task 2, goes on with them.
struct Kernel {
  std::vector<std::uint32_t> spirv;
  std::uint64_t storageDigest = 0;
  Addressing addressing = Addressing::Buffer;
  Loops loops = Loops::Cut;                ///< `Whole`: only for devices that run every loop to its end.
  Arithmetic arithmetic = Arithmetic::Any; ///< Other than `Any`: only for devices of such arithmetic.
  bool bounded = false;                    ///< Rays are `BoundedRay`s.

  /// Reads the facts out of a module. Errors: not SPIR-V, truncated, or not made by voxc.
  static Expected<Kernel> fromSpirv(std::vector<std::uint32_t> spirv);
  static Expected<Kernel> load(const std::string &path);
};

/// What a kernel says of itself, as the module's string.
std::string kernelFacts(const Kernel &kernel);

} // namespace voxc
