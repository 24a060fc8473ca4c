// What `voxc compile` can write: one row a kind.
#pragma once

#include "voxc/Emit/Emit.h"
#include "voxc/IR/Format.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Support/Error.h"
#include "voxc/Trace/Kernel.h"

#include <string>
#include <variant>
#include <vector>

namespace voxc::tool {

/// How kernels are compiled.
struct KernelChoices {
  PlanOptions device;    ///< Of kernels for devices.
  bool optimise = false; ///< spirv-opt.
  CpuObjectOptions cpu;
  std::string name; ///< Of the functions in a header; "" takes one made of the format.
  HeaderLanguage language = HeaderLanguage::Shared;
};

struct Artefact {
  std::string file;
  std::string contents;
};

/// The names of the kinds, as given to --emit.
std::vector<std::string> artefactNames();

/// The files of kinds that `artefactNames` has: each kind's own, and what it needs beside it. With `alone`
/// the kinds' own files only. A finished plan is printed as it stands. Errors: as of compiling a kernel; what
/// is not printed of such a plan (`Input`).
Expected<std::vector<Artefact>> makeArtefacts(const std::variant<Format, Plan> &source,
                                              const std::vector<std::string> &kinds,
                                              const KernelChoices &choices, bool alone);

} // namespace voxc::tool
