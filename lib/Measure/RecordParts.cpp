// Parts of records, made of what they are about.
#include "voxc/Measure/Digest.h"
#include "voxc/Measure/Record.h"
#include "voxc/Trace/CpuKernel.h"

#include <algorithm>
#include <thread>

namespace voxc::measure {

FormatPart formatPart(const std::string &label, const std::string &text,
                      const std::vector<std::string> &passes, const Format &kernel) {
  // As it was written, unless that is the text of the IR.
  const bool isIr = text.starts_with("format");
  return {label, isIr ? toString(kernel) : text, passes, Digest().add(printIr(kernel)).hex()};
}

std::uint64_t longestAxis(const Format &format) {
  const Int3 extent = format.extent();
  return static_cast<std::uint64_t>(std::max({extent.x, extent.y, extent.z}));
}

DevicePart devicePart(const Device *device, unsigned threads) {
  const DeviceInfo info = device ? device->info() : cpuDeviceInfo();
  const bool isProcessor = info.kind == "cpu";
  DevicePart part{info.name, device ? "vulkan" : "cpu", info.driver, {}, isProcessor ? "cpu" : "gpu"};
  if (isProcessor)
    part.threads = threads > 0 ? threads : std::max(std::thread::hardware_concurrency(), 1u);
  return part;
}

ErrorPart errorPart(const ErrorFigures &error) {
  return {error.rays,   error.missed, error.ghost, error.wrong,   error.boundary,
          error.colour, error.maxDt,  error.rmsDt, error.maxUlpDt};
}

} // namespace voxc::measure
