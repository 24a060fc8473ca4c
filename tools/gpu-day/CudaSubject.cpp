// CUDA by its driver's interface, of which a machine needs no more than the driver.
#include "CudaSubject.h"

#include "Clock.h"
#include "Difference.h"
#include "Subject.h"

#include <algorithm>
#include <array>
#include <dlfcn.h>

namespace voxc::gpu {
namespace {

// As cuda.h declares them.
using Result = int;
using DevicePointer = unsigned long long;
using Handle = void *;

constexpr unsigned kBlock = 64; // Threads.
constexpr std::size_t kFewestLaunches = 5;
constexpr int kRegisters = 4, kLocalBytes = 3; // Of CUfunction_attribute.

#define VOXC_CUDA_FUNCTIONS(X)                                                                               \
  X(cuInit, unsigned)                                                                                        \
  X(cuDeviceGet, int *, int)                                                                                 \
  X(cuDevicePrimaryCtxRetain, Handle *, int)                                                                 \
  X(cuCtxSetCurrent, Handle)                                                                                 \
  X(cuModuleLoadData, Handle *, const void *)                                                                \
  X(cuModuleGetFunction, Handle *, Handle, const char *)                                                     \
  X(cuFuncGetAttribute, int *, int, Handle)                                                                  \
  X(cuMemAlloc_v2, DevicePointer *, std::size_t)                                                             \
  X(cuMemFree_v2, DevicePointer)                                                                             \
  X(cuMemcpyHtoD_v2, DevicePointer, const void *, std::size_t)                                               \
  X(cuMemcpyDtoH_v2, void *, DevicePointer, std::size_t)                                                     \
  X(cuEventCreate, Handle *, unsigned)                                                                       \
  X(cuEventRecord, Handle, Handle)                                                                           \
  X(cuEventSynchronize, Handle)                                                                              \
  X(cuEventElapsedTime, float *, Handle, Handle)                                                             \
  X(cuLaunchKernel, Handle, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned, Handle,    \
    void **, void **)                                                                                        \
  X(cuGetErrorString, Result, const char **)

struct Driver {
#define VOXC_DECLARE(name, ...) Result (*name)(__VA_ARGS__);
  VOXC_CUDA_FUNCTIONS(VOXC_DECLARE)
#undef VOXC_DECLARE
};

/// The driver, and the first of its calls that failed: those behind it do nothing.
class Cuda {
public:
  Cuda() {
    const Handle library = ::dlopen("libcuda.so.1", RTLD_NOW);
    if (!library) {
      failure_ = "there is no driver of CUDA";
      return;
    }
#define VOXC_LOAD(name, ...)                                                                                 \
  driver_.name = reinterpret_cast<decltype(driver_.name)>(::dlsym(library, #name));                          \
  if (!driver_.name)                                                                                         \
    failure_ = "the driver of CUDA has no " #name;
    VOXC_CUDA_FUNCTIONS(VOXC_LOAD)
#undef VOXC_LOAD
    int device = 0;
    Handle context = nullptr;
    call(driver_.cuInit, 0u);
    call(driver_.cuDeviceGet, &device, 0);
    call(driver_.cuDevicePrimaryCtxRetain, &context, device);
    call(driver_.cuCtxSetCurrent, context);
    for (Handle &event : events_)
      call(driver_.cuEventCreate, &event, 0u);
  }

  const std::string &failure() const { return failure_; }
  const Driver &driver() const { return driver_; }

  template <typename... Parameters, typename... Arguments>
  void call(Result (*function)(Parameters...), Arguments... arguments) {
    const Result result = failure_.empty() ? function(arguments...) : 0;
    if (result == 0)
      return;
    const char *text = nullptr;
    driver_.cuGetErrorString(result, &text);
    failure_ = std::string("cuda refuses: ") + (text ? text : "error " + std::to_string(result));
  }

  DevicePointer bring(std::span<const std::byte> bytes, std::size_t room) {
    DevicePointer there = 0;
    call(driver_.cuMemAlloc_v2, &there, std::max<std::size_t>(room, 16));
    if (!bytes.empty())
      call(driver_.cuMemcpyHtoD_v2, there, bytes.data(), bytes.size());
    return there;
  }

  /// The seconds of one launch.
  double launch(Handle function, unsigned threads, void **arguments) {
    call(driver_.cuEventRecord, events_[0], nullptr);
    call(driver_.cuLaunchKernel, function, (threads + kBlock - 1) / kBlock, 1u, 1u, kBlock, 1u, 1u, 0u,
         nullptr, arguments, nullptr);
    call(driver_.cuEventRecord, events_[1], nullptr);
    call(driver_.cuEventSynchronize, events_[1]);
    float milliseconds = 0;
    call(driver_.cuEventElapsedTime, &milliseconds, events_[0], events_[1]);
    return double(milliseconds) * 1e-3;
  }

private:
  Driver driver_{};
  std::array<Handle, 2> events_{};
  std::string failure_;
};

tool::Json traceSet(Cuda &cuda, Handle function, DevicePointer words, const RaysThere &set, double seconds) {
  DevicePointer rays = cuda.bring(std::as_bytes(set.rays), set.rays.size_bytes());
  DevicePointer found = cuda.bring({}, set.rays.size() * sizeof(Hit));
  auto count = static_cast<unsigned>(set.rays.size());
  std::array<void *, 4> arguments = {&words, &rays, &found, &count};
  Times times;
  double warmed = 0, timed = 0;
  while (cuda.failure().empty() && (timed < seconds || times.totals.size() < kFewestLaunches)) {
    const double one = cuda.launch(function, count, arguments.data());
    if (warmed < seconds / 2) {
      warmed += one;
      continue;
    }
    timed += one;
    times.totals.push_back(one);
  }
  if (!cuda.failure().empty())
    return {};
  times.megahertz = clockMegahertz();
  std::ranges::sort(times.totals);
  std::vector<Hit> hits(set.rays.size());
  cuda.call(cuda.driver().cuMemcpyDtoH_v2, hits.data(), found, hits.size() * sizeof(Hit));
  cuda.call(cuda.driver().cuMemFree_v2, rays);
  cuda.call(cuda.driver().cuMemFree_v2, found);
  return {{"rays", set.name},
          {"count", set.rays.size()},
          {"mrays_per_s", speedJson(set.rays.size(), times)},
          {"error", differenceOf(hits, set.exact).toJson()}};
}

} // namespace

Expected<tool::Json> measureCuda(const std::string &code, std::span<const std::uint32_t> words,
                                 std::span<const RaysThere> sets, double seconds) {
  Cuda cuda;
  Handle module = nullptr, function = nullptr;
  cuda.call(cuda.driver().cuModuleLoadData, &module, code.c_str());
  cuda.call(cuda.driver().cuModuleGetFunction, &function, module, "trace");
  int registers = 0, localBytes = 0;
  cuda.call(cuda.driver().cuFuncGetAttribute, &registers, kRegisters, function);
  cuda.call(cuda.driver().cuFuncGetAttribute, &localBytes, kLocalBytes, function);
  const DevicePointer there = cuda.bring(std::as_bytes(words), words.size_bytes());
  tool::Json rows = tool::Json::array();
  for (const RaysThere &set : sets)
    rows.push_back(traceSet(cuda, function, there, set, seconds));
  if (!cuda.failure().empty())
    return Error::environment(cuda.failure());
  const tool::Json program{{"Register Count", registers}, {"Local Bytes", localBytes}};
  return tool::Json{{"programs", tool::Json::array({program})}, {"rows", rows}};
}

} // namespace voxc::gpu
