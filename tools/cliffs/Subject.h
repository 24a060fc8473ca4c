// What is measured: a tracer of a place on a device, with the rays and hits of a situation.
#pragma once

#include "Stage.h"

#include "voxc/Trace/CpuKernel.h"
#include "voxc/Trace/InstancedTracer.h"
#include "voxc/Trace/PagedTracer.h"
#include "voxc/Trace/Tracer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace voxc::cliffs {

/// A device that rays are traced on.
struct Machine {
  std::string name;               ///< "cpu", or as Vulkan has it.
  std::unique_ptr<Device> device; ///< Null: this processor.

  bool isCpu() const { return device == nullptr; }
  /// What it costs is CPU time; else, as of a GPU, time that passes.
  bool isProcessor() const { return isCpu() || device->info().kind == "cpu"; }
  /// Opens it. Error: there is none of that name.
  static Expected<Machine> open(const std::string &name);
};

/// The kernels of a place on a machine, each compiled once.
class KernelShelf {
public:
  explicit KernelShelf(Machine &machine) : machine_(machine) {}
  /// What exact arithmetic had to do for some rays, a ray, by the kernel of this processor.
  Expected<double> exactStepsOf(const Volume &volume, const Format &format, const RaySpan &rays);
  /// A new tracer, which knows nothing of earlier rays. The volume must outlive it.
  Expected<std::unique_ptr<Tracer>> tracer(const Volume &volume, const Format &format, unsigned threads);
  /// The same of a volume in pages, for all of which there is room.
  Expected<std::unique_ptr<Tracer>> tracer(const PagedVolume &volume, const Format &format, unsigned threads);
  void clear() { cpu_.clear(), vulkan_.clear(); }
  Machine &machine() const { return machine_; }

private:
  Expected<CpuKernel> cpuKernel(const Format &format, Addressing addressing);
  Expected<Kernel> vulkanKernel(const Format &format, Addressing addressing);

  Machine &machine_;
  std::map<std::string, CpuKernel> cpu_;
  std::map<std::string, Kernel> vulkan_;
};

class Subject {
public:
  /// Nothing if the situation cannot be, as pages of a format that takes none.
  static Expected<std::optional<Subject>> of(KernelShelf &shelf, const Stage &stage,
                                             const Situation &situation, const StagedRays &rays);

  /// Traces all rays once. Nanoseconds that passed, without copying rays in and hits out; of instances, with
  /// all.
  Expected<double> trace(const TraceOptions &options = {});
  /// Traces some other rays and tells their look-ups a ray; not of instances.
  Expected<double> lookupsOf(const RaySpan &rays);

  bool isOnProcessor() const { return isOnProcessor_; }
  std::size_t rays() const { return rays_.size(); }
  std::span<const Hit> hits() const { return hits_; }
  std::span<const InstanceHit> instanceHits() const { return instanceHits_; }
  /// From the voxels of each instance to the world.
  const std::vector<glm::mat4> &placements() const { return placements_; }

private:
  Expected<void> placeInstances(const Stage &stage, const Situation &situation);

  bool isOnProcessor_ = true;
  RaySpan rays_;
  std::unique_ptr<PagedVolume> pages_; // Outlives the tracer.
  std::unique_ptr<Tracer> tracer_;
  std::unique_ptr<InstancedTracer> world_;
  std::vector<glm::mat4> placements_;
  std::vector<Hit> hits_;
  std::vector<InstanceHit> instanceHits_;
};

} // namespace voxc::cliffs
