// Looking for a kernel in a library.
#include "KernelLibrary.h"

#include "Support/Platform/Library.h"
#include "Support/Platform/Path.h"

namespace voxc::tool {

Expected<CpuKernel> loadKernel(const std::string &path) {
  // A name alone would be looked for in the system's folders.
  const std::string whole = platform::utf8From(std::filesystem::absolute(platform::pathFrom(path)));
  void *const library = platform::openLibrary(whole.c_str());
  if (!library)
    return Error::input("'" + path + "' is no library that can be loaded here");
  void *const function = platform::findFunction(library, "voxc_intersect");
  const void *const storage = platform::findFunction(library, "voxc_intersect_storage");
  if (!function || !storage)
    return Error::input("'" + path +
                        "' lacks voxc_intersect or voxc_intersect_storage; docs/windows.md links both");
  return CpuKernel{reinterpret_cast<CpuKernel::Function>(function),
                   *static_cast<const std::uint64_t *>(storage)};
}

} // namespace voxc::tool
