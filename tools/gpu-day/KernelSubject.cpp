// Kernels of voxc, by their interface (voxc/Trace/Kernel.h).
#include "KernelSubject.h"

#include "Difference.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voxc::gpu {
namespace {

// Specialization constants of a kernel.
constexpr std::uint32_t kExactFallback = 3, kComesNear = 6, kGroup = 7;
// Tasks of a dispatch.
constexpr std::uint32_t kAll = 0, kDeferred = 1;

constexpr std::uint64_t kListHead = 4; // Words before the numbers of rays in the list.

/// Whether rays of a set begin so far away that a kernel has to move them near (shaders-runtime/near.glsl):
/// those of a camera all do, or none.
bool beginsFar(const RaysThere &set, Int3 extent) {
  const float far = 2 * static_cast<float>(std::max({extent.x, extent.y, extent.z}));
  return std::ranges::any_of(set.rays.front().origin, [&](float at) { return std::abs(at) > far; });
}

Expected<Program> makeVariant(const Gpu &gpu, const Kernel &kernel, bool exactFallback, std::uint32_t group,
                              bool anywhere) {
  const std::array constants = {ProgramConstant{kExactFallback, exactFallback},
                                ProgramConstant{kComesNear, anywhere}, ProgramConstant{kGroup, group}};
  return Program::make(gpu, kernel.spirv, 4, 3, constants);
}

} // namespace

std::vector<GpuStep> KernelSubject::Way::stepsOf(std::uint64_t rays, std::uint32_t mostGroups,
                                                 bool atOnce) const {
  std::vector<GpuStep> steps;
  const std::uint64_t most = std::uint64_t{mostGroups} * group;
  if (!atOnce)
    steps.push_back({.written = &list, .words = {0, 1, 1, 0}});
  for (std::uint64_t first = 0; first < rays; first += most) {
    const auto count = static_cast<std::uint32_t>(std::min(most, rays - first));
    steps.push_back({.program = atOnce ? &resolves : &defers,
                     .words = {static_cast<std::uint32_t>(first), count, kAll},
                     .groupsX = (count + group - 1) / group});
  }
  if (!atOnce)
    steps.push_back(
        {.program = &resolves, .words = {0, static_cast<std::uint32_t>(rays), kDeferred}, .groups = &list});
  return steps;
}

Expected<KernelSubject> KernelSubject::make(const Gpu &gpu, const Volume &volume,
                                            const MeasureOptions &options) {
  if (volume.words().size_bytes() > gpu.facts().mostStorageBytes)
    return Error::environment("the volume has " + std::to_string(volume.words().size_bytes()) +
                              " bytes, and a buffer of the device holds " +
                              std::to_string(gpu.facts().mostStorageBytes));
  auto words = VOXC_TRY(gpu.makeBuffer(volume.words().size() * sizeof(std::uint32_t)));
  VOXC_TRY(gpu.upload(words, std::as_bytes(std::span(volume.words()))));
  return KernelSubject(gpu, volume, options, std::move(words));
}

Expected<KernelSubject::Way> KernelSubject::makeWay(const Kernel &kernel, std::uint32_t group,
                                                    std::uint64_t mostRays, bool anywhere) const {
  if (kernel.storageDigest != volume_->storageDigest())
    return Error::input("the kernel was made for volumes that are stored in another way");
  if (kernel.addressing != Addressing::Buffer || kernel.bounded)
    return Error::input("the kernel is not one of words in one buffer and of rays without bounds");
  if (group < 1 || group > gpu_->facts().mostInGroup)
    return Error::usage("a workgroup of " + std::to_string(group) +
                        " invocations was asked for; it should be 1 to " +
                        std::to_string(gpu_->facts().mostInGroup));
  if (kernel.arithmetic == Arithmetic::Ieee ||
      (kernel.arithmetic == Arithmetic::Nearest && !gpu_->facts().roundsToNearest))
    return Error::environment("the kernel relies on arithmetic=" + std::string(toString(kernel.arithmetic)) +
                              ", which is not known of the device");
  auto defers = VOXC_TRY(makeVariant(*gpu_, kernel, false, group, anywhere));
  auto resolves = VOXC_TRY(makeVariant(*gpu_, kernel, true, group, anywhere));
  auto list = VOXC_TRY(gpu_->makeBuffer((kListHead + mostRays) * sizeof(std::uint32_t)));
  return Way{group, std::move(defers), std::move(resolves), std::move(list)};
}

void KernelSubject::bind(const Way &way, const GpuBuffer &rays, const GpuBuffer &hits) const {
  for (const Program *const program : {&way.defers, &way.resolves})
    program->bind(std::array{&rays, &hits, &words_, &way.list});
}

Expected<tool::Json> KernelSubject::trace(const Way &way, const RaysThere &set, bool atOnce) const {
  bind(way, set.buffer, set.hits);
  const std::vector<GpuStep> steps = way.stepsOf(set.rays.size(), gpu_->facts().mostGroups, atOnce);
  const auto times = VOXC_TRY(timeSteps(*gpu_, steps, options_.seconds));
  hits_.resize(set.rays.size()); // Kept: pages of a new one would take longer than the rays.
  const std::span<Hit> hits(hits_);
  VOXC_TRY(gpu_->download(set.hits, std::as_writable_bytes(hits)));
  std::array<std::uint32_t, kListHead> list{};
  VOXC_TRY(gpu_->download(way.list, std::as_writable_bytes(std::span(list))));
  Difference difference = differenceOf(hits, set.exact);
  if (const PayloadKind &kind = kindOf(volume_->layout().payload); !kind.varies && !kind.oneColour)
    difference.colour = 0; // It keeps none.
  return tool::Json{{"rays", set.name},
                    {"count", set.rays.size()},
                    {"group", way.group},
                    {"dispatches", atOnce ? 1 : 2},
                    {"mrays_per_s", speedJson(set.rays.size(), times)},
                    {"step_seconds", times.steps},
                    {"deferred", atOnce ? 0 : list[3]},
                    {"hits", std::ranges::count_if(hits, &Hit::isHit)},
                    {"error", difference.toJson()}};
}

Expected<void> KernelSubject::keepRows(const Way &way, const RaysThere &set, tool::Json &rows) const {
  for (int atOnce = 0; atOnce <= int(options_.atOnce); ++atOnce) {
    auto row = VOXC_TRY(trace(way, set, atOnce != 0));
    rows.push_back(std::move(row));
  }
  return {};
}

Expected<tool::Json> KernelSubject::measure(const Kernel &kernel, std::span<const RaysThere> sets) const {
  std::uint64_t mostRays = 0;
  for (const RaysThere &set : sets)
    mostRays = std::max<std::uint64_t>(mostRays, set.rays.size());
  tool::Json rows = tool::Json::array(), programs = tool::Json::array();
  std::vector<std::uint32_t> groups = options_.groups;
  groups.insert(groups.begin(), kWorkgroupSize);
  for (const std::uint32_t group : groups) {
    for (const bool far : {false, true}) {
      std::vector<const RaysThere *> traced;
      for (const RaysThere &set : sets)
        if (beginsFar(set, volume_->info().extent) == far)
          traced.push_back(&set);
      if (traced.empty())
        continue;
      const auto way = VOXC_TRY(makeWay(kernel, group, mostRays, far));
      programs.push_back({{"group", group},
                          {"far", far},
                          {"defers", figuresJson(way.defers)},
                          {"resolves", figuresJson(way.resolves)}});
      for (const RaysThere *const set : traced)
        VOXC_TRY(keepRows(way, *set, rows));
    }
  }
  return tool::Json{{"programs", programs}, {"rows", rows}};
}

} // namespace voxc::gpu
