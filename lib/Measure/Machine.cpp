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

/// "model name : ..." of the first processor, or the architecture where there is no such line.
std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name"))
      if (const std::size_t colon = line.find(": "); colon != std::string::npos)
        return line.substr(colon + 2);
  return "unknown";
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
