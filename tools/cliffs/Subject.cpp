// Tracers of situations.
#include "Subject.h"

#include "testing/HardRays/RandomSource.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/CompileCpu.h"
#include "voxc/Plan/Plan.h"
#include "voxc/Support/Stopwatch.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <unistd.h>

namespace voxc::cliffs {
namespace {

std::string keyOf(const Format &format, Addressing addressing) {
  return std::string(toString(addressing)) + printIr(format);
}

/// Room for every page, its table, and a round of rays.
PagingOptions roomForAll(const PagedVolume &volume, unsigned threads) {
  std::uint64_t bytes = leastPagingBytes(volume);
  for (const PagedStream &stream : volume.streams())
    bytes += 2 * (stream.bytes + stream.pageBytes);
  return {.memoryBytes = bytes, .threads = threads};
}

/// Instances in the cells of a grid, each turned and scaled as it likes and within its cell.
std::vector<glm::mat4> placementsOf(unsigned count, Int3 extent, test::RandomSource &random) {
  const auto edge = static_cast<float>(std::max({extent.x, extent.y, extent.z}));
  const auto side = static_cast<int>(std::ceil(std::cbrt(static_cast<double>(count))));
  std::vector<glm::mat4> placements;
  for (unsigned i = 0; i < count; ++i) {
    const int number = static_cast<int>(i);
    const glm::vec3 cell(number % side, number / side % side, number / side / side);
    const auto scale = static_cast<float>(random.real(0.1, 0.55));
    const glm::vec3 axis(random.real(-1, 1), random.real(-1, 1), 1.5);
    glm::mat4 matrix = glm::translate(glm::mat4(1), edge * (cell + 0.5f));
    matrix = glm::rotate(matrix, static_cast<float>(random.real(0, 6.28)), glm::normalize(axis));
    matrix = glm::scale(matrix, glm::vec3(scale));
    placements.push_back(glm::translate(matrix, glm::vec3(-0.5f * edge)));
  }
  return placements;
}

} // namespace

Expected<Machine> Machine::open(const std::string &name) {
  if (name == cpuDeviceInfo().name)
    return Machine{name, nullptr};
  // Lavapipe takes its number of threads from here alone, once, when it is loaded.
  ::setenv("LP_NUM_THREADS", "1", 1);
  auto device = VOXC_TRY(Device::open(name));
  return Machine{name, std::make_unique<Device>(std::move(device))};
}

Expected<CpuKernel> KernelShelf::cpuKernel(const Format &format, Addressing addressing) {
  const std::string key = keyOf(format, addressing);
  if (const auto known = cpu_.find(key); known != cpu_.end())
    return known->second;
  auto kernel = compileCpuKernel(format, {.addressing = addressing, .start = CpuStart::Whole});
  if (kernel)
    cpu_.emplace(key, *kernel);
  return kernel;
}

Expected<Kernel> KernelShelf::vulkanKernel(const Format &format, Addressing addressing) {
  const std::string key = keyOf(format, addressing);
  if (const auto known = vulkan_.find(key); known != vulkan_.end())
    return known->second;
  const DeviceInfo &info = machine_.device->info();
  auto kernel =
      compileKernel(format, {.addressing = addressing, .loops = info.loops, .arithmetic = info.arithmetic});
  if (kernel)
    vulkan_.emplace(key, *kernel);
  return kernel;
}

Expected<double> KernelShelf::exactStepsOf(const Volume &volume, const Format &format, const RaySpan &rays) {
  const auto kernel = VOXC_TRY(cpuKernel(format, Addressing::Buffer));
  std::vector<Hit> hits(rays.size());
  kernel.function(volume.words().data(), rays.origin(0), reinterpret_cast<std::uint32_t *>(hits.data()),
                  rays.size(), 2, 0);
  double sum = 0;
  for (const Hit &hit : hits)
    sum += hit.steps >> 16;
  return sum / static_cast<double>(std::max<std::size_t>(hits.size(), 1));
}

Expected<std::unique_ptr<Tracer>> KernelShelf::tracer(const Volume &volume, const Format &format,
                                                      unsigned threads) {
  if (machine_.isCpu()) {
    const auto kernel = VOXC_TRY(cpuKernel(format, Addressing::Buffer));
    return createCpuTracer(kernel, volume, threads);
  }
  const auto kernel = VOXC_TRY(vulkanKernel(format, machine_.device->addressingFor(volume)));
  return createTracer(*machine_.device, kernel, volume, threads);
}

Expected<std::unique_ptr<Tracer>> KernelShelf::tracer(const PagedVolume &volume, const Format &format,
                                                      unsigned threads) {
  const PagingOptions options = roomForAll(volume, threads);
  Expected<std::unique_ptr<PagedTracer>> tracer = Error::usage("no tracer");
  if (machine_.isCpu()) {
    const auto kernel = VOXC_TRY(cpuKernel(format, Addressing::Paged));
    tracer = createPagedCpuTracer(kernel, volume, options);
  } else {
    const auto kernel = VOXC_TRY(vulkanKernel(format, Addressing::Paged));
    tracer = createPagedTracer(*machine_.device, kernel, volume, options);
  }
  if (!tracer)
    return tracer.error();
  return std::unique_ptr<Tracer>(std::move(*tracer));
}

Expected<std::optional<Subject>> Subject::of(KernelShelf &shelf, const Stage &stage,
                                             const Situation &situation, const StagedRays &rays) {
  Subject subject;
  subject.isOnProcessor_ = shelf.machine().isProcessor();
  subject.rays_ = rays.span();
  const Format format = askedFormat(stage.place, situation);
  if (!problemOfQuestion(format).empty())
    return std::optional<Subject>();
  if (situation.isPaged) {
    if (!checkPaging(format))
      return std::optional<Subject>();
    const std::string path =
        (std::filesystem::temp_directory_path() / ("voxc-cliffs-" + std::to_string(::getpid()) + ".hvx"))
            .string();
    VOXC_TRY(stage.volume.save(path, {.compress = true}));
    auto opened = PagedVolume::open(path);
    std::filesystem::remove(path); // It is mapped.
    if (!opened)
      return opened.error();
    subject.pages_ = std::make_unique<PagedVolume>(std::move(*opened));
  }
  subject.tracer_ = VOXC_TRY(subject.pages_ ? shelf.tracer(*subject.pages_, format, situation.threads)
                                            : shelf.tracer(stage.volume, format, situation.threads));
  subject.hits_.resize(subject.rays_.size());
  if (situation.instances > 0)
    VOXC_TRY(subject.placeInstances(stage, situation));
  return std::optional<Subject>(std::move(subject));
}

Expected<void> Subject::placeInstances(const Stage &stage, const Situation &situation) {
  test::RandomSource random(situation.seed + 2);
  const Int3 extent = stage.place.format.extent();
  placements_ = placementsOf(situation.instances, stage.place.extent, random);
  std::vector<Instance> instances;
  instances.reserve(placements_.size());
  for (const glm::mat4 &placement : placements_)
    instances.push_back({tracer_.get(), extent, placement});
  auto world = VOXC_TRY(InstancedTracer::create(instances, situation.threads));
  world_ = std::make_unique<InstancedTracer>(std::move(world));
  instanceHits_.resize(rays_.size());
  return {};
}

Expected<double> Subject::trace(const TraceOptions &options) {
  if (world_) {
    const Stopwatch watch;
    VOXC_TRY(world_->trace(rays_, instanceHits_, options));
    return 1e9 * watch.seconds();
  }
  const auto report = VOXC_TRY(tracer_->trace(rays_, hits_, options));
  return 1e9 * report.repeats.back().wall;
}

Expected<double> Subject::lookupsOf(const RaySpan &rays) {
  std::vector<Hit> hits(rays.size());
  TraceOptions options;
  options.countSteps = true;
  options.order = RayOrder::Given;
  VOXC_TRY(tracer_->trace(rays, hits, options));
  double sum = 0;
  for (const Hit &hit : hits)
    sum += hit.steps;
  return sum / static_cast<double>(std::max<std::size_t>(hits.size(), 1));
}

} // namespace voxc::cliffs
