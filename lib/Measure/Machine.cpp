// Asking the machine.
#include "voxc/Measure/Machine.h"

#include "Support/Platform/Memory.h"
#include "voxc/Support/Version.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace voxc::measure {
namespace {

/// "model name : ..." of the first processor, or its numbers where there is no such line, as on aarch64.
std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  std::string numbers;
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos)
      continue;
    if (line.starts_with("model name"))
      return line.substr(colon + 2);
    if (line.starts_with("CPU implementer") && !numbers.empty())
      break; // That of the next processor.
    if (line.starts_with("CPU implementer") || line.starts_with("CPU variant") ||
        line.starts_with("CPU part"))
      numbers += (numbers.empty() ? "" : " ") + line.substr(colon + 2);
  }
  return numbers.empty() ? "unknown" : "ARM " + numbers;
}

} // namespace

MadeByPart madeBy(std::string command) {
  return {versionText(), VOXC_LLVM_VERSION, processorName(),
          std::max(std::thread::hardware_concurrency(), 1u), std::move(command)};
}

std::uint64_t machineMemory() { return platform::physicalMemory(); }

void disableShaderCaches() {
  for (const char *variable : {"MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE"})
    ::setenv(variable, "true", 1);
  ::setenv("__GL_SHADER_DISK_CACHE", "0", 1);
}

} // namespace voxc::measure
