// C++ text to object code with Clang; the one file that includes Clang's frontend is ClangFrontend.cpp.
#pragma once

#include "voxc/Support/CompileCache.h"
#include "voxc/Support/Error.h"

#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// A file that the compiled text may include.
struct MemoryFile {
  std::string name;
  std::string_view text;
};

struct ClangOptions {
  int optimisation = 1; ///< 0 to 3, as in -O2.
  /// The text is a kernel: passes for kernels take the place of Clang's, and make packets.
  bool isKernel = false;
  /// The processor to compile for, as Clang names it ("x86-64-v3"); "native" is this one, "" the baseline of
  /// this architecture.
  std::string processor = "native";
  bool forWindows = false; ///< For a program of Windows, rather than of this system.
  /// Whether loops over words take many of them at a time, which -O1 leaves out.
  bool vectorLoops = false;
  std::vector<std::string> macros; ///< As in -DNAME=1, without -D.
};

/// Makes LLVM know this processor, once; what compiles and what links calls it.
void initializeTarget();

/// Compiles freestanding C++20 (`files[0]`, which may include the others) to position-independent object code
/// of this platform; or finds it in `cache`, if there is one. Error: the compiler's diagnostics.
Expected<std::string> compileToObject(const std::vector<MemoryFile> &files, const ClangOptions &options,
                                      const CompileCache *cache = nullptr);

/// The same to LLVM's bitcode, optimised; each function in it knows its processor.
Expected<std::string> compileToBitcode(const std::vector<MemoryFile> &files, const ClangOptions &options);

} // namespace voxc
