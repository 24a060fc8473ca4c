// Clocks by NVIDIA's management library, where a driver has brought it.
#include "Clock.h"

#include <dlfcn.h>

namespace voxc::gpu {
namespace {

// As nvml.h declares them.
using Handle = void *;
constexpr int kProcessors = 1; // NVML_CLOCK_SM

struct Library {
  int (*clockInfo)(Handle, int, unsigned *) = nullptr;
  Handle device = nullptr;

  Library() {
    const Handle library = ::dlopen("libnvidia-ml.so.1", RTLD_NOW);
    if (!library)
      return;
    const auto init = reinterpret_cast<int (*)()>(::dlsym(library, "nvmlInit_v2"));
    const auto first =
        reinterpret_cast<int (*)(unsigned, Handle *)>(::dlsym(library, "nvmlDeviceGetHandleByIndex_v2"));
    const auto info = reinterpret_cast<decltype(clockInfo)>(::dlsym(library, "nvmlDeviceGetClockInfo"));
    if (init && first && info && init() == 0 && first(0, &device) == 0)
      clockInfo = info;
  }
};

} // namespace

std::optional<unsigned> clockMegahertz() {
  static const Library library;
  unsigned megahertz = 0;
  return library.clockInfo && library.clockInfo(library.device, kProcessors, &megahertz) == 0
             ? std::optional(megahertz)
             : std::nullopt;
}

} // namespace voxc::gpu
