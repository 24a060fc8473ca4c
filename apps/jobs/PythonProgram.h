// Programs of voxc's that are written in Python: they lie in share/voxc/report beside voxc.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Progress.h"

#include <string>
#include <vector>

namespace voxc::tool {

/// Runs one, by the name of its file, to its end, and returns the lines that it noted. It is tried with the
/// Python that is found first and with that of the system, for only one may have what it needs. Errors: what
/// the program says, of the kind that its exit code tells; `Environment` if it is not there, or no Python has
/// what it needs, with the package that does; `Interrupted`.
Expected<std::vector<std::string>> runPythonProgram(const std::string &name,
                                                    const std::vector<std::string> &arguments,
                                                    const Progress &progress);

} // namespace voxc::tool
